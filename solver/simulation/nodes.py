"""The phases that a motion can be in, and the surfaces of states that end them.

The phases of a scene are those of its cell and, where the other half of its period is the
mirror image of the cell, their mirror images.  A surface is where a linear form of the state
vanishes.  Which forms vanish on the same one is decided once, from their factors: near two
surfaces, no number of a state tells them apart.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from ..arrays import Matrix
from ..scenes.bodies.cell import BodyPhase
from ..scenes.cell import Cell, Form, Phase
from ..scenes.mirror import mirror, same
from ..scenes.orders import Step
from .steps.column import NONE


@dataclass(frozen=True)
class Node:
    """One phase that a motion can be in: of the cell, by its index, or the mirror image of one.

    `event` and `demands` are numbers of surfaces: of its event, and of its demands.
    """

    phase: Phase
    index: int
    mirrored: bool
    event: int
    demands: tuple[int, ...]

    @property
    def step(self) -> Step:
        """What an order of phases calls it."""
        return Step(self.index, self.mirrored)

    @property
    def equation(self) -> tuple[object, ...]:
        """What its equation of motion is made of."""
        return self.phase.equation

    @property
    def jumps(self) -> bool:
        """Whether it ends at a place where the velocity jumps."""
        return self.phase.event[1] == 0 and self.changes_velocity

    @property
    def changes_velocity(self) -> bool:
        """Whether the velocity jumps where its event ends it."""
        q = self.phase
        jumps = q.jumps if isinstance(q, BodyPhase) else ((q.rho, q.d),)
        return any(jump != (1.0, 0.0) for jump in jumps)


def nodes(cell: Cell) -> tuple[Node, ...]:
    """Return the phases that a motion of a cell can be in, each before the one that follows."""
    found = [(cell.carrying(p), p, False) for p in range(len(cell.phases))]
    if cell.sign < 0:
        found += [(mirror(phase), p, True) for phase, p, _ in found]
    surfaces: list[Form] = []

    def surface(form: Form) -> int:
        known = (i for i, other in enumerate(surfaces) if same(form, other))
        number = next(known, len(surfaces))
        if number == len(surfaces):
            surfaces.append(form)
        return number

    return tuple(
        Node(
            phase, index, mirrored, surface(phase.event),
            tuple(surface(form) for _, form in phase.demands),
        )
        for phase, index, mirrored in found
    )  # fmt: skip


class InState(NamedTuple):
    """What linear forms are of in a phase, by the entries of a state with the forcing and 1.

    Of the rows, one an entry of a form, the second is the velocity; the entry `one` is 1.
    """

    rows: Matrix
    generator: Matrix
    one: int


def ending(nodes: Sequence[Node], p: int, surface: int) -> int:
    """Return the phase of the same equation whose event is a surface; `NONE` without one."""
    turn = (q for q in (p, *range(len(nodes))) if nodes[q].event == surface)
    return next((q for q in turn if nodes[q].equation == nodes[p].equation), NONE)


def turns(nodes: Sequence[Node]) -> list[list[int]]:
    """Return in which turn phases are tried where one is declared, or at last none.

    Constraints hold while they can.
    """
    phases = range(len(nodes))
    first = [p for p in phases if nodes[p].phase.held and nodes[p].phase.demands]
    ways = [*([p, *phases] for p in phases), [*phases]]
    return [list(dict.fromkeys([q for q in way if q in first] + way)) for way in ways]


def walls(nodes: Sequence[Node]) -> list[int]:
    """Return behind the jump of which phase each is a rest at a place; `NONE` of others."""
    phases = range(len(nodes))
    behind = [nodes[p].phase.held and nodes[p - 1].jumps for p in phases]
    return [
        (p - 1) % len(nodes) if rests else NONE for p, rests in zip(phases, behind, strict=True)
    ]
