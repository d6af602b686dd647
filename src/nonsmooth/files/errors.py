"""What is wrong with a file, or not as it should be."""

from pathlib import Path


class FileError(ValueError):
    """A file that cannot be read or written as asked; it names the path."""

    def __init__(self, path: Path, problem: str) -> None:
        super().__init__(f"{path}: {problem}")
        self.path = path
        self.problem = problem

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.path, self.problem), vars(self)


class FileWarning(UserWarning):
    """A file that was loaded, and is not as it was written."""


def other_kind(path: Path) -> FileError:
    """Return the error of a file that holds what is written for other programs."""
    return FileError(path, "holds no orbit, sweep, family or modes: nothing else can be loaded")


def damaged(path: Path, how: str) -> FileError:
    """Return the error of a file that cannot be right."""
    return FileError(path, f"damaged: {how}")
