"""A folder is written whole or not at all, and nothing of the user's is replaced."""

import os
import shutil
import tempfile
from collections.abc import Callable, Set
from pathlib import Path

from .output import check_folder_of, telling
from .problems import Problem

#: The page of a folder, and what a page that we made has in it.
PAGE, MARK = "index.html", 'name="generator" content="nonsmooth '


def check_folder(path: Path, files: Set[str]) -> None:
    """Check that a folder of these files can be put at `path`.

    It may be new, empty, or an earlier result: a page that we made, and no other files.  A
    `Problem` names the path and what was expected.
    """
    path = Path(os.path.abspath(path))
    there = set()
    if path.exists():
        if not path.is_dir() or path.is_symlink():
            raise Problem(f"-o: {path} is there, expected a folder or a new name")
        there = {entry.name for entry in path.iterdir()}
    check_folder_of(path)
    other = sorted(there - files)
    if other or (there and not _ours(path / PAGE)):
        what = f"has {other[0]} in it" if other else "has a page that is not ours"
        raise Problem(
            f"-o: {path} {what}; expected a new or empty folder, or one that report made"
        )


def _ours(page: Path) -> bool:
    return page.is_file() and MARK in page.read_text("utf-8", errors="replace")


def write_folder(path: Path, write: Callable[[Path], None]) -> None:
    """Let `write` fill a temporary folder beside `path`, then put it in its place.

    A `Problem` is raised if it cannot be written; then what was there before is still there.
    """
    path = Path(os.path.abspath(path))
    temporary = Path(tempfile.mkdtemp(dir=path.parent, prefix=f".{path.name}-"))
    try:
        with telling(path):
            made = temporary / "made"
            made.mkdir(mode=0o777)
            write(made)
            if path.exists():
                os.replace(path, temporary / "before")
            os.replace(made, path)
    finally:
        if (temporary / "before").exists() and not path.exists():
            os.replace(temporary / "before", path)
        shutil.rmtree(temporary, ignore_errors=True)
