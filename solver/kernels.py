"""Load the generated kernels of a method: as plain Python, or compiled by numba.

Both are the same functions of the same file and give the same bits.  Plain Python is
quicker for a single orbit of moderate order, because importing numba and loading what it
cached takes more than a second; compiled kernels are for many orbits.
"""

import importlib
import types
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

from .arrays import Matrix, Vector

#: Modules of ``generated/`` by method.
MODULES = {"hb": "hb", "hb-c1": "hb_c1", "c1": "c1", "c1-reduced": "c1_reduced"}


@dataclass(frozen=True)
class Kernel:
    """Residual and Jacobian of one method over arrays, filled in place.

    Parameters
    ----------
    residual : callable
        ``residual(alpha, z, R)``.
    jacobian : callable
        ``jacobian(alpha, z, J)``.
    size : callable
        ``size(N)``, the number of unknowns at order ``N``.
    """

    residual: Callable[[float, Vector, Vector], None]
    jacobian: Callable[[float, Vector, Matrix], None]
    size: Callable[[int], int]


def module(method: str) -> types.ModuleType:
    """Return the generated module of a method."""
    package = __package__.rpartition(".")[0]
    return importlib.import_module(f"{package}.generated.{MODULES[method]}")


@cache
def plain(method: str) -> Kernel:
    """Return the kernel of `method` as plain Python."""
    source = module(method)
    return Kernel(source.residual, source.jacobian, source.size)


@cache
def compiled(method: str) -> Kernel:
    """Return the kernel of `method` compiled by numba, cached on disk where possible."""
    functions = compiled_functions(method)
    return Kernel(functions["residual"], functions["jacobian"], functions["size"])


@cache
def compiled_functions(method: str) -> dict[str, Any]:
    """Return every function of the generated module of `method`, compiled, by name."""
    return compile_functions(module(method))


def compile_functions(source: types.ModuleType) -> dict[str, Any]:
    """Return the functions of a generated module compiled by numba, by name.

    A function that calls another must find it compiled, so each is rebuilt over a
    namespace of its own.  Its name in numba's cache carries the hash of the module's
    text: after a regeneration nothing old can be found, whatever the clock says.

    Parameters
    ----------
    source : module
        One of ``generated/``; its functions are in the order in which they call.
    """
    namespace = dict(vars(source))
    if "prange" in namespace:
        from numba import prange  # noqa: PLC0415

        namespace["prange"] = prange
    for name, function in vars(source).items():
        if isinstance(function, types.FunctionType):
            clone = types.FunctionType(function.__code__, namespace, name)
            clone.__module__ = function.__module__
            clone.__qualname__ = f"{name}_{source.BODY[:16]}"
            namespace[name] = _jit(clone)
    return namespace


def _jit(function: types.FunctionType) -> Any:
    """Return `function` compiled; uncached where no folder for the cache is writable."""
    import numba  # noqa: PLC0415  (750 ms, for compiled kernels only)

    options: dict[str, Any] = {
        "error_model": "numpy",
        "parallel": "prange" in function.__code__.co_names,
    }
    try:
        return numba.njit(cache=True, **options)(function)
    except RuntimeError:
        return numba.njit(**options)(function)
