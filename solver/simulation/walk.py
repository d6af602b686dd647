"""A motion as a list of its phases, from the beginning of one on."""

import math
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from ..arrays import Matrix
from ..scenes.arrays import Integers
from ..scenes.case import Case
from ..scenes.cell import Phase
from .machine import Machine, follow_by
from .record import Segment, Simulation
from .steps.bounds import window
from .steps.chatter import CHATTER, accumulates, end_of
from .steps.clock import Clock, at_start
from .steps.column import NONE
from .steps.locate import BEYOND, EVENT, LOST, MOST_STEPS
from .steps.run import MOST_PHASES
from .steps.state import State, begun
from .steps.step import REFUSED, Passed
from .steps.switches import has_rest

#: Windows of a search for events that take about as long as what else a phase takes.
STRETCH = 10


@dataclass(frozen=True)
class Place:
    """Where a phase of a motion begins.

    Parameters
    ----------
    phase : int
        Which of the machine's.
    state : State
    clock : Clock
        Which says the angle of the forcing.
    t : Fraction
        The exact sum of the durations before.
    """

    phase: int
    state: State
    clock: Clock
    t: Fraction = Fraction(0)

    @classmethod
    def first(cls, machine: Machine, state: State) -> "Place":
        """Return where the motion from a state begins that a phase takes."""
        node = machine.first(state)
        assert node is not None
        p, clock = machine.number(node.step), at_start(state.angle, machine.cell.omega)
        return cls(p, with_array(begun(machine.rules, p, state)), clock)


def with_array(state: State) -> State:
    """Return a state whose memory is an array, as it is where functions are compiled."""
    return state._replace(memory=np.array(state.memory, dtype=float))


def follow(case: Case, machine: Machine, start: State, duration: float) -> Simulation:
    """Return the motion of a case from a state that a phase takes, all without units."""
    segments, _, ended = walk(case, machine, Place.first(machine, start), duration)
    return Simulation(case, tuple(segments), ended)


def strobed(machine: Machine, start: State, cycles: int) -> tuple[Matrix, Integers, int]:
    """Return a motion at each whole turn of the forcing from a state on: see `run`."""
    states, phases, how = follow_by("run", machine.rules, with_array(start), cycles)
    return states, phases, how


def effort(phase: Phase, omega: float, s: float) -> float:
    """Return what it takes to follow a phase for a time: 1, and more for a long one."""
    return 1 + s / (STRETCH * window(phase, omega))


def _reach(phase: Phase, omega: float, most: float) -> float:
    """Return for how long a phase is followed by an effort."""
    return max(most - 1, 0.0) * STRETCH * window(phase, omega) if most < math.inf else most


def walk(
    case: Case, machine: Machine, place: Place, until: float, most: float = math.inf
) -> tuple[list[Segment], Place, str]:
    """Return the phases of a motion from the beginning of one on, the last one cut off.

    Parameters
    ----------
    case : Case
    machine : Machine
        Of its cell.
    place : Place
        Where to begin.
    until : float
        The time at which it ends, without units.
    most : float
        The `effort` after which it ends earlier.

    Returns
    -------
    segments : list of Segment
    place : Place
        Where the last of them begins, to go on from.
    ended : str
        Why the motion ends before, where it does.
    """
    rules, omega, whole = machine.rules, machine.cell.omega, Fraction(until)
    segments: list[Segment] = []
    while True:
        p, state = place.phase, place.state
        phase = machine.nodes[p].phase
        longest = min(max(float(whole - place.t), 0.0), _reach(phase, omega, most))
        passed: Passed = follow_by("step", rules, p, state, place.clock, longest)
        s, surface = passed.s, passed.surface
        segments.append(_segment(machine, p, state, place.t, s, surface))
        most -= effort(phase, omega, s)
        if passed.how not in (EVENT, REFUSED) or most < 1:
            return segments, place, _ended(segments[-1], passed.how)
        t = place.t + Fraction(s)
        if passed.how == REFUSED:
            when = f"at t = {float(t) * case.units.time:.6g} s"
            words = (
                f"no phase of the scene takes the state {when}, where "
                f"{segments[-1].phase.name} ends; {machine.unmet(passed.behind)}"
            )
            return segments, place, words
        if passed.away != NONE:
            left = max(min(passed.left, float(whole - t)), 0.0)
            segments.append(_segment(machine, passed.away, passed.behind, t, left))
            t += Fraction(left)
        elif accumulates(_last(segments)) and (passed.left or not has_rest(rules, surface)):
            return segments, place, f"chatter: {_chatter(case, segments)}"
        if len(segments) >= MOST_PHASES:
            words = f"{MOST_PHASES} phases are the most that one motion may have"
            return segments, place, words
        place = Place(passed.phase, passed.state, passed.clock, t)


def _ended(segment: Segment, how: int) -> str:
    """Return in words why a phase was not followed to its end; empty if it was cut off."""
    if how == BEYOND:
        return f"the motion in {segment.phase.name} is beyond float64"
    if how == LOST:
        return f"no event was located in {segment.phase.name} within {MOST_STEPS} steps"
    return ""


def _segment(
    machine: Machine, p: int, state: State, t: Fraction, s: float, surface: int = NONE
) -> Segment:
    node, memory = machine.nodes[p], [float(value) for value in state.memory]
    place = (node.index, node.mirrored, t, state.angle)
    step = machine.ending(p, surface)
    return Segment(node.phase.remembering(memory), *place, state.x, state.v, s, step)


def _last(segments: list[Segment]) -> list[float]:
    """Return the durations of the last phases; infinite ones before the first."""
    last = [q.s for q in segments[-CHATTER:]]
    return [math.inf] * (CHATTER - len(last)) + last


def _chatter(case: Case, segments: list[Segment]) -> str:
    """Return in words where the switches accumulate."""
    before, last = segments[-2].s, segments[-1].s
    when = end_of(float(segments[-1].t) + last, before, last) * case.units.time
    return (
        f"{segments[-1].phase.name} ends ever sooner, the switches accumulate at "
        f"t = {when:.9g} s, and the scene does not say what follows"
    )
