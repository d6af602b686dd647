"""Errors in scene files, each described in one line."""


class SceneFileError(ValueError):
    """A scene file or a scene object cannot be used; the message names file and field."""


def one_line(error: BaseException) -> str:
    """Return the type and the message of an exception in one line."""
    text = " ".join(str(error).split())
    name = type(error).__name__
    return f"{name}: {text:.300}" if text else name
