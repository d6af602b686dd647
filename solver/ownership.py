"""Whether a file that is run can have been written by its user alone."""

import errno
import os
import stat
from pathlib import Path

#: Permission of the group, and of all others, to write.
OTHERS = stat.S_IWGRP | stat.S_IWOTH


class NotPrivate(PermissionError):  # noqa: N818  (named like the other errors of the package)
    """A file or folder that another user owns or may write to, and that is not used."""

    def __str__(self) -> str:
        return f"{self.filename} {self.strerror}"


def check_private(path: Path, status: os.stat_result | None = None) -> None:
    """Check that a file or folder is its user's alone, and a link to it as well.

    Where a system has no numbers of users, as Windows, nothing is checked.

    Parameters
    ----------
    path : Path
    status : stat_result, optional
        Of what the path leads to, if it is open already.

    Raises
    ------
    NotPrivate
        If another user owns it, or others may write to it.
    FileNotFoundError
        If there is nothing.
    """
    link, there = path.lstat(), status or path.stat()
    if not hasattr(os, "getuid"):
        return
    if {link.st_uid, there.st_uid} != {os.getuid()}:
        raise NotPrivate(errno.EPERM, "belongs to another user", str(path))
    if there.st_mode & OTHERS:
        raise NotPrivate(errno.EPERM, "may be written by others", str(path))
