"""Rough times for Newton's method from the periodic motion to which a simulation converges.

Where Newton's method fails from other rough times, a long simulation may find the order of the
phases, their durations and the phase of the forcing.  It finds stable orbits only.  It runs as
long as transients last by the damping, up to a number of phases.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache

from ..scenes.case import Case
from ..scenes.cell import Cell
from ..scenes.ordered import OrderedScene, of_all_phases, placed
from ..scenes.orders import declared_order
from .machines import machine_of
from .outcome import Settled, as_copies, nearly, outcome_of
from .record import Simulation
from .repeats import slowest_decay
from .segment import Segment
from .simulate import cycle
from .steps.state import AnyState
from .walk import Place, walk

#: Cycles that are simulated at first, and the factor by which they grow until they suffice.
CYCLES, LONGER = 100, 1.5

#: Number of time constants (decay by a factor e) for which a transient is followed.
DECAYS = 10

#: Most phases simulated from all starts together; long ones count as several.  About 3 s.
PHASES = 4000

#: The same, where orbits can be listed and a simulation tells what else there is; and for each
#: further state.
FEW = 500

#: Phases of the forcing at which motions start at rest, where those from 0 are inconclusive:
#: spread over a period, each far from those before.
ANGLES = tuple(2.4 * j % (2 * math.pi) for j in range(1, 6))


def rough_times_by_simulation(
    case: Case, *phases: int, widely: bool = False
) -> Iterator[Settled]:
    """Yield the outcomes of simulations of a case, from rest and from each constraint.

    Parameters
    ----------
    case : Case
    *phases : int
        Bounds of the phases that are simulated; default `PHASES`.  Of several, the later ones
        are for motions that do not settle within those before.
    widely : bool
        Whether other states follow where these do not suffice: see `from_several_states`.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> found = next(rough_times_by_simulation(registry.load("impact")()))
    >>> f"{found.times.angle:.6f}", found.words
    ('0.929644', 'a simulation settles on flight')
    """
    base = of_all_phases(case)
    simulated = from_several_states if widely else _from_rest
    for settled in simulated(case, *phases):
        yield settled if base is case else _in_that(case, base.cell, settled)


def _in_that(case: Case, base: Cell, settled: Settled) -> Settled:
    """Return the outcome of a simulation, with times for the order of phases of a case."""
    _, order = placed(case.scene)
    other = settled.other.within(case.cycles) if settled.other else None
    times = settled.times if order == declared_order(base) else None
    if other is not None:
        times = other.times_in(order, base) or times
    return replace(settled, times=times, other=None)


def from_several_states(case: Case, *phases: int) -> Iterator[Settled]:
    """Yield the outcomes of simulations of all phases that a case may have.

    After those of `rough_times_by_simulation`, if none is conclusive, or none settles on what
    is asked for, simulations from rest at other phases of the forcing follow; and if none
    settles on such an orbit with switches, simulations of a mass that is thrown.
    """
    base, outcomes = of_all_phases(case), []
    for settled in _from_rest(case, *phases):
        outcomes.append(settled)
        yield settled
    if isinstance(case.scene, OrderedScene):
        asked = [q for q in outcomes if q.conclusive and _in_that(case, base.cell, q).times]
    else:
        asked = [q for q in outcomes if q.conclusive and _is_asked(q, case.cycles)]
    if any(q.times or q.other for q in asked):
        return
    machine = machine_of(base.cell)
    starts = machine.thrown()
    if not asked and base.cell.forced:
        starts = [*(machine.at_rest(angle) for angle in ANGLES), *starts]
    yield from _followed_from(base, starts, (FEW * len(starts),))


def _from_rest(case: Case, *phases: int) -> Iterator[Settled]:
    """Yield the outcomes of simulations from rest and from each constraint."""
    base = of_all_phases(case)
    return _followed_from(base, machine_of(base.cell).starts(0.0), phases or (PHASES,))


def _followed_from(
    case: Case, starts: Iterable[AnyState | None], phases: Sequence[int]
) -> Iterator[Settled]:
    """Yield the outcome of a simulation from each admissible state among some.

    Then, of those that do not settle on what is asked for, where they almost return.  That a
    motion does not settle is said with the last bound of `phases`.
    """
    begin = machine_of(case.cell).begin
    possible = [q for q in dict.fromkeys(starts) if q is not None and begin(q)]
    for bound in phases:
        most = bound // max(len(possible), 1)
        followed = {}
        for start in possible:
            outcome, *followed[start] = _followed(case, start, most)
            last = outcome.conclusive or bound == phases[-1]
            yield outcome if last else replace(outcome, words="")
        for others in followed.values():
            yield from others
        possible = [q for q in possible if not _followed(case, q, most)[0].conclusive]


@lru_cache(maxsize=32)
def _followed(case: Case, start: AnyState, most: int) -> tuple[Settled, ...]:
    """Return the outcome of a simulation, then what else it may show.

    That is all copies of what it repeats, or where it almost returns, if it does not settle or
    does so on another period.  Cached, as all methods ask for the same.
    """
    machine, cell = machine_of(case.cell), case.cell
    place, cycles, left = Place.first(machine, start), float(CYCLES), float(most)
    segments: list[Segment] = []
    while True:
        # the phase that was cut off is followed anew, to its end
        followed, place, ended, left = walk(case, machine, place, cycles * cycle(cell), left)
        segments = segments[:-1] + followed
        motion = Simulation(case, tuple(segments), ended)
        outcome = outcome_of(cell, motion)
        enough = outcome.conclusive or motion.ended or left < 1
        if enough or cycles >= _lasting(cell):
            copies = as_copies(cell, motion) if outcome.conclusive else ()
            if outcome.times or copies or _is_asked(outcome, case.cycles):
                return outcome, *copies
            return outcome, *nearly(cell, motion, case.cycles)
        cycles = min(LONGER * cycles, _lasting(cell))


def _is_asked(outcome: Settled, cycles: int) -> bool:
    """Whether a motion has settled on what may have a number of periods of the forcing.

    Else an orbit of that period may be near: it flips into one of twice its period.
    """
    other = outcome.other
    return outcome.conclusive and (other is None or other.within(cycles) is not None)


def _lasting(cell: Cell) -> float:
    """Return for how many cycles transients may last, by the damping; `CYCLES` at least."""
    return max(CYCLES, DECAYS / (slowest_decay(cell) * cycle(cell)))
