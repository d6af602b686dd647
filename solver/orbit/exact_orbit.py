"""The exact motion of a case, made of the closed-form flow of its phases."""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from ..arrays import Vector
from ..bodies.exact import left_open, magnitudes
from ..flow.exact_system import exact_kernel
from ..iteration.newton import ITERATION_LIMIT, Outcome, newton
from ..kernels.kernel import Kernel
from ..kernels.start import RoughTimes, solved
from ..scenes.bodies.cell import BodyCell
from ..scenes.case import Case
from ..simulation.followers import not_followed
from . import admissible
from .shown import Shown

#: Rounding error of a sum over modes, relative to the sum of the moduli of its terms.
NOISE = 256 * float(np.finfo(float).eps)

#: Differences of times, relative to the largest, between solutions of a body that are the same;
#: and between any that differ by rounding.
SAME, EQUAL = 1e-11, 1e-13

#: Largest residual of an orbit, relative to its terms, or of a body to its states.
CLOSED = 1e-8

#: Largest unknown of one mass beside which rounding leaves digits of a forcing of about 1.
LARGEST = 1e12

#: Most iterations for one mass: each lengthens a phase by a limited factor, and one may last a
#: hundred million times as long as another.
LIMIT = 80


@dataclass(frozen=True, eq=False, repr=False)
class ExactOrbit(Shown):
    """The exact periodic orbit of a case, from the closed-form flow of its phases.

    Parameters
    ----------
    outcome : Outcome
        States and times without units, and how Newton's method found them.
    """

    case: Case
    outcome: Outcome

    @cached_property
    def _kernel(self) -> Kernel:
        return exact_kernel(self.case.cell)

    def _least_sizes(self, p: int) -> Vector | float:
        """Return sizes below which signals of a body on phase `p` are mostly rounding."""
        cell = self.case.cell
        if not isinstance(cell, BodyCell):
            return 0.0
        return magnitudes(cell, self.times, p) * (NOISE / admissible.ROUNDING)

    @cached_property
    def violations(self) -> tuple[str, ...]:
        """Why the solution is not an orbit, in words; empty if it is one."""
        cell = self.case.cell
        opening = self._left_open if self.outcome.converged else 0.0
        if not opening <= CLOSED:
            return (f"it does not close: by {opening:.3g} of its size",)
        reasons = admissible.violations(self) or not_followed(self)
        if not reasons and cell.forced and np.abs(self.outcome.unknowns).max() > LARGEST:
            return ("its motion is so large that what drives it is lost in rounding",)
        return reasons

    @property
    def _left_open(self) -> float:
        """The largest residual, relative to its terms; of a body see `bodies.exact`."""
        cell, z = self.case.cell, self.outcome.unknowns
        if isinstance(cell, BodyCell):
            return left_open(cell, self.times)
        R, J = np.empty(len(z)), np.empty((len(z), len(z)))
        with np.errstate(all="ignore"):
            self._kernel.residual(cell, z, R)
            self._kernel.jacobian(cell, z, J)
            terms = np.abs(J) @ np.abs(z) + np.abs(z).max()
            return float((np.abs(R) / terms).max())

    @cached_property
    def admissible(self) -> bool:
        """Whether the solution is an orbit: nothing in `violations`.

        Times of orbits are kept: expansions of all orders lead to the same solution, and to
        judge it takes longer than to find it.
        """
        times, admitted = self.times, _admitted(self.case)
        if any(np.abs(q - times).max() <= EQUAL * np.abs(times).max() for q in admitted):
            return True
        is_orbit = not (admissible.seen_violated(self) or self.violations)
        if is_orbit and self.outcome.converged:
            admitted.append(times)
        return is_orbit

    @property
    def label(self) -> str:
        """Name in a legend."""
        return "exact"

    @property
    def look(self) -> None:
        """Style of its curve in pictures: None, the one of all exact orbits."""

    def __repr__(self) -> str:
        return f"<exact orbit of {self.case.scene.label}: {self._times}{self._verdict}>"


def from_times(case: Case, start: RoughTimes) -> ExactOrbit:
    """Return the result of Newton's method from rough times; `admissible` tells if an orbit."""
    kernel = exact_kernel(case.cell)
    times = np.array([*start.durations, *([start.angle] if kernel.forced else [])])
    with kernel.spending():
        limit = ITERATION_LIMIT if case.scene.has_body else LIMIT
        outcome = solved(kernel, case.cell, kernel.size(1), times, limit)
    orbit = case.presented(ExactOrbit(case, outcome))
    return _kept(orbit) if kernel.condensed else orbit


@lru_cache(maxsize=8)
def _admitted(case: Case) -> list[Vector]:
    """Return the list, filled by `ExactOrbit.admissible`, of the times of orbits of a case."""
    return []


@lru_cache(maxsize=8)
def _solutions(case: Case) -> list[ExactOrbit]:
    """Return the list, filled by `_kept`, of converged solutions of a case."""
    return []


def _kept(orbit: ExactOrbit) -> ExactOrbit:
    """Return the same solution found earlier, with its cached properties; else the new one.

    To judge a solution of a body takes long, and expansions of all orders lead to the same one.
    """
    if not orbit.outcome.converged:
        return orbit
    earlier, times = _solutions(orbit.case), orbit.times
    for other in earlier:
        if np.abs(other.times - times).max() <= SAME * np.abs(times).max():
            return other
    earlier.append(orbit)
    return orbit


def of_unknowns(case: Case, z: Vector) -> ExactOrbit:
    """Return the result of Newton's method from unknowns of the exact equations."""
    kernel = exact_kernel(case.cell)
    with kernel.spending():
        outcome = newton(kernel.iterate, case.cell, z)
    return case.presented(ExactOrbit(case, outcome))
