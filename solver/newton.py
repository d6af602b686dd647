"""Newton's method with step control, the same for all methods of the paper.

The step is damped by the natural monotonicity test (P. Deuflhard, Newton Methods for
Nonlinear Problems, Springer 2004, Section 2.1): a step is accepted when the simplified
correction, by the old Jacobian at the new point, is shorter than the correction before.
Both are solutions of the same linear system, so no scaling of the equations changes what
is accepted.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.linalg import lapack

from .arrays import Matrix, Vector

#: Corrections of the times below this part of T cannot be improved in float64.
ROUNDOFF = 4.0 * np.finfo(float).eps

#: Corrections below this, of coefficients and times, are of no size that their square
#: could have: what is left is rounding, and only how far it goes down is to be seen.
SETTLED = 1e-8

#: Smallest damping factor; below it the iteration has failed.
SMALLEST_STEP = 2.0**-12

ITERATION_LIMIT = 40


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


def _time_norm(step: Vector, unknowns: Vector) -> float:
    return float(np.max(np.abs(step[-2:])) / unknowns[-1])


def _norm(step: Vector, unknowns: Vector) -> float:
    """Return the size of a step: times against T, coefficients against the largest."""
    largest = max(float(np.max(np.abs(unknowns[:-2]))), 1e-300)
    return max(_time_norm(step, unknowns), float(np.max(np.abs(step[:-2]))) / largest)


def _longest_step(step: Vector, unknowns: Vector) -> float:
    """Return the damping that keeps ``t1`` and ``T - t1`` above half their values."""
    t1, T = unknowns[-2:]
    falls = np.array([-step[-2] / t1, -(step[-1] - step[-2]) / (T - t1)])
    return float(min(1.0, 0.5 / max(falls.max(), 0.5)))


def newton(
    residual: Callable[[Vector, Vector], None],
    jacobian: Callable[[Vector, Matrix], None],
    start: Vector,
    limit: int = ITERATION_LIMIT,
) -> Outcome:
    """Solve ``residual(z) = 0`` from `start`.

    The iteration stops when all corrections are small and that of the times is at rounding
    level or no longer falls: then the rounding errors of the residual are all that is left,
    and `Outcome.correction` says how large they are.

    Parameters
    ----------
    residual : callable
        ``residual(z, R)`` fills `R`, shape (n,).
    jacobian : callable
        ``jacobian(z, J)`` fills `J`, shape (n, n).
    start : ndarray, shape (n,)
        First iterate, not overwritten; its last two entries are ``0 < t1 < T``.
    limit : int
        Most Jacobians to factorise.
    """
    z = start.copy()
    n = len(z)
    R, J = np.empty(n), np.empty((n, n), order="F")
    residual(z, R)
    damping, previous, correction = 1.0, np.inf, np.inf

    def end(converged: bool, iterations: int, reason: str) -> Outcome:
        norm = float(np.max(np.abs(R)))
        return Outcome(z, converged, iterations, correction, norm, reason)

    for iteration in range(1, limit + 1):
        jacobian(z, J)
        if not (np.isfinite(R).all() and np.isfinite(J).all()):
            return end(False, iteration, "the equations overflow")
        factors, pivots, singular = lapack.dgetrf(J)
        if singular:
            return end(False, iteration, "the Jacobian is singular")
        step = -lapack.dgetrs(factors, pivots, R)[0]
        length, correction = _norm(step, z), _time_norm(step, z)
        at_rest = correction <= ROUNDOFF or correction > 0.5 * previous
        if length <= SETTLED and at_rest:
            if not 0 < z[-2] + step[-2] < z[-1] + step[-1]:
                return end(False, iteration, "t1 ran out of (0, T)")
            z += step
            residual(z, R)
            return end(True, iteration, "converged")
        previous = correction
        damping = min(1.0, 2.0 * damping, _longest_step(step, z))
        while True:
            trial = z + damping * step
            residual(trial, R)
            simplified = lapack.dgetrs(factors, pivots, R)[0]
            if length <= SETTLED or _norm(simplified, z) <= (1 - damping / 4) * length:
                break
            damping /= 2
            if damping < SMALLEST_STEP:
                residual(z, R)
                return end(False, iteration, "no step reduces the correction")
        z = trial
    return end(False, limit, f"no convergence in {limit} iterations")
