"""Functions of a kernel and Newton's method, linked to each other: plain, or compiled."""

import builtins
import cmath
import dis
import math
import types
from collections.abc import Callable, Container
from functools import cache
from pathlib import Path
from typing import Any

from ...generated import hb
from ..arrays import Complex, Matrix, Vector
from ..iteration import iteration, linear, single
from ..iteration.iteration import Iteration
from ..maps import alone, band, one_by_one, series, series_rates, together
from ..rows import (
    breaking,
    fourier,
    harmonics,
    joints,
    moments,
    one_function,
    orthogonality,
    polynomials,
    whole_period,
)
from .compiling import rebuilt

#: Modules of Newton's method, for several unknowns and for one.
SEVERAL, ONE = (linear, iteration), (single,)
NEWTON = SEVERAL + ONE

#: Modules of motions that are polynomials on each phase, and of the quick way to them.
POLYNOMIALS = (moments, joints, polynomials)
MAPS = (band, linear, series, series_rates, alone, one_by_one, together, *POLYNOMIALS)

#: Modules of motions that are one series over the period; of one function beside it.
SERIES = (hb, moments, harmonics, joints, fourier, orthogonality, breaking, whole_period)
WITH_ONE = (*SERIES, one_function)

#: Attributes, of modules and of numbers, that make no array.
OF_NUMBERS = {"imag", "real", "shape"}.union(vars(cmath), vars(math))

#: Makes a function over a namespace, plain or compiled; `counted` is whether it makes arrays.
Make = Callable[[Any, dict[str, Any], bool], Any]


def linked(
    residual: Callable[[Any, Vector, Vector], None],
    jacobian: Callable[[Any, Vector, Matrix], None],
    durations: int,
    forced: bool,
    **constants: float,
) -> Iteration:
    """Return `iteration.iterate_scene` for a residual and Jacobian, as plain Python.

    With other constants, where some are given.
    """

    def times_of(case: Any) -> tuple[int, int]:
        return durations, int(forced)

    found = newton_with(residual, jacobian, times_of, rebuilt, **constants)
    iterate: Iteration = found["iterate_scene"]
    return iterate


def newton_with(
    residual: Any, jacobian: Any, times_of: Any, make: Make, **constants: float
) -> dict[str, Any]:
    """Return all functions of Newton's method for such functions, with other constants."""
    own = {"residual": residual, "jacobian": jacobian, "times_of": times_of}
    return made(SEVERAL, own | constants, make, of_numbers=own)


def times_of(case: Any) -> tuple[int, int]:
    """Return how many durations are unknown, and 1 if the phase of the forcing is, else 0."""
    return len(case[0]), 1 if case[4][2] != 0 else 0


def over_the_period(
    modules: tuple[types.ModuleType, ...], equations: types.ModuleType, make: Make
) -> dict[str, Any]:
    """Return the functions of modules and a generated one, and Newton's method on them."""
    found = made((*modules, equations), {}, make)
    own = found["residual"], found["jacobian"], make(times_of, found, False)
    return found | {"iterate": newton_with(*own, make)["iterate_scene"]}


def phase_maps(equations: types.ModuleType, make: Make) -> dict[str, Any]:
    """Return the functions of motions by a generated module, and the quick way to them."""
    found = made((*MAPS, equations), {}, make)
    residual, jacobian = found["together_residual"], found["together_jacobian"]
    changed = {"FAST": together.FAST, "AGAIN": together.AGAIN}
    newton = newton_with(residual, jacobian, found["times_of"], make, **changed)
    found["iterate_within"] = newton["iterate_within"]
    own = {"residual": found["event_residual"], "jacobian": found["event_rate"]}
    found["iterate_single"] = made(ONE, own, make, of_numbers=own)["iterate_single"]
    return found | {"iterate": found["iterate_together"]}


def made(
    modules: tuple[types.ModuleType, ...],
    given: dict[str, Any],
    make: Make,
    *,
    of_numbers: Container[str] = (),
) -> dict[str, Any]:
    """Return the content of modules and what is given, their functions made over all that.

    Functions with no body stand for those that are given, or put in later.  Those of the given
    that are `of_numbers` return no arrays.
    """
    namespace: dict[str, Any] = {"__builtins__": builtins}  # by which NumPy imports its own
    for module in modules:
        namespace |= {name: q for name, q in vars(module).items() if not name.startswith("__")}
    own = {
        name: value
        for module in modules
        for name, value in vars(module).items()
        if isinstance(value, types.FunctionType)
        and value.__module__ == module.__name__
        and "NotImplementedError" not in value.__code__.co_names
    }
    others = {name for name, one in given.items() if callable(one) and name not in of_numbers}
    makers = set(own) if make is rebuilt else with_arrays(own, others)
    for name, value in own.items():
        namespace[name] = make(value, namespace, name in makers)
    namespace |= given
    return namespace


def with_arrays(functions: dict[str, types.FunctionType], others: set[str]) -> set[str]:
    """Return which of some functions may make arrays, or take over arrays of what they call.

    Of the `others` nothing is known.
    """
    found = set(others)
    for name, value in functions.items():
        is_array = value.__annotations__.get("return") in (Vector, Matrix, Complex)
        if is_array or not attributes(value) <= OF_NUMBERS:
            found.add(name)
    more = found
    while more:
        calling = ((name, value.__code__.co_names) for name, value in functions.items())
        more = {name for name, used in calling if not found.isdisjoint(used)} - found
        found |= more
    return found


def attributes(function: types.FunctionType) -> set[str]:
    """Return the names of all attributes that a function uses."""
    return {
        instruction.argval
        for instruction in dis.get_instructions(function)
        if instruction.opname in ("LOAD_ATTR", "LOAD_METHOD")
    }


@cache
def text_of(*modules: types.ModuleType) -> bytes:
    """Return the text of what is compiled together."""
    return b"".join(Path(str(module.__file__)).read_bytes() for module in modules)
