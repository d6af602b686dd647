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
