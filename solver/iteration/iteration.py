"""Newton's method on coefficients and times of any scene, plain or compiled.

It is damped by the natural monotonicity test.  Limits keep the times meaningful: no step
changes a duration by more than 40 %, nor the phase of the forcing by more than 0.8 rad.  Rows
of the Jacobian are scaled to a largest entry of 1, for pivots are chosen by size and the
conditions have different physical units.

The test needs the simplified Newton correction, that of the next residual with the same
Jacobian.  While it is much smaller than the one before, it is applied as well: this costs less
than half of a new Jacobian, and raises the order of convergence by one each time.

Functions without a body here are replaced by those of a kernel, to which `linking` links this
module.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from ..arrays import Matrix, Vector
from .linear import factorise, solve_factorised

#: Rounding level of corrections of the times, relative to the cell.
ROUNDOFF = 4.0 * np.finfo(float).eps

#: Corrections below this have squares below rounding: a further one is only rounding.
SETTLED = 1e-8

#: Least scale of coefficients, without units: the states of a motion that is at rest at 0 at
#: all its switches are only rounding.
LEAST = 1e-6

#: Smallest damping factor; below it the iteration has failed.
SMALLEST_STEP = 2.0**-12

#: Largest change in a step: of a duration, relative to it; of the phase of the forcing, in rad.
DURATION_STEP, ANGLE_STEP = 0.4, 0.8

#: Largest ratio of a simplified Newton correction to the one before with which it is applied.
FAST = 0.125

#: Largest step for which its Jacobian tells whether simplified corrections have converged: one
#: at states far from the solution may have columns of another size.
NEAR = 0.5

#: After a last correction above this, the residual is evaluated once more.
AGAIN = ROUNDOFF

CONVERGED, OVERFLOW, SINGULAR, NO_DESCENT, TOO_MANY = range(5)

Iteration = Callable[[Any, Vector, int], tuple[int, int, float, float]]


def residual(case: Any, z: Vector, R: Vector) -> None:
    """Fill R with the residual; a placeholder for that of the kernel."""
    raise NotImplementedError


def jacobian(case: Any, z: Vector, J: Matrix) -> None:
    """Fill J with the Jacobian; a placeholder for that of the kernel."""
    raise NotImplementedError


def times_of(case: Any) -> tuple[int, int]:
    """Return the number of unknown durations, and 1 if forced, else 0; a placeholder."""
    raise NotImplementedError


def greatest(values: Vector, first: int, last: int) -> float:
    """Return the largest modulus of ``values[first:last]``; NaN if one of them is."""
    largest = 0.0
    for i in range(first, last):
        size = abs(values[i])
        if size > largest or np.isnan(size):
            largest = size
    return largest


def step_size(step: Vector, z: Vector, durations: int, forced: int) -> tuple[float, float]:
    """Return the relative size of a step, and that of its times alone.

    Durations are relative to the sum of the unknown ones, the phase of the forcing to a turn,
    coefficients to the largest of them, or `LEAST`.
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
    """Return the largest damping factor, at most 1, that keeps the limits of the times."""
    last = len(z) - forced
    excess = 1.0
    for i in range(last - durations, last):
        excess = max(excess, abs(step[i]) / (DURATION_STEP * abs(z[i])))
    if forced:
        excess = max(excess, abs(step[last]) / ANGLE_STEP)
    return 1.0 / excess


def scale_rows(J: Matrix, scales: Vector) -> None:
    """Divide each row of J by its largest modulus, and fill `scales` with these."""
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
    """Fill `step` with the Newton correction of a residual R.

    `J`, `rows`: factors and exchanges of the Jacobian; `scales`: those of its rows.
    """
    for i in range(len(R)):
        step[i] = -(R[i] / scales[i])
    solve_factorised(J, rows, step)


def add(z: Vector, factor: float, step: Vector, result: Vector) -> None:
    """Fill `result` with ``z + factor * step``."""
    for i in range(len(z)):
        result[i] = z[i] + factor * step[i]


def iterate_scene(case: Any, z: Vector, limit: int) -> tuple[int, int, float, float]:
    """Solve ``residual(case, z) = 0`` from `z`, which is overwritten.

    It ends when all corrections are small, and that of the times is at rounding level or no
    longer decreases.  Return the status, 0 if converged; the number of Jacobians factorised;
    the last correction of the times; and the maximum norm of the residual.
    """
    n = len(z)
    J, rows, vectors = np.empty((n, n)), np.empty(n, dtype=np.int64), np.empty((5, n))
    return iterate_within(case, z, limit, J, rows, vectors)


def iterate_within(
    case: Any, z: Vector, limit: int, J: Matrix, rows: Any, vectors: Matrix
) -> tuple[int, int, float, float]:
    """Do the same as `iterate_scene` in the workspace of J, its exchanges and five vectors."""
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
        previous, near = correction, length <= NEAR
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
            settled = max(size, length) <= SETTLED and correction <= ROUNDOFF
            fast = damping == 1 and size <= FAST * length
            whole = longest_damping(following, z, durations, forced) == 1
            if not (near if settled else fast and whole):
                break
            add(z, 1.0, following, z)
            if not settled or size > AGAIN:  # else the residual hardly changes
                residual(case, z, R)
            if settled:
                return CONVERGED, iteration, correction, greatest(R, 0, n)
            correct(J, rows, scales, R, following)
            length, previous = size, correction
            size, ahead = step_size(following, z, durations, forced)
    return TOO_MANY, limit, correction, greatest(R, 0, n)
