"""Which phase follows an event: one whose demands hold just after it.

A phase ends where its event happens or one of its demands would be violated next.  The law of
the switch is that of the event; a demand that ends where the event of another phase of the same
equation happens has the law of that.  A phase that is held behind a jump of the velocity at
a place is a rest there: it is entered by a jump that leaves no velocity or by infinitely many.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from ..scenes.cell import Cell, Form
from ..scenes.orders import Step
from .bounds import local
from .locate import NOISE, sign_after
from .nodes import Node, nodes

#: How far from the velocity at which a phase is held a motion may enter it, without units.
NEAR = 1e-9


@dataclass(frozen=True)
class State:
    """Displacement, velocity, angle of the forcing and memory, without units.

    Parameters
    ----------
    x, v, angle : float
    surface : int or None
        The surface that it is known to be on: that of the event that has just happened.
    memory : tuple of float
        What the motion remembers.
    placed : bool
        Whether the displacement is that of the surface, to its own rounding.
    """

    x: float
    v: float
    angle: float
    surface: int | None = None
    memory: tuple[float, ...] = ()
    placed: bool = False


@dataclass(frozen=True)
class Machine:
    """The phases of a cell, and the rules by which one follows another."""

    cell: Cell
    nodes: tuple[Node, ...]

    @classmethod
    def of(cls, cell: Cell) -> "Machine":
        """Return the machine of a cell."""
        return cls(cell, nodes(cell))

    def first(self, state: State) -> Node | None:
        """Return the phase in which a motion from a state begins; None if it is in none."""
        return next((q for q in self._held_first(None) if self.admits(q, state)), None)

    def watched(self, node: Node, state: State) -> list[tuple[int, Form]]:
        """Return what ends a phase: surfaces, each with a form that is not negative before."""
        phase = node.at(state)
        found = [(q, form) for q, (_, form) in zip(node.demands, phase.demands, strict=True)]
        if node.event not in node.demands:
            event = phase.event
            ahead = self._sign(node, node.event, event, state) >= 0
            found.append((node.event, event if ahead else _negative(event)))
        return found

    def _sign(self, node: Node, surface: int, form: Form, state: State) -> int:
        x, v, omega, angle = state.x, state.v, self.cell.omega, state.angle
        at = local(node.at(state), x, v, omega, angle, state.placed)
        return sign_after(at, form, surface == state.surface)

    def law(self, node: Node, surface: int) -> tuple[float, float]:
        """Return rho and d of the switch where a phase ends on a surface."""
        ending = self.ending(node, surface)
        return (1.0, 0.0) if ending is None else (ending.phase.rho, ending.phase.d)

    def ending(self, node: Node, surface: int) -> Node | None:
        """Return the phase of the same equation whose event is a surface; None without one."""

        def equation(q: Node) -> tuple[object, ...]:
            phase = q.phase
            return phase.m, phase.c, phase.k, phase.f, phase.g, phase.held, phase.memory

        turn = (node, *self.nodes)
        same = (q for q in turn if q.event == surface and equation(q) == equation(node))
        return next(same, None)

    def node(self, step: Step) -> Node:
        """Return a phase as an order calls it."""
        return self.nodes[step.phase + len(self.cell.phases) * step.mirrored]

    def crossed(self, node: Node, surface: int, form: Form, end: State) -> State:
        """Return the state behind the switch on a surface from that in which a phase ends.

        A displacement or a velocity that the surface alone gives is that, without rounding.
        """
        (rho, d), (ex, ev, ec, constant) = self.law(node, surface), form
        placed, paced = ev == ec == 0 != ex, ex == ec == 0 != ev
        x = 0.0 - constant / ex if placed else end.x
        v = 0.0 - constant / ev if paced else end.v
        known = surface if ev == 0 or (rho, d) == (1, 0) else None
        return replace(end, x=x, v=rho * v + d, surface=known, placed=placed)

    def next(self, node: Node, surface: int, before: State, state: State) -> Node | None:
        """Return the phase that follows on a surface, from the state behind the switch.

        The one that the scene declares does not follow where the state `before` the switch is
        not one that the event demands.
        """
        declared = self._beside(node, 1) if surface == node.event else None
        refused = declared if declared and not self._switches(node, before) else None
        return next(
            (
                q
                for q in self._held_first(declared)
                if q is not refused
                and (q is declared or not self.sets(q))
                and self.admits(q, self.entered(q, state))
            ),
            None,
        )

    def _switches(self, node: Node, before: State) -> bool:
        """Whether a state is one that the event of a phase demands, but for rounding."""
        terms = before.x, before.v, math.cos(before.angle), 1.0
        for _, form in node.at(before).switch_demands:
            parts = [factor * term for factor, term in zip(form, terms, strict=True)]
            if sum(parts) < -NOISE * sum(map(abs, parts)):
                return False
        return True

    def rest(self, node: Node, surface: int, state: State) -> Node | None:
        """Return the rest at a place that takes a state whose jumps have died away there."""
        still = (
            q for q in self._held_first(self._beside(node, 1)) if self._wall(q) is not None
        )
        return next((q for q in still if self.admits(q, q.begun(state))), None)

    def has_rest(self, surface: int) -> bool:
        """Whether the scene has a rest at a place."""
        walls = (self._wall(node) for node in self.nodes)
        return any(wall is not None and wall.event == surface for wall in walls)

    def sets(self, node: Node) -> bool:
        """Whether the beginning of a phase sets what the motion remembers.

        Such a phase follows its event alone: elsewhere, what it sets would be wrong.
        """
        return any(memory.phase == node.index for memory in self.cell.memory)

    def _beside(self, node: Node, step: int) -> Node:
        """Return the phase that the scene declares behind another, or before it."""
        place = node.index + len(self.cell.phases) * node.mirrored
        return self.nodes[(place + step) % len(self.nodes)]

    def _wall(self, node: Node) -> Node | None:
        """Return the phase behind whose jump one is held in place; None where it is not."""
        before = self._beside(node, -1)
        return before if node.phase.held and before.jumps else None

    def _held_first(self, declared: Node | None) -> Iterator[Node]:
        """Yield phases as they are tried in turn: constraints hold while they can."""
        turn = self.nodes if declared is None else (declared, *self.nodes)
        yield from (q for q in turn if q.phase.held and q.phase.demands)
        yield from turn

    def admits(self, node: Node, state: State) -> bool:
        """Whether the demands of a phase hold just after a state."""
        return self._holds(node, state) and all(
            self._sign(node, surface, form, state) >= 0
            for surface, (_, form) in zip(node.demands, node.at(state).demands, strict=True)
        )

    def _holds(self, node: Node, state: State) -> bool:
        """Whether a phase, if it is held, is held at a state: behind a jump, there alone."""
        if not node.phase.held:
            return True
        speed, wall = node.phase.speed, self._wall(node)
        if wall is None:
            return abs(state.v - speed) <= NEAR * max(1.0, abs(speed))
        return state.v == speed and (state.surface == wall.event or _is_on(wall, state))

    def entered(self, node: Node, state: State) -> State:
        """Return the state in which a phase begins: with what its beginning sets."""
        values = list(state.memory)
        for i, memory in enumerate(self.cell.memory):
            if memory.phase == node.index:
                vx, vv, vc, constant = memory.value
                moving = vx * state.x + vv * state.v + vc * math.cos(state.angle)
                values[i] = moving + (-constant if node.mirrored else constant)
        return replace(state, memory=tuple(values))

    def remembered(self, state: State) -> State:
        """Return a state of which nothing is remembered with what suits it best.

        The middle of what the demands of a phase leave to it; where they leave it free, what
        the beginning of the phase sets.
        """
        if not self.cell.memory or state.memory:
            return state
        for node in self.nodes:
            begun = self.entered(node, replace(state, memory=(0.0,) * len(self.cell.memory)))
            for i in range(len(self.cell.memory)):
                begun = _in_the_middle(node, begun, i)
            if self.admits(node, begun):
                return begun
        return replace(state, memory=(0.0,) * len(self.cell.memory))

    def unmet(self, state: State) -> str:
        """Return in words why no phase takes a state."""
        found = []
        for q in self.nodes:
            demands = zip(q.demands, q.at(state).demands, strict=True)
            words = [w for on, (w, form) in demands if self._sign(q, on, form, state) < 0]
            if words:
                found.append(f"in {q.phase.name} not true that {words[0]}")
            elif q.phase.held:
                found.append(f"the velocity or the place is not that of {q.phase.name}")
        return "; ".join(dict.fromkeys(found))


def _negative(form: Form) -> Form:
    x, v, cos, constant = form
    return -x, -v, -cos, -constant


def _is_on(node: Node, state: State) -> bool:
    """Whether a state is on the surface of the event of a phase, to rounding."""
    ex, _, ec, constant = node.at(state).event
    terms = ex * state.x, ec * math.cos(state.angle), constant
    return abs(sum(terms)) <= NOISE * sum(map(abs, terms))


def _in_the_middle(node: Node, state: State, i: int) -> State:
    """Return a state with one memory in the middle of what the demands of a phase leave."""
    low, high, cosine = -math.inf, math.inf, math.cos(state.angle)
    others = list(state.memory)
    others[i] = 0.0
    for (_, raw), (_, form) in zip(
        node.phase.demands, node.phase.remembering(others).demands, strict=True
    ):
        factor = raw[4 + i]
        value = form[0] * state.x + form[1] * state.v + form[2] * cosine + form[3]
        if factor > 0:
            low = max(low, -value / factor)
        elif factor < 0:
            high = min(high, -value / factor)
    if math.isfinite(low) and math.isfinite(high):
        others[i] = (low + high) / 2
        return replace(state, memory=tuple(others))
    return state
