"""What is of bodies in the rules by which one phase follows another.

The functions stand for those of the same names in `steps`, over the `Rules` and the states
of bodies: plain Python.
"""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np

from ...arrays import Matrix, Vector
from ...bodies.switch import impulses_of
from ...scenes.bodies.cell import BodyCell
from ..nodes import Node
from ..steps import chatter, column
from ..steps.clock import Clock, angle_of, later
from ..steps.column import NONE
from ..steps.locate import EVENT, NOISE
from ..steps.rules import Rules, rules_of
from ..steps.state import NEAR, sets
from ..steps.switches import next_phase, rest_behind
from .along import Along, state_at
from .locate import first_event
from .regime import Regime, regimes

#: Of each contact, ``rho`` and ``d`` of its velocity ``rho v + d`` behind a switch.
Jumps: TypeAlias = Sequence[tuple[float, float]]

#: Height of a jump that is located, in units of what is rounding of a displacement.
RESOLVED = 4


class BodyState(NamedTuple):
    """A state of a body, without units: y of the modes, the angle of the forcing, the memory.

    The surface that it is known to be on, or `NONE`; see `bodies.laws` for y.
    """

    y: tuple[float, ...]
    angle: float
    surface: int = NONE
    memory: tuple[float, ...] = ()

    def at(self, y: Vector) -> "BodyState":
        """Return the state with another y."""
        return self._replace(y=tuple(map(float, y)))

    @property
    def full(self) -> Vector:
        """What forms are of: ``Y = (y, cos, sin, 1, memory)``."""
        waves = np.cos(self.angle), np.sin(self.angle), 1.0
        return np.array([*self.y, *waves, *self.memory])


def body_rules_of(cell: BodyCell, nodes: Sequence[Node]) -> Rules:
    """Return the rules of a cell of a body, whose phases are nodes."""
    own, found = rules_of(cell, nodes), regimes(cell, nodes)
    ends = zip(found, own.kinds[:, column.ROW], own.kinds[:, column.END], strict=True)
    forms = [own.forms[a:b] @ regime.part.lawful.rows for regime, a, b in ends]
    return own._replace(phases=found, forms=np.vstack(forms))


def local_of(rules: Rules, p: int, state: BodyState) -> tuple[Regime, Vector]:
    """Return a phase at a state in which it begins."""
    return rules.phases[p], begun(rules, p, state).full


def sign_of(rules: Rules, at: tuple[Regime, Vector], row: int, state: BodyState) -> int:
    """Return the sign of a form just after a state."""
    regime, Y = at
    return regime.sign_after(rules.forms[row], Y, bool(rules.surfaces[row] == state.surface))


def may_be_held(rules: Rules, p: int, state: BodyState) -> bool:
    """Whether a held phase is held at a state: behind a jump, there alone.

    A jump may give its velocity to the whole body, of which some modes are left out.
    """
    regime, wall, Y = rules.phases[p], rules.kinds[p, column.WALL], state.full
    speed, row = regime.phase.speed, rules.kinds[wall, column.ROW]
    on = wall != NONE and bool(rules.surfaces[row] == state.surface)
    if on and rules.phases[wall].phase.jumps[0] == (0.0, speed):
        return True
    v = float(regime.contacts[1, 0] @ Y)
    if abs(v - speed) > NEAR * max(1.0, abs(speed)):
        return False
    event = rules.forms[row]
    return bool(wall == NONE or on or abs(event @ Y) <= NOISE * (np.abs(event) @ np.abs(Y)))


def begun(rules: Rules, p: int, state: BodyState) -> BodyState:
    """Return a state with the velocity at which a phase is held, if it is."""
    regime: Regime = rules.phases[p]
    if not regime.phase.held:
        return state
    jumps = [(0.0, regime.phase.speed)] + [(1.0, 0.0)] * (len(regime.phase.laws) - 1)
    return struck(regime, state, regime.body.kept_mobility, jumps)


def struck(regime: Regime, state: BodyState, mobility: Vector, jumps: Jumps) -> BodyState:
    """Return a state behind impulses."""
    by_velocity, constant = impulses_of(mobility, jumps)
    velocity = regime.contacts[1] @ state.full
    return state.at(np.array(state.y) + regime.free.B @ (by_velocity @ velocity + constant))


def on(rows: Matrix, state: BodyState) -> BodyState:
    """Return the state nearest to one at which some forms vanish."""
    moved, *_ = np.linalg.lstsq(rows[:, : len(state.y)], rows @ state.full)
    return state.at(np.array(state.y) - moved)


def entered(rules: Rules, p: int, state: BodyState) -> BodyState:
    """Return the state in which a phase begins: with what its beginning sets."""
    values = list(state.memory)
    if sets(rules, p):
        seen = rules.phases[p].free.rows @ state.full
        for i in np.flatnonzero(rules.setting == rules.kinds[p, column.INDEX]):
            form = rules.memory[i].copy()
            form[3] *= rules.kinds[p, column.SIGN]
            values[i] = float(form @ seen)
    return state._replace(memory=tuple(values))


def jumps_of(rules: Rules, p: int, surface: int) -> Jumps:
    """Return the jumps where a phase ends on a surface; none where they are 1 and 0."""
    ending = rules.endings[p, surface]
    jumps: Jumps = () if ending == NONE else rules.phases[ending].phase.jumps
    return jumps if any(jump != (1.0, 0.0) for jump in jumps) else ()


def crossed(rules: Rules, p: int, row: int, end: BodyState) -> BodyState:
    """Return the state behind the switch from that in which a phase ends, where a form does."""
    surface, regime = int(rules.surfaces[row]), rules.phases[p]
    jumps = jumps_of(rules, p, surface)
    if not jumps:
        return end._replace(surface=surface)
    found = struck(regime, end, regime.body.mobility, jumps)
    moving = rules.phases[rules.endings[p, surface]].phase.event[1]
    return found._replace(surface=NONE if moving else surface)


def may_switch(rules: Rules, p: int, before: BodyState) -> bool:
    """Whether a state is one that the event of a phase demands, but for rounding."""
    kinds, Y = rules.kinds[p], before.full
    rows = rules.forms[kinds[column.AT_SWITCH] : kinds[column.END]]
    return bool((rows @ Y >= -NOISE * (np.abs(rows) @ np.abs(Y))).all())


def watched(rules: Rules, p: int, state: BodyState) -> tuple[list[int], Matrix]:
    """Return the rows of what may end a phase, and the forms, none negative there."""
    own = rules.kinds[p]
    event, behind = int(own[column.ROW]), int(own[column.AT_SWITCH])
    rows = [*range(event + 1, behind), *[event] * int(own[column.WATCHED])]
    forms, at = rules.forms[rows], (rules.phases[p], state.full)
    if own[column.WATCHED] and sign_of(rules, at, event, state) < 0:
        forms[-1] *= -1
    return rows, forms


def end_of_phase(
    rules: Rules, p: int, state: BodyState, clock: Clock, most: float
) -> tuple[float, int, int, BodyState]:
    """Return when a phase ends, how, the row of the form that ends it, and the state there.

    An event behind which nothing changes is passed, as where a mass comes back through the
    place at which it left a spring.
    """
    begins, start = state, 0.0
    while True:
        rows, forms = watched(rules, p, begins)
        along = Along(rules.phases[p], begins.full, forms)
        s, how, form = first_event(along, rules.surfaces[rows] == begins.surface, most - start)
        s, row = start + s, rows[form]
        if how != EVENT:
            return s, how, NONE, state
        end = reached(rules.phases[p], state, s, forms[form], angle_of(later(clock, s)))
        behind = crossed(rules, p, row, end)
        if s == start or changes(rules, p, row, end, behind):
            return s, how, row, end
        begins, start = begun(rules, p, behind), s


def reached(regime: Regime, state: BodyState, s: float, row: Vector, angle: float) -> BodyState:
    """Return the state in which a phase ends where a form vanishes, without rounding there.

    A held contact has moved by its speed.
    """
    Y, rows, n, speed = state.full, [row], regime.states, regime.phase.speed
    if regime.phase.held:
        place, velocity = np.zeros(len(Y)), regime.contacts[1, 0].copy()
        place[:n] = regime.free.rows[0, :n]
        place[n + 2] = -(place @ Y + speed * s)
        velocity[n + 2] -= speed
        rows += [place, velocity]
    end = BodyState((), angle, NONE, state.memory).at(state_at(regime, Y, s))
    return on(np.array(rows), end)


def changes(rules: Rules, p: int, row: int, end: BodyState, behind: BodyState) -> bool:
    """Whether a switch changes anything: the phase, the memory, or a velocity."""
    surface = int(rules.surfaces[row])
    same = not jumps_of(rules, p, surface) and entered(rules, p, behind) == behind
    return not same or next_phase(rules, p, surface, end, behind) != p


def jumping(rules: Rules, p: int, surface: int, after: int, state: BodyState) -> float:
    """Return how long jumps go on behind that which ends a phase; 0 if not known."""
    jumps, regime, Y = jumps_of(rules, p, surface), rules.phases[after], state.full
    hit = [(i, *jump) for i, jump in enumerate(jumps) if jump != (1.0, 0.0)]
    if len(hit) != 1 or regime.phase.held or hit[0][2] != 0:
        return 0.0
    i, rho, _ = hit[0]
    row = regime.contacts[1, i]
    if regime.leading(row, Y, False):  # whether it moves away is not known
        return 0.0
    v, a = row @ Y, row @ regime.generator @ Y
    jerk = row @ regime.generator @ regime.generator @ Y
    resolved = RESOLVED * NOISE * (np.abs(regime.contacts[0, i]) @ np.abs(Y))
    return float(chatter.time_left(v, a, jerk, rho, resolved))


def rest_of(
    rules: Rules, p: int, behind: BodyState, left: float, angle: float
) -> tuple[int, BodyState]:
    """Return the rest behind jumps that go on for a time, and the state in which it begins."""
    rest = rest_behind(rules, p, behind)
    if rest == NONE:
        return rest, behind
    first = begun(rules, rest, entered(rules, rest, behind))
    y = state_at(rules.phases[rest], first.full, left)
    return rest, begun(rules, rest, first.at(y)._replace(angle=angle))
