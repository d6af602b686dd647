"""States of a motion of one mass, the phases that admit them, and the map of a switch.

Functions over `Rules` and states: plain Python, or compiled by numba.
"""

from collections.abc import Sequence
from math import cos
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from ...arrays import Vector
from . import column
from .bounds import Equation, Local, local, window
from .column import NONE
from .locate import NOISE, sign_after
from .rules import Rules

#: Tolerance of the velocity with which a motion may enter a held phase, without units.
NEAR = 1e-9

#: Values of the memory; an array where functions are compiled.
Values: TypeAlias = Sequence[float] | Vector


class State(NamedTuple):
    """Displacement, velocity, angle of the forcing and memory, without units.

    `surface` is the one on which the state is known to be, that of the event just before it, or
    `NONE`.  `placed`: the displacement is that of the surface, exact to its own rounding.
    """

    x: float
    v: float
    angle: float
    surface: int = NONE
    placed: bool = False
    memory: Values = ()

    @property
    def full(self) -> Vector:
        """The vector on which forms act: ``(x, x', cos, 1, memory)``."""
        return np.array([self.x, self.v, cos(self.angle), 1.0, *self.memory])


#: A `State`, or that of a body.
AnyState: TypeAlias = Any


def equation_of(rules: Rules, p: int, memory: Values) -> Equation:
    """Return the equation of a phase with the values of the memory.

    In Python's floats: NumPy's are slow, and round complex quotients differently.
    """
    row = rules.phases[p]
    m, c, k = float(row[column.M]), float(row[column.C]), float(row[column.K])
    f, g, speed = float(row[column.F]), float(row[column.G]), float(row[column.SPEED])
    force = f + _remembered(row[column.MEMORY :], memory)
    held = bool(rules.kinds[p, column.HELD] != 0)
    return Equation(m, c, k, force, g, held, speed, float(rules.omega))


def window_of(rules: Rules, p: int, state: State) -> float:
    """Return a time of less than one oscillation in a phase; it may be infinite."""
    return window(equation_of(rules, p, state.memory), float(rules.omega))


def form_of(rules: Rules, row: int, memory: Values) -> tuple[float, float, float, float]:
    """Return the coefficients of a form, with the memory evaluated into the constant."""
    form = rules.forms[row]
    constant = float(form[3]) + _remembered(form[4:], memory)
    return float(form[0]), float(form[1]), float(form[2]), constant


def _remembered(factors: Vector, memory: Values) -> float:
    total = 0.0
    for i in range(len(memory)):
        total += float(factors[i]) * float(memory[i])
    return total


def local_of(rules: Rules, p: int, state: State) -> Local:
    """Return the derivatives of the motion in a phase at a state."""
    phase = equation_of(rules, p, state.memory)
    return local(phase, state.x, state.v, state.angle, state.placed)


def sign_of(rules: Rules, at: Local, row: int, state: State) -> int:
    """Return the sign of a form just after a state."""
    is_zero = bool(rules.surfaces[row] == state.surface)
    return sign_after(at, form_of(rules, row, state.memory), is_zero)


def sets(rules: Rules, before: int, p: int) -> bool:
    """Whether the start of a phase sets a memory behind another one, or behind `NONE`.

    One that does so behind any follows only the event before it: elsewhere it would set a wrong
    value.
    """
    for is_set in rules.setting[before, p]:  # noqa: SIM110  (numba has no `any`)
        if is_set != 0:
            return True
    return False


def entered(rules: Rules, before: int, p: int, state: State) -> State:
    """Return a state with the memory that the start of a phase sets; see `sets`."""
    if not sets(rules, before, p):
        return state
    values = np.zeros(len(state.memory))
    for i in range(len(values)):
        values[i] = state.memory[i]
        if rules.setting[before, p, i] != 0:
            vx, vv, vc, constant = rules.memory[before, p, i]
            values[i] = vx * state.x + vv * state.v + vc * cos(state.angle) + constant
    return State(state.x, state.v, state.angle, state.surface, state.placed, values)


def begun(rules: Rules, p: int, state: State) -> State:
    """Return a state with the velocity that a held phase prescribes; else unchanged."""
    v = float(rules.phases[p, column.SPEED]) if rules.kinds[p, column.HELD] != 0 else state.v
    return State(state.x, v, state.angle, state.surface, state.placed, state.memory)


def may_be_held(rules: Rules, p: int, state: State) -> bool:
    """Whether a held phase may begin at a state: a rest behind a jump, only at its place."""
    speed, wall = float(rules.phases[p, column.SPEED]), rules.kinds[p, column.WALL]
    if wall == NONE:
        return abs(state.v - speed) <= NEAR * max(1.0, abs(speed))
    row = rules.kinds[wall, column.ROW]
    on = rules.surfaces[row] == state.surface or _is_on(rules, row, state)
    return state.v == speed and on


def _is_on(rules: Rules, row: int, state: State) -> bool:
    """Whether a state is on the surface of an event, to rounding, at any velocity."""
    ex, _, ec, constant = form_of(rules, row, state.memory)
    of_x, of_cos = ex * state.x, ec * cos(state.angle)
    return abs(of_x + of_cos + constant) <= NOISE * (abs(of_x) + abs(of_cos) + abs(constant))


def may_switch(rules: Rules, p: int, before: State) -> bool:
    """Whether a state meets the demands at the switch of a phase, to rounding."""
    cosine = cos(before.angle)
    for row in range(rules.kinds[p, column.AT_SWITCH], rules.kinds[p, column.END]):
        ex, ev, ec, constant = form_of(rules, row, before.memory)
        of_x, of_v, of_cos = ex * before.x, ev * before.v, ec * cosine
        size = abs(of_x) + abs(of_v) + abs(of_cos) + abs(constant)
        if of_x + of_v + of_cos + constant < -NOISE * size:
            return False
    return True


def is_met(rules: Rules, p: int, row: int, state: State) -> bool:
    """Whether a phase ends in a state by the event of a row, to rounding, without a jump."""
    surface = int(rules.surfaces[row])
    if rules.endings[p, surface] == NONE or law(rules, p, surface) != (1.0, 0.0):
        return False
    ex, ev, ec, constant = form_of(rules, row, state.memory)
    of_x, of_v, of_cos = ex * state.x, ev * state.v, ec * cos(state.angle)
    size = abs(of_x) + abs(of_v) + abs(of_cos) + abs(constant)
    return abs(of_x + of_v + of_cos + constant) <= NOISE * size


def law(rules: Rules, p: int, surface: int) -> tuple[float, float]:
    """Return rho and d of the switch on a surface, ``v -> rho v + d``; 1 and 0 if none."""
    ending = rules.endings[p, surface]
    if ending == NONE:
        return 1.0, 0.0
    return float(rules.phases[ending, column.RHO]), float(rules.phases[ending, column.D])


def crossed(rules: Rules, p: int, row: int, end: State) -> State:
    """Return the state behind the switch, from the state where the form of a row vanishes.

    A displacement or a velocity that the surface alone fixes is taken from it, exactly.
    """
    surface = int(rules.surfaces[row])
    rho, d = law(rules, p, surface)
    ex, ev, ec, constant = form_of(rules, row, end.memory)
    placed = ev == 0 and ec == 0 and ex != 0
    paced = ex == 0 and ec == 0 and ev != 0
    x = 0.0 - constant / ex if placed else end.x
    v = 0.0 - constant / ev if paced else end.v
    on_surface = surface if ev == 0 or (rho == 1 and d == 0) else NONE
    return State(x, rho * v + d, end.angle, on_surface, placed, end.memory)


def cannot_go_on(left: float, away: int) -> bool:
    """Whether accumulating jumps are too low to be followed; never those of one mass."""
    return False
