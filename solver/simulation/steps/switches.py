"""Which phase follows an event: one whose demands hold just after it.

A phase ends at its event, or where one of its demands would be violated next.  The switch has
the law of the event; where a demand ends the phase, that of the phase of the same equation with
its event on the same surface.  A held phase behind a jump of the velocity at a place is a rest
there: it is entered by a jump that leaves no velocity, or by infinitely many jumps.

Functions over `Rules` and states: plain Python, or compiled by numba.  They serve bodies as
well: the functions that look into a state are in `state`, or in `bodies.state`.
"""

from . import column
from .column import NONE
from .rules import Rules
from .state import (
    AnyState,
    begun,
    entered,
    is_met,
    local_of,
    may_be_held,
    may_switch,
    sets,
    sign_of,
)


def admits(rules: Rules, p: int, state: AnyState) -> bool:
    """Whether the demands of a phase hold just after a state."""
    if rules.kinds[p, column.HELD] != 0 and not may_be_held(rules, p, state):
        return False
    at = local_of(rules, p, state)
    for row in range(rules.kinds[p, column.ROW] + 1, rules.kinds[p, column.AT_SWITCH]):
        if sign_of(rules, at, row, state) < 0:
            return False
    return True


def first_phase(rules: Rules, state: AnyState) -> int:
    """Return the phase in which a motion from a state begins; `NONE` if it is in none."""
    for p in rules.turns[-1]:
        if admits(rules, p, state):
            return int(p)
    return NONE


def next_phase(rules: Rules, p: int, surface: int, before: AnyState, state: AnyState) -> int:
    """Return the phase that follows phase p, which ended on a surface; `NONE` if none does.

    `state` is the state behind the switch.  Where none does, another event may be met there:
    then the phase between, of no duration, is left out.
    """
    found = single_next(rules, p, surface, before, state)
    if found != NONE:
        return found
    ended = NONE if surface == NONE else int(rules.endings[p, surface])
    for q in rules.turns[ended]:
        if follows(rules, p, ended, int(q), state):  # it is not decided which
            return NONE
    for q in rules.turns[ended]:
        if q == NONE or (sets(rules, NONE, q) and not (rules.declared[ended] == q).any()):
            continue
        between = entered(rules, p, int(q), state)
        row = met_at_once(rules, int(q), between)
        if row != NONE:
            met = int(rules.surfaces[row])
            found = single_next(rules, int(q), met, between, between)
        if found != NONE:
            break
    return found


def met_at_once(rules: Rules, p: int, state: AnyState) -> int:
    """Return the row of the event by which a phase ends where it begins; `NONE` if none.

    It is the one demand that does not hold behind the state.
    """
    if rules.kinds[p, column.HELD] != 0 and not may_be_held(rules, p, state):
        return NONE
    at, found = local_of(rules, p, state), NONE
    for row in range(rules.kinds[p, column.ROW] + 1, rules.kinds[p, column.AT_SWITCH]):
        if sign_of(rules, at, row, state) < 0:
            if found != NONE or not is_met(rules, p, row, state):
                return NONE
            found = row
    return found


def single_next(rules: Rules, p: int, surface: int, before: AnyState, state: AnyState) -> int:
    """Return the phase that follows phase p where no other event is met; `NONE` if none does.

    The first phase that the scene declares to follow is skipped if the state `before` the
    switch violates a demand of the event.  Where demands and events alone decide, none follows
    if phases of two laws could.
    """
    ended = NONE if surface == NONE else int(rules.endings[p, surface])
    switches = ended == NONE or may_switch(rules, ended, before)
    refused = NONE if switches else rules.declared[ended, 0]
    found = NONE
    for q in rules.turns[ended]:
        if q == refused or not follows(rules, p, ended, int(q), state):
            continue
        law = rules.kinds[q, column.LAW]
        if law == NONE or (found == NONE and rules.kinds[q, column.HELD] != 0):
            return int(q)
        if found != NONE and rules.kinds[found, column.LAW] != law:
            return NONE
        found = int(q) if found == NONE else found
    return found


def follows(rules: Rules, p: int, ended: int, q: int, state: AnyState) -> bool:
    """Whether phase q takes the state behind phase p, which the event of a phase has ended."""
    if q == NONE or (sets(rules, NONE, q) and not (rules.declared[ended] == q).any()):
        return False
    return admits(rules, q, entered(rules, p, q, state) if sets(rules, p, q) else state)


def rest_behind(rules: Rules, p: int, state: AnyState) -> int:
    """Return the rest at a place that admits a state where jumps died away; `NONE` if none."""
    for q in rules.turns[p]:
        if q == NONE or rules.kinds[q, column.WALL] == NONE:
            continue
        if admits(rules, q, begun(rules, q, state)):
            return int(q)
    return NONE


def has_rest(rules: Rules, surface: int) -> bool:
    """Whether the scene has a rest at the place of a surface."""
    for wall in rules.kinds[:, column.WALL]:
        if wall != NONE and rules.surfaces[rules.kinds[wall, column.ROW]] == surface:
            return True
    return False
