"""Sets of functions, a file each: what a motion is expanded in, and what it is tested with.

None knows an oscillator.  A file has `METHOD`, `TITLE` and ``derive(scene)``, and may have
`ABOUT`.  Its kernel has the name of the file or, where another's serves it, that in `KERNEL`;
of one with a ``test`` it is written with no more ado.  One whose ``derive`` takes a number of
functions besides says in `FUNCTIONS` which there may be, and one made for some scenes alone has
``applies(scene)``.  One that expands the contact forces of bodies, too, has ``of_body(scene)``.
"""

import importlib
import pkgutil
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from types import ModuleType

from ..scene import Scene


@dataclass(frozen=True)
class About:
    """Facts about an expansion; a file of ``expansions/`` without them has these.

    Parameters
    ----------
    place : int
        Where it stands when all are told, the lowest first.
    power : bool
        Whether its errors fall as a power of the order; else by a factor with each order.
    first : bool
        Whether the orbits of all others start from its times and are judged by it; of one.
    colour, marker, line : str, str, str or tuple
        Of its curve in pictures, as matplotlib has them; filled or not.
    filled : bool
        Whether the marker is filled.
    """

    place: int = 99
    power: bool = False
    first: bool = False
    colour: str = "0.5"
    marker: str = "x"
    line: str | tuple[int, tuple[float, ...]] = "--"
    filled: bool = True


@cache
def modules() -> Mapping[str, ModuleType]:
    """Return the files of the folder by the names of their modules."""
    names = (entry.name for entry in pkgutil.iter_modules(__path__))
    return {name: importlib.import_module(f"{__name__}.{name}") for name in names}


def about(module: ModuleType) -> About:
    """Return what an expansion says of itself, or what holds for one that says nothing."""
    stated: About = getattr(module, "ABOUT", About())
    return stated


def in_order() -> list[ModuleType]:
    """Return the expansions in the order in which they are told."""
    return sorted(modules().values(), key=lambda q: (about(q).place, q.METHOD))


def kernel_name(module: ModuleType) -> str:
    """Return the name of the kernel of an expansion."""
    name = module.__name__.rpartition(".")[2]
    return str(getattr(module, "KERNEL", name))


def applies(module: ModuleType, scene: Scene) -> bool:
    """Whether an expansion is made for a scene; most are for every one."""
    if scene.body is not None:
        return hasattr(module, "of_body")
    return not hasattr(module, "applies") or bool(module.applies(scene))
