"""Folders of generated modules that are kept: sealed when written, checked when read.

A kernel in which one digit was changed gives wrong orbits, and estimates by which they are
right.  So a folder is read at once, and used only if it is its user's alone and all of it is as
it was written; what was read is what runs, whatever becomes of the files.
"""

import errno
import hashlib
import os
import stat
from collections.abc import Mapping
from pathlib import Path

#: The file with the hash of all others, and the endings of these.
SEAL, ENDINGS = "seal", (".py", ".npz")

#: Permission of the group, and of all others, to write.
OTHERS = stat.S_IWGRP | stat.S_IWOTH

#: What a folder holds, by place; folders in it have a slash behind their name.
Kept = Mapping[str, bytes]


class Damaged(ValueError):  # noqa: N818  (named like the other errors of the package)
    """A folder that is not as it was written."""


class NotPrivate(PermissionError):  # noqa: N818  (named like the other errors of the package)
    """A file or folder that another user owns or may write to, and that is not used."""

    def __str__(self) -> str:
        return f"{self.filename} {self.strerror}"


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


def check_private(path: Path, like: Path | None = None) -> None:
    """Check that a file or folder is its user's alone, and a link to it as well.

    Where a system has no numbers of users, as Windows, nothing is checked.

    Parameters
    ----------
    like : Path, optional
        A folder whose files are run in any case: who owns it, or may write to it, is trusted.

    Raises
    ------
    NotPrivate
        If another user owns it, or others may write to it.
    FileNotFoundError
        If there is nothing.
    """
    check_status(path, path.stat(), like.stat() if like else None)


def check_status(path: Path, there: os.stat_result, like: os.stat_result | None = None) -> None:
    """Check the same where the status of what the path leads to is known."""
    owners = {there.st_uid, path.lstat().st_uid}
    if not hasattr(os, "getuid"):
        return
    trusted, allowed = ({like.st_uid}, like.st_mode) if like else (set(), 0)
    if owners - trusted - {os.getuid()}:
        raise NotPrivate(errno.EPERM, "belongs to another user", str(path))
    if there.st_mode & OTHERS & ~allowed:
        raise NotPrivate(errno.EPERM, "may be written by others", str(path))
