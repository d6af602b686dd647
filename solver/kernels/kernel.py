"""Kernels of a scene: residual, Jacobian, motion of one method, and Newton's method for them.

A kernel may come from a generated module, plain or compiled, or be made in place, as the exact
equations are.  Compiled functions stand in numba's cache under names that carry a hash of all
that is compiled with them, so that a change finds nothing old.
"""

import hashlib
import types
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from ..arrays import Matrix, Vector
from ..compiling import PLAIN_ORDER, Account, jit, rebuilt
from ..iteration import condensed, iteration
from ..iteration.iteration import Iteration
from ..scenes.method_names import with_class_one
from .linking import CALLS, CALLS_OF_SEVERAL, driver_text, iteration_of, linked

#: What a kernel does that only NumPy can: plain Python, even where the rest is compiled.
PLAIN = (
    "motion", "coefficients", "integrated", "phase_motion",
    "once", "residual_once", "jacobian_once",
)  # fmt: skip


@dataclass(frozen=True)
class Kernel:
    """The equations of one method for one scene over arrays, and their solver.

    Parameters
    ----------
    method : str
        Generic name.
    durations : int
        Phases of the cell: so many unknowns behind the coefficients are durations.
    forced : bool
        Whether the last unknown is the phase of the forcing.
    lowest : int
        The lowest order.
    size, residual, jacobian, motion, coefficients : callable
        As the generated modules have them.
    iterate : callable
        ``iterate(case, z, limit)``: `iteration.iterate_scene` for these, or, if `condensed`,
        `condensed.iterate_condensed`.
    condensed : bool
        Whether it starts from the times in ``z`` alone.
    account : Account or None
        What it has cost as plain Python; None of what is compiled, or has no other form.
    starts : bool
        Whether the scene's start is imposed in place of the event that ends the first phase.
    """

    method: str
    durations: int
    forced: bool
    lowest: int
    size: Callable[[int], int]
    residual: Callable[[Any, Vector, Vector], None]
    jacobian: Callable[[Any, Vector, Matrix], None]
    motion: Callable[[Any, Vector, int, Vector, int], Vector]
    coefficients: Callable[[Vector], dict[str, tuple[Any, int]]]
    iterate: Iteration
    condensed: bool = False
    account: Account | None = None
    starts: bool = False

    def times(self, z: Vector) -> Vector:
        """Return the durations and, if the scene is forced, the phase of the forcing."""
        return z[len(z) - self.durations - self.forced :]

    def split(self, z: Vector) -> tuple[Vector, float]:
        """Return the durations, and the phase of the forcing or 0."""
        times = self.times(z)
        return times[: self.durations], float(times[-1]) if self.forced else 0.0


@cache
def plain(module: types.ModuleType) -> Kernel:
    """Return the kernel of a generated module as plain Python."""
    return _kernel(module, vars(module), iteration_of(vars(module), rebuilt), account(module))


@cache
def once_continuous(module: types.ModuleType) -> Kernel | None:
    """Return the kernel for functions of class C^1, where a smoother scene's module has it.

    Accelerations are polynomials of degree N on each phase, tested to degree N, and need not be
    continuous.  Order, size and sequence of the unknowns are those of the module; it is wanted
    where the module's own conditions are singular, and rarely: so it stays plain Python.
    """
    if not hasattr(module, "residual_once"):
        return None
    found, functions = plain(module), (module.residual_once, module.jacobian_once)
    return replace(
        found,
        method=with_class_one(found.method),
        residual=functions[0],
        jacobian=functions[1],
        iterate=linked(*functions, found.durations, found.forced),
        condensed=False,
        account=None,
    )


@cache
def account(module: types.ModuleType) -> Account:
    """Return what the kernel of a module has cost in plain Python."""
    entry = condensed.iterate_condensed if "bands" in vars(module) else iteration.iterate_scene
    return Account(entry.__code__.co_filename, f"{entry.__name__}_{fingerprint(module)}")


def quicker(module: types.ModuleType, order: int = 0) -> Kernel:
    """Return the kernel of a module in the form that is the better one by now.

    Parameters
    ----------
    module : module
        Generated.
    order : int
        For which it is wanted: of a high order it is compiled from the first, if it is in
        numba's cache.
    """
    spent = account(module)
    wanted = spent.pays() or (order > PLAIN_ORDER and spent.is_cached())
    return compiled(module) if wanted else plain(module)


@cache
def compiled(module: types.ModuleType) -> Kernel:
    """Return the kernel of a generated module compiled by numba, cached where possible."""
    namespace = dict(vars(module))
    own = [
        value
        for name, value in vars(module).items()
        if isinstance(value, types.FunctionType) and name not in PLAIN
    ]
    key = fingerprint(module)
    calls = CALLS if namespace.get("KEPT") == 1 else CALLS_OF_SEVERAL

    def compiled_one(function: Any, names: dict[str, Any]) -> Any:
        clone = rebuilt(function, names)
        clone.__qualname__ = f"{function.__name__}_{key}"
        return jit(clone, inlined=function.__name__ not in calls)

    for function in own:
        namespace[function.__name__] = compiled_one(function, namespace)
    account(module).is_compiled = True
    return _kernel(module, namespace, iteration_of(namespace, compiled_one))


def fingerprint(module: types.ModuleType) -> str:
    """Return a hash of all that is compiled for a generated module, the driver included.

    The name of the module is part of it: numba imports it again with what it has cached.
    """
    own = f"{module.__name__} {module.BODY} {module.DURATIONS} {module.FORCED}".encode()
    return hashlib.sha256(own + driver_text()).hexdigest()[:16]


def _kernel(
    module: types.ModuleType,
    functions: dict[str, Any],
    iterate: Iteration,
    spent: Account | None = None,
) -> Kernel:
    names = ("size", "residual", "jacobian", "motion", "coefficients")
    return Kernel(
        method=str(module.METHOD).partition(",")[0],
        durations=int(module.DURATIONS),
        forced=bool(module.FORCED),
        lowest=int(getattr(module, "LOWEST", 1)),
        iterate=iterate,
        condensed="bands" in functions,
        starts=bool(getattr(module, "STARTS", False)),
        account=spent,
        **{name: functions[name] for name in names},
    )
