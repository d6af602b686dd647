"""Which phase follows an event: one whose demands hold just after it.

A phase ends where its event happens or one of its demands would be violated next.  The law of
the switch is that of the event; a demand that ends where the event of another phase of the same
equation happens has the law of that.  A phase that is held behind a jump of the velocity at
a place is a rest there: it is entered by a jump that leaves no velocity or by infinitely many.

Functions over `Rules` and states: plain Python, or compiled by numba.  They are the rules of
bodies as well: what looks into a state is in `state`, or in `bodies.rules`.
"""

from . import column
from .column import NONE
from .rules import Rules
from .state import AnyState, begun, entered, local_of, may_be_held, may_switch, sets, sign_of


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
    """Return the phase that follows on a surface, from the state behind the switch.

    The one that the scene declares does not follow where the state `before` the switch is not
    one that the event demands; `NONE` if none follows.
    """
    event = rules.surfaces[rules.kinds[p, column.ROW]]
    declared = (p + 1) % len(rules.kinds) if surface == event else NONE
    refused = declared if declared != NONE and not may_switch(rules, p, before) else NONE
    for q in rules.turns[declared]:
        if q == refused or (q != declared and sets(rules, q)):
            continue
        if admits(rules, q, entered(rules, q, state)):
            return int(q)
    return NONE


def rest_behind(rules: Rules, p: int, state: AnyState) -> int:
    """Return the rest at a place that takes a state whose jumps have died away there."""
    for q in rules.turns[(p + 1) % len(rules.kinds)]:
        if rules.kinds[q, column.WALL] != NONE and admits(rules, q, begun(rules, q, state)):
            return int(q)
    return NONE


def has_rest(rules: Rules, surface: int) -> bool:
    """Whether the scene has a rest at a place."""
    for wall in rules.kinds[:, column.WALL]:
        if wall != NONE and rules.surfaces[rules.kinds[wall, column.ROW]] == surface:
            return True
    return False
