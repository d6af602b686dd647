"""Condition of the times of a motion: how far rounding of the exact equations moves them."""

import numpy as np

from ..arrays import Vector
from ..bodies.exact import event_sizes
from ..flow.exact_system import exact_kernel, unknowns_of
from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Cell
from .motion import Motion

#: Rounding error of a sum over modes, in units of that of one term.
OF_MODES = 512


def moved_times(motion: Motion, with_sums: bool = False) -> Vector:
    """Return Skeel's bound of the change of each time per relative rounding of all terms.

    ``|J^-1| |J| |z|``, with the Jacobian J of the exact equations at the unknowns z near one of
    their solutions; its entries for durations and the phase of the forcing, without units.  It
    is invariant under scaling of equations, and infinite where J is singular.

    The velocity at which a phase is held is no unknown: where a phase begins and ends at it,
    only the change between is rounded.  Of a body the unknowns are times alone.  `with_sums`,
    these sums are rounded as well: velocities, and the events of a body over its modes.
    """
    cell, kernel = motion.case.cell, exact_kernel(motion.case.cell)
    z = motion.times if isinstance(cell, BodyCell) else unknowns_of(motion)
    J = np.empty((len(z), len(z)))
    kernel.jacobian(cell, z, J)
    rows = np.abs(J).max(axis=1)
    J /= rows[:, None]
    sizes = np.abs(z)
    if cell.forced:
        sizes[-1] = max(1.0, sizes[-1])  # a cosine is rounded at a small angle too
    weights = np.abs(J)
    if not (with_sums or isinstance(cell, BodyCell)):
        begun = np.empty_like(J)
        kernel.jacobian(cell, _at_once(cell, z), begun)
        exact = _held_velocities(cell)
        weights[:, exact] = np.abs(J[:, exact] - begun[:, exact] / rows[:, None])
    terms = weights @ sizes
    if with_sums and isinstance(cell, BodyCell):
        events = slice(len(cell.phases))
        terms[events] += OF_MODES * event_sizes(cell, z) / rows[events]
    try:
        return kernel.times(np.abs(np.linalg.inv(J)) @ terms)
    except np.linalg.LinAlgError:
        return kernel.times(np.full(len(z), np.inf))


def _at_once(cell: Cell, z: Vector) -> Vector:
    """Return the unknowns with phases of no duration: in their Jacobian no state changes."""
    unknowns, before = z.copy(), len(z) - len(cell.phases) - cell.forced
    unknowns[before : len(z) - cell.forced] = 0.0
    return unknowns


def _held_velocities(cell: Cell) -> list[int]:
    """Return which unknowns are velocities at which a phase is held, or begins behind one."""
    indices = []
    for p, phase in enumerate(cell.phases):
        before = cell.phases[p - 1]
        if phase.held or (before.held and (before.rho, before.d) == (1.0, 0.0)):
            indices.append(2 * p + 1)
    return indices
