"""The monodromy matrix of one cell of an orbit, at the orbit's own times and states."""

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

#: Least rate at which an event is crossed, relative to the terms of the rate.
TOUCH = 1e-12

#: Local times at which the largest velocity is looked for.
LOOK = np.linspace(0.0, 1.0, 17)


class NoMultipliersError(ArithmeticError):
    """There are no multipliers: an event is touched and not crossed."""


def monodromy(motion: "Motion") -> tuple[Matrix, Matrix]:
    """Return the monodromy matrix of a cell of an orbit, and the scale of its rounding errors.

    It maps perturbations of the state over one cell, from its first switch, before a mirrored
    cell is turned back; see `cell_map`.

    Raises
    ------
    NoMultipliersError
        If an event is touched and not crossed.
    """
    cell = motion.case.cell
    with np.errstate(all="ignore"):  # an event that is touched is found below
        if isinstance(cell, BodyCell):
            matrix, size, crossed = of_body(cell, motion.times)
        else:
            phases = range(len(cell.phases))
            speed = max(float(np.abs(motion.part(p, LOOK, 1)).max()) for p in phases)
            arguments = arrays(cell), unknowns_of(motion), _reached(motion), speed
            matrix, size, crossed = cell_map(*arguments)
    for phase, rate in zip(cell.phases, crossed, strict=True):
        if not rate > TOUCH:
            raise NoMultipliersError(
                f"the event that ends {phase.name} is touched, not crossed: "
                "perturbations are not mapped linearly"
            )
    return matrix, size


def of_body(cell: BodyCell, times: Vector) -> tuple[Matrix, Matrix, Vector]:
    """Return the monodromy matrix of a cell of a body, as `cell_map` does for one mass.

    The state is ``X = (y, memory)``, with the modal coordinates and velocities y.

    Returns
    -------
    matrix : ndarray, shape (n, n)
    size : ndarray, shape (n, n)
        Scale of the rounding errors of `matrix`; see `linear.product`.
    crossed : ndarray, shape (P,)
        The rate at which the event that ends each phase is crossed, relative to its terms.
    """
    parts, starts = parts_of(cell), evaluated(cell, times).starts
    theta, count = angles_of(cell, times), len(parts)
    shape = count, starts.shape[1], starts.shape[1]
    steps, sizes, crossed = np.empty(shape), np.empty(shape), np.empty(count)
    for p, part in enumerate(parts):
        transition, by_wave = phase_map(part, float(times[p]))
        end = transition @ starts[p] + by_wave @ wave(theta[p])
        q, sign = (p + 1, 1) if p + 1 < count else (0, cell.sign)
        before = rates(part, end, wave(theta[p + 1]))
        after = sign * rates(parts[q], starts[q], wave(theta[q] if q == 0 else theta[p + 1]))
        gradient, waves = part.switch.gradient, part.switch.waves
        approach = cell.omega * float(waves @ turned(theta[p + 1]))
        scale = float(np.abs(gradient) @ np.abs(before)) + cell.omega * float(
            np.abs(waves).sum()
        )
        rate = approach + float(gradient @ before)
        crossed[p] = abs(rate) / scale if scale > 0 else 0.0
        jump = after - part.switch.state @ before
        jump -= cell.omega * (part.switch.inputs @ turned(theta[p + 1]))
        saltation = part.switch.state + np.outer(jump, gradient) / rate
        steps[p] = saltation @ transition
        sizes[p] = np.abs(saltation) @ np.abs(transition) / min(1.0, crossed[p])
    return *product(steps, sizes), crossed


def _reached(motion: "Motion") -> Matrix:
    """Return velocity and acceleration of the motion at the end of each phase."""
    phases = motion.cell.phases
    reached = np.zeros((len(phases), 2))
    for p, phase in enumerate(phases):
        x, v, cosine, _ = motion.signals(p, np.ones(1))[:, 0]
        v = phase.speed if phase.held else v
        reached[p] = v, phase.acceleration(x, v, cosine)
    return reached


def forgotten(cell: Cell) -> int:
    """Return the dimension by which the map of a cell is rank-deficient: of multipliers 0.

    A held phase forgets the velocity and, if at rest at a known place, the displacement; a
    switch forgets the values before of the memories that it sets.  The largest number counts.
    """
    phases = range(len(cell.phases))
    held = (cell.phases[p].held + (cell.place(p) is not None) for p in phases)
    sets = (sum(memory.phase == p for memory in cell.memory) for p in phases)
    return max(*held, *sets)
