"""Newton's method with step control, the same for all kernels, plain or compiled.

The step is damped by the natural monotonicity test (P. Deuflhard, Newton Methods for
Nonlinear Problems, Springer 2004, Section 2.1): a step is accepted when the simplified
correction, by the old Jacobian at the new point, is shorter than the correction before.
Both are solutions of the same linear system, so no scaling of the equations changes what
is accepted.

`kernels` links `iterate` to the kernel that it is to solve, and compiles both together: for
the small systems of this package a factorisation is over before a library is called.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...arrays import Matrix, Vector
from ...iteration.linear import factorise, solve_factorised

#: Corrections of the times below this part of T cannot be improved in float64.
ROUNDOFF = 4.0 * np.finfo(float).eps

#: Corrections below this, of coefficients and times, are of no size that their square
#: could have: what is left is rounding, and only how far it goes down is to be seen.
SETTLED = 1e-8

#: Smallest damping factor; below it the iteration has failed.
SMALLEST_STEP = 2.0**-12

ITERATION_LIMIT = 40

#: Fills a residual or a Jacobian for a case and an iterate; `iterate` for one of each.
Fill = Callable[[Any, Vector, Any], None]
Iteration = Callable[[Any, Vector, int], tuple[int, int, float, float]]

CONVERGED, OVERFLOW, SINGULAR, OUT_OF_RANGE, NO_DESCENT, TOO_MANY = range(6)

REASONS = (
    "converged",
    "the equations overflow",
    "the Jacobian is singular",
    "t1 ran out of (0, T)",
    "Newton's method stalled (no damped step reduces the correction)",
    "no convergence within the limit of iterations",
)


@dataclass(frozen=True)
class Outcome:
    """Where an iteration ended.

    Parameters
    ----------
    unknowns : ndarray
        The last iterate: coefficients, ``t1``, ``T``.
    converged : bool
        Whether the corrections of ``t1`` and ``T`` went down to rounding errors.
    iterations : int
        Jacobians factorised.
    correction : float
        Last correction of ``t1`` and ``T``, as a part of ``T``.
    residual_norm : float
        Maximum norm of the residual at `unknowns`, dimensionless.
    reason : str
        Why the iteration ended, for a message.
    """

    unknowns: Vector
    converged: bool
    iterations: int
    correction: float
    residual_norm: float
    reason: str


def largest(values: Vector) -> float:
    """Return the maximum norm; not a number if an entry is not."""
    found = 0.0
    for value in values:
        size = abs(value)
        if size > found or np.isnan(size):
            found = size
    return found


def time_norm(step: Vector, z: Vector) -> float:
    """Return the size of a step of ``t1`` and ``T``, as a part of ``T``."""
    size: float = max(abs(step[-2]), abs(step[-1])) / z[-1]
    return size


def step_norm(step: Vector, z: Vector) -> float:
    """Return the size of a step: times against T, coefficients against the largest."""
    scale = max(largest(z[:-2]), 1e-300)
    size: float = max(time_norm(step, z), largest(step[:-2]) / scale)
    return size


def longest_step(step: Vector, z: Vector) -> float:
    """Return the damping that keeps ``t1`` and ``T - t1`` above half their values."""
    fall = max(-step[-2] / z[-2], -(step[-1] - step[-2]) / (z[-1] - z[-2]))
    damping: float = min(1.0, 0.5 / max(fall, 0.5))
    return damping


def residual(case: Any, z: Vector, R: Vector) -> None:
    """Stand for the residual of the kernel that `kernels` links `iterate` to."""
    raise NotImplementedError


def jacobian(case: Any, z: Vector, J: Matrix) -> None:
    """Stand for the Jacobian of the kernel."""
    raise NotImplementedError


def iterate(case: Any, z: Vector, limit: int) -> tuple[int, int, float, float]:
    """Solve ``residual(case, z) = 0`` from `z`, which is overwritten.

    The iteration stops when all corrections are small and that of the times, or the one
    that would follow, is at rounding level, or no longer falls: then the rounding errors of
    the residual are all that is left, and the last correction says how large they are.

    Returns
    -------
    status, iterations : int
        0 if converged, else the index of the reason in `REASONS`; Jacobians factorised.
    correction, residual_norm : float
        Last correction of the times, as a part of ``T``; maximum norm of the residual.
    """
    n = len(z)
    R, J, rows = np.empty(n), np.empty((n, n)), np.empty(n, dtype=np.int64)
    residual(case, z, R)
    damping, previous, correction = 1.0, np.inf, np.inf
    for iteration in range(1, limit + 1):
        jacobian(case, z, J)
        regular = factorise(J, rows)
        step = -R
        if regular:
            solve_factorised(J, rows, step)
        length, correction = step_norm(step, z), time_norm(step, z)
        if not (regular and np.isfinite(length)):
            status = SINGULAR if np.isfinite(length) else OVERFLOW
            return status, iteration, correction, largest(R)
        at_rest = correction <= ROUNDOFF or correction > 0.5 * previous
        if length <= SETTLED and at_rest:
            if not 0 < z[-2] + step[-2] < z[-1] + step[-1]:
                return OUT_OF_RANGE, iteration, correction, largest(R)
            z += step
            residual(case, z, R)
            return CONVERGED, iteration, correction, largest(R)
        previous = correction
        damping = min(1.0, 2.0 * damping, longest_step(step, z))
        while True:
            trial = z + damping * step
            residual(case, trial, R)
            simplified = R.copy()
            solve_factorised(J, rows, simplified)
            if length <= SETTLED and time_norm(simplified, z) <= ROUNDOFF:
                z[:] = trial
                return CONVERGED, iteration, time_norm(simplified, z), largest(R)
            if length <= SETTLED or step_norm(simplified, z) <= (1 - damping / 4) * length:
                break
            damping /= 2
            if damping < SMALLEST_STEP:
                residual(case, z, R)
                return NO_DESCENT, iteration, correction, largest(R)
        z[:] = trial
    return TOO_MANY, limit, correction, largest(R)


def newton(
    iteration: Iteration, case: Any, start: Vector, limit: int = ITERATION_LIMIT
) -> Outcome:
    """Solve a system from `start`, which is not overwritten.

    Parameters
    ----------
    iteration : callable
        `iterate` for the system: ``iteration(case, z, limit)``; see `kernels`.
    case : float or tuple
        What the system depends on: ``alpha``; or ``alpha`` and the number of C1 functions.
    start : ndarray, shape (n,)
        First iterate; its last two entries are ``0 < t1 < T``.
    limit : int
        Most Jacobians to factorise.
    """
    z = start.copy()
    with np.errstate(all="ignore"):  # an overflow is reported as such
        status, iterations, correction, norm = iteration(case, z, limit)
    return Outcome(z, status == CONVERGED, iterations, correction, norm, REASONS[status])
