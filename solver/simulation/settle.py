"""The periodic motion that a simulation comes to, as times from which Newton's method starts.

What Newton's method misses from rough times, a long simulation may find: the order of the
phases, their durations and the phase of the forcing.  It comes to stable orbits only.  Where it
settles on another order of phases than the scene declares, that is said in words.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from ..case.case import Case
from ..case.cell import Cell
from ..iteration.start import RoughTimes
from .machine import Machine, State
from .record import Segment, Simulation
from .simulate import at_rest, cycle, follow

#: Cycles that are simulated, and how many a settled motion may take to repeat.
CYCLES, MOST = 100, 8

#: How far from itself a settled motion may be a period later, in units of time and length.
NEAR = 1e-3

#: What is rounding of a duration, in units of time: of two events that meet, its square root.
NO_TIME = 1e-7


@dataclass(frozen=True)
class Settled:
    """What a simulation came to.

    Parameters
    ----------
    times : RoughTimes or None
        Of a cell of the declared order; None if it did not settle on one.
    words : str
        What it settled on, or that it did not.
    """

    times: RoughTimes | None
    words: str


def rough_times_by_simulation(case: Case) -> Iterator[Settled]:
    """Yield what simulations of a case come to, from rest and from each constraint.

    Examples
    --------
    >>> from nonsmooth.solver.case import registry
    >>> found = next(rough_times_by_simulation(registry.load("impact")()))
    >>> f"{found.times.angle:.6f}", found.words
    ('0.929644', 'a simulation settles on flight')
    """
    machine = Machine.of(case.cell)
    starts = [at_rest(machine, 0.0)]
    held = [State(0.0, q.phase.speed, 0.0) for q in machine.nodes if q.phase.held]
    starts += map(machine.remembered, held)
    for start in dict.fromkeys(starts):
        if start is not None and machine.first(start) is not None:
            yield _followed(case, start)


@lru_cache(maxsize=16)
def _followed(case: Case, start: State) -> Settled:
    """Return what the simulation from one state comes to; every method asks for the same."""
    machine = Machine.of(case.cell)
    return settled(case.cell, follow(case, machine, start, CYCLES * cycle(case.cell)))


def settled(cell: Cell, motion: Simulation) -> Settled:
    """Return what a motion of a cell came to, by its last phases."""
    if motion.ended:
        return Settled(None, f"a simulation ends: {motion.ended}")
    segments = motion.segments[:-1]  # the last is cut off
    cells = [i for i in range(len(segments)) if _is_cell(cell, segments, i)]
    if cells:
        first = segments[cells[-1] : cells[-1] + len(cell.phases)]
        durations = tuple(q.s for q in first)
        words = f"a simulation settles on {', '.join(q.phase.name for q in first)}"
        touched = [q.phase.name for q in first if q.s < NO_TIME]
        if touched:
            words += f", where {' and '.join(touched)} lasts no time to rounding"
        again = cells[-2:-1] and segments[cells[-2] : cells[-2] + len(cell.phases)]
        if again and all(
            max(abs(one.s - two.s), abs(one.x - two.x), abs(one.v - two.v)) <= NEAR
            for one, two in zip(first, again, strict=True)
        ):
            return Settled(RoughTimes(durations, first[0].angle, words), words)
    return Settled(None, _other(cell, segments))


def _is_cell(cell: Cell, segments: tuple[Segment, ...], start: int) -> bool:
    """Whether the phases from one on are a cell in the declared order, of its duration."""
    found = segments[start : start + len(cell.phases)]
    if [(q.index, q.mirrored) for q in found] != [(p, False) for p in range(len(cell.phases))]:
        return False
    return not cell.forced or abs(sum(q.s for q in found) - cell.duration) <= NEAR


def _other(cell: Cell, segments: tuple[Segment, ...]) -> str:
    """Return in words on which other order of phases a motion settles, if on any."""
    if not segments or segments[-1].t < (CYCLES / 2) * cycle(cell):
        return "a simulation comes to a motion without switches"
    last = segments[-1]
    for length in range(1, len(segments) // 2):
        one, two = last, segments[-1 - length]
        passed = one.t - two.t
        if passed > MOST * cycle(cell):
            break
        turns = passed / cycle(cell)
        whole = not cell.forced or abs(turns - round(turns)) <= NEAR
        same = (one.index, one.mirrored) == (two.index, two.mirrored)
        if whole and same and max(abs(one.x - two.x), abs(one.v - two.v)) <= NEAR:
            names = ", ".join(
                f"{'-' if q.mirrored else ''}{q.phase.name}" for q in segments[-length:]
            )
            count = round(turns)
            every = "each period" if count == 1 else f"every {count} periods"
            within = f", in {every} of the forcing" if cell.forced else ""
            return f"a simulation settles on another order of phases: {names}{within}"
    return "a simulation does not settle on a periodic motion"
