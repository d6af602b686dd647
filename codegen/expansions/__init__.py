"""Sets of functions, a file each: what a motion is expanded in, and what it is tested with.

None knows an oscillator.  A file has `METHOD`, `TITLE` and ``derive(scene)``; one whose
``derive`` takes a number of functions besides says in `FUNCTIONS` which there may be.
"""

import importlib
import pkgutil
from collections.abc import Callable, Mapping
from functools import cache, partial

from ..galerkin import GalerkinConditions
from ..scene import Scene

Derivation = Callable[[Scene], GalerkinConditions]


@cache
def kernels() -> Mapping[str, Derivation]:
    """Return what derives each kernel of a scene, by the name of its module."""
    found: dict[str, Derivation] = {}
    for entry in pkgutil.iter_modules(__path__):
        module = importlib.import_module(f"{__name__}.{entry.name}")
        numbers = getattr(module, "FUNCTIONS", None)
        if numbers is None:
            found[entry.name] = module.derive
        else:
            for number in numbers:
                found[f"{entry.name}_{number}"] = partial(module.derive, functions=number)
    return found
