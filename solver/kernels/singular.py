"""Where the conditions of a method are singular: at orbits that are symmetric in time.

A cell of undamped phases may be run through backwards: with ``x(t)`` also ``x(-t)`` solves it.
At an orbit that is its own reflection, the Jacobian maps even changes to even conditions and
odd ones to odd ones.  If there are not as many of either kind, it is singular, whatever the
order: see ``docs/digits.md``.
"""

import numpy as np

from ..arrays import Vector
from ..scaling import equilibrated
from ..scenes.case import Case
from ..scenes.cell import Cell
from .kernel import Kernel
from .start import with_coefficients

#: The least singular value that is rounding, as a part of the largest.
ROUNDING = 1e-12


def is_reversible(cell: Cell) -> bool:
    """Return whether a motion of a cell, run through backwards, is another one or itself."""
    return not cell.memory and all(
        phase.c == 0 and not phase.held and (phase.rho, phase.d) == (1, 0)
        for phase in cell.phases
    )


def is_singular(kernel: Kernel, case: Case, order: int, times: Vector) -> bool:
    """Return whether the Jacobian of a kernel is singular at given times; see `attempt`."""
    given = kernel.given(case, order)
    z = with_coefficients(kernel, given, kernel.size(order), times)
    J = np.empty((len(z), len(z)))
    kernel.jacobian(given, z, J)
    if not np.isfinite(J).all():
        return False
    values = np.linalg.svd(equilibrated(J), compute_uv=False)
    return bool(values[-1] <= ROUNDING * values[0])
