"""Kernels of a scene: residual, Jacobian, motion of one method, and Newton's method for them.

They come from a generated module, plain or compiled, or are made in place, as the exact
equations are.  Compiled functions stand in numba's cache under names that carry a hash of all
that is compiled with them, so that a change finds nothing old.
"""

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from typing import Any

from ..arrays import Matrix, Vector
from ..iteration.iteration import Iteration
from ..scenes.case import Case
from .compiling import Account, inner, rebuilt
from .linking import Make


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
    signals : callable, optional
        Of a body, ``signals(given, z, p, u)``: all that linear forms are of.
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
        """Count the time within as what the kernel costs in plain Python."""
        return nullcontext() if self.account is None else self.account.spending()

    def times(self, z: Vector) -> Vector:
        """Return the durations and, if the scene is forced, the phase of the forcing."""
        return z[len(z) - self.durations - self.forced :]

    def split(self, z: Vector) -> tuple[Vector, float]:
        """Return the durations, and the phase of the forcing or 0."""
        times = self.times(z)
        return times[: self.durations], float(times[-1]) if self.forced else 0.0


def for_others(key: str) -> Make:
    """Return what compiles functions for others, under names with a key of all they are of."""

    def compiled_one(function: Any, names: dict[str, Any], counted: bool) -> Any:
        clone = rebuilt(function, names)
        clone.__qualname__ = f"{function.__name__}_{key}"
        return inner(clone, counted=counted)

    return compiled_one
