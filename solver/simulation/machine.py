"""The phases of a cell and the rules by which one follows another, for states one by one."""

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from types import ModuleType
from typing import Any

import numpy as np

from ..flow import divided, responses
from ..kernels import linking
from ..kernels.family import Family
from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Cell
from ..scenes.classes import generator
from ..scenes.orders import Step
from .nodes import InState, Node, Phases, nodes
from .record import Segment
from .steps import (
    bounds,
    chatter,
    clock,
    column,
    locate,
    rules,
    run,
    state,
    step,
    switches,
    zeros,
)
from .steps.bounds import window
from .steps.clock import Clock
from .steps.column import NONE, ROW
from .steps.rules import Rules, rules_of
from .steps.state import State, begun, entered, local_of, sign_of
from .steps.step import Passed
from .steps.switches import admits, crossed, first_phase, has_rest, next_phase

#: How far from a limit a mass that is pressed against it is put, in units of length.
ASIDE = 0.1

#: What a motion is followed by, beside the flow of a phase.
PARTS = zeros, bounds, locate, chatter, clock, state, switches, step


def linked(motion: ModuleType, make: linking.Make) -> dict[str, Any]:
    """Return the functions of `step` and `run`, plain or compiled."""
    flow = linking.made((divided, responses), {}, make)

    def counting(function: Any, names: dict[str, Any], _: bool) -> Any:
        """Return a function made so that numba counts: some take lists of forms."""
        return make(function, names, True)

    return linking.made((*PARTS, motion), {"state_at": flow["state_at"]}, counting)


#: The functions, linked as plain Python or compiled; what plain ones cost is kept.
FAMILY = Family(linked, (divided, responses, column, rules, *PARTS), step.step)


def with_array(state: State) -> State:
    """Return a state whose memory is an array, as it is where functions are compiled."""
    return state._replace(memory=np.array(state.memory, dtype=float))


def follow_by(name: str, *arguments: Any) -> Any:
    """Return what `step` or `run` does: in plain Python, or compiled once that pays."""
    account = FAMILY.account_of(run.__name__)
    if account.pays():
        return FAMILY.compiled(run.__name__)[name](*arguments)
    with account.spending():
        return FAMILY.plain(run.__name__)[name](*arguments)


@dataclass(frozen=True)
class Machine(Phases):
    """The phases of a cell of one mass, and the rules by which one follows another."""

    @classmethod
    def of(cls, cell: Cell) -> "Machine":
        """Return the machine of a cell.

        Raises
        ------
        ValueError
            If it is that of a body.
        """
        if isinstance(cell, BodyCell):
            raise ValueError("got a body of several degrees of freedom, expected one mass")
        return cls(cell, nodes(cell))

    @cached_property
    def rules(self) -> Rules:
        """The same as arrays."""
        return rules_of(self.cell, self.nodes)

    def first(self, state: State) -> Node | None:
        """Return the phase in which a motion from a state begins; None if it is in none."""
        return self._node(first_phase(self.rules, state))

    def _node(self, p: int) -> Node | None:
        return None if p == NONE else self.nodes[p]

    def window(self, p: int) -> float:
        """Return a time in which a motion in a phase does not turn often; may be infinite."""
        return window(self.nodes[p].phase, self.cell.omega)

    def begin(self, state: State) -> tuple[int, State] | None:
        """Return the phase in which a motion from a state begins, and the state in it."""
        p = first_phase(self.rules, state)
        if p == NONE:
            return None
        return p, with_array(begun(self.rules, p, state))

    def released(self, x: float, v: float, angle: float) -> State:
        """Return the state with a displacement and a velocity, and a memory that suits it."""
        return self.remembered(State(x, v, angle))

    def at_rest(self, angle: float) -> State | None:
        """Return the admissible state at rest that is nearest to 0."""
        cosine = math.cos(angle)
        places = [0.0]
        for node in self.nodes:
            for x, _, cos, constant, *_ in (form for _, form in node.phase.demands):
                if x:
                    limit = -(constant + cos * cosine) / x
                    places += [limit, limit - ASIDE, limit + ASIDE]
        speeds = [0.0, *(q.phase.speed for q in self.nodes if q.phase.held)]
        for speed in speeds:
            for place in sorted(places, key=abs):
                state = self.remembered(State(place, speed, angle))
                if self.first(state) is not None:
                    return state
        return None

    def starts(self, angle: float) -> list[State | None]:
        """Return states from which motions settle: at rest, and in each held phase."""
        held = [State(0.0, q.phase.speed, angle) for q in self.nodes if q.phase.held]
        return [self.at_rest(angle), *map(self.remembered, held)]

    def step(self, p: int, state: State, clock: Clock, most: float) -> Passed:
        """Follow a phase from where it begins, for a time at most, and across its switch."""
        passed: Passed = follow_by("step", self.rules, p, state, clock, most)
        return passed

    def in_state(self, p: int) -> InState:
        """Return what forms of a phase are in a state ``(x, x', 1, cos, sin, memory)``."""
        more = len(self.cell.memory)
        rows = np.eye(4 + more, 5 + more, 1)
        rows[:3] = np.eye(5 + more)[[0, 1, 3]]
        rows[3] = np.eye(5 + more)[2]
        return InState(rows, generator(self.cell, self.nodes[p].phase, 1), 2)

    def has_rest(self, surface: int) -> bool:
        """Whether the scene has a rest at the place of a surface."""
        return has_rest(self.rules, surface)

    def recorded(self, p: int, state: State, t: Fraction, s: float, surface: int) -> Segment:
        """Return a phase that was followed as it is kept."""
        node, memory = self.nodes[p], [float(value) for value in state.memory]
        place = (node.index, node.mirrored, t, state.angle)
        ended = self.ending(p, surface)
        return Segment(node.phase.remembering(memory), *place, state.x, state.v, s, ended)

    def after(self, one: Step, end: State) -> Node | None:
        """Return the phase that follows where the event of one ends it in a state."""
        p = self.number(one)
        end = begun(self.rules, p, end)
        behind = crossed(self.rules, p, int(self.rules.kinds[p, ROW]), end)
        return self._node(next_phase(self.rules, p, self.nodes[p].event, end, behind))

    def remembered(self, state: State) -> State:
        """Return a state of which nothing is remembered with what suits it best.

        The middle of what the demands of a phase leave to it; where they leave it free, what
        the beginning of the phase sets.
        """
        if not self.cell.memory or len(state.memory):
            return state
        nothing = state._replace(memory=(0.0,) * len(self.cell.memory))
        for p, node in enumerate(self.nodes):
            found = entered(self.rules, p, nothing)
            found = found._replace(memory=tuple(map(float, found.memory)))
            for i in range(len(self.cell.memory)):
                found = _in_the_middle(node, found, i)
            if admits(self.rules, p, found):
                return found
        return nothing

    def unmet(self, state: State) -> str:
        """Return in words why no phase takes a state."""
        found = []
        for p, q in enumerate(self.nodes):
            at, first = local_of(self.rules, p, state), int(self.rules.kinds[p, ROW]) + 1
            demands = enumerate((words for words, _ in q.phase.demands), first)
            words = [w for row, w in demands if sign_of(self.rules, at, row, state) < 0]
            if words:
                found.append(f"in {q.phase.name} not true that {words[0]}")
            elif q.phase.held:
                found.append(f"the velocity or the place is not that of {q.phase.name}")
        return "; ".join(dict.fromkeys(found))


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
        return state._replace(memory=tuple(others))
    return state
