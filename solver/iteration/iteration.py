"""Newton's method on coefficients and times of any scene, plain or compiled.

Damped by the natural monotonicity test like `solver.newton`, and with limits that keep the
times meaningful: no step changes a duration by more than 40 %, nor the phase of the forcing by
more than 0.8 rad.  The rows are scaled to a largest entry of 1 before they are solved:
conditions of different physical kind stand beside each other, and pivots are chosen by size.

The test looks at the correction that follows with the same Jacobian.  While that shrinks fast
it is taken as well: a residual and a solution cost less than half of a Jacobian and its
factors, and each such step adds one to the order of convergence.

``DURATIONS`` and ``FORCED`` are those of the kernel that `kernel` links this module to.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from ..arrays import Matrix, Vector
from .linear import factorise, solve_factorised

#: Corrections of the times below this part of the cell cannot be improved in float64.
ROUNDOFF = 4.0 * np.finfo(float).eps

#: Corrections below this have squares below rounding: what is left is only rounding.
SETTLED = 1e-8

#: Smallest damping factor; below it the iteration has failed.
SMALLEST_STEP = 2.0**-12

#: Most that a step changes: a duration, as a part of it; the phase of the forcing, in rad.
DURATION_STEP, ANGLE_STEP = 0.4, 0.8

#: A correction that is at most this part of the one before is taken with the same Jacobian.
FAST = 0.125

CONVERGED, OVERFLOW, SINGULAR, NO_DESCENT, TOO_MANY = range(5)

#: Stand for those of the kernel.
DURATIONS = 1
FORCED = False

Iteration = Callable[[Any, Vector, int], tuple[int, int, float, float]]


def residual(case: Any, z: Vector, R: Vector) -> None:
    """Stand for the residual of the kernel."""
    raise NotImplementedError


def jacobian(case: Any, z: Vector, J: Matrix) -> None:
    """Stand for the Jacobian of the kernel."""
    raise NotImplementedError


def greatest(values: Vector) -> float:
    """Return the maximum norm; not a number if an entry is not."""
    found = 0.0
    for value in values:
        size = abs(value)
        if size > found or np.isnan(size):
            found = size
    return found


def times_size(step: Vector, z: Vector) -> float:
    """Return the size of a step of the times: as a part of the cell, and of a turn."""
    first = len(z) - DURATIONS - (1 if FORCED else 0)
    durations = z[first : first + DURATIONS]
    size = greatest(step[first : first + DURATIONS]) / np.sum(np.abs(durations))
    if FORCED:
        size = max(size, abs(step[-1]) / (2 * np.pi))
    return float(size)


def step_size(step: Vector, z: Vector) -> float:
    """Return the size of a step: its times, and its coefficients against the largest."""
    first = len(z) - DURATIONS - (1 if FORCED else 0)
    scale = max(greatest(z[:first]), 1e-300)
    return max(times_size(step, z), greatest(step[:first]) / scale)


def longest_damping(step: Vector, z: Vector) -> float:
    """Return the damping that keeps a step within the limits of the times."""
    first = len(z) - DURATIONS - (1 if FORCED else 0)
    excess = 1.0
    for i in range(first, first + DURATIONS):
        excess = max(excess, abs(step[i]) / (DURATION_STEP * abs(z[i])))
    if FORCED:
        excess = max(excess, abs(step[-1]) / ANGLE_STEP)
    return 1.0 / excess


def scale_rows(J: Matrix, scales: Vector) -> None:
    """Divide each row by its largest entry, which `scales` keeps."""
    n = len(J)
    for i in range(n):
        row, largest = J[i], 0.0
        for j in range(n):
            size = abs(row[j])
            largest = size if size > largest else largest
        scales[i] = largest if largest > 0 else 1.0
        factor = 1.0 / scales[i]
        for j in range(n):
            row[j] *= factor


def correct(J: Matrix, rows: Any, scales: Vector, R: Vector, step: Vector) -> None:
    """Fill `step` with the correction of a residual, by a Jacobian scaled and factorised."""
    np.divide(R, scales, step)
    np.negative(step, step)
    solve_factorised(J, rows, step)


def iterate_scene(case: Any, z: Vector, limit: int) -> tuple[int, int, float, float]:
    """Solve ``residual(case, z) = 0`` from `z`, which is overwritten.

    It ends where all corrections are small and that of the times, or the one that would
    follow, is at rounding level or no longer falls.  Returned are the status, 0 if converged,
    the Jacobians factorised, the last correction of the times, and the norm of the residual.
    """
    n = len(z)
    R, J, rows = np.empty(n), np.empty((n, n)), np.empty(n, dtype=np.int64)
    scales, step, following, trial = np.empty(n), np.empty(n), np.empty(n), np.empty(n)
    residual(case, z, R)
    damping, previous, correction = 1.0, np.inf, np.inf
    for iteration in range(1, limit + 1):
        jacobian(case, z, J)
        scale_rows(J, scales)
        if not factorise(J, rows):
            status = SINGULAR if np.isfinite(greatest(R)) else OVERFLOW
            return status, iteration, correction, greatest(R)
        correct(J, rows, scales, R, step)
        length, correction = step_size(step, z), times_size(step, z)
        if not np.isfinite(length):
            return OVERFLOW, iteration, correction, greatest(R)
        at_rest = correction <= ROUNDOFF or correction > 0.5 * previous
        if length <= SETTLED and at_rest:
            z += longest_damping(step, z) * step  # a duration near 0 stays positive
            residual(case, z, R)
            return CONVERGED, iteration, correction, greatest(R)
        previous = correction
        damping = min(1.0, 2.0 * damping, longest_damping(step, z))
        while True:
            trial[:] = z + damping * step
            residual(case, trial, R)
            correct(J, rows, scales, R, following)
            size = step_size(following, z)
            if size <= (1 - damping / 4) * length or max(size, length) <= SETTLED:
                break
            damping /= 2
            if damping < SMALLEST_STEP:
                residual(case, z, R)
                return NO_DESCENT, iteration, correction, greatest(R)
        z[:] = trial
        while True:
            correction = times_size(following, z)
            converged = max(size, length) <= SETTLED and correction <= ROUNDOFF
            fast = damping == 1 and size <= FAST * length
            if not (converged or (fast and longest_damping(following, z) == 1)):
                break
            z += following
            residual(case, z, R)
            if converged:
                return CONVERGED, iteration, correction, greatest(R)
            correct(J, rows, scales, R, following)
            length, size, previous = size, step_size(following, z), correction
    return TOO_MANY, limit, correction, greatest(R)
