"""Newton's method for a kernel of a scene, and its outcome."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arrays import Vector
from .iteration import CONVERGED, Iteration

ITERATION_LIMIT = 40

#: Why the iteration ended, by its status.
REASONS = (
    "converged",
    "the equations overflow",
    "the Jacobian is singular",
    "Newton's method stalled (no damped step reduces the correction)",
    "no convergence within the limit of iterations",
)


@dataclass(frozen=True)
class Outcome:
    """The result of Newton's method.

    Parameters
    ----------
    unknowns : ndarray
        Coefficients or states, then times; without units.
    iterations : int
        Jacobians factorised.
    correction : float
        Last correction of the times, relative to the cell and to a turn.
    residual_norm : float
        Maximum norm of the residual.
    reason : str
        One of `REASONS`.
    """

    unknowns: Vector
    converged: bool
    iterations: int
    correction: float
    residual_norm: float
    reason: str


def newton(
    iteration: Iteration, case: Any, start: Vector, limit: int = ITERATION_LIMIT
) -> Outcome:
    """Solve a kernel's system from `start`, which is not overwritten."""
    z = start.copy()
    with np.errstate(all="ignore"):  # an overflow is reported as such
        status, iterations, correction, norm = iteration(case, z, limit)
    sizes = float(correction), float(norm)  # of NumPy, if not compiled
    return Outcome(z, status == CONVERGED, iterations, *sizes, REASONS[status])
