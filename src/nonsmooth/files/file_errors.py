"""What is wrong with a file, or not as it should be."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..scene_files.error import SceneFileError

#: What Python raises where content is not what it is taken for.
CONTENT = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)


class FileError(ValueError):
    """A file that cannot be read or written as asked; it names the path."""

    def __init__(self, path: Path, problem: str) -> None:
        super().__init__(f"{path}: {problem}")
        self.path = path
        self.problem = problem

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.path, self.problem), vars(self)


class FileWarning(UserWarning):
    """A file was loaded that was changed after it was written."""


class NotRightError(ValueError):
    """A number that is inconsistent or out of range; the message names it."""


def other_kind(path: Path) -> FileError:
    """Return the error for a file that is meant for other programs."""
    return FileError(path, "holds no orbit, sweep or family: nothing else can be loaded")


def damaged(path: Path, how: str) -> FileError:
    """Return the error for a damaged file."""
    return FileError(path, f"damaged: {how}")


@contextmanager
def refused(path: Path, *also: type[Exception]) -> Iterator[None]:
    """Let what goes wrong with the content of a file refuse the file.

    Parameters
    ----------
    path : Path
        The file.
    *also : type
        Errors that come from its content, beside those of any content.

    Raises
    ------
    FileError
        In words, or with the name of the error of Python.
    """
    expected: tuple[type[Exception], ...] = (*CONTENT, *also)
    try:
        yield
    except (FileError, SceneFileError):
        raise
    except NotRightError as error:
        raise damaged(path, str(error)) from error
    except expected as error:
        raise damaged(path, f"{type(error).__name__} {error}") from error
