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
from ..stability.in_words import in_words
from . import admissible
from .shown import Shown

#: What is rounding of a sum over modes, as a part of its terms added without sign.
NOISE = 256 * float(np.finfo(float).eps)

#: Differences of times, as a part of the largest, of the same solution of a body; of any one,
#: those that are rounding.
SAME, EQUAL = 1e-11, 1e-13

#: How far from closed a body may be, as a part of its states.
CLOSED = 1e-8

#: Most iterations for one mass: a step lengthens a phase by a part of itself, and one may last
#: a hundred million times as long as another.
LIMIT = 80


@dataclass(frozen=True, eq=False, repr=False)
class ExactOrbit(Shown):
    """The exact periodic orbit of a case, from the closed-form flow of its phases.

    Its outcome has states and times without units, and how Newton's method found them.
    """

    case: Case
    outcome: Outcome

    @cached_property
    def _kernel(self) -> Kernel:
        return exact_kernel(self.case.cell)

    @property
    def times(self) -> Vector:
        """Durations and, if something forces, the phase of the forcing; without units."""
        return self._kernel.times(self.outcome.unknowns)

    @property
    def memory_values(self) -> tuple[float, ...]:
        """What the switches of the cell set, without units."""
        count = len(self.case.cell.phases)
        found = self.outcome.unknowns[2 * count : 2 * count + len(self.case.cell.memory)]
        return tuple(map(float, found))

    def _least_sizes(self, p: int) -> Vector | float:
        cell = self.case.cell
        if not isinstance(cell, BodyCell):
            return 0.0
        return magnitudes(cell, self.times, p) * (NOISE / admissible.ROUNDING)

    @cached_property
    def violations(self) -> tuple[str, ...]:
        """What keeps the solution from being an orbit, in words."""
        cell = self.case.cell
        if isinstance(cell, BodyCell) and self.outcome.converged:
            apart = left_open(cell, self.times)
            if not apart <= CLOSED:
                return (f"it does not close: by {apart:.3g} of its size",)
        return admissible.violations(self) or not_followed(self)

    @cached_property
    def admissible(self) -> bool:
        """Whether the solution is an orbit: nothing in `violations`.

        All orders lead to the same solution, and to judge it takes longer than to find it: what
        differs from an orbit by rounding is one.
        """
        own, known = self.times, _admitted(self.case)
        if any(np.abs(each - own).max() <= EQUAL * np.abs(own).max() for each in known):
            return True
        found = not (admissible.is_seen_violated(self) or self.violations)
        if found and self.outcome.converged:
            known.append(own)
        return found

    @property
    def label(self) -> str:
        """What a legend calls it."""
        return "exact"

    @property
    def look(self) -> None:
        """Of its curves in pictures: None, those of every exact orbit."""

    @property
    def facts(self) -> dict[str, str]:
        """What a notebook shows."""
        found = super().facts
        head = {name: found.pop(name) for name in ("scene", "parameters")}
        return head | {"orbit": "exact"} | found | {"stability": in_words(self)}

    def __repr__(self) -> str:
        return f"<exact orbit of {self.case.scene.label}: {self._times}{self._verdict}>"


def from_times(case: Case, start: RoughTimes) -> ExactOrbit:
    """Return where Newton's method leads from rough times: an orbit only if it says so."""
    kernel = exact_kernel(case.cell)
    times = np.array([*start.durations, *([start.angle] if kernel.forced else [])])
    with kernel.spending():
        limit = ITERATION_LIMIT if case.scene.has_body else LIMIT
        outcome = solved(kernel, case.cell, kernel.size(1), times, limit)
    orbit = case.presented(ExactOrbit(case, outcome))
    return _kept(orbit) if kernel.condensed else orbit


@lru_cache(maxsize=8)
def _admitted(case: Case) -> list[Vector]:
    """Return the times of solutions of a case that are orbits: filled by others."""
    return []


@lru_cache(maxsize=8)
def _found(case: Case) -> list[ExactOrbit]:
    """Return the solutions of a case to which Newton's method led before: filled by others."""
    return []


def _kept(orbit: ExactOrbit) -> ExactOrbit:
    """Return the same solution as it was found before, with what was asked of it, if it was.

    Of a body every judgement takes long, and all orders lead to the same solution.
    """
    if not orbit.outcome.converged:
        return orbit
    before, own = _found(orbit.case), orbit.times
    for other in before:
        if np.abs(other.times - own).max() <= SAME * np.abs(own).max():
            return other
    before.append(orbit)
    return orbit


def of_unknowns(case: Case, z: Vector) -> ExactOrbit:
    """Return where Newton's method leads from unknowns of the exact equations."""
    kernel = exact_kernel(case.cell)
    with kernel.spending():
        outcome = newton(kernel.iterate, case.cell, z)
    return case.presented(ExactOrbit(case, outcome))
