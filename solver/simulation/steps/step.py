"""A motion from phase to phase: one step is a phase, and what is behind it.

Functions over `Rules`, states and clocks: plain Python, or compiled by numba.
"""

from typing import NamedTuple

from . import column
from .chatter import time_left
from .clock import Clock, angle_of, later
from .column import NONE
from .locate import EVENT, Reached, first_event
from .rules import Rules
from .state import State, begun, entered, form_of, local_of, sign_of
from .switches import crossed, law, next_phase, rest_behind

#: How a motion ends beside the ways in which a phase does: no phase takes a state, its switches
#: accumulate, or it has too many phases.
REFUSED, CHATTERS, MANY = range(4, 7)


class Passed(NamedTuple):
    """A phase that was followed, and what is behind it.

    Parameters
    ----------
    s : float
        How long it lasted.
    how : int
        How it ended, as in `Reached`, or `REFUSED`.
    surface : int
        On which it ended, if it did by an event.
    left : float
        How long the jumps at that surface still go on; 0 if that is not known.
    away : int
        The phase that stands for all that are left of them, for that time; `NONE` else.
    behind : State
        Just behind the switch.
    phase, state, clock : int, State, Clock
        The phase that goes on, and where it begins; of one that is cut off, its own.
    """

    s: float
    how: int
    surface: int
    left: float
    away: int
    behind: State
    phase: int
    state: State
    clock: Clock


def step(rules: Rules, p: int, state: State, clock: Clock, most: float) -> Passed:
    """Follow a phase from where it begins, for a time at most, and across its switch."""
    end, row = end_of_phase(rules, p, state, most)
    if end.how != EVENT:
        return Passed(end.s, end.how, NONE, 0.0, NONE, state, p, state, clock)
    clock, surface = later(clock, end.s), int(rules.surfaces[row])
    before = State(end.x, end.v, angle_of(clock), NONE, False, state.memory)
    behind = crossed(rules, p, row, before)
    after = next_phase(rules, p, surface, before, behind)
    if after == NONE:
        return Passed(end.s, REFUSED, surface, 0.0, NONE, behind, p, behind, clock)
    left, away = _time_left(rules, p, surface, after, behind), NONE
    state = entered(rules, after, behind)
    if left > 0:
        rested = later(clock, left)
        angle, memory = angle_of(rested), behind.memory
        still = State(behind.x, 0.0, angle, behind.surface, behind.placed, memory)
        rest = rest_behind(rules, p, still)
        if rest != NONE:  # the last of them stands for all that are left
            away, after, clock = after, rest, rested
            state = entered(rules, rest, still)
    state = begun(rules, after, state)
    return Passed(end.s, EVENT, surface, left, away, behind, after, state, clock)


def end_of_phase(rules: Rules, p: int, state: State, most: float) -> tuple[Reached, int]:
    """Return where a phase ends, and the row of the form that ends it.

    Each of the forms that are watched is not negative before it does.
    """
    at, own = local_of(rules, p, state), rules.kinds[p]
    forms, rows, zeros = [], [], []
    event, behind = own[column.ROW], own[column.AT_SWITCH]
    for watched in range(event + 1, behind + own[column.WATCHED]):
        row = watched if watched < behind else event
        x, v, cosine, constant = form_of(rules, row, state.memory)
        if row == event and sign_of(rules, at, row, state) < 0:
            x, v, cosine, constant = -x, -v, -cosine, -constant
        forms.append((x, v, cosine, constant))
        rows.append(int(row))
        zeros.append(bool(rules.surfaces[row] == state.surface))
    end = first_event(at.phase, state.x, state.v, state.angle, state.placed, forms, zeros, most)
    return end, rows[end.form]


def _time_left(rules: Rules, p: int, surface: int, after: int, state: State) -> float:
    """Return how long jumps go on behind that which ends a phase; 0 if not known."""
    at, (rho, d) = local_of(rules, after, state), law(rules, p, surface)
    return 0.0 if at.phase.held or d != 0 else time_left(at, rho)
