"""Functions of a kernel and Newton's method, linked to each other: plain, or compiled."""

import types
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from ..arrays import Matrix, Vector
from ..iteration import iteration, linear, single
from ..iteration.iteration import Iteration
from ..maps import band, series, together
from .compiling import rebuilt

#: Modules of Newton's method, for several unknowns and for one.
SEVERAL, ONE = (linear, iteration), (single,)
NEWTON = SEVERAL + ONE

#: Modules of the quick way for motions that are polynomials on each phase.
MAPS = (band, linear, series, together)

#: What only NumPy can do: plain Python, even where the rest is compiled.
PLAIN = frozenset(("motion", "coefficients", "integrated", "phase_motion"))

#: Makes a function over a namespace, plain or compiled.
Make = Callable[[Any, dict[str, Any]], Any]


def linked(
    residual: Callable[[Any, Vector, Vector], None],
    jacobian: Callable[[Any, Vector, Matrix], None],
    durations: int,
    forced: bool,
) -> Iteration:
    """Return `iteration.iterate_scene` for a residual and Jacobian, as plain Python."""

    def times_of(case: Any) -> tuple[int, int]:
        return durations, int(forced)

    return newton_of(residual, jacobian, times_of, rebuilt)


def newton_of(
    residual: Any, jacobian: Any, times_of: Any, make: Make, **constants: float
) -> Iteration:
    """Return `iteration.iterate_scene` for such functions, all it calls made by `make`."""
    own = {"residual": residual, "jacobian": jacobian, "times_of": times_of}
    iterate: Iteration = made(SEVERAL, own | constants, make)["iterate_scene"]
    return iterate


def times_of(case: Any) -> tuple[int, int]:
    """Return how many durations are unknown, and 1 if the phase of the forcing is, else 0."""
    return len(case[0]), 1 if case[4][2] != 0 else 0


def whole_period(equations: types.ModuleType, make: Make) -> dict[str, Any]:
    """Return the functions of a generated module, and Newton's method on all its unknowns."""
    found = made((equations,), {}, make)
    own = found["residual"], found["jacobian"], make(times_of, found)
    return found | {"iterate": newton_of(*own, make)}


def phase_maps(equations: types.ModuleType, make: Make) -> dict[str, Any]:
    """Return the functions of a generated module, and the quick way to its solutions."""
    found = made((*MAPS, equations), {}, make)
    residual, jacobian = found["together_residual"], found["together_jacobian"]
    iterate = newton_of(residual, jacobian, found["times_of"], make, FAST=together.FAST)
    found["iterate_scene"] = iterate
    own = {"residual": found["event_residual"], "jacobian": found["event_rate"]}
    found["iterate_single"] = made(ONE, own, make)["iterate_single"]
    return found | {"iterate": found["iterate_together"]}


def made(
    modules: tuple[types.ModuleType, ...], given: dict[str, Any], make: Make
) -> dict[str, Any]:
    """Return the content of modules and what is given, their functions made over all that.

    Functions with no body stand for those that are given, or put in later.
    """
    namespace: dict[str, Any] = {}
    for module in modules:
        namespace |= {name: q for name, q in vars(module).items() if not name.startswith("__")}
    for module in modules:
        for name, value in vars(module).items():
            own = isinstance(value, types.FunctionType) and value.__module__ == module.__name__
            if own and "NotImplementedError" not in value.__code__.co_names:
                namespace[name] = value if name in PLAIN else make(value, namespace)
    namespace |= given
    return namespace


@cache
def text_of(*modules: types.ModuleType) -> bytes:
    """Return the text of what is compiled together."""
    return b"".join(Path(str(module.__file__)).read_bytes() for module in modules)
