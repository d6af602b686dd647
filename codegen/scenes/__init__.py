"""The oscillators that come with the program, a file each: plain data."""

import importlib
import pkgutil
from collections.abc import Mapping
from functools import cache
from types import ModuleType

from ...nearest import one_of
from ..scene import Scene


def names() -> tuple[str, ...]:
    """Return the names of the scenes that there are files of."""
    return tuple(module.name.replace("_", "-") for module in pkgutil.iter_modules(__path__))


@cache
def load(name: str) -> Scene:
    """Return the scene of this name; a `ValueError` if there is none."""
    if name not in names():
        raise ValueError(f"scene: got {name!r}, expected {one_of(name, names())}")
    scene: Scene = _file(name).SCENE
    return scene


def numbers_of(scene: Scene) -> Mapping[str, str]:
    """Return the numbers of the paper by the names of rows: ``NUMBERS`` of a scene's own file.

    ``motion_flight`` is the equation of motion of a phase, ``held_flight`` its velocity,
    ``demands_flight`` what is demanded in it; conditions have their names.  A scene that is
    not of a file here has none.

    Examples
    --------
    >>> numbers_of(load("impact")), numbers_of(load("stick-slip"))["motion_slip"]
    ({}, '1')
    """
    if scene.name not in names() or load(scene.name) is not scene:
        return {}
    numbers: Mapping[str, str] = getattr(_file(scene.name), "NUMBERS", {})
    return numbers


def _file(name: str) -> ModuleType:
    return importlib.import_module(f"{__name__}.{name.replace('-', '_')}")
