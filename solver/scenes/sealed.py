"""Folders of generated modules in the cache: sealed when written, checked when read.

A kernel with one digit changed would give wrong orbits, and error estimates that hide it.  So a
folder is read as a whole, and used only if it belongs to its user alone and its content has the
hash it was written with.  The content that was read is run, whatever becomes of the files.
"""

import errno
import hashlib
import os
import stat
from collections.abc import Mapping
from pathlib import Path

#: The file with the hash of all others, and the suffixes of the files that are hashed.
SEAL, ENDINGS = "seal", (".py", ".npz")

#: Permission of the group, and of all others, to write.
OTHERS = stat.S_IWGRP | stat.S_IWOTH

#: Content of the files in a folder, by their path in it, with slashes.
Kept = Mapping[str, bytes]


class Damaged(ValueError):  # noqa: N818  (named like the other errors of the package)
    """The content of a sealed folder has changed since it was written."""


class NotPrivate(PermissionError):  # noqa: N818  (named like the other errors of the package)
    """A file or folder is not used because another user owns it or may write to it."""

    def __str__(self) -> str:
        return f"{self.filename} {self.strerror}"


def write(files: Kept, folder: Path) -> None:
    """Write files and their seal into a folder, readable by its user alone."""
    for name, content in {**files, SEAL: _seal(folder.name, files)}.items():
        path = folder / name
        path.parent.mkdir(mode=0o700, exist_ok=True)
        path.touch(mode=0o600)
        path.write_bytes(content)


def read(folder: Path) -> dict[str, bytes]:
    """Return the content of a sealed folder.

    Raises
    ------
    Damaged
        If the folder's name, or the name or content of a file, differs from what was sealed.
    NotPrivate
        An `OSError`: if it, or a file in it, does not belong to its user alone.
    OSError
        If it does not exist, or cannot be read.
    """
    check_private(folder)
    content: dict[str, bytes] = {}
    for directory, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if name != "__pycache__"]  # numba's own
        check_private(Path(directory))
        for path in (Path(directory, name) for name in names):
            if path.suffix in ENDINGS or path.name == SEAL:
                content[path.relative_to(folder).as_posix()] = _content(path)
    if content.pop(SEAL, None) != _seal(folder.name, content):
        raise Damaged(f"{folder} is not as it was written")
    return content


def read_any(folder: Path) -> Kept | None:
    """Return the content of a folder that is sealed, or lies in a sealed one; else None.

    Raises
    ------
    Damaged, OSError
        See `read`.
    """
    if (folder / SEAL).exists():
        return read(folder)
    return below(read(folder.parent), folder.name) if (folder.parent / SEAL).exists() else None


def below(contents: Kept, name: str) -> Kept:
    """Return the content of the folder `name` within a folder."""
    start = f"{name}/"
    return {q.removeprefix(start): contents[q] for q in contents if q.startswith(start)}


def _content(path: Path) -> bytes:
    """Return the content of a file, once its permissions are checked."""
    with path.open("rb") as file:
        check_status(path, os.fstat(file.fileno()))
        return file.read()


def _seal(name: str, files: Kept) -> bytes:
    """Return the hash of a folder's name and of all its files."""
    digest = hashlib.sha256(name.encode())
    for path, content in sorted(files.items()):
        digest.update(f"\0{path}\0{len(content)}\0".encode() + content)
    return digest.hexdigest().encode()


def check_private(path: Path, like: Path | None = None) -> None:
    """Check that a file or folder, and a link to it, belong to the current user alone.

    Nothing is checked on systems without user ids, such as Windows.

    Parameters
    ----------
    like : Path, optional
        A folder whose owner, and writers, are trusted as well: its files are run in any case.

    Raises
    ------
    NotPrivate
        If another user owns it, or others may write to it.
    FileNotFoundError
        If it does not exist.
    """
    check_status(path, path.stat(), like.stat() if like else None)


def check_status(
    path: Path, status: os.stat_result, like: os.stat_result | None = None
) -> None:
    """Check the same as `check_private`, with the status of the file that the path leads to."""
    owners = {status.st_uid, path.lstat().st_uid}
    if not hasattr(os, "getuid"):
        return
    trusted, allowed = ({like.st_uid}, like.st_mode) if like else (set(), 0)
    if owners - trusted - {os.getuid()}:
        raise NotPrivate(errno.EPERM, "belongs to another user", str(path))
    if status.st_mode & OTHERS & ~allowed:
        raise NotPrivate(errno.EPERM, "may be written by others", str(path))
