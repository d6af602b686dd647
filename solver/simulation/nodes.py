"""The phases that a motion can be in, and the surfaces of states that end them.

The phases of a scene are those of its cell and, where the other half of its period is the
mirror image of the cell, their mirror images.  A surface is where a linear form of the state
vanishes.  Which forms vanish on the same one is decided once, from their factors: near two
surfaces, no number of a state tells them apart.
"""

from dataclasses import dataclass

from ..scenes.cell import Cell, Form, Phase
from ..scenes.mirror import mirror, same
from ..scenes.orders import Step


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
    event : int
        The surface of its event, by number.
    demands : tuple of int
        The surfaces of its demands.
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
        return (self.phase.rho, self.phase.d) != (1.0, 0.0)


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
