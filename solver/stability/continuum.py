"""Whether an orbit is one of a continuum: others of its period lie beside it."""

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from ..flow.exact_system import exact_kernel, unknowns_of
from ..scenes.cell import Cell
from ..scenes.orders import Order, Step, in_cell

if TYPE_CHECKING:
    from ..orbit.motion import Motion

#: How far beside an orbit another is looked for, as a part of its largest unknown; what is
#: rounding of their equations; the singular value, as a part of the largest, that is none.
BESIDE, ROUNDING, SINGULAR = 1e-3, 1e-11, 1e-7

#: Steps towards an orbit beside it.
STEPS = 12


def is_one_of_a_continuum(motion: "Motion") -> bool:
    """Return whether the exact equations of a whole period have another solution close by.

    Where they are singular, a step is made along what they do not fix, and from there the
    nearest solution is looked for: if it stays away, the orbit is one of many.

    Parameters
    ----------
    motion : Motion
        An orbit: exact, or near an exact one.
    """
    if motion.case.scene.has_body:
        return False  # not looked for
    cell = whole_period(motion.case.cell)
    found = _nearest(cell, _unknowns(motion))
    if found is None:
        return False
    _, singular, directions = np.linalg.svd(_jacobian(cell, found))
    if singular[-1] > SINGULAR * singular[0]:
        return False
    away = BESIDE * float(np.abs(found).max()) * directions[-1]
    other = _nearest(cell, found + away)
    return other is not None and bool(np.abs(other - found).max() > np.abs(away).max() / 2)


def whole_period(cell: Cell) -> Cell:
    """Return a cell of a whole period, the mirror image spelled out."""
    if cell.sign > 0:
        return cell
    steps = [Step(p, mirrored) for mirrored in (False, True) for p in range(len(cell.phases))]
    return replace(in_cell(cell, Order(tuple(steps))), cycles=cell.cycles)


def _unknowns(motion: "Motion") -> Vector:
    """Return the unknowns of the exact equations of a whole period, as a motion has them."""
    cell, z = motion.case.cell, unknowns_of(motion)
    if cell.sign > 0:
        return z
    count, more = len(cell.phases), len(cell.memory)
    states, memory, times = np.split(z, [2 * count, 2 * count + more])
    durations, turn = times[:count], times[count:]
    settings = np.column_stack([memory, -memory]).ravel()  # each memory twice in turn
    return np.concatenate([states, -states, settings, durations, durations, turn])


def _jacobian(cell: Cell, z: Vector) -> Matrix:
    J = np.empty((len(z), len(z)))
    exact_kernel(cell).jacobian(cell, z, J)
    return J


def _nearest(cell: Cell, z: Vector) -> Vector | None:
    """Return the solution that the shortest steps of Newton's method lead to, if to one."""
    z, R = z.copy(), np.empty(len(z))
    for _ in range(STEPS):
        exact_kernel(cell).residual(cell, z, R)
        if np.abs(R).max() <= ROUNDING * max(1.0, float(np.abs(z).max())):
            return z
        z -= np.linalg.pinv(_jacobian(cell, z), rcond=SINGULAR) @ R
    return None
