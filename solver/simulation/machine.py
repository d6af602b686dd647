"""Which phase follows an event: one whose demands hold just after it.

The phases of a scene are those of its cell and, where the other half of its period is the
mirror image of the cell, their mirror images.  A phase ends where its event happens or one of
its demands would be violated next.  The law of the switch is that of the event; a demand that
ends where the event of another phase of the same equation happens has the law of that.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Vector
from ..case.cell import Cell, Form, Phase
from .bounds import local
from .locate import sign_after

#: How far from the velocity at which a phase is held a motion may enter it, without units.
NEAR = 1e-9


@dataclass(frozen=True)
class Node:
    """One phase that a motion can be in.

    Parameters
    ----------
    phase : Phase
        In the coordinates of the motion.
    index : int
        Its place in the cell.
    mirrored : bool
        Whether it is the mirror image of a phase of the cell.
    """

    phase: Phase
    index: int
    mirrored: bool

    def at(self, state: "State") -> Phase:
        """Return the phase with numbers for what the motion remembers."""
        return self.phase.remembering(state.memory)


def mirror(phase: Phase) -> Phase:
    """Return the mirror image of a phase: the motion ``-x`` half a period of the forcing on."""
    return replace(
        phase,
        f=-phase.f,
        speed=-phase.speed,
        event=_mirrored(phase.event),
        d=-phase.d,
        demands=tuple((words, _mirrored(form)) for words, form in phase.demands),
    )


def _mirrored(form: Form) -> Form:
    x, v, cos, constant, *memory = form
    return -x, -v, -cos, constant, *(-factor for factor in memory)


def nodes(cell: Cell) -> tuple[Node, ...]:
    """Return the phases that a motion of a cell can be in."""
    own = tuple(Node(cell.carrying(p), p, False) for p in range(len(cell.phases)))
    if cell.sign > 0:
        return own
    return own + tuple(Node(mirror(q.phase), q.index, True) for q in own)


@dataclass(frozen=True)
class State:
    """Displacement, velocity, angle of the forcing and memory, without units.

    Parameters
    ----------
    x, v, angle : float
    zero : Form or None
        A form that is known to vanish there: that of the event that has just happened.
    memory : tuple of float
        What the motion remembers.
    """

    x: float
    v: float
    angle: float
    zero: Form | None = None
    memory: tuple[float, ...] = ()

    def has(self, form: Form) -> bool:
        """Whether a form is known to vanish there."""
        return self.zero is not None and same(form, self.zero)


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

    def watched(self, node: Node, state: State) -> list[Form]:
        """Return the forms that end a phase where they vanish: not negative at its start."""
        phase = node.at(state)
        forms = [form for _, form in phase.demands]
        event = phase.event
        if not any(same(form, event) for form in forms):
            forms.append(event if self._sign(node, event, state) >= 0 else _negative(event))
        return forms

    def _sign(self, node: Node, form: Form, state: State) -> int:
        at = local(node.at(state), state.x, state.v, self.cell.omega, state.angle)
        return sign_after(at, form, state.has(form))

    def law(self, node: Node, form: Form, state: State) -> tuple[float, float]:
        """Return rho and d of the switch where a form that ends a phase vanishes."""
        own = node.at(state)
        equation = (own.m, own.c, own.k, own.f, own.g, own.held)
        for other in (node, *self.nodes):
            q = other.at(state)
            alike = (q.m, q.c, q.k, q.f, q.g, q.held) == equation
            if alike and same(q.event, form):
                return q.rho, q.d
        return 1.0, 0.0

    def next(self, node: Node, form: Form, state: State) -> Node | None:
        """Return the phase that follows where a form vanished, the law of the switch done."""
        declared = self._declared(node) if same(form, node.at(state).event) else None
        found = self._held_first(declared)
        return next(
            (
                q
                for q in found
                if (q is declared or not self.sets(q))
                and self.admits(q, self.entered(q, state))
            ),
            None,
        )

    def sets(self, node: Node) -> bool:
        """Whether the beginning of a phase sets what the motion remembers.

        Such a phase follows its event alone: elsewhere, what it sets would be wrong.
        """
        return any(memory.phase == node.index for memory in self.cell.memory)

    def _declared(self, node: Node) -> Node:
        after = (node.index + 1) % len(self.cell.phases)
        mirrored = node.mirrored != (after == 0 and self.cell.sign < 0)
        return next(q for q in self.nodes if (q.index, q.mirrored) == (after, mirrored))

    def _held_first(self, declared: Node | None) -> Iterator[Node]:
        """Yield phases as they are tried in turn: constraints hold while they can."""
        yield from (q for q in self.nodes if q.phase.held and q.phase.demands)
        if declared is not None:
            yield declared
        yield from self.nodes

    def admits(self, node: Node, state: State) -> bool:
        """Whether the demands of a phase hold just after a state."""
        phase = node.at(state)
        if phase.held and abs(state.v - phase.speed) > NEAR * max(1.0, abs(phase.speed)):
            return False
        return all(self._sign(node, form, state) >= 0 for _, form in phase.demands)

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
            demands = q.at(state).demands
            words = [words for words, form in demands if self._sign(q, form, state) < 0]
            if words:
                found.append(f"in {q.phase.name} not true that {words[0]}")
            elif q.phase.held:
                found.append(f"the velocity is not that of {q.phase.name}")
        return "; ".join(dict.fromkeys(found))


def same(one: Form, other: Form) -> bool:
    """Whether two forms vanish at the same states.

    Examples
    --------
    >>> same((1.0, 0.0, 0.0, -0.5), (-2.0, 0.0, 0.0, 1.0))
    True
    >>> same((1.0, 0.0, 0.0, -0.5), (1.0, 0.0, 0.0, 0.5))
    False
    >>> same((1.0, 0.0, 0.0, -1e300), (-2.0, 0.0, 0.0, 2e300))
    True
    """
    a, b = _scaled(one), _scaled(other)
    sizes = math.sqrt(float(a @ a) * float(b @ b))
    return bool(sizes > 0 and sizes - abs(float(a @ b)) <= 1e-12 * sizes)


def _scaled(form: Form) -> Vector:
    """Return a form of which the largest factor is 1, so that no square overflows."""
    factors = np.array(form)
    return factors / (np.abs(factors).max() or 1.0)


def _negative(form: Form) -> Form:
    x, v, cos, constant = form
    return -x, -v, -cos, -constant


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
