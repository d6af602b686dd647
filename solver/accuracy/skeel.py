"""How much the times of an orbit answer to rounding of the exact equations, to first order.

Near a fold, where two orbits meet, or at a resonance that little damps, they answer by far more
than what is rounded; every method there shares that error.
"""

import math

import numpy as np

from ..flow.exact_system import exact_kernel, unknowns_of
from ..orbit.motion import Motion


def condition(motion: Motion) -> float:
    """Return Skeel's condition number of the exact equations, near one of their solutions.

    ``|J^-1| |J| |z|`` with the Jacobian J at the unknowns z, of the time that answers most, as
    a part of the period: if each term is rounded by a part e, no time moves by more than e
    times this.  It does not depend on the units of conditions and unknowns, and is infinite
    where J is singular.

    Parameters
    ----------
    motion : Motion
        An orbit, of an expansion or exact.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> from nonsmooth.solver.exact import exact_orbit
    >>> round(condition(exact_orbit(registry.load("impact")())), 1)
    5.3
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
        moved = kernel.times(np.abs(np.linalg.inv(J)) @ np.abs(J) @ sizes)
    except np.linalg.LinAlgError:
        return math.inf
    if cell.forced:
        moved[-1] /= cell.omega
    return float(moved.max() / np.sum(motion.cell_durations)) / cell.cells
