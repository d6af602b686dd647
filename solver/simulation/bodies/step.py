"""One step of a body: a phase up to its event, and the switch at its end.

The functions replace those of the same names in `steps`: plain Python, or compiled by numba.
"""

import numpy as np

from ...arrays import Indices, Integers, Matrix, Vector
from ..steps import column
from ..steps.chatter import time_left
from ..steps.clock import Clock, angle_of, later, time_to
from ..steps.column import NONE
from ..steps.locate import EVENT, NOISE
from ..steps.rules import Rules
from ..steps.switches import follows, next_phase, rest_behind
from .along import along_of, sign_after
from .locate import first_event
from .modes import size_by_poles, size_of, state_at, value_of
from .phases import NO_CONTACT
from .state import BodyState, begun, crossed, entered, full_of, jumps_at, on

#: Least height of a jump that is located, in units of the rounding of a displacement.
RESOLVED = 4


def width(rules: Rules) -> int:
    """Return how many numbers `strobe` keeps of a state."""
    return 2 + int(rules.setting.shape[2]) + len(rules.phases.laws.struck)


def watched(rules: Rules, p: int, state: BodyState) -> tuple[Integers, Vector, Indices]:
    """Return the rows of the forms that may end a phase, their signs, and the known zeros.

    The signs make each form nonnegative just after the start of the phase.
    """
    kinds, Y = rules.kinds[p], full_of(state)
    event, behind = int(kinds[column.ROW]), int(kinds[column.AT_SWITCH])
    count = behind + int(kinds[column.WATCHED]) - event - 1
    rows, signs, zeros = np.zeros(count, np.int64), np.ones(count), np.zeros(count, np.bool_)
    for i in range(count):
        rows[i] = event + 1 + i if event + 1 + i < behind else event
        zeros[i] = rules.surfaces[rows[i]] == state.surface
        if rows[i] == event and sign_after(rules.phases, event, Y, bool(zeros[i])) < 0:
            signs[i] = -1.0
    return rows, signs, zeros


def end_of_phase(
    rules: Rules, p: int, state: BodyState, clock: Clock, most: float
) -> tuple[float, int, int, BodyState]:
    """Return when a phase ends, how, the row of the form that vanishes, and the state there.

    An event at which nothing changes is skipped, as where a mass comes back through the place
    at which it left a spring.
    """
    begins, start = state, 0.0
    while True:
        rows, signs, zeros = watched(rules, p, begins)
        Y = full_of(begins)
        along = along_of(rules.phases, rules.omega, p, Y, rows, signs, zeros)
        s, how, form = first_event(along, most - start)
        s += start
        if how != EVENT:
            return s, how, NONE, state
        row = int(rows[form])
        end = reached(rules, p, state, s, row, angle_of(later(clock, s)))
        behind = crossed(rules, p, row, end)
        if s == start or changes(rules, p, row, end, behind):
            return s, how, row, end
        begins, start = begun(rules, p, behind), s


def reached(
    rules: Rules, p: int, state: BodyState, s: float, row: int, angle: float
) -> BodyState:
    """Return the state in which a phase ends after a time `s`, projected onto its surface.

    A held contact is put where its speed brings it.
    """
    Y, n, laws = full_of(state), len(state.y), rules.phases.laws
    held, speed = rules.kinds[p, column.HELD] != 0, float(laws.speed[p])
    rows = np.zeros((3 if held else 1, len(Y)))
    for j in range(len(Y)):
        rows[-1, j] = rules.forms[row, j]
        if held:
            rows[0, j] = laws.variables[0, j] if j < n else 0.0
            rows[1, j] = laws.velocity[p, 0, 0, j]
    if held:
        rows[0, n + 2] = -(value_of(rows[0], Y) + speed * s)
        rows[1, n + 2] -= speed
    y = state_at(rules.phases.poles, rules.omega, p, Y, s)
    return on(rows, BodyState(y, angle, NONE, state.memory))


def changes(rules: Rules, p: int, row: int, end: BodyState, behind: BodyState) -> bool:
    """Whether a switch changes anything: the phase, the memory, or a velocity."""
    surface = int(rules.surfaces[row])
    if jumps_at(rules, p, surface) != NONE:
        return True
    memory = entered(rules, p, p, behind).memory
    for i in range(len(memory)):
        if memory[i] != behind.memory[i]:
            return True
    if not follows(rules, p, int(rules.endings[p, surface]), p, behind):
        return True
    return bool(next_phase(rules, p, surface, end, behind) != p)


def jumping(rules: Rules, p: int, surface: int, after: int, state: BodyState) -> float:
    """Return the time until the jumps behind the end of a phase accumulate; 0 if unknown."""
    ending, laws, Y = jumps_at(rules, p, surface), rules.phases.laws, full_of(state)
    if ending == NONE or rules.kinds[after, column.HELD] != 0:
        return 0.0
    i, rho = int(laws.hit[ending]), float(laws.rho[ending])
    if i == NO_CONTACT:
        return 0.0
    v = value_of(laws.velocity[after, i, 0], Y)
    if not abs(v) > NOISE * size_of(laws.rounding[after, i], Y):  # its sign is rounding
        return 0.0
    a, jerk = value_of(laws.velocity[after, i, 1], Y), value_of(laws.velocity[after, i, 2], Y)
    if not v * a < 0:
        return 0.0
    place = laws.place[after, i]
    size = size_by_poles(rules.phases.poles, rules.omega, after, place, Y)
    resolved = NOISE * max(RESOLVED * size_of(place, Y), 2 * size)
    return time_left(v, a, jerk, rho, resolved)


def cannot_go_on(left: float, away: int) -> bool:
    """Whether the jumps accumulate without a rest: they are too low to be followed."""
    return left > 0 and away == NONE


def rest_of(
    rules: Rules, p: int, behind: BodyState, left: float, angle: float
) -> tuple[int, BodyState]:
    """Return the rest behind jumps that accumulate in a time `left`, and its state then."""
    rest = rest_behind(rules, p, behind)
    if rest == NONE:
        return rest, behind
    start = begun(rules, rest, entered(rules, p, rest, behind))
    y = state_at(rules.phases.poles, rules.omega, rest, full_of(start), left)
    return rest, begun(rules, rest, BodyState(y, angle, start.surface, start.memory))


def strobe(
    rules: Rules, p: int, state: BodyState, clock: Clock, s: float,
    states: Matrix, phases: Integers, count: int,
) -> int:  # fmt: skip
    """Fill in the states at the whole turns within a phase of duration `s`.

    Each is displacement and velocity of the first contact, the memory, and y.  `count` states
    are filled in before; return how many are then.
    """
    laws, poles, Y = rules.phases.laws, rules.phases.poles, full_of(state)
    memories = len(state.memory)
    while count < len(states):
        t = time_to(clock, count)
        if not t < s:
            break
        y = state_at(poles, rules.omega, p, Y, t)
        full = full_of(BodyState(y, clock.first, NONE, state.memory))
        states[count, 0] = value_of(laws.place[p, 0], full)
        states[count, 1], phases[count] = value_of(laws.velocity[p, 0, 0], full), p
        for i in range(memories):
            states[count, 2 + i] = state.memory[i]
        for i in range(len(y)):
            states[count, 2 + memories + i] = y[i]
        count += 1
    return count
