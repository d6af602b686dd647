"""Kernels of a scene: residual, Jacobian, motion of one method, and Newton's method for them.

The functions are those of a generated module, plain or compiled, or, for the exact equations,
written by hand.  Compiled functions have names in numba's cache with a hash of all that is
compiled with them, so that no outdated one is found.
"""

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from typing import Any

from ..arrays import Matrix, Vector
from ..iteration.iteration import Iteration
from ..scenes.case import Case
from .account import Account
from .compiling import inner, rebuilt
from .linking import Make


@dataclass(frozen=True)
class Kernel:
    """The equations of one method for one scene over arrays, and their solver.

    Parameters
    ----------
    method : str
        Generic name.
    durations : int
        Number of phases of the cell; the durations follow the coefficients in the unknowns.
    forced : bool
        Whether the last unknown is the phase of the forcing.
    lowest : int
        The lowest order.
    size : callable
        ``size(order)``: number of unknowns.
    residual, jacobian, motion : callable
        ``residual(given, z, R)``, ``jacobian(given, z, J)``, and
        ``motion(given, z, p, u, derivative)``.
    coefficients : callable
        ``coefficients(z)``: unknowns by name, each with the power of 1/time in its unit.
    iterate : callable
        ``iterate(given, z, limit)``: Newton's method for these functions, as
        `iteration.iterate_scene` or, if `condensed`, `together.iterate_together`.
    given : callable
        ``given(case, order)``: the first argument of these functions.
    condensed : bool
        Whether `iterate` needs starting values of the times in ``z`` only.
    account : Account or None
        The time it has taken as plain Python; None if it is compiled, or has one form only.
    starts : bool
        Whether the scene's start is imposed in place of the event that ends the first phase.
    signals : callable, optional
        For a body, ``signals(given, z, p, u)``: the quantities of linear forms; see `Motion`.
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
    given: Callable[[Case, int], Any] = lambda case, order: case.cell
    condensed: bool = False
    account: Account | None = None
    starts: bool = False
    signals: Callable[[Any, Vector, int, Vector], Matrix] | None = None

    def spending(self) -> AbstractContextManager[None]:
        """Count the time of a ``with`` block in the kernel's account, if it has one."""
        return nullcontext() if self.account is None else self.account.spending()

    def times(self, z: Vector) -> Vector:
        """Return the durations and, if the scene is forced, the phase of the forcing."""
        return z[len(z) - self.durations - self.forced :]

    def split(self, z: Vector) -> tuple[Vector, float]:
        """Return the durations, and the phase of the forcing or 0."""
        times = self.times(z)
        return times[: self.durations], float(times[-1]) if self.forced else 0.0


def for_others(key: str) -> Make:
    """Return a `Make` that compiles functions for compiled callers; `key` is in their names."""

    def compiled_one(function: Any, names: dict[str, Any], counted: bool) -> Any:
        clone = rebuilt(function, names)
        clone.__qualname__ = f"{function.__name__}_{key}"
        return inner(clone, counted=counted)

    return compiled_one
