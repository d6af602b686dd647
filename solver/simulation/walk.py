"""A motion as a list of its phases, from the start of a given phase."""

import math
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

from ..scenes.case import Case
from .machine import Machine
from .record import Simulation
from .segment import Segment
from .steps.chatter import CHATTER, accumulates, end_of
from .steps.clock import Clock, at_start
from .steps.column import NONE
from .steps.locate import BEYOND, EVENT, LOST, MOST_STEPS
from .steps.run import MOST_PHASES, effort
from .steps.state import AnyState
from .steps.step import CHATTERS, REFUSED, Passed
from .steps.switches import has_rest

#: The first word of what is said where switches accumulate.
ACCUMULATE = "chatter"

#: So many pairs of phases, each less than half as long as the one before, are chatter.
PAIRS = 4


@dataclass(frozen=True)
class Place:
    """The start of a phase: its number in a machine, and its `State` or `BodyState`.

    The clock gives the angle of the forcing; `t` is the exact sum of the durations before.
    """

    phase: int
    state: AnyState
    clock: Clock
    t: Fraction = Fraction(0)

    @classmethod
    def first(cls, machine: Machine, state: AnyState) -> "Place":
        """Return where the motion from a state begins, which some phase must admit."""
        beginning = machine.begin(state)
        assert beginning is not None
        p, begun = beginning
        return cls(p, begun, at_start(state.angle, machine.cell.omega))


def follow(case: Case, machine: Machine, start: AnyState, duration: float) -> Simulation:
    """Return the motion of a case from an admissible state, all without units."""
    segments, _, ended, _ = walk(case, machine, Place.first(machine, start), duration)
    return Simulation(case, tuple(segments), ended)


def walk(
    case: Case, machine: Machine, place: Place, until: float, most: float = math.inf
) -> tuple[list[Segment], Place, str, float]:
    """Return the phases of a motion from the start of a phase; the last one is cut off.

    Parameters
    ----------
    until : float
        The time at which the motion ends, without units.
    most : float
        The effort after which it ends earlier: see `run.effort`.

    Returns
    -------
    segments : list of Segment
    place : Place
        Where the last of them begins; `walk` can go on from there.
    ended : str
        Why the motion ends early; empty if it was cut off.
    left : float
        What is left of `most`.
    """
    end_time, rules = Fraction(until), machine.rules
    segments: list[Segment] = []
    ahead: list[Passed] = []
    while True:
        p, state = place.phase, place.state
        if not ahead:
            ahead = machine.several(p, state, place.clock, end_time - place.t, most)[::-1]
        passed = ahead.pop()
        s, surface = passed.s, passed.surface
        segments.append(machine.recorded(p, state, place.t, s, surface))
        most -= effort(machine.by("window_of", p, state), s) if most < math.inf else 0.0
        if passed.how == CHATTERS:
            return segments, place, _chatter(case, segments[-1], s + passed.left), most
        if passed.how not in (EVENT, REFUSED) or most < 1:
            return segments, place, _ended(segments[-1], passed.how), most
        t = place.t + Fraction(s)
        if passed.how == REFUSED and _falls(pairs := _in_pairs(segments)):
            words = _chatter(case, segments[-1], end_of(segments[-1].s, *pairs[-2:]))
            return segments, place, words, most
        if passed.how == REFUSED:
            when = f"at t = {float(t) * case.units.time:.6g} s"
            undecided = machine.undecided(p, surface, passed.behind)
            words = (
                f"no phase of the scene takes the state {when}, where "
                f"{segments[-1].phase.name} ends; {machine.unmet(passed.behind)}"
            )
            return segments, place, f"{when}, {undecided}" if undecided else words, most
        if passed.away != NONE:
            resting = max(min(passed.left, float(end_time - t)), 0.0)
            segments.append(machine.recorded(passed.away, passed.behind, t, resting, NONE))
            t += Fraction(resting)
        elif accumulates(_last(segments)) and (passed.left or not has_rest(rules, surface)):
            before, last = segments[-2].s, segments[-1].s
            words = _chatter(case, segments[-1], end_of(last, before, last))
            return segments, place, words, most
        if len(segments) >= MOST_PHASES:
            words = f"{MOST_PHASES} phases are the most that one motion may have"
            return segments, place, words, most
        place = Place(passed.phase, passed.state, passed.clock, t)


def _ended(segment: Segment, how: int) -> str:
    """Return in words why a phase was not followed to its end; empty if it was cut off."""
    if how == BEYOND:
        return f"the motion in {segment.phase.name} is beyond float64"
    if how == LOST:
        return f"no event was located in {segment.phase.name} within {MOST_STEPS} steps"
    return ""


def _last(segments: list[Segment]) -> list[float]:
    """Return the durations of the last `CHATTER` phases, infinite where there are fewer."""
    last = [q.s for q in segments[-CHATTER:]]
    return [math.inf] * (CHATTER - len(last)) + last


def _in_pairs(segments: list[Segment]) -> list[float]:
    """Return how long the last `PAIRS` pairs of phases last.

    A jump and the way back are two phases, where another event lies between, such as the
    velocity that vanishes.
    """
    last = _last(segments)[-2 * PAIRS :]
    return [sum(last[i : i + 2]) for i in range(0, len(last), 2)]


def _falls(durations: list[float]) -> bool:
    """Whether each duration is less than half of the one before."""
    return all(after < before / 2 for before, after in pairwise(durations))


def _chatter(case: Case, last: Segment, s: float) -> str:
    """Return in words when the switches accumulate: a time `s` after the last phase begins."""
    return (
        f"{ACCUMULATE}: {last.phase.name} ends ever sooner, the switches accumulate at "
        f"t = {float(last.t + Fraction(s)) * case.units.time:.9g} s, "
        "and the scene does not say what follows"
    )
