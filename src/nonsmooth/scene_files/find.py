"""Find a scene by its name, the path of its file, or as an object."""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from nonsmooth.solver.kernels import registry
from nonsmooth.solver.scenes import loaded, sealed
from nonsmooth.solver.scenes.loaded import LoadedScene

from .content import key_of_scene, key_of_text, stands_alone
from .error import SceneFileError, one_line
from .read import is_path, read_scene, text_of
from .store import keep, say, stored


def find_scene(what: object) -> LoadedScene:
    """Return a scene; a new one is derived first.  See `nonsmooth.scene.find`."""
    if isinstance(what, LoadedScene):
        return what
    if isinstance(what, str) and not is_path(what):
        return registry.load(what)
    if isinstance(what, str | Path):
        return _of_file(Path(what))
    if _is_scene(what):
        scene: Any = what
        return _kept(key_of_scene(scene), lambda: scene, "scene")
    raise TypeError(
        f"scene: got {what!r:.80}, expected a name, the path of a scene file, or a Scene"
    )


def names() -> tuple[str, ...]:
    """Return the names of the shipped scenes.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> "impact" in ns.scenes()
    True
    """
    return registry.names()


def _is_scene(what: object) -> bool:
    """Whether an object is a `Scene`; SymPy is not imported to find out."""
    module = sys.modules.get("nonsmooth.codegen.scene")
    return module is not None and isinstance(what, module.Scene)


def _of_file(path: Path) -> LoadedScene:
    text = text_of(path)
    if stands_alone(text):
        return _kept(key_of_text(text), lambda: read_scene(path, text), str(path))
    scene = read_scene(path, text)
    return _kept(key_of_scene(scene), lambda: scene, str(path))


def _kept(key: str, make: Callable[[], Any], where: str) -> LoadedScene:
    """Return the scene of a key from the cache; if it is new, make, derive and keep it.

    `where` names its origin in messages.
    """
    folder = stored(key)
    if folder is None:
        folder = keep(key, _derived(make(), where))
    try:
        scene = loaded.load_folder(folder, sealed.read(folder))
    except Exception as error:
        raise SceneFileError(f"{where}: its kernels cannot be read ({error})") from error
    _check_name(scene.name, where)
    return scene


def _derived(scene: Any, where: str) -> dict[str, str | bytes]:
    """Return the content of each generated file of a scene, by name.

    A `SceneFileError` is raised if a shipped scene has its name, or it cannot be derived.
    """
    from nonsmooth.codegen.generate import scene_sources  # noqa: PLC0415  (SymPy)

    _check_name(scene.name, where)
    say(f"deriving the equations of {scene.name}, this once")
    files: dict[str, str | bytes] = {}
    try:
        for name, content in scene_sources(scene):
            files[name] = content
    except Exception as error:
        after = f" (after {list(files)[-1]})" if files else ""
        raise SceneFileError(
            f"{where}: {scene.name} cannot be derived{after}: {one_line(error)}"
        ) from error
    return files


def _check_name(name: str, where: str) -> None:
    """Raise a `SceneFileError` if the name of a scene is that of a shipped one."""
    if name.replace("_", "-") in registry.names():
        raise SceneFileError(
            f"{where}: name: got {name!r}, the name of a shipped scene; expected another"
        )
