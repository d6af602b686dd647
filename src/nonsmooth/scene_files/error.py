"""What is wrong with a scene file, in one line."""


class SceneFileError(ValueError):
    """A scene file, or a scene made in place, that cannot be used; it names file and field."""


def one_line(error: BaseException) -> str:
    """Return what an exception says, in one line, with its type if that says more."""
    text = " ".join(str(error).split())
    name = type(error).__name__
    return f"{name}: {text:.300}" if text else name
