"""States of a motion, and its phases at them.

Functions over `Rules` and states: plain Python, or compiled by numba.
"""

from collections.abc import Sequence
from math import cos
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from ...arrays import Vector
from . import column
from .bounds import Equation, Local, local
from .column import NONE
from .locate import sign_after
from .rules import Rules

#: What a motion remembers; an array where functions are compiled.
Values: TypeAlias = Sequence[float] | Vector


class State(NamedTuple):
    """Displacement, velocity, angle of the forcing and memory, without units.

    The surface that it is known to be on, that of the event that has just happened, or `NONE`;
    `placed` if the displacement is that of the surface, to its own rounding.
    """

    x: float
    v: float
    angle: float
    surface: int = NONE
    placed: bool = False
    memory: Values = ()

    @property
    def full(self) -> Vector:
        """What forms are of: ``(x, x', cos, 1, memory)``."""
        return np.array([self.x, self.v, cos(self.angle), 1.0, *self.memory])


#: A `State`, or that of a body.
AnyState: TypeAlias = Any


def equation_of(rules: Rules, p: int, memory: Values) -> Equation:
    """Return a phase with numbers for what the motion remembers.

    As Python's floats: NumPy's are slow, and round complex quotients otherwise.
    """
    row = rules.numbers[p]
    m, c, k = float(row[column.M]), float(row[column.C]), float(row[column.K])
    f, g, speed = float(row[column.F]), float(row[column.G]), float(row[column.SPEED])
    force = f + _remembered(row[column.MEMORY :], memory)
    held = bool(rules.kinds[p, column.HELD] != 0)
    return Equation(m, c, k, force, g, held, speed, float(rules.omega))


def form_of(rules: Rules, row: int, memory: Values) -> tuple[float, float, float, float]:
    """Return a form with numbers for what the motion remembers."""
    form = rules.forms[row]
    constant = float(form[3]) + _remembered(form[4:], memory)
    return float(form[0]), float(form[1]), float(form[2]), constant


def _remembered(factors: Vector, memory: Values) -> float:
    total = 0.0
    for i in range(len(memory)):
        total += float(factors[i]) * float(memory[i])
    return total


def local_of(rules: Rules, p: int, state: State) -> Local:
    """Return a phase at a state."""
    phase = equation_of(rules, p, state.memory)
    return local(phase, state.x, state.v, state.angle, state.placed)


def sign_of(rules: Rules, at: Local, row: int, state: State) -> int:
    """Return the sign of a form just after a state."""
    known = bool(rules.surfaces[row] == state.surface)
    return sign_after(at, form_of(rules, row, state.memory), known)


def sets(rules: Rules, p: int) -> bool:
    """Whether the beginning of a phase sets what the motion remembers.

    Such a phase follows its event alone: elsewhere, what it sets would be wrong.
    """
    for index in rules.setting:  # noqa: SIM110  (numba has no `any`)
        if index == rules.kinds[p, column.INDEX]:
            return True
    return False


def entered(rules: Rules, p: int, state: State) -> State:
    """Return the state in which a phase begins: with what its beginning sets."""
    if not sets(rules, p):
        return state
    values = np.zeros(len(state.memory))
    for i in range(len(values)):
        values[i] = state.memory[i]
        if rules.setting[i] == rules.kinds[p, column.INDEX]:
            vx, vv, vc, constant = rules.memory[i]
            moving = vx * state.x + vv * state.v + vc * cos(state.angle)
            values[i] = moving + rules.kinds[p, column.SIGN] * constant
    return State(state.x, state.v, state.angle, state.surface, state.placed, values)


def begun(rules: Rules, p: int, state: State) -> State:
    """Return a state with the velocity at which a phase is held, if it is."""
    v = float(rules.numbers[p, column.SPEED]) if rules.kinds[p, column.HELD] != 0 else state.v
    return State(state.x, v, state.angle, state.surface, state.placed, state.memory)
