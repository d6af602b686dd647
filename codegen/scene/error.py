"""A mistake in a scene, in one line."""

from collections.abc import Iterator
from contextlib import contextmanager


class SceneError(ValueError):
    """A scene that cannot be: the message names the field, what was found and expected."""


@contextmanager
def named(field: str) -> Iterator[None]:
    """Put the name of the field before what is wrong with it."""
    try:
        yield
    except SceneError as error:
        text = str(error)
        raise SceneError(text if text.startswith(field) else f"{field}: {text}") from None
