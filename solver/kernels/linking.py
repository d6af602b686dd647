"""Linking of a kernel's functions and Newton's method over one namespace, plain or compiled."""

import builtins
import cmath
import dis
import math
import sys
import types
from collections.abc import Callable, Container, Sequence
from functools import cache
from pathlib import Path
from typing import Any, get_args, get_origin

from ...generated import hb
from ..arrays import Complex, Indices, Integers, Matrix, Vector
from ..iteration import by_rows, iteration, linear, single
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

#: Modules of motions that are polynomials on each phase; the same with their condensation.
POLYNOMIALS = (moments, joints, polynomials)
MAPS = (band, linear, series, series_rates, alone, one_by_one, together, *POLYNOMIALS)

#: Modules of motions that are one series over the period; the same with one function added.
SERIES = (hb, moments, harmonics, joints, fourier, orthogonality, breaking, whole_period)
WITH_ONE = (*SERIES, one_function)

#: Attributes, of modules and of numbers, whose use allocates no array.
OF_NUMBERS = {"conjugate", "imag", "real", "shape"}.union(vars(cmath), vars(math))

#: Arrays, as functions return them.
ARRAYS = (Vector, Matrix, Complex, Integers, Indices)

#: ``make(function, namespace, counted)``: a function over a namespace, plain or compiled;
#: `counted` if it may allocate arrays.
Make = Callable[[Any, dict[str, Any], bool], Any]


def newton_with(
    residual: Any, jacobian: Any, times_of: Any, make: Make, **constants: float
) -> dict[str, Any]:
    """Return the functions of Newton's method, linked to those of a system of equations.

    `constants` replace those of the modules.
    """
    system = {"residual": residual, "jacobian": jacobian, "times_of": times_of}
    modules = (*SEVERAL, by_rows) if make is rebuilt else SEVERAL
    return made(modules, system | constants, make, of_numbers=system)


def times_of(case: Any) -> tuple[int, int]:
    """Return the number of unknown durations, and 1 if the case is forced, else 0."""
    return len(case[0]), 1 if case[4][2] != 0 else 0


def solved_by_newton(
    modules: tuple[types.ModuleType, ...], equations: types.ModuleType, make: Make
) -> dict[str, Any]:
    """Return the functions of modules and one of equations, with Newton's method for them."""
    functions = made((*modules, equations), {}, make)
    system = functions["residual"], functions["jacobian"], make(times_of, functions, False)
    return functions | {"iterate": newton_with(*system, make)["iterate_scene"]}


def phase_maps(equations: types.ModuleType, make: Make) -> dict[str, Any]:
    """Return the functions of motions that are polynomials on each phase.

    With a generated module of equations, their condensation, and Newton's method for it.
    """
    functions = made((*MAPS, equations), {}, make)
    residual, jacobian = functions["together_residual"], functions["together_jacobian"]
    changed = {"FAST": together.FAST, "AGAIN": together.AGAIN}
    newton = newton_with(residual, jacobian, functions["times_of"], make, **changed)
    functions["iterate_within"] = newton["iterate_within"]
    event = {"residual": functions["event_residual"], "jacobian": functions["event_rate"]}
    functions["iterate_single"] = made(ONE, event, make, of_numbers=event)["iterate_single"]
    return functions | {"iterate": functions["iterate_together"]}


def made(
    modules: tuple[types.ModuleType, ...],
    given: dict[str, Any],
    make: Make,
    *,
    of_numbers: Container[str] = (),
) -> dict[str, Any]:
    """Return the joint namespace of modules and `given`, with functions made over it.

    Later modules replace names of earlier ones, `given` replaces both.  Placeholders, functions
    that raise NotImplementedError, are not made: they are `given`, or put in later.

    Parameters
    ----------
    of_numbers : container of str
        The functions among `given` that return no arrays.
    """
    namespace: dict[str, Any] = {"__builtins__": builtins}  # NumPy's imports need it
    for module in modules:
        namespace |= {name: q for name, q in vars(module).items() if not name.startswith("__")}
    functions = {
        name: value
        for module in modules
        for name, value in vars(module).items()
        if isinstance(value, types.FunctionType)
        and value.__module__ == module.__name__
        and "NotImplementedError" not in value.__code__.co_names
    }
    callables = {name for name, q in given.items() if callable(q) and name not in of_numbers}
    counted = set(functions) if make is rebuilt else with_arrays(functions, callables)
    for name, value in functions.items():
        namespace[name] = make(value, namespace, name in counted)
    namespace |= given
    return namespace


def with_arrays(functions: dict[str, types.FunctionType], callables: set[str]) -> set[str]:
    """Return the names of functions that may allocate or own arrays, or call one that may.

    The `callables`, of which nothing is known, are among them.
    """
    owners, known = set(callables), set(OF_NUMBERS)
    for value in functions.values():
        known |= {
            field for q in vars(sys.modules[value.__module__]).values() for field in fields(q)
        }
    for name, value in functions.items():
        kinds = value.__annotations__
        lists = not {list, Sequence}.isdisjoint(map(get_origin, kinds.values()))
        if lists or holds_arrays(kinds.get("return")) or not attributes(value) <= known:
            owners.add(name)
    new = owners
    while new:
        calling = ((name, value.__code__.co_names) for name, value in functions.items())
        new = {name for name, used in calling if not owners.isdisjoint(used)} - owners
        owners |= new
    return owners


def fields(kind: Any) -> set[str]:
    """Return the names of the fields of a `NamedTuple`, and of those in it; else none."""
    if not (isinstance(kind, type) and hasattr(kind, "_fields")):
        return set()
    return set(kind.__annotations__).union(*map(fields, kind.__annotations__.values()))


def holds_arrays(annotation: Any) -> bool:
    """Return whether what a function returns may hold arrays, as far as its type says so."""
    parts = map(holds_arrays, get_args(annotation))
    return annotation in ARRAYS or bool(fields(annotation)) or any(parts)


def attributes(function: types.FunctionType) -> set[str]:
    """Return the names of all attributes that a function uses."""
    return {
        instruction.argval
        for instruction in dis.get_instructions(function)
        if instruction.opname in ("LOAD_ATTR", "LOAD_METHOD")
    }


@cache
def text_of(*modules: types.ModuleType) -> bytes:
    """Return the source text of modules that are compiled together."""
    return b"".join(Path(str(module.__file__)).read_bytes() for module in modules)
