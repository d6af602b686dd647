"""``nonsmooth.scene("impact")`` finds a scene; scene files import their words from here.

Examples
--------
>>> import nonsmooth as ns
>>> ns.scene("impact")(gap=0.2).values["gap"]
0.2
>>> from nonsmooth.scene import Event, Memory, Parameter, Phase, Scene, a, forcing, t, v, x
>>> Event(x).zero
x
"""

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .codegen.scene import (
        Body,
        Event,
        Memory,
        Parameter,
        Phase,
        Scene,
        SceneError,
        a,
        forcing,
        t,
        v,
        x,
    )
    from .solver.scenes.loaded import LoadedScene

__all__ = [
    "Body", "Event", "Memory", "Parameter", "Phase", "Scene", "SceneError",
    "a", "find", "forcing", "t", "v", "x",
]  # fmt: skip


def find(what: object) -> "LoadedScene":
    """Return a scene, derived first if it is new; ``nonsmooth.scene(what)`` is the same.

    Parameters
    ----------
    what : str, Path or Scene
        The name of a shipped scene, the path of a scene file (a text with a slash, or that
        ends in ``.py``), or a `Scene` that was made in place.  A scene file is Python and is
        run.

    Returns
    -------
    LoadedScene
        The scene; called with parameters in SI units it makes a case.

    Raises
    ------
    TypeError
        If `what` is none of these.
    UnknownScene
        A `ValueError`: if no scene has this name.
    SceneFileError
        A `ValueError`: if a scene file, or the scene in it, is not as it must be.
    """
    from .scene_files.find import find_scene  # noqa: PLC0415  (it reads no SymPy yet)

    return find_scene(what)


def __getattr__(name: str) -> Any:
    """Return a word of scene files; SymPy is imported with the first."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(".codegen.scene", __package__), name)


class _Callable(ModuleType):
    """A module that is a function as well: ``nonsmooth.scene`` is both."""

    def __call__(self, what: object) -> "LoadedScene":
        return find(what)


sys.modules[__name__].__class__ = _Callable
