"""Newton's method on coefficients and times of any scene, plain or compiled.

Damped by the natural monotonicity test, and with limits that keep the
times meaningful: no step changes a duration by more than 40 %, nor the phase of the forcing by
more than 0.8 rad.  The rows are scaled to a largest entry of 1 before they are solved:
conditions of different physical kind stand beside each other, and pivots are chosen by size.

The test looks at the correction that follows with the same Jacobian.  While that shrinks fast
it is taken as well: a residual and a solution cost less than half of a Jacobian and its
factors, and each such step adds one to the order of convergence.

The functions that stand here with no body are those of the kernel that `linking` links this
module to.
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

#: Least size against which coefficients are measured, without units: where a motion is at rest
#: at 0 at all its switches, the states there are nothing but rounding.
LEAST = 1e-6

#: Smallest damping factor; below it the iteration has failed.
SMALLEST_STEP = 2.0**-12

#: Most that a step changes: a duration, as a part of it; the phase of the forcing, in rad.
DURATION_STEP, ANGLE_STEP = 0.4, 0.8

#: A correction that is at most this part of the one before is taken with the same Jacobian.
FAST = 0.125

#: After a last correction that is larger, the residual is evaluated once more.
AGAIN = ROUNDOFF

CONVERGED, OVERFLOW, SINGULAR, NO_DESCENT, TOO_MANY = range(5)

Iteration = Callable[[Any, Vector, int], tuple[int, int, float, float]]


def residual(case: Any, z: Vector, R: Vector) -> None:
    """Stand for the residual of the kernel."""
    raise NotImplementedError


def jacobian(case: Any, z: Vector, J: Matrix) -> None:
    """Stand for the Jacobian of the kernel."""
    raise NotImplementedError


def times_of(case: Any) -> tuple[int, int]:
    """Stand for how many durations are unknown, and 1 if phi is, else 0."""
    raise NotImplementedError


def greatest(values: Vector, first: int, last: int) -> float:
    """Return the largest modulus from `first` up to `last`; not a number if an entry is not."""
    found = 0.0
    for i in range(first, last):
        size = abs(values[i])
        if size > found or np.isnan(size):
            found = size
    return found


def step_size(step: Vector, z: Vector, durations: int, forced: int) -> tuple[float, float]:
    """Return the size of a step, and that of its times alone.

    Times are measured as a part of the cell, or of those of its durations that are unknown,
    and of a turn; coefficients against the largest, or `LEAST`.
    """
    last = len(z) - forced
    first, cell = last - durations, 0.0
    for i in range(first, last):
        cell += abs(z[i])
    times = greatest(step, first, last) / cell if durations else 0.0
    if forced:
        times = max(times, abs(step[last]) / (2 * np.pi))
    scale = max(greatest(z, 0, first), LEAST)
    return max(times, greatest(step, 0, first) / scale), times


def longest_damping(step: Vector, z: Vector, durations: int, forced: int) -> float:
    """Return the damping that keeps a step within the limits of the times."""
    last = len(z) - forced
    excess = 1.0
    for i in range(last - durations, last):
        excess = max(excess, abs(step[i]) / (DURATION_STEP * abs(z[i])))
    if forced:
        excess = max(excess, abs(step[last]) / ANGLE_STEP)
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
    for i in range(len(R)):
        step[i] = -(R[i] / scales[i])
    solve_factorised(J, rows, step)


def add(z: Vector, factor: float, step: Vector, found: Vector) -> None:
    """Fill `found` with ``z + factor * step``."""
    for i in range(len(z)):
        found[i] = z[i] + factor * step[i]


def iterate_scene(case: Any, z: Vector, limit: int) -> tuple[int, int, float, float]:
    """Solve ``residual(case, z) = 0`` from `z`, which is overwritten.

    It ends where all corrections are small and that of the times, or the one that would
    follow, is at rounding level or no longer falls.  Returned are the status, 0 if converged,
    the Jacobians factorised, the last correction of the times, and the norm of the residual.
    """
    n = len(z)
    J, rows, vectors = np.empty((n, n)), np.empty(n, dtype=np.int64), np.empty((5, n))
    return iterate_within(case, z, limit, J, rows, vectors)


def iterate_within(
    case: Any, z: Vector, limit: int, J: Matrix, rows: Any, vectors: Matrix
) -> tuple[int, int, float, float]:
    """Do so within room for a Jacobian, its exchanges and five vectors."""
    n, (durations, forced) = len(z), times_of(case)
    R, scales, step = vectors[0, :n], vectors[1, :n], vectors[2, :n]
    following, trial = vectors[3, :n], vectors[4, :n]
    residual(case, z, R)
    damping, previous, correction = 1.0, np.inf, np.inf
    for iteration in range(1, limit + 1):
        jacobian(case, z, J)
        scale_rows(J, scales)
        if not factorise(J, rows):
            status = SINGULAR if np.isfinite(greatest(R, 0, n)) else OVERFLOW
            return status, iteration, correction, greatest(R, 0, n)
        correct(J, rows, scales, R, step)
        length, correction = step_size(step, z, durations, forced)
        if not np.isfinite(length):
            return OVERFLOW, iteration, correction, greatest(R, 0, n)
        at_rest = correction <= ROUNDOFF or correction > 0.5 * previous
        if length <= SETTLED and at_rest:
            # a duration near 0 stays positive
            add(z, longest_damping(step, z, durations, forced), step, z)
            residual(case, z, R)
            return CONVERGED, iteration, correction, greatest(R, 0, n)
        previous = correction
        damping = min(1.0, 2.0 * damping, longest_damping(step, z, durations, forced))
        while True:
            add(z, damping, step, trial)
            residual(case, trial, R)
            correct(J, rows, scales, R, following)
            size, ahead = step_size(following, z, durations, forced)
            if size <= (1 - damping / 4) * length or max(size, length) <= SETTLED:
                break
            damping /= 2
            if damping < SMALLEST_STEP:
                residual(case, z, R)
                return NO_DESCENT, iteration, correction, greatest(R, 0, n)
        add(trial, 0.0, trial, z)
        while True:
            correction = ahead
            converged = max(size, length) <= SETTLED and correction <= ROUNDOFF
            fast = damping == 1 and size <= FAST * length
            whole = longest_damping(following, z, durations, forced) == 1
            if not (converged or (fast and whole)):
                break
            add(z, 1.0, following, z)
            if not converged or size > AGAIN:  # else the residual hardly changes
                residual(case, z, R)
            if converged:
                return CONVERGED, iteration, correction, greatest(R, 0, n)
            correct(J, rows, scales, R, following)
            length, previous = size, correction
            size, ahead = step_size(following, z, durations, forced)
    return TOO_MANY, limit, correction, greatest(R, 0, n)
