"""Kernels of a scene: residual, Jacobian, motion of one method, and Newton's method for them.

A kernel may come from a generated module, plain or compiled, or be made in place, as the exact
equations are.  Compiled functions stand in numba's cache under names that carry a hash of all
that is compiled with them, so that a change finds nothing old.
"""

import hashlib
import types
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

from ..arrays import Matrix, Vector
from ..compiling import PLAIN_ORDER, Account, jit, rebuilt
from ..iteration import iteration
from ..iteration.iteration import Iteration
from ..scenes.case import Case
from .linking import NEWTON, PLAIN, Make, newton_of, text_of


def _numbers(case: Case, order: int) -> Any:
    """Return what the functions of a module of one scene call the case."""
    return case.arguments


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
    size : callable
        Number of unknowns of an order.
    residual, jacobian, motion : callable
        ``residual(given, z, R)``, ``jacobian(given, z, J)``, and
        ``motion(given, z, p, u, derivative)``.
    coefficients : callable
        Unknowns by name, each with the power of 1/time in its unit.
    iterate : callable
        ``iterate(given, z, limit)``: `iteration.iterate_scene` for these, or, if `condensed`,
        `together.iterate_together`.
    given : callable
        ``given(case, order)``: what these functions take for a case.
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
    given: Callable[[Case, int], Any] = _numbers
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


def pays(spent: Account, order: int) -> bool:
    """Return whether the next use of a kernel is better by its compiled form.

    Parameters
    ----------
    spent : Account
        What it has cost.
    order : int
        For which it is wanted: of a high order it is compiled from the first, if it is in
        numba's cache.
    """
    return spent.pays() or (order > PLAIN_ORDER and spent.is_cached())


def compiling(key: str) -> Make:
    """Return what compiles functions under names with a key of all that they are made from."""

    def compiled_one(function: Any, names: dict[str, Any]) -> Any:
        clone = rebuilt(function, names)
        clone.__qualname__ = f"{function.__name__}_{key}"
        return jit(clone)

    return compiled_one


#: Stand for those of a generated module.
DURATIONS, FORCED = 1, False


def times_of(case: Any) -> tuple[int, int]:
    """Return how many durations are unknown, and 1 if the phase of the forcing is, else 0."""
    return DURATIONS, 1 if FORCED else 0


@cache
def plain(module: types.ModuleType) -> Kernel:
    """Return the kernel of a generated module of one scene as plain Python."""
    return _kernel(module, vars(module), rebuilt, account(module))


@cache
def account(module: types.ModuleType) -> Account:
    """Return what the kernel of a module has cost in plain Python."""
    entry = iteration.iterate_scene
    return Account(entry.__code__.co_filename, f"{entry.__name__}_{fingerprint(module)}")


@cache
def compiled(module: types.ModuleType) -> Kernel:
    """Return the kernel of a generated module compiled by numba, cached where possible."""
    namespace, make = dict(vars(module)), compiling(fingerprint(module))
    for name, value in vars(module).items():
        if isinstance(value, types.FunctionType) and name not in PLAIN:
            namespace[name] = make(value, namespace)
    account(module).is_compiled = True
    return _kernel(module, namespace, make)


def fingerprint(module: types.ModuleType) -> str:
    """Return a hash of all that is compiled for a generated module, the driver included.

    The name of the module is part of it: numba imports it again with what it has cached.
    """
    own = f"{module.__name__} {module.BODY} {module.DURATIONS} {module.FORCED}".encode()
    return hashlib.sha256(own + text_of(*NEWTON)).hexdigest()[:16]


def _kernel(
    module: types.ModuleType,
    functions: dict[str, Any],
    make: Make,
    spent: Account | None = None,
) -> Kernel:
    names = ("size", "residual", "jacobian", "motion", "coefficients")

    own = {name: functions[name] for name in names}
    return Kernel(
        method=str(module.METHOD).partition(",")[0],
        durations=int(module.DURATIONS),
        forced=bool(module.FORCED),
        lowest=int(getattr(module, "LOWEST", 1)),
        iterate=newton_of(own["residual"], own["jacobian"], make(times_of, functions), make),
        account=spent,
        **own,
    )
