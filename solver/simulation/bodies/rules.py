"""The rules by which one phase of a body follows another; see `steps.switches`.

They are those of one mass: a phase ends where its event happens or one of its demands would be
violated next, and one follows whose demands hold just behind that.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ...arrays import Matrix, Vector
from ...bodies.laws import Free, free
from ...bodies.switch import impulses_of
from ...scenes.bodies.cell import BodyCell, BodyPhase
from ..nodes import Phases, turns, walls
from ..steps.chatter import LEFT
from ..steps.column import NONE
from ..steps.locate import NOISE
from ..steps.switches import NEAR
from .regime import Regime, regimes

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


@dataclass(frozen=True)
class BodyRules(Phases):
    """The phases of a cell of a body, and the rules by which one follows another."""

    cell: BodyCell

    @cached_property
    def regimes(self) -> tuple[Regime, ...]:
        """Its phases in numbers."""
        return regimes(self.cell, self.nodes)

    @cached_property
    def turns(self) -> list[list[int]]:
        """In which turn phases are tried; see `nodes.turns`."""
        return turns(self.nodes)

    @cached_property
    def walls(self) -> list[int]:
        """Which phases are a rest at a place; see `nodes.walls`."""
        return walls(self.nodes)

    @cached_property
    def free(self) -> Free:
        """The body without its contact forces."""
        return free(self.cell.body, self.cell.omega, len(self.cell.memory))

    def full(self, state: BodyState) -> Vector:
        """Return ``Y = (y, cos, sin, 1, memory)``."""
        waves = np.cos(state.angle), np.sin(state.angle), 1.0
        return np.array([*state.y, *waves, *state.memory])

    def watched(self, p: int, state: BodyState) -> tuple[Vector, list[int]]:
        """Return the forms that may end a phase, none negative there, and their surfaces."""
        node, regime = self.nodes[p], self.regimes[p]
        rows, surfaces = regime.demands, list(node.demands)
        if node.event not in node.demands:
            known = node.event == state.surface
            sign = regime.sign_after(regime.event, self.full(state), known)
            rows = np.vstack([rows, -regime.event if sign < 0 else regime.event])
            surfaces.append(node.event)
        return rows, surfaces

    def signs(self, p: int, state: BodyState) -> Iterator[tuple[str, int]]:
        """Yield the demands of a phase in words, and their signs just after a state."""
        node, regime, Y = self.nodes[p], self.regimes[p], self.full(state)
        words = (w for w, _ in node.phase.demands)
        for w, row, surface in zip(words, regime.demands, node.demands, strict=True):
            yield w, regime.sign_after(row, Y, surface == state.surface)

    def admits(self, p: int, state: BodyState) -> bool:
        """Whether the demands of a phase hold just after a state."""
        if self.nodes[p].phase.held and not self._may_be_held(p, state):
            return False
        return all(sign >= 0 for _, sign in self.signs(p, self.begun(p, state)))

    def _may_be_held(self, p: int, state: BodyState) -> bool:
        """Whether a held phase is held at a state: behind a jump, there alone.

        A jump may give its velocity to the whole body, of which some modes are left out.
        """
        speed, wall, Y = self.nodes[p].phase.speed, self.walls[p], self.full(state)
        phase = self.nodes[wall].phase
        given = wall != NONE and isinstance(phase, BodyPhase) and phase.jumps[0] == (0.0, speed)
        if given and self.nodes[wall].event == state.surface:
            return True
        v = float(self.regimes[p].contacts[1, 0] @ Y)
        if abs(v - speed) > NEAR * max(1.0, abs(speed)):
            return False
        if wall == NONE or self.nodes[wall].event == state.surface:
            return True
        event = self.regimes[wall].event
        return bool(abs(event @ Y) <= NOISE * (np.abs(event) @ np.abs(Y)))

    def begun(self, p: int, state: BodyState) -> BodyState:
        """Return a state with the velocity at which a phase is held, if it is."""
        phase = self.nodes[p].phase
        if not phase.held:
            return state
        jumps = [(0.0, phase.speed)] + [(1.0, 0.0)] * (len(self.regimes[p].contacts[1]) - 1)
        return self._struck(state, self.cell.body.kept_mobility, jumps)

    def _struck(
        self, state: BodyState, mobility: Vector, jumps: Sequence[tuple[float, float]]
    ) -> BodyState:
        """Return a state behind impulses."""
        by_velocity, constant = impulses_of(mobility, jumps)
        velocity = self.regimes[0].contacts[1] @ self.full(state)
        moved = self.free.B @ (by_velocity @ velocity + constant)
        return state._replace(y=tuple(map(float, np.array(state.y) + moved)))

    def on(self, rows: Matrix, state: BodyState) -> BodyState:
        """Return the state nearest to one at which some forms vanish."""
        own = rows[:, : len(state.y)]
        moved, *_ = np.linalg.lstsq(own, rows @ self.full(state))
        return state._replace(y=tuple(map(float, np.array(state.y) - moved)))

    def entered(self, p: int, state: BodyState) -> BodyState:
        """Return the state in which a phase begins: with what its beginning sets."""
        if not self._sets(p):
            return state
        values, Y, node = list(state.memory), self.full(state), self.nodes[p]
        for i, each in enumerate(self.cell.memory):
            if each.phase == node.index:
                form = np.array(each.value[: len(self.free.rows)])
                form[3] *= -1 if node.mirrored else 1
                values[i] = float(form @ (self.free.rows @ Y))
        return state._replace(memory=tuple(values))

    def _sets(self, p: int) -> bool:
        """Whether the beginning of a phase sets what the motion remembers."""
        return any(each.phase == self.nodes[p].index for each in self.cell.memory)

    def in_the_middle(self, p: int, state: BodyState, i: int) -> BodyState:
        """Return a state with one memory in the middle of what the demands of a phase leave."""
        place = len(state.y) + 3 + i
        Y = self.full(state)
        Y[place] = 0.0
        factors, rest = self.regimes[p].demands[:, place], self.regimes[p].demands @ Y
        limits = -rest / np.where(factors == 0, 1.0, factors)
        low = limits[factors > 0].max(initial=-np.inf)
        high = limits[factors < 0].min(initial=np.inf)
        if not (np.isfinite(low) and np.isfinite(high)):
            return state
        values = list(state.memory)
        values[i] = float(low + high) / 2
        return state._replace(memory=tuple(values))

    def law(self, p: int, surface: int) -> Sequence[tuple[float, float]]:
        """Return the jumps where a phase ends on a surface; none where they are 1 and 0."""
        ending = self.ending(p, surface)
        phase = None if ending is None else self.node(ending).phase
        jumps = phase.jumps if isinstance(phase, BodyPhase) else ()
        return jumps if any(jump != (1.0, 0.0) for jump in jumps) else ()

    def crossed(self, p: int, surface: int, end: BodyState) -> BodyState:
        """Return the state behind the switch from that in which a phase ends."""
        jumps = self.law(p, surface)
        if not jumps:
            return end._replace(surface=surface)
        found = self._struck(end, self.cell.body.mobility, jumps)
        event = np.array(next(q for q in self.nodes if q.event == surface).phase.event)
        return found._replace(surface=NONE if event[1] else surface)

    def next_phase(self, p: int, surface: int, before: BodyState, state: BodyState) -> int:
        """Return the phase that follows on a surface; see `steps.switches.next_phase`."""
        declared = (p + 1) % len(self.nodes) if surface == self.nodes[p].event else NONE
        refused = declared if declared != NONE and not self._switches(p, before) else NONE
        for q in self.turns[declared]:
            if q == refused or (q != declared and self._sets(q)):
                continue
            if self.admits(q, self.entered(q, state)):
                return q
        return NONE

    def _switches(self, p: int, before: BodyState) -> bool:
        """Whether a state is one that the event of a phase demands, but for rounding."""
        rows, Y = self.regimes[p].at_switch, self.full(before)
        return bool((rows @ Y >= -NOISE * (np.abs(rows) @ np.abs(Y))).all())

    def rest_behind(self, p: int, state: BodyState) -> int:
        """Return the rest at a place that takes a state whose jumps have died away there."""
        for q in self.turns[(p + 1) % len(self.nodes)]:
            if self.walls[q] != NONE and self.admits(q, self.begun(q, state)):
                return q
        return NONE

    def time_left(self, p: int, surface: int, after: int, state: BodyState) -> float:
        """Return how long jumps go on behind one, as `chatter.time_left`; 0 if not known."""
        hit = [(i, *jump) for i, jump in enumerate(self.law(p, surface)) if jump != (1.0, 0.0)]
        if len(hit) != 1 or self.nodes[after].phase.held:
            return 0.0
        (i, rho, d), regime, Y = hit[0], self.regimes[after], self.full(state)
        row = regime.contacts[1, i]
        v, a, jerk = (
            row @ Y,
            row @ regime.generator @ Y,
            row @ regime.generator @ regime.generator @ Y,
        )
        if d != 0 or not (-1 < rho <= 0 and v * a < 0):
            return 0.0
        left = float(-2 * v / (a * (1 + rho)))
        resolved = RESOLVED * NOISE * (np.abs(regime.contacts[0, i]) @ np.abs(Y))
        short = left * left * max(1.0, abs(jerk / a)) <= LEFT
        return left if short or v * v <= 2 * abs(a) * resolved else 0.0
