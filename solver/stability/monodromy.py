"""The monodromy of one cell of an orbit, at the orbit's own times and states."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from ..bodies.exact import evaluated
from ..bodies.part import angles_of, parts_of, phase_map, rates, turned, wave
from ..flow.exact_system import arrays, unknowns_of
from ..iteration.linear import product
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
            matrix, size, crossed = of_body(cell, times)
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


def of_body(cell: BodyCell, times: Vector) -> tuple[Matrix, Matrix, Vector]:
    """Return what a cell makes of perturbations of ``X = (y, memory)``, before it is mirrored.

    The product over the phases of the flow and of the saltation at the switch that ends the
    phase, ``S = R + (F+ - R F- - R_t) n^T/(n F- + h_t)``; see `stability.cell_map`.

    Returns
    -------
    matrix : ndarray, shape (n, n)
    size : ndarray, shape (n, n)
        Rounding errors are parts of it; see `linear.product`.
    crossed : ndarray, shape (P,)
        The rate at which the event that ends each phase is crossed, as a part of the size of
        its terms.
    """
    parts, starts = parts_of(cell), evaluated(cell, times).starts
    theta, count = angles_of(cell, times), len(parts)
    shape = count, starts.shape[1], starts.shape[1]
    steps, sizes, crossed = np.empty(shape), np.empty(shape), np.empty(count)
    for p, part in enumerate(parts):
        along, by_wave = phase_map(part, float(times[p]))
        end = along @ starts[p] + by_wave @ wave(theta[p])
        q, sign = (p + 1, 1) if p + 1 < count else (0, cell.sign)
        before = rates(part, end, theta[p + 1])
        behind = sign * rates(parts[q], starts[q], theta[q] if q == 0 else theta[p + 1])
        gradient, waves = part.switch.gradient, part.switch.waves
        approach = cell.omega * float(waves @ turned(theta[p + 1]))
        scale = float(np.abs(gradient) @ np.abs(before)) + cell.omega * float(
            np.abs(waves).sum()
        )
        rate = approach + float(gradient @ before)
        crossed[p] = abs(rate) / scale if scale > 0 else 0.0
        jump = behind - part.switch.state @ before
        jump -= cell.omega * (part.switch.inputs @ turned(theta[p + 1]))
        across = part.switch.state + np.outer(jump, gradient) / rate
        steps[p] = across @ along
        sizes[p] = np.abs(across) @ np.abs(along) / min(1.0, crossed[p])
    return *product(steps, sizes), crossed


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
