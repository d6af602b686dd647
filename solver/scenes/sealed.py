"""Folders of generated modules that are kept: sealed when written, checked when read.

A kernel in which one digit was changed gives wrong orbits, and estimates by which they are
right.  So a folder is read at once, and used only if it is its user's alone and all of it is as
it was written; what was read is what runs, whatever becomes of the files.
"""

import hashlib
import os
from collections.abc import Mapping
from pathlib import Path

from ..ownership import check_private, check_status

#: The file with the hash of all others, and the endings of these.
SEAL, ENDINGS = "seal", (".py", ".npz")

#: What a folder holds, by place; folders in it have a slash behind their name.
Kept = Mapping[str, bytes]


class Damaged(ValueError):  # noqa: N818  (named like the other errors of the package)
    """A folder that is not as it was written."""


def write(files: Kept, folder: Path) -> None:
    """Write files into a folder, and its seal, for the user alone."""
    for place, content in {**files, SEAL: _seal(folder.name, files)}.items():
        path = folder / place
        path.parent.mkdir(mode=0o700, exist_ok=True)
        path.touch(mode=0o600)
        path.write_bytes(content)


def read(folder: Path) -> dict[str, bytes]:
    """Return what is in a sealed folder.

    Raises
    ------
    Damaged
        If it is not what was written there: under this name, each file and no other.
    NotPrivate
        An `OSError`: if it, or a file in it, is not its user's alone.
    OSError
        If it is not there, or cannot be read.
    """
    check_private(folder)
    found: dict[str, bytes] = {}
    for place, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if name != "__pycache__"]  # numba's own
        check_private(Path(place))
        for path in (Path(place, name) for name in names):
            if path.suffix in ENDINGS or path.name == SEAL:
                found[path.relative_to(folder).as_posix()] = _content(path)
    if found.pop(SEAL, None) != _seal(folder.name, found):
        raise Damaged(f"{folder} is not as it was written")
    return found


def read_any(folder: Path) -> Kept | None:
    """Return what is in a folder that is sealed, or lies in one; None of any other.

    Raises
    ------
    Damaged, OSError
        See `read`.
    """
    if (folder / SEAL).exists():
        return read(folder)
    return below(read(folder.parent), folder.name) if (folder.parent / SEAL).exists() else None


def below(kept: Kept, name: str) -> Kept:
    """Return what is in one of the folders of a folder."""
    start = f"{name}/"
    return {q.removeprefix(start): kept[q] for q in kept if q.startswith(start)}


def _content(path: Path) -> bytes:
    with path.open("rb") as file:
        check_status(path, os.fstat(file.fileno()))
        return file.read()


def _seal(name: str, files: Kept) -> bytes:
    """Return the hash of a folder's name and of all that is in it."""
    digest = hashlib.sha256(name.encode())
    for place, content in sorted(files.items()):
        digest.update(f"\0{place}\0{len(content)}\0".encode() + content)
    return digest.hexdigest().encode()
