"""The phases that a motion can be in, and the switching surfaces that end them.

The phases of a scene are those of its cell and, where the other half of its period is the
mirror image of the cell, their mirror images.  A surface is the set of states where a linear
form vanishes.  Which forms share a surface is decided once, from their coefficients: near two
surfaces, the numbers of a state cannot tell them apart.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from ..arrays import Matrix
from ..scenes.cell import Cell, Form, Phase
from ..scenes.mirror import mirror, opposed, same
from ..scenes.orders import Step
from .steps.column import NONE


@dataclass(frozen=True)
class Node:
    """One phase that a motion can be in: the phase `index` of the cell, or its mirror image.

    `event` and `demands` are the numbers of the surfaces of its event and of its demands.
    """

    phase: Phase
    index: int
    mirrored: bool
    event: int
    demands: tuple[int, ...]

    @property
    def step(self) -> Step:
        """The phase as a step of an order of phases."""
        return Step(self.index, self.mirrored)

    @property
    def name(self) -> str:
        """The name of the phase, with a minus if it is mirrored."""
        return f"{'-' * self.mirrored}{self.phase.name}"

    @cached_property
    def law(self) -> tuple[object, ...]:
        """What determines the motion: phases with the same differ in what ends them.

        In held phases other forces may hold the velocity: their demands belong to it.
        """
        own = *self.phase.equation, self.phase.speed
        return (*own, self._held_while) if self.phase.held else own

    @cached_property
    def _held_while(self) -> frozenset[tuple[int, bool]]:
        """The surface of each demand, and on which side of it the demand holds."""
        forms = (form for _, form in self.phase.demands)
        sides = (next((q > 0 for q in form if q), True) for form in forms)
        return frozenset(zip(self.demands, sides, strict=True))

    def goes_on_as(self, other: "Node") -> bool:
        """Whether nothing changes where another phase begins, no demand to its opposite."""
        return self.law == other.law and not opposed(self.phase, other.phase)

    @property
    def jumps(self) -> bool:
        """Whether the velocity jumps at its event, whose form does not depend on it."""
        return self.phase.event[1] == 0 and self.changes_velocity

    @property
    def changes_velocity(self) -> bool:
        """Whether the velocity jumps at its event."""
        return any(jump != (1.0, 0.0) for jump in self.phase.jumps)


def nodes(cell: Cell) -> tuple[Node, ...]:
    """Return the phases that a motion of a cell can be in, in cyclic order."""
    phases = [(cell.carrying(p), p, False) for p in range(len(cell.phases))]
    if cell.sign < 0:
        phases += [(mirror(phase), p, True) for phase, p, _ in phases]
    surfaces: list[Form] = []

    def surface(form: Form) -> int:
        matches = (i for i, other in enumerate(surfaces) if same(form, other))
        number = next(matches, len(surfaces))
        if number == len(surfaces):
            surfaces.append(form)
        return number

    return tuple(
        Node(
            phase, index, mirrored, surface(phase.event),
            tuple(surface(form) for _, form in phase.demands),
        )
        for phase, index, mirrored in phases
    )  # fmt: skip


class InState(NamedTuple):
    """The quantities on which forms act, as linear functions of an augmented state of a phase.

    The state has the forcing and 1 among its entries, 1 at the index `one`, and its derivative
    is `generator` times it.  Each row gives one quantity; the second is the velocity.
    """

    rows: Matrix
    generator: Matrix
    one: int


def ending(nodes: Sequence[Node], p: int, surface: int) -> int:
    """Return the phase of the same law whose event is a surface; `NONE` without one."""
    turn = (q for q in (p, *range(len(nodes))) if nodes[q].event == surface)
    return next((q for q in turn if nodes[p].goes_on_as(nodes[q])), NONE)


def firsts(cell: Cell, nodes: Sequence[Node]) -> list[Step]:
    """Return for each phase the first one that is the same, by whatever name.

    Demands at their switches may differ: they tell what follows.
    """
    setters = {memory.phase for memory in cell.memory}
    found: dict[tuple[object, ...], Step] = {}
    steps = []
    for node in nodes:
        phase, own = node.phase, node.step if node.index in setters else None
        law = own, node.law, phase.jumps, node.event
        demands = frozenset(form for _, form in phase.demands)
        steps.append(found.setdefault((*law, demands), node.step))
    return steps


def followers(cell: Cell, nodes: Sequence[Node]) -> list[list[int]]:
    """Return the phases that the scene declares to follow each; see `Cell.followers`."""
    count = len(cell.phases)
    return [
        [q + count * (turned != node.mirrored) for q, turned in cell.followers(node.index)]
        for node in nodes
    ]


def said(cell: Cell, nodes: Sequence[Node], step: Step) -> list[tuple[object, ...]]:
    """Return the laws of the phases that the event of a phase says to follow, if it does.

    A phase with the law of its image is either.
    """
    to, count = cell.to[step.phase] if cell.to else (), len(cell.phases)
    return [nodes[q + count * (turned != step.mirrored)].law for q, turned in to]


def turns(
    cell: Cell, nodes: Sequence[Node], declared: Sequence[Sequence[int]]
) -> list[list[int]]:
    """Return in which turn successors are tried, behind each phase, then behind none.

    Held phases with demands come first: constraints hold while they can.  Then come those that
    are declared to follow.  Where an event says what follows, other phases do not; `NONE`
    stands for them.
    """
    phases = range(len(nodes))
    first = [p for p in phases if nodes[p].phase.held and nodes[p].phase.demands]
    orders = [*([*some, *phases] for some in declared), [*phases]]
    found = [list(dict.fromkeys([q for q in order if q in first] + order)) for order in orders]
    for p, node in enumerate(nodes):
        laws = said(cell, nodes, node.step)
        found[p] = [NONE if laws and nodes[q].law not in laws else q for q in found[p]]
    return found


def walls(nodes: Sequence[Node], declared: Sequence[Sequence[int]]) -> list[int]:
    """Return, for each rest at a place, the phase whose jump it follows; else `NONE`."""
    found = [NONE] * len(nodes)
    for p, some in enumerate(declared):
        for q in some:
            if nodes[q].phase.held and nodes[p].jumps and found[q] == NONE:
                found[q] = p
    return found
