"""A motion of a body from phase to phase: one step is a phase, and what is behind it."""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from ...arrays import Vector
from ...scenes.bodies.cell import BodyCell
from ...scenes.orders import Step
from ..nodes import InState, Node, nodes
from ..steps.clock import Clock, angle_of, later
from ..steps.column import NONE
from ..steps.locate import EVENT
from ..steps.step import REFUSED, Passed
from .along import Along, state_at
from .locate import first_event
from .record import BodySegment
from .rules import BodyRules, BodyState


@dataclass(frozen=True)
class BodyMachine(BodyRules):
    """The phases of a cell of a body, and what follows a motion through them."""

    @classmethod
    def of(cls, cell: BodyCell) -> "BodyMachine":
        """Return the machine of a cell."""
        return cls(cell, nodes(cell))

    def window(self, p: int) -> float:
        """Return a time in which a motion in a phase does not turn often."""
        return self.regimes[p].window

    def begin(self, state: BodyState) -> tuple[int, BodyState] | None:
        """Return the phase in which a motion from a state begins, and the state in it."""
        for p in self.turns[-1]:
            if self.admits(p, state):
                return p, self.begun(p, state)
        return None

    def first(self, state: BodyState) -> Node | None:
        """Return the phase in which a motion from a state begins; None if it is in none."""
        found = self.begin(state)
        return None if found is None else self.nodes[found[0]]

    def at_rest(self, angle: float) -> BodyState | None:
        """Return an admissible state at rest: at 0, or where a phase leaves it in balance."""
        found = (self.still(angle), *self._balanced(angle))
        return next((state for state in found if self.first(state)), None)

    def still(self, angle: float) -> BodyState:
        """Return the state at rest where nothing is displaced."""
        return self._at(np.zeros(len(self.free.A)), angle)

    def released(self, x: float, v: float, angle: float) -> BodyState:
        """Return the state nearest to rest with a place and a velocity of the first contact."""
        rows = self.regimes[0].contacts[:2, 0].copy()
        rows[:, self.regimes[0].states + 2] -= x, v
        return self.remembered(self.on(rows, self.still(angle)))

    def starts(self, angle: float) -> list[BodyState | None]:
        """Return states from which motions settle: at rest, held, and in balance."""
        rest = self.still(angle)
        held = [p for p, node in enumerate(self.nodes) if node.phase.held]
        begun = (self.remembered(self.begun(p, rest)) for p in held)
        return [self.at_rest(angle), *begun, *self._balanced(angle)]

    def _balanced(self, angle: float) -> Iterator[BodyState]:
        """Yield the states in which each phase would leave the body without a forcing."""
        for regime in self.regimes:
            own = regime.part.lawful
            still, *_ = np.linalg.lstsq(own.A, -own.inputs[:, 2])
            yield self._at(np.asarray(still, dtype=float), angle)

    def _at(self, y: Vector, angle: float) -> BodyState:
        """Return a state with the memory that suits it best; see `remembered`."""
        nothing = (0.0,) * len(self.cell.memory)
        return self.remembered(BodyState(tuple(map(float, y)), angle, NONE, nothing))

    def step(self, p: int, state: BodyState, clock: Clock, most: float) -> Passed:
        """Follow a phase from where it begins, for a time at most, and across its switch.

        An event behind which nothing changes is passed, as where a mass comes back through the
        place at which it left a spring.
        """
        begun, start, regime = state, 0.0, self.regimes[p]
        while True:
            rows, surfaces = self.watched(p, begun)
            known = np.array([surface == begun.surface for surface in surfaces])
            along = Along(regime, self.full(begun), rows)
            s, how, form = first_event(along, known, most - start)
            now, s = later(clock, start + s), start + s
            if how != EVENT:
                return _passed(s, how, NONE, 0.0, state, p, state, clock)
            surface = surfaces[form]
            before = self._ended(p, state, s, rows[form], angle_of(now))
            behind = self.crossed(p, surface, before)
            after = self.next_phase(p, surface, before, behind)
            if after == NONE:
                return _passed(s, REFUSED, surface, 0.0, behind, p, behind, now)
            entered = self.begun(after, self.entered(after, behind))
            changes = after != p or entered.memory != state.memory or self.law(p, surface)
            if changes or s == start:
                break
            begun, start = entered, s
        left, away = self.time_left(p, surface, after, entered), NONE
        rest = self.rest_behind(p, behind) if left else NONE
        if rest != NONE:  # the last of the jumps stands for all that are left
            away, after, now = after, rest, later(now, left)
            entered = self._rested(rest, behind, left, angle_of(now))
        return _passed(s, EVENT, surface, left, behind, after, entered, now, away)

    def _rested(self, rest: int, behind: BodyState, left: float, angle: float) -> BodyState:
        """Return the state in which a rest begins behind jumps that go on for a time."""
        begun = self.begun(rest, self.entered(rest, behind))
        y = state_at(self.regimes[rest], self.full(begun), left)
        return self.begun(rest, begun._replace(y=tuple(map(float, y)), angle=angle))

    def _ended(
        self, p: int, state: BodyState, s: float, row: Vector, angle: float
    ) -> BodyState:
        """Return the state in which a phase ends where a form vanishes, without rounding there.

        A held contact has moved by its speed.
        """
        regime, Y, rows = self.regimes[p], self.full(state), [row]
        speed, n = self.nodes[p].phase.speed, self.regimes[p].states
        if self.nodes[p].phase.held:
            place, velocity = np.zeros(len(Y)), regime.contacts[1, 0].copy()
            place[:n] = self.free.rows[0, :n]
            place[n + 2] = -(place @ Y + speed * s)
            velocity[n + 2] -= speed
            rows += [place, velocity]
        y = tuple(map(float, state_at(regime, Y, s)))
        return self.on(np.array(rows), BodyState(y, angle, NONE, state.memory))

    def after(self, one: Step, end: BodyState) -> Node | None:
        """Return the phase that follows where the event of one ends it in a state."""
        p = self.number(one)
        end = self.begun(p, end)
        found = self.next_phase(
            p, self.nodes[p].event, end, self.crossed(p, self.nodes[p].event, end)
        )
        return None if found == NONE else self.nodes[found]

    def in_state(self, p: int) -> InState:
        """Return what forms of a phase are in a state."""
        regime = self.regimes[p]
        return InState(regime.part.lawful.rows, regime.generator, regime.states + 2)

    def has_rest(self, surface: int) -> bool:
        """Whether the scene has a rest at the place of a surface."""
        return any(q != NONE and self.nodes[q].event == surface for q in self.walls)

    def recorded(
        self, p: int, state: BodyState, t: Fraction, s: float, surface: int
    ) -> BodySegment:
        """Return a phase that was followed as it is kept."""
        node, regime, Y = self.nodes[p], self.regimes[p], self.full(state)
        x, v = (float(row @ Y) for row in regime.contacts[:2, 0])
        return BodySegment(
            node.phase, node.index, node.mirrored, t, state.angle, x, v, s,
            self.ending(p, surface), Y=Y, regime=regime, watched=self.watched(p, state)[0],
        )  # fmt: skip

    def remembered(self, state: BodyState) -> BodyState:
        """Return a state of which nothing is remembered with what suits it best.

        The middle of what the demands of a phase leave to it; where they leave it free, what
        the beginning of the phase sets.
        """
        if not self.cell.memory:
            return state
        for p in range(len(self.nodes)):
            found = self.entered(p, state)
            for i in range(len(self.cell.memory)):
                found = self.in_the_middle(p, found, i)
            if self.admits(p, found):
                return found
        return state

    def unmet(self, state: BodyState) -> str:
        """Return in words why no phase takes a state."""
        found = []
        for p, q in enumerate(self.nodes):
            words = [w for w, sign in self.signs(p, self.begun(p, state)) if sign < 0]
            if words:
                found.append(f"in {q.phase.name} not true that {words[0]}")
            elif q.phase.held:
                found.append(f"the velocity or the place is not that of {q.phase.name}")
        return "; ".join(dict.fromkeys(found))


def _passed(
    s: float, how: int, surface: int, left: float, behind: BodyState, phase: int,
    state: BodyState, clock: Clock, away: int = NONE,
) -> Passed:  # fmt: skip
    """Return a phase that was followed; its states are those of a body."""
    return Passed(s, how, surface, left, away, behind, phase, state, clock)  # type: ignore[arg-type]
