"""Derive the kernels of a user's scene, with a word on how far it is."""

import time
from typing import TYPE_CHECKING

from .error import SceneFileError, one_line
from .store import Say

if TYPE_CHECKING:
    from nonsmooth.codegen.scene import Scene

#: Seconds after which another line says how far the derivation is.
PATIENCE = 2.0


def derive(scene: "Scene", where: str, say: Say) -> dict[str, str | bytes]:
    """Return the content of each generated file of a scene, by name.

    A `SceneFileError` is raised if the name is that of a shipped scene, or an expansion cannot
    be derived.

    Parameters
    ----------
    scene : Scene
        The scene.
    where : str
        What names it in an error: its file.
    say : callable
        Takes the progress, a line at a time.
    """
    from nonsmooth.codegen.generate import scene_sources  # noqa: PLC0415  (SymPy)

    check_name(scene.name, where)
    say(f"deriving the equations of {scene.name}, this once")
    files: dict[str, str | bytes] = {}
    last = time.monotonic()
    try:
        for name, content in scene_sources(scene):
            files[name] = content
            if time.monotonic() - last > PATIENCE:
                last = time.monotonic()
                say(f"deriving {scene.name}: {name.removesuffix('.py')} done")
    except Exception as error:
        after = f" (after {list(files)[-1]})" if files else ""
        raise SceneFileError(
            f"{where}: {scene.name} cannot be derived{after}: {one_line(error)}"
        ) from error
    return files


def check_name(name: str, where: str) -> None:
    """Check that a scene's name is not that of a shipped one; a `SceneFileError` if it is."""
    from nonsmooth.solver.kernels.registry import names  # noqa: PLC0415  (as light as needed)

    if name.replace("_", "-") in names():
        raise SceneFileError(
            f"{where}: name: got {name!r}, the name of a shipped scene; expected another"
        )
