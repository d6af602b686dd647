"""The phases that a motion can be in, and the surfaces of states that end them.

The phases of a scene are those of its cell and, where the other half of its period is the
mirror image of the cell, their mirror images.  A surface is where a linear form of the state
vanishes.  Which forms vanish on the same one is decided once, from their factors: near two
surfaces, no number of a state tells them apart.
"""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from ..scenes.cell import Cell, Form, Phase

if TYPE_CHECKING:
    from .machine import State

#: What may be rounding of the factors of a form, as a part of each.
ROUNDING = 1e-12


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

    def at(self, state: "State") -> Phase:
        """Return the phase with numbers for what the motion remembers."""
        return self.phase.remembering(state.memory)

    def begun(self, state: "State") -> "State":
        """Return a state with the velocity at which the phase is held, if it is."""
        return replace(state, v=self.phase.speed) if self.phase.held else state

    @property
    def jumps(self) -> bool:
        """Whether it ends at a place where the velocity jumps."""
        return self.phase.event[1] == 0 and (self.phase.rho, self.phase.d) != (1.0, 0.0)


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


def mirror(phase: Phase) -> Phase:
    """Return the mirror image of a phase: the motion ``-x`` half a period of the forcing on."""
    return replace(
        phase,
        f=-phase.f,
        speed=-phase.speed,
        event=_mirrored(phase.event),
        d=-phase.d,
        demands=tuple((words, _mirrored(form)) for words, form in phase.demands),
        switch_demands=tuple((words, _mirrored(form)) for words, form in phase.switch_demands),
    )


def _mirrored(form: Form) -> Form:
    x, v, cos, constant, *memory = form
    return -x, -v, -cos, constant, *(-factor for factor in memory)


def same(one: Form, other: Form) -> bool:
    """Whether two forms vanish at the same states: their factors are in one proportion.

    Each factor counts, however small it is beside the others.

    Examples
    --------
    >>> same((1.0, 0.0, 0.0, -0.5), (-2.0, 0.0, 0.0, 1.0))
    True
    >>> same((1.0, 0.0, 0.0, -1e-300), (1.0, 0.0, 0.0, 1e-300))
    False
    >>> same((1.0, 0.0, 0.0, -1e300), (-2.0, 0.0, 0.0, 2e300))
    True
    """
    a, b = np.array(one), np.array(other)
    where = a != 0
    if not where.any() or (where != (b != 0)).any():
        return False
    (p, power), (q, other_power) = np.frexp(a[where]), np.frexp(b[where])  # no ratio overflows
    powers = other_power - power
    ratios = np.ldexp(q / p, np.clip(powers - powers[0], -4, 4))
    return bool((np.abs(ratios - ratios[0]) <= ROUNDING * np.abs(ratios[0])).all())
