"""Which phase follows an event: one whose demands hold just after it.

A phase ends where its event happens or one of its demands would be violated next.  The law of
the switch is that of the event; a demand that ends where the event of another phase of the same
equation happens has the law of that.  A phase that is held behind a jump of the velocity at
a place is a rest there: it is entered by a jump that leaves no velocity or by infinitely many.

Functions over `Rules` and states: plain Python, or compiled by numba.  Those from `admits` to
`has_rest` are the rules of bodies as well, over other functions of the same names as the rest.
"""

from math import cos

from . import column
from .column import NONE
from .locate import NOISE
from .rules import Rules
from .state import AnyState, State, begun, entered, form_of, local_of, sets, sign_of

#: How far from the velocity at which a phase is held a motion may enter it, without units.
NEAR = 1e-9


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


def may_be_held(rules: Rules, p: int, state: State) -> bool:
    """Whether a held phase is held at a state: behind a jump, there alone."""
    speed, wall = float(rules.numbers[p, column.SPEED]), rules.kinds[p, column.WALL]
    if wall == NONE:
        return abs(state.v - speed) <= NEAR * max(1.0, abs(speed))
    row = rules.kinds[wall, column.ROW]
    on = rules.surfaces[row] == state.surface or _is_on(rules, row, state)
    return state.v == speed and on


def _is_on(rules: Rules, row: int, state: State) -> bool:
    """Whether a state is on the surface of an event, to rounding, whatever its velocity."""
    ex, _, ec, constant = form_of(rules, row, state.memory)
    of_x, of_cos = ex * state.x, ec * cos(state.angle)
    return abs(of_x + of_cos + constant) <= NOISE * (abs(of_x) + abs(of_cos) + abs(constant))


def may_switch(rules: Rules, p: int, before: State) -> bool:
    """Whether a state is one that the event of a phase demands, but for rounding."""
    cosine = cos(before.angle)
    for row in range(rules.kinds[p, column.AT_SWITCH], rules.kinds[p, column.END]):
        ex, ev, ec, constant = form_of(rules, row, before.memory)
        of_x, of_v, of_cos = ex * before.x, ev * before.v, ec * cosine
        size = abs(of_x) + abs(of_v) + abs(of_cos) + abs(constant)
        if of_x + of_v + of_cos + constant < -NOISE * size:
            return False
    return True


def law(rules: Rules, p: int, surface: int) -> tuple[float, float]:
    """Return rho and d of the switch where a phase ends on a surface."""
    ending = rules.endings[p, surface]
    if ending == NONE:
        return 1.0, 0.0
    return float(rules.numbers[ending, column.RHO]), float(rules.numbers[ending, column.D])


def crossed(rules: Rules, p: int, row: int, end: State) -> State:
    """Return the state behind the switch from that in which a phase ends, where a form does.

    A displacement or a velocity that the surface alone gives is that, without rounding.
    """
    surface = int(rules.surfaces[row])
    rho, d = law(rules, p, surface)
    ex, ev, ec, constant = form_of(rules, row, end.memory)
    placed = ev == 0 and ec == 0 and ex != 0
    paced = ex == 0 and ec == 0 and ev != 0
    x = 0.0 - constant / ex if placed else end.x
    v = 0.0 - constant / ev if paced else end.v
    known = surface if ev == 0 or (rho == 1 and d == 0) else NONE
    return State(x, rho * v + d, end.angle, known, placed, end.memory)
