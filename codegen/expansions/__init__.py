"""Sets of functions, a file each: what a motion is expanded in, and what it is tested with.

None knows an oscillator.  A file has `METHOD`, `TITLE` and ``derive(scene)``, and may have
`ABOUT`.  One with a ``test`` has a kernel for any scene, of its own name or, where another's
serves it, of that in `KERNEL`.  One whose ``derive`` takes a number of functions besides says
in `FUNCTIONS` which there may be, and one made for some scenes alone has ``applies(scene)``.
"""

import importlib
import pkgutil
from collections.abc import Callable, Mapping
from functools import cache, partial
from types import ModuleType

from ..expansion import About
from ..galerkin import GalerkinConditions
from ..scene import Scene

Derivation = Callable[[Scene], GalerkinConditions]


@cache
def modules() -> Mapping[str, ModuleType]:
    """Return the files of the folder by the names of their modules."""
    found = (entry.name for entry in pkgutil.iter_modules(__path__))
    return {name: importlib.import_module(f"{__name__}.{name}") for name in found}


def about(module: ModuleType) -> About:
    """Return what an expansion says of itself, or what holds for one that says nothing."""
    found: About = getattr(module, "ABOUT", About())
    return found


def in_order() -> list[ModuleType]:
    """Return the expansions in the order in which they are told."""
    return sorted(modules().values(), key=lambda q: (about(q).place, q.METHOD))


def kernel_name(module: ModuleType) -> str | None:
    """Return the name of the kernel that an expansion has for any scene, if it has one."""
    own = module.__name__.rpartition(".")[2] if hasattr(module, "test") else None
    return getattr(module, "KERNEL", own)


def applies(module: ModuleType, scene: Scene) -> bool:
    """Whether an expansion is made for a scene; most are for every one."""
    return not hasattr(module, "applies") or bool(module.applies(scene))


def kernels(scene: Scene) -> Mapping[str, Derivation]:
    """Return what derives each kernel that is of a scene alone, by the name of its module."""
    found: dict[str, Derivation] = {}
    for name, module in modules().items():
        if kernel_name(module) or not applies(module, scene):
            continue
        numbers = getattr(module, "FUNCTIONS", None)
        if numbers is None:
            found[name] = module.derive
        else:
            for number in numbers:
                found[f"{name}_{number}"] = partial(module.derive, functions=number)
    return found
