"""The user's cache: a folder of kernels for each scene, whole or not at all."""

import atexit
import os
import shutil
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path

from .error import SceneFileError

#: What takes a line on what is being done.
Say = Callable[[str], None]

#: The module that every folder of kernels has.
SCENE = "scene.py"

#: Folders that go with the process, by key: where the cache cannot be written.
_FOR_NOW: dict[str, Path] = {}


def root() -> Path:
    """Return the folder in which the kernels of users' scenes are kept."""
    given = os.environ.get("XDG_CACHE_HOME", "")
    base = Path(given) if os.path.isabs(given) else Path(os.path.expanduser("~/.cache"))
    return base / "nonsmooth" / "scenes"


def stored(key: str) -> Path | None:
    """Return the folder of a key, if there is one."""
    if key in _FOR_NOW:
        return _FOR_NOW[key]
    try:
        found = sorted(root().glob(f"*-{key}/{SCENE}"))
    except OSError:
        return None
    return found[0].parent if found else None


def keep(name: str, key: str, files: Mapping[str, str], say: Say) -> Path:
    """Write the kernels of a scene and return their folder.

    Where the cache cannot be written, they go into a temporary folder, for this process only.

    Parameters
    ----------
    name, key : str
        Of the scene; both are in the folder's name.
    files : mapping of str to str
        Text by name of file.
    say : callable
        Told where the cache cannot be written.
    """
    target = root() / f"{name}-{key}"
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        _put(files, target)
        return target
    except OSError as error:
        reason = error.strerror or str(error)
        say(f"cannot write to {target.parent}: {reason}; derived for this run only")
    return _for_now(key, files)


def _put(files: Mapping[str, str], target: Path) -> None:
    """Write a folder beside its place and put it there, unless another's is there already."""
    temporary = Path(tempfile.mkdtemp(dir=target.parent, prefix=".making-"))
    try:
        _write(files, temporary)
        try:
            os.replace(temporary, target)
        except OSError:
            if not (target / SCENE).is_file():
                raise
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def _for_now(key: str, files: Mapping[str, str]) -> Path:
    try:
        folder = Path(tempfile.mkdtemp(prefix="nonsmooth-scene-"))
        atexit.register(shutil.rmtree, folder, ignore_errors=True)
        _write(files, folder)
    except OSError as error:
        raise SceneFileError(
            f"no folder can be written, neither a cache nor a temporary one: {error.strerror}"
        ) from None
    _FOR_NOW[key] = folder
    return folder


def _write(files: Mapping[str, str], folder: Path) -> None:
    for name, text in files.items():
        (folder / name).parent.mkdir(exist_ok=True)  # of one of several motions
        (folder / name).write_text(text, "utf-8", newline="\n")
