"""Load the generated kernels of a method: as plain Python, or compiled by numba.

Both are the same functions of the same file and give the same bits.  Plain Python is
quicker for a single orbit of moderate order, because importing numba and loading what it
cached takes half a second; compiled kernels are for many orbits.  See `compiling`.
"""

import hashlib
import importlib
import types
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from ...arrays import Matrix, Vector
from ...compiling import PLAIN_ORDER, Account, jit, rebuilt
from ...iteration import linear
from . import newton

#: Modules of ``generated/``.
MODULES = {
    name: name.replace("-", "_") for name in ("hb", "hb-c1", "c1", "c1-reduced", "hb-symmetric")
}


@dataclass(frozen=True)
class Kernel:
    """Residual and Jacobian of one method over arrays, filled in place, and their solver.

    Parameters
    ----------
    residual : callable
        ``residual(case, z, R)``; ``case`` is ``alpha``, or what the module says.
    jacobian : callable
        ``jacobian(case, z, J)``.
    size : callable
        The number of unknowns: of the order, and of what else the module says.
    iterate : callable
        ``iterate(case, z, limit)``: `newton.iterate` for these two.
    functions : dict
        Every function of the generated module, by name.
    account : Account or None
        What it has cost as plain Python; None of what is compiled.
    """

    residual: Callable[[Any, Vector, Vector], None]
    jacobian: Callable[[Any, Vector, Matrix], None]
    size: Callable[..., int]
    iterate: newton.Iteration
    functions: dict[str, Any]
    account: Account | None = None


def module(method: str) -> types.ModuleType:
    """Return the generated module of a method."""
    package = __package__.rpartition(".solver")[0]
    return importlib.import_module(f"{package}.generated.shortcuts.{MODULES[method]}")


@cache
def plain(method: str) -> Kernel:
    """Return the kernel of `method` as plain Python."""
    functions = vars(module(method))
    iterate = plain_iteration(functions["residual"], functions["jacobian"])
    return _kernel({**functions, "iterate": iterate}, account(method))


def plain_iteration(
    residual: newton.Fill, jacobian: newton.Fill, *, compile_algebra: bool = False
) -> newton.Iteration:
    """Return `newton.iterate` for any residual and Jacobian, as plain Python.

    The linear algebra may be compiled nevertheless: for systems of hundreds.
    """
    namespace = {**vars(newton), "residual": residual, "jacobian": jacobian}
    if compile_algebra:
        functions = compiled_functions("c1")
        names = ("largest", "factorise", "solve_factorised")
        namespace |= {name: functions[name] for name in names}
    iterate: newton.Iteration = rebuilt(newton.iterate, namespace)
    return iterate


@cache
def compiled(method: str) -> Kernel:
    """Return the kernel of `method` compiled by numba, cached on disk where possible."""
    return _kernel(compiled_functions(method))


@cache
def account(method: str) -> Account:
    """Return what the kernel of `method` has cost in plain Python."""
    return Account(str(newton.__file__), f"iterate_{fingerprint(module(method))}")


def is_compiled(method: str) -> bool:
    """Return whether the solver of `method` is in numba's cache, as far as can be seen."""
    return account(method).is_cached()


def quicker(method: str) -> Kernel:
    """Return the kernel of `method` in the form that is the better one by now."""
    return compiled(method) if account(method).pays() else plain(method)


_COMPILED: dict[str, dict[str, Any]] = {}


def compiled_functions(method: str) -> dict[str, Any]:
    """Return every function of the generated module of `method`, compiled, by name."""
    if method not in _COMPILED:
        _COMPILED[method] = compile_functions(module(method))
        account(method).is_compiled = True
    return _COMPILED[method]


def functions_for(method: str, order: int) -> dict[str, Any]:
    """Return the functions of a module: compiled if they are already, or if it pays."""
    if order > PLAIN_ORDER or method in _COMPILED:
        return compiled_functions(method)
    return vars(module(method))


def _kernel(functions: dict[str, Any], spent: Account | None = None) -> Kernel:
    names = ("residual", "jacobian", "size", "iterate")
    found = {name: functions[name] for name in names}
    return Kernel(**found, functions=functions, account=spent)


#: The functions of `newton` that are compiled with a kernel, callers after what they call.
DRIVER = (
    newton.largest,
    newton.time_norm,
    newton.step_norm,
    newton.longest_step,
    linear.factorise,
    linear.solve_factorised,
    newton.iterate,
)


@cache
def _driver_text() -> bytes:
    """Return the text of what is compiled with every kernel."""
    return b"".join(Path(str(part.__file__)).read_bytes() for part in (newton, linear))


def fingerprint(source: types.ModuleType) -> str:
    """Return a hash of all that is compiled for a generated module, the driver included."""
    return hashlib.sha256(source.BODY.encode() + _driver_text()).hexdigest()[:16]


def compile_functions(source: types.ModuleType) -> dict[str, Any]:
    """Return the functions of a generated module, and its solver, compiled, by name.

    A function that calls another must find it compiled, so each is rebuilt over a
    namespace of its own.  Its name in numba's cache carries the hash of the module's text
    and of the driver's: after a change of either nothing old can be found, whatever the clock
    says.

    Parameters
    ----------
    source : module
        One of ``generated/``; its functions are in the order in which they call.
    """
    namespace = {**vars(newton), **vars(source)}
    if "prange" in namespace:
        from numba import prange  # noqa: PLC0415

        namespace["prange"] = prange
    own = [value for value in vars(source).values() if isinstance(value, types.FunctionType)]
    functions: tuple[Any, ...] = (*own, *DRIVER)
    key = fingerprint(source)
    for function in functions:
        clone = rebuilt(function, namespace)
        clone.__qualname__ = f"{function.__name__}_{key}"
        namespace[function.__name__] = jit(clone)
    return namespace
