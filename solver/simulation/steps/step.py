"""One step of a motion: a phase up to its event, and the switch to the next phase.

Functions over `Rules`, states and clocks: plain Python, or compiled by numba.  `step` serves
bodies as well: there it is linked with their functions of the same names.
"""

from typing import NamedTuple

from . import column
from .chatter import time_left
from .clock import Clock, angle_of, later
from .column import NONE
from .locate import EVENT, first_event
from .rules import Rules
from .state import (
    AnyState,
    State,
    begun,
    cannot_go_on,
    crossed,
    entered,
    form_of,
    law,
    local_of,
    sign_of,
)
from .switches import next_phase, rest_behind

#: Further ways in which a motion ends, beside those of a phase in `locate`: no phase admits the
#: state, the switches accumulate, or there are too many phases.
REFUSED, CHATTERS, MANY = range(4, 7)


class Passed(NamedTuple):
    """A phase that was followed, and the switch at its end.

    Parameters
    ----------
    s : float
        Duration of the phase.
    how : int
        How it ended, as in `Reached`, or `REFUSED` or `CHATTERS`.
    surface : int
        The switching surface on which it ended; `NONE` if no event ended it.
    left : float
        Time until the jumps at that surface accumulate; 0 if unknown.
    away : int
        The phase that replaces all remaining jumps, for the time `left`; `NONE` if none does.
    behind : State or BodyState
        The state just behind the switch.
    phase, state, clock : int, State or BodyState, Clock
        The next phase, and where it begins.  If no event ended the phase, itself and its start;
        if no phase follows, itself and what is behind the switch.
    """

    s: float
    how: int
    surface: int
    left: float
    away: int
    behind: AnyState
    phase: int
    state: AnyState
    clock: Clock


def step(rules: Rules, p: int, state: AnyState, clock: Clock, most: float) -> Passed:
    """Follow a phase from its start, for a time `most` at most, and cross its switch."""
    s, how, row, before = end_of_phase(rules, p, state, clock, most)
    if how != EVENT:
        return Passed(s, how, NONE, 0.0, NONE, state, p, state, clock)
    clock, surface = later(clock, s), int(rules.surfaces[row])
    behind = crossed(rules, p, row, before)
    after, away = next_phase(rules, p, surface, before, behind), NONE
    if after == NONE:
        return Passed(s, REFUSED, surface, 0.0, NONE, behind, p, behind, clock)
    state = begun(rules, after, entered(rules, p, after, behind))
    left = jumping(rules, p, surface, after, state)
    if left > 0:
        rest_clock = later(clock, left)
        rest, rested = rest_of(rules, p, behind, left, angle_of(rest_clock))
        if rest != NONE:  # the last of the jumps stands for all that are left
            away, after, state, clock = after, rest, rested, rest_clock
    how = CHATTERS if cannot_go_on(left, away) else EVENT
    return Passed(s, how, surface, left, away, behind, after, state, clock)


def end_of_phase(
    rules: Rules, p: int, state: State, clock: Clock, most: float
) -> tuple[float, int, int, State]:
    """Return when a phase ends, how, the row of the form that vanishes, and the state there.

    The watched forms are signed so that none is negative at the start.
    """
    at, kinds = local_of(rules, p, state), rules.kinds[p]
    forms, rows, zeros = [], [], []
    event, behind = kinds[column.ROW], kinds[column.AT_SWITCH]
    for watched in range(event + 1, behind + kinds[column.WATCHED]):
        row = watched if watched < behind else event
        x, v, cosine, constant = form_of(rules, row, state.memory)
        if row == event and sign_of(rules, at, row, state) < 0:
            x, v, cosine, constant = -x, -v, -cosine, -constant
        forms.append((x, v, cosine, constant))
        rows.append(int(row))
        zeros.append(bool(rules.surfaces[row] == state.surface))
    end = first_event(at.phase, state.x, state.v, state.angle, state.placed, forms, zeros, most)
    angle = angle_of(later(clock, end.s))
    end_state = State(end.x, end.v, angle, NONE, False, state.memory)
    return end.s, end.how, rows[end.form], end_state


def jumping(rules: Rules, p: int, surface: int, after: int, state: State) -> float:
    """Return the time until the jumps behind the end of a phase accumulate; 0 if unknown."""
    at, (rho, d) = local_of(rules, after, state), law(rules, p, surface)
    if at.phase.held or d != 0:
        return 0.0
    return time_left(at.derivatives[1], at.derivatives[2], at.derivatives[3], rho, 0.0)


def rest_of(
    rules: Rules, p: int, behind: State, left: float, angle: float
) -> tuple[int, State]:
    """Return the rest behind jumps that accumulate in a time `left`, and its first state."""
    stopped = State(behind.x, 0.0, angle, behind.surface, behind.placed, behind.memory)
    rest = rest_behind(rules, p, stopped)
    if rest == NONE:
        return rest, stopped
    return rest, begun(rules, rest, entered(rules, p, rest, stopped))
