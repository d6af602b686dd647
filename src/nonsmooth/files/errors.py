"""What is wrong with a file."""

from pathlib import Path


class FileError(ValueError):
    """A file that cannot be read or written as asked; it names the path."""

    def __init__(self, path: Path, problem: str) -> None:
        super().__init__(f"{path}: {problem}")
        self.path = path


def damaged(path: Path, how: str) -> FileError:
    """Return the error of a file that is not as it was written."""
    return FileError(path, f"damaged, or changed since it was written: {how}")
