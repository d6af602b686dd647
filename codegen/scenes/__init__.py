"""The oscillators that come with the program, a file each: plain data."""

import importlib
import pkgutil
from functools import cache

from ..scene import Scene


def names() -> tuple[str, ...]:
    """Return the names of the scenes that there are files of."""
    return tuple(module.name.replace("_", "-") for module in pkgutil.iter_modules(__path__))


@cache
def load(name: str) -> Scene:
    """Return the scene of this name.

    Raises
    ------
    ValueError
        If there is none.
    """
    if name not in names():
        raise ValueError(f"scene: got {name!r}, expected one of {', '.join(names())}")
    scene: Scene = importlib.import_module(f"{__name__}.{name.replace('-', '_')}").SCENE
    return scene
