"""The user's cache: a folder of kernels for each scene, whole or not at all.

What is in it is run, so it is the user's alone: it is made so, and a folder or file that others
own or may write to is not used.
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

#: Folders that go with the process, by key: where the cache cannot be written.
_FOR_NOW: dict[str, Path] = {}


def say(line: str) -> None:
    """Print a line on what is being done."""
    print(f"nonsmooth: {line}", file=sys.stderr, flush=True)


def root() -> Path:
    """Return the folder in which the kernels of users' scenes are kept."""
    return user_cache_path("nonsmooth", appauthor=False) / "scenes"


def stored(key: str) -> Path | None:
    """Return the folder of a key, if it is there, as it was written, and the user's alone."""
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

    Where the cache cannot be written, or others could, they go into a temporary folder, for
    this process only.

    Parameters
    ----------
    key : str
        Of the scene; the name of the folder.
    files : mapping of str to str
        Content by name of file.
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
    """Make the folder of all scenes, for the user alone."""
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
    """Write a folder beside its place and put it there, unless another's is there already."""
    temporary = Path(tempfile.mkdtemp(dir=target.parent, prefix=".making-"))
    try:
        made = temporary / target.name
        _write(files, made)
        if _is_whole(target):
            return
        if os.path.lexists(target):
            say(f"{target} was not as it was written, and is written anew")
            os.replace(target, temporary / "before")
        try:
            os.replace(made, target)
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
    """Write a folder that is new."""
    folder.mkdir(mode=0o700)
    contents = {
        name: content if isinstance(content, bytes) else content.encode()
        for name, content in files.items()
    }
    sealed.write(contents, folder)
