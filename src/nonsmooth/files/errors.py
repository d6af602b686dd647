"""What is wrong with a file."""

from pathlib import Path


class FileError(ValueError):
    """A file that cannot be read or written as asked; it names the path."""

    def __init__(self, path: Path, problem: str) -> None:
        super().__init__(f"{path}: {problem}")
        self.path = path


def of_a_scene(path: Path, scene: object) -> FileError:
    """Return the error of a file of a scene: those are written for other programs."""
    return FileError(
        path, f"of the scene {scene}: only what the paper's methods made is loaded"
    )


def damaged(path: Path, how: str) -> FileError:
    """Return the error of a file that is not as it was written."""
    return FileError(path, f"damaged, or changed since it was written: {how}")
