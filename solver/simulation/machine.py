"""The phases of a cell and the rules by which one follows another, for states one by one."""

import math
from dataclasses import dataclass
from functools import cached_property
from types import ModuleType
from typing import Any

from ..flow import divided, responses
from ..kernels import linking
from ..kernels.family import Family
from ..scenes.bodies.cell import BodyCell
from ..scenes.bodies.only import NotOfBodies
from ..scenes.cell import Cell
from ..scenes.orders import Step
from .nodes import Node, nodes
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
from .steps.column import NONE, ROW
from .steps.rules import Rules, rules_of
from .steps.state import State, begun, entered, local_of, sign_of
from .steps.switches import admits, crossed, first_phase, next_phase

#: What a motion is followed by, beside the flow of a phase.
PARTS = zeros, bounds, locate, chatter, clock, state, switches, step


def linked(motion: ModuleType, make: linking.Make) -> dict[str, Any]:
    """Return the functions of `step` and `run`, plain or compiled."""
    flow = linking.made((divided, responses), {}, make)
    return linking.made((*PARTS, motion), {"state_at": flow["state_at"]}, make)


#: The functions, linked as plain Python or compiled; what plain ones cost is kept.
FAMILY = Family(linked, (divided, responses, column, rules, *PARTS), step.step)


def follow_by(name: str, *arguments: Any) -> Any:
    """Return what `step` or `run` does: in plain Python, or compiled once that pays."""
    account = FAMILY.account_of(run.__name__)
    if account.pays():
        return FAMILY.compiled(run.__name__)[name](*arguments)
    with account.spending():
        return FAMILY.plain(run.__name__)[name](*arguments)


@dataclass(frozen=True)
class Machine:
    """The phases of a cell, and the rules by which one follows another."""

    cell: Cell
    nodes: tuple[Node, ...]

    @classmethod
    def of(cls, cell: Cell) -> "Machine":
        """Return the machine of a cell.

        Raises
        ------
        NotOfBodies
            A `ValueError`: if it is that of a body.
        """
        if isinstance(cell, BodyCell):
            raise NotOfBodies("simulate: not of a body of several degrees of freedom yet")
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

    def ending(self, p: int, surface: int) -> Step | None:
        """Return the phase whose event ends a phase on a surface; None without one."""
        ending = None if surface == NONE else self._node(self.rules.endings[p, surface])
        return None if ending is None else ending.step

    def number(self, one: Step) -> int:
        """Return the number of a phase as an order calls it."""
        return one.phase + len(self.cell.phases) * one.mirrored

    def node(self, one: Step) -> Node:
        """Return a phase as an order calls it."""
        return self.nodes[self.number(one)]

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
