"""The monodromy of one cell of an orbit, at the orbit's own times and states."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix
from ..bodies import perturbed
from ..flow.exact_system import arrays, unknowns_of
from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Cell
from .cell_map import cell_map

if TYPE_CHECKING:
    from ..orbit.motion import Motion

#: Least rate at which an event is crossed, as a part of the size of its terms.
TOUCH = 1e-12

#: Local times at which the velocity is looked at.
LOOK = np.linspace(0.0, 1.0, 17)


class NoMultipliersError(ArithmeticError):
    """There are no multipliers: an event is touched and not crossed."""


@dataclass(frozen=True)
class Monodromy:
    """What one cell makes of small perturbations of the state at its first switch.

    The matrix is that of the cell, before its motion is mirrored; rounding errors are parts of
    `size`; shape (n, n) each.  As many multipliers are exactly 0 as are `forgotten` at the
    phase or the switch that forgets most.
    """

    matrix: Matrix
    size: Matrix
    forgotten: int


def monodromy(motion: "Motion") -> Monodromy:
    """Return the monodromy of a cell of an orbit; see `cell_map`.

    Raises
    ------
    NoMultipliersError
        If an event is touched and not crossed.
    """
    cell = motion.case.cell
    with np.errstate(all="ignore"):  # an event that is touched is found below
        if isinstance(cell, BodyCell):
            angle = [motion.angle] if cell.forced else []
            times = np.array([*motion.cell_durations, *angle])
            matrix, size, crossed = perturbed.cell_map(cell, times)
        else:
            phases = range(len(cell.phases))
            speed = max(float(np.abs(motion.part(p, LOOK, 1)).max()) for p in phases)
            given = arrays(cell), unknowns_of(motion), _reached(motion), speed
            matrix, size, crossed = cell_map(*given)
    for phase, rate in zip(cell.phases, crossed, strict=True):
        if not rate > TOUCH:
            raise NoMultipliersError(
                f"the event that ends {phase.name} is touched, not crossed: "
                "perturbations are not mapped linearly"
            )
    return Monodromy(matrix, size, forgotten(cell))


def _reached(motion: "Motion") -> Matrix:
    """Return velocity and acceleration where each phase ends, as the motion has them."""
    phases = motion.cell.phases
    found = np.zeros((len(phases), 2))
    for p, phase in enumerate(phases):
        x, v, cosine, _ = motion.signals(p, np.ones(1))[:, 0]
        v = phase.speed if phase.held else v
        found[p] = v, phase.acceleration(x, v, cosine)
    return found


def forgotten(cell: Cell) -> int:
    """Return of how many parts of the state nothing is left at some place of a cell.

    A phase that is held forgets the velocity, at one place the displacement too; a switch
    forgets each constant that it sets.
    """
    places = range(len(cell.phases))
    held = (cell.phases[p].held + (cell.place(p) is not None) for p in places)
    sets = (sum(memory.phase == p for memory in cell.memory) for p in places)
    return max(*held, *sets)
