"""The exact orbits of a case of one motion that can be listed: all of them, some, or none.

Where a forcing fixes the duration of a cell, the exact equations have solutions that can be
listed: of one free phase in closed form (see `one_phase`), of two by the roots of one function
of one duration (see `two_phases`).  If the list is complete and has no orbit, it is proved that
there is none.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from ..arrays import Vector
from ..flow.exact_system import exact_kernel
from ..iteration.newton import Outcome
from ..kernels.start import RoughTimes
from ..orbit.admissible import Undecided, are_same, seen_violated
from ..orbit.errors import times_apart
from ..orbit.exact_orbit import ExactOrbit, from_times
from ..scenes.bodies.cell import BodyCell
from ..scenes.case import Case
from ..scenes.ordered import OrderedScene
from . import bodies, one_phase, two_phases

#: Difference of times, relative to a cell, below which two solutions are the same.
SAME = 1e-11

#: How far Newton's method may move from a root, relative to a cell, to the same solution;
#: difference in the phase of the forcing of two orbits that are the same.
NEAR = 1e-6


@dataclass(frozen=True)
class Known:
    """Solutions of the exact equations of a case.

    Parameters
    ----------
    orbits : tuple of ExactOrbit
        The admissible ones, the stable ones first.
    refused : tuple of ExactOrbit
        Those that violate a demand.
    complete : bool
        Whether it is proved that there are no others.
    infinite : bool
        Whether there are infinitely many, none of them isolated.
    listed : bool
        Whether they were listed, as far as float64 allows: a search from a grid finds no more.
    """

    orbits: tuple[ExactOrbit, ...] = ()
    refused: tuple[ExactOrbit, ...] = ()
    complete: bool = False
    infinite: bool = False
    listed: bool = False

    @property
    def none(self) -> bool:
        """Whether it is proved that there is no orbit."""
        return self.complete and not self.orbits


@lru_cache(maxsize=64)
def known(case: Case) -> Known:
    """Return the exact solutions of a case of one motion, as far as they can be listed.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> found = known(registry.load("clearance")())
    >>> len(found.orbits), len(found.refused), found.complete
    (1, 1, True)
    """
    cell = case.cell
    if isinstance(cell, BodyCell):
        found = isinstance(case.scene, OrderedScene) and cell.forced  # by simulations
        if found and not bodies.listed(cell):
            return Known()
        roots = list(bodies.solutions(case))
        return replace(_sorted(roots, bodies.complete(cell, roots)), listed=bodies.listed(cell))
    if one_phase.applies(cell):
        closed = one_phase.solutions(cell)
        roots = [_of_state(case, q) for q in closed.states]
        complete = closed.none or bool(roots)
        return replace(_sorted(roots, complete), infinite=closed.infinite, listed=True)
    if not two_phases.applies(cell):
        return Known()
    scan = two_phases.solutions(cell)
    orbits: list[ExactOrbit] = []
    known_times: list[Vector] = []
    complete = scan.complete
    for start in (*scan.certain, *scan.doubtful):
        orbit = from_times(case, RoughTimes(*start, "the scan"))
        near = orbit.outcome.converged and times_apart(orbit, *start) <= NEAR
        if near and not _is_among(orbit, known_times):
            orbits.append(orbit)
            known_times.append(orbit.times)
        elif start in scan.certain:
            complete = False
    return replace(_sorted(orbits, complete), listed=True)


@lru_cache(maxsize=64)
def searched(case: Case) -> tuple[RoughTimes, ...]:
    """Return the times of the orbits of a body to which starts on a grid lead; see `bodies`.

    For orders that a scene does not declare; without a forcing `known` has them.
    """
    orbits = (q for q in bodies.solutions(case) if q.admissible) if case.cell.forced else ()
    return tuple(
        RoughTimes(tuple(map(float, q.cell_durations)), q.angle, "several starts")
        for q in orbits
    )


def known_orbits(case: Case) -> list[ExactOrbit]:
    """Return the orbits that are known of each motion of a case, the stable ones first."""
    return stable_first(
        replace(orbit, case=each) if orbit.case.scene.folder != each.scene.folder else orbit
        for each in case.each_motion
        for orbit in known(each).orbits
    )  # a copy of a scene compares equal, but may have other methods


def others(orbit: ExactOrbit) -> list[ExactOrbit]:
    """Return the other known orbits of the same oscillator, of any motion."""
    case, scene = orbit.case, orbit.case.scene.whole
    if scene.half_period and case.cycles % 2 == 0:  # no motion of the scene has that period
        return []
    every = known_orbits(Case(scene, case.values, case.cycles))
    return [other for other in every if not are_one(orbit, other)]


def are_one(orbit: ExactOrbit, other: ExactOrbit) -> bool:
    """Whether two orbits are the same, whichever phase each begins with.

    The same motion at another phase of the forcing is a different orbit.
    """
    phases, rate = other.phases, other.case.cell.omega / other.case.units.time
    if len(phases) != len(orbit.phases):
        return False
    for i in range(len(phases)):
        turned = orbit.angle - other.angle - rate * math.fsum(other.durations[:i])
        at_once = abs(math.remainder(turned, 2 * math.pi)) <= NEAR
        if at_once and are_same(orbit, [*phases[i:], *phases[:i]]):
            return True
    return False


def stable_first(orbits: Iterable[ExactOrbit]) -> list[ExactOrbit]:
    """Return orbits in their order, except that stable ones come first."""
    orbits = list(orbits)
    return orbits if len(orbits) < 2 else sorted(orbits, key=lambda q: q.stable is not True)


def _sorted(solutions: Iterable[ExactOrbit], complete: bool) -> Known:
    solutions = list(solutions)
    orbits = tuple(stable_first(q for q in solutions if q.admissible))
    refused = tuple(q for q in solutions if not q.admissible)
    return Known(orbits, refused, complete and all(map(_is_none, refused)))


def _is_none(solution: ExactOrbit) -> bool:
    """Whether a refused solution certainly violates a demand."""
    if seen_violated(solution):
        return True
    return any(not isinstance(why, Undecided) for why in solution.violations)


def _is_among(orbit: ExactOrbit, others: list[Vector]) -> bool:
    """Whether the times of an orbit are among those of others: there may be thousands."""
    if not others:
        return False
    off = np.abs(np.array(others) - orbit.times)
    off[:, -1] = np.abs((off[:, -1] + math.pi) % (2 * math.pi) - math.pi) / orbit.cell.omega
    return bool((off.max(axis=1) <= SAME * orbit.cell_durations.sum()).any())


def _of_state(case: Case, state: tuple[float, float, float]) -> ExactOrbit:
    """Return a solution in closed form as an orbit, admissible or not."""
    x, v, angle = state
    z, R = np.array([x, v, case.cell.duration, angle]), np.empty(4)
    exact_kernel(case.cell).residual(case.cell, z, R)
    norm = float(np.abs(R).max())
    return ExactOrbit(case, Outcome(z, True, 0, 0.0, norm, "converged"))
