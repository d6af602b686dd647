"""How much rounding of the exact equations may move the times of a motion."""

import numpy as np

from ..arrays import Vector
from ..flow.exact_system import exact_kernel, unknowns_of
from .motion import Motion


def moved_times(motion: Motion) -> Vector:
    """Return how far each time moves at most if each term is rounded by a small part, over it.

    ``|J^-1| |J| |z|``, by Skeel, with the Jacobian J of the exact equations at the unknowns z,
    near one of their solutions: durations and the phase of the forcing, without units.  It does
    not depend on the units of conditions and unknowns, and is infinite where J is singular.
    """
    cell, kernel = motion.case.cell, exact_kernel(motion.case.cell)
    z = unknowns_of(motion)
    z = kernel.times(z) if kernel.condensed else z
    J = np.empty((len(z), len(z)))
    kernel.jacobian(cell, z, J)
    J /= np.abs(J).max(axis=1, keepdims=True)
    sizes = np.abs(z)
    if cell.forced:
        sizes[-1] = max(1.0, sizes[-1])  # a cosine is rounded at a small angle too
    try:
        return kernel.times(np.abs(np.linalg.inv(J)) @ np.abs(J) @ sizes)
    except np.linalg.LinAlgError:
        return kernel.times(np.full(len(z), np.inf))
