"""The user's cache: a folder of kernels for each scene, written completely or not at all.

Its files are run.  So it is private to the user: a folder or file that others own or may write
to is not used.
"""

import atexit
import os
import shutil
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

from platformdirs import user_cache_path

from nonsmooth.solver.scenes import sealed
from nonsmooth.solver.scenes.sealed import NotPrivate, check_private

from .error import SceneFileError

#: Temporary folders of this process, by key, used where the cache cannot be written.
_FOR_NOW: dict[str, Path] = {}


def say(line: str) -> None:
    """Print a line of progress to stderr."""
    print(f"nonsmooth: {line}", file=sys.stderr, flush=True)


def root() -> Path:
    """Return the folder in which the kernels of users' scenes are kept."""
    return user_cache_path("nonsmooth", appauthor=False) / "scenes"


def stored(key: str) -> Path | None:
    """Return the folder of a key; None unless it exists, unchanged and private to the user."""
    folder = _FOR_NOW.get(key)
    try:
        if folder is None:
            _check_root()
            folder = root() / key
        return folder if _is_whole(folder) else None
    except OSError:
        return None  # `keep` says why


def keep(key: str, files: Mapping[str, str | bytes]) -> Path:
    """Write the kernels of a scene and return their folder.

    If the cache cannot be written, or is not private, they go into a temporary folder for this
    process.

    Parameters
    ----------
    key : str
        The cache key of the scene, and the name of the folder.
    files : mapping of str to str or bytes
        Contents by file name.

    Raises
    ------
    SceneFileError
        If no temporary folder can be written either.
    """
    target = root() / key
    try:
        _make_root()
        _put(files, target)
        return target
    except NotPrivate as error:
        say(f"{error}, so it is not used; derived for this run only")
    except OSError as error:
        reason = error.strerror or str(error)
        say(f"cannot write to {target.parent}: {reason}; derived for this run only")
    return _for_now(key, files)


def _make_root() -> None:
    """Make the folder of all scenes, private to the user."""
    root().parent.parent.mkdir(parents=True, exist_ok=True)
    for folder in (root().parent, root()):
        folder.mkdir(mode=0o700, exist_ok=True)
    _check_root()


def _check_root() -> None:
    for folder in (root().parent, root()):
        check_private(folder)


def _is_whole(folder: Path) -> bool:
    try:
        sealed.read(folder)
    except (FileNotFoundError, sealed.Damaged):
        return False
    return True


def _put(files: Mapping[str, str | bytes], target: Path) -> None:
    """Write a temporary folder and move it to `target`, unless a complete one is there."""
    temporary = Path(tempfile.mkdtemp(dir=target.parent, prefix=".making-"))
    try:
        fresh = temporary / target.name
        _write(files, fresh)
        if _is_whole(target):
            return
        if os.path.lexists(target):
            say(f"{target} was not as it was written, and is written anew")
            os.replace(target, temporary / "before")
        try:
            os.replace(fresh, target)
        except OSError:
            if not _is_whole(target):
                raise
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def _for_now(key: str, files: Mapping[str, str | bytes]) -> Path:
    try:
        temporary = Path(tempfile.mkdtemp(prefix="nonsmooth-scene-"))
        atexit.register(shutil.rmtree, temporary, ignore_errors=True)
        _write(files, temporary / key)
    except OSError as error:
        raise SceneFileError(
            f"no folder can be written, neither a cache nor a temporary one: {error.strerror}"
        ) from None
    _FOR_NOW[key] = temporary / key
    return temporary / key


def _write(files: Mapping[str, str | bytes], folder: Path) -> None:
    """Write files into a new folder, private to the user, and seal it."""
    folder.mkdir(mode=0o700)
    contents = {
        name: content if isinstance(content, bytes) else content.encode()
        for name, content in files.items()
    }
    sealed.write(contents, folder)
