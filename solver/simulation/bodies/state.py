"""States of a body, and the map of a switch.

The functions replace those of the same names in `steps`: plain Python, or compiled by numba.
"""

from math import cos, sin, sqrt
from typing import NamedTuple

import numpy as np

from ...arrays import Matrix, Vector
from ..steps import column
from ..steps.column import NONE
from ..steps.locate import NOISE
from ..steps.rules import Rules
from ..steps.state import NEAR, Values, sets
from .along import sign_after
from .modes import rounding_of, value_of

#: Relative size of the part of a form orthogonal to others below which it depends on them.
NEW = 1e-10


class BodyState(NamedTuple):
    """A state of a body, without units: y of the modes, the angle of the forcing, the memory.

    `surface` is the one on which it is known to be, or `NONE`; see `bodies.laws` for y.
    """

    y: Values
    angle: float
    surface: int = NONE
    memory: Values = ()

    @property
    def full(self) -> Vector:
        """The vector on which forms act: ``Y = (y, cos, sin, 1, memory)``."""
        return full_of(self)


def full_of(state: BodyState) -> Vector:
    """Return the vector ``Y = (y, cos, sin, 1, memory)`` of a state."""
    n, memories = len(state.y), len(state.memory)
    Y = np.ones(n + 3 + memories)
    for i in range(n):
        Y[i] = state.y[i]
    Y[n], Y[n + 1] = cos(state.angle), sin(state.angle)
    for i in range(memories):
        Y[n + 3 + i] = state.memory[i]
    return Y


def window_of(rules: Rules, p: int, state: BodyState) -> float:
    """Return a third of a period of the forcing or, without one, of the slowest pole."""
    return float(rules.phases.poles.window[p])


def local_of(rules: Rules, p: int, state: BodyState) -> Vector:
    """Return the vector Y of a state in which a phase begins."""
    held = rules.kinds[p, column.HELD] != 0
    return full_of(begun(rules, p, state) if held else state)


def sign_of(rules: Rules, at: Vector, row: int, state: BodyState) -> int:
    """Return the sign of a form just after a state."""
    return sign_after(rules.phases, row, at, bool(rules.surfaces[row] == state.surface))


def may_be_held(rules: Rules, p: int, state: BodyState) -> bool:
    """Whether a held phase may begin at a state: a rest behind a jump, only at its place.

    Behind a jump that leaves no velocity, the velocity of the contact is not checked: with
    truncated modes it need not be exact.
    """
    laws, wall, Y = rules.phases.laws, rules.kinds[p, column.WALL], full_of(state)
    row, speed = rules.kinds[wall, column.ROW], float(laws.speed[p])
    on = wall != NONE and bool(rules.surfaces[row] == state.surface)
    if on and laws.rests[p]:
        return True
    if abs(value_of(laws.velocity[p, 0, 0], Y) - speed) > NEAR * max(1.0, abs(speed)):
        return False
    event, n = rules.forms[row], len(state.y)
    return wall == NONE or on or abs(value_of(event, Y)) <= NOISE * rounding_of(event, Y, n)


def begun(rules: Rules, p: int, state: BodyState) -> BodyState:
    """Return a state with the velocity that a held phase prescribes; else unchanged."""
    if rules.kinds[p, column.HELD] == 0:
        return state
    return struck(rules, rules.phases.laws.holding[p], state, state.surface)


def struck(rules: Rules, impulses: Matrix, state: BodyState, surface: int) -> BodyState:
    """Return the state behind impulses, which are linear forms of the state before them."""
    Y, by_impulse, y = full_of(state), rules.phases.laws.struck, copied(state.y)
    for j in range(len(impulses)):
        impulse = value_of(impulses[j], Y)
        for i in range(len(y)):
            y[i] += float(by_impulse[i, j]) * impulse
    return BodyState(y, state.angle, surface, state.memory)


def on(rows: Matrix, state: BodyState) -> BodyState:
    """Return the state nearest to one at which some forms vanish.

    The gradients of the forms are orthogonalized by Gram and Schmidt.
    """
    n, Y = len(state.y), full_of(state)
    directions, steps, y = np.zeros((len(rows), n)), np.zeros(len(rows)), copied(state.y)
    for k in range(len(rows)):
        distance = -value_of(rows[k], Y)
        for i in range(n):
            directions[k, i] = rows[k, i]
        full_length = sqrt(value_of(directions[k], directions[k]))
        for j in range(k):
            part = value_of(directions[j], directions[k])
            distance -= part * float(steps[j])
            for i in range(n):
                directions[k, i] -= part * directions[j, i]
        length = sqrt(value_of(directions[k], directions[k]))
        is_new = length > NEW * full_length  # else it depends on those before it
        steps[k] = distance / length if is_new else 0.0
        for i in range(n):
            directions[k, i] = directions[k, i] / length if is_new else 0.0
            y[i] += steps[k] * directions[k, i]
    return BodyState(y, state.angle, state.surface, state.memory)


def copied(values: Values) -> Vector:
    """Return a copy of numbers as an array."""
    copy = np.zeros(len(values))
    for i in range(len(copy)):
        copy[i] = values[i]
    return copy


def entered(rules: Rules, before: int, p: int, state: BodyState) -> BodyState:
    """Return a state with the memory that the start of a phase sets; see `sets`."""
    if not sets(rules, before, p):
        return state
    Y, values = full_of(state), copied(state.memory)
    for i in range(len(values)):
        if rules.setting[before, p, i] != 0:
            total, form = 0.0, rules.memory[before, p, i]
            for j in range(len(form)):
                total += float(form[j]) * value_of(rules.phases.laws.variables[j], Y)
            values[i] = total
    return BodyState(state.y, state.angle, state.surface, values)


def jumps_at(rules: Rules, p: int, surface: int) -> int:
    """Return the phase with the jumps at which phase p ends on a surface; `NONE` if no jump."""
    ending = int(rules.endings[p, surface])
    return ending if ending != NONE and rules.phases.laws.jumps[ending] else NONE


def is_met(rules: Rules, p: int, row: int, state: BodyState) -> bool:
    """Whether a phase ends in a state by the event of a row, to rounding, without a jump.

    Rounding is that of the whole state: all velocities may vanish with that of a contact.
    """
    surface, Y, form = int(rules.surfaces[row]), full_of(state), rules.forms[row]
    if rules.endings[p, surface] == NONE or jumps_at(rules, p, surface) != NONE:
        return False
    factors, largest = 0.0, 0.0
    for i in range(len(form)):
        factors, largest = factors + abs(float(form[i])), max(largest, abs(float(Y[i])))
    return abs(value_of(form, Y)) <= NOISE * factors * largest


def crossed(rules: Rules, p: int, row: int, end: BodyState) -> BodyState:
    """Return the state behind the switch, from the state where the form of a row vanishes."""
    surface = int(rules.surfaces[row])
    ending = jumps_at(rules, p, surface)
    if ending == NONE:
        return BodyState(end.y, end.angle, surface, end.memory)
    laws = rules.phases.laws
    on_surface = NONE if laws.moving[ending] else surface
    return struck(rules, laws.switching[ending], end, on_surface)


def may_switch(rules: Rules, p: int, before: BodyState) -> bool:
    """Whether a state meets the demands at the switch of a phase, to rounding."""
    Y, n = full_of(before), len(before.y)
    for row in range(rules.kinds[p, column.AT_SWITCH], rules.kinds[p, column.END]):
        if value_of(rules.forms[row], Y) < -NOISE * rounding_of(rules.forms[row], Y, n):
            return False
    return True
