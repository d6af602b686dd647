"""Newton's method where a single duration is unknown, as Python that numba compiles.

The first step is Newton's.  Each residual after it is a further point of the inverse function,
the duration by the residual; the polynomial through all of them, with the slope at the first,
is at 0 the next iterate.  Its error is of the size of the product of all errors before, that of
the first squared, and no derivative is formed again.  Where corrections do not shrink fast, it
begins anew with Newton's step, damped and limited as in `iteration`.

``residual`` and ``jacobian`` are those that `linking` links it to.
"""

from typing import Any

import numpy as np

from ..arrays import Matrix, Vector
from .iteration import (
    CONVERGED,
    DURATION_STEP,
    NO_DESCENT,
    OVERFLOW,
    ROUNDOFF,
    SETTLED,
    SINGULAR,
    SMALLEST_STEP,
    TOO_MANY,
    jacobian,
    residual,
)

#: A correction that is at most this part of the one before is taken without a derivative.
FAST = 0.25

#: Most points of the inverse function; they are used up by rounding long before.
POINTS = 8

#: Rows of the room that is needed: points, differences; residual and derivative.
ROOM = 3


def limited(step: float, y: float) -> float:
    """Return the damping that keeps a step within the limit of a duration."""
    return min(1.0, DURATION_STEP * abs(y) / abs(step))


def iterate_single(
    work: Any, y: Vector, limit: int, room: Matrix
) -> tuple[int, int, float, float]:
    """Solve ``residual(work, y) = 0`` from `y`, which is overwritten.

    It ends with a correction at rounding level, or where corrections no longer fall; the last
    evaluation is at the solution.  See `iteration.iterate_scene`.  The room is of the shape
    (`ROOM`, `POINTS`).
    """
    points, differences, R, J = room[0], room[1], room[2, :1], room[2:, 1:2]
    residual(work, y, R)
    damping, previous, correction = 1.0, np.inf, np.inf
    for iteration in range(1, limit + 1):
        jacobian(work, y, J)
        if J[0, 0] == 0:
            return SINGULAR, iteration, correction, abs(R[0])
        begin, value, size = y[0], R[0], max(abs(y[0]), 1e-300)
        step = -value / J[0, 0]
        length = abs(step) / size
        if not np.isfinite(length):
            return OVERFLOW, iteration, correction, abs(value)
        correction = length
        if length <= SETTLED and (length <= ROUNDOFF or length > 0.5 * previous):
            y[0] = begin + limited(step, begin) * step
            residual(work, y, R)
            return CONVERGED, iteration, correction, abs(R[0])
        damping = min(1.0, 2.0 * damping, limited(step, begin))
        while True:
            y[0] = begin + damping * step
            residual(work, y, R)
            if abs(R[0]) <= (1 - damping / 4) * abs(value) or length <= SETTLED:
                break
            damping /= 2
            if damping < SMALLEST_STEP:
                y[0] = begin
                residual(work, y, R)
                return NO_DESCENT, iteration, correction, abs(R[0])
        previous = length
        if damping < 1:
            continue
        # divided differences of the inverse function, over the newest points first; the first
        # point stands there twice, for its slope
        points[0], points[1] = value, value
        differences[0], differences[1] = begin, 1.0 / J[0, 0]
        for count in range(2, POINTS):
            points[count] = R[0]
            newer, product, following = y[0], 1.0, 0.0
            for j in range(count):
                newer, differences[j] = (
                    (newer - differences[j]) / (R[0] - points[count - 1 - j]),
                    newer,
                )
                product *= -points[count - j]
                following += newer * product
            differences[count] = newer
            ahead = abs(following) / size
            if ahead <= ROUNDOFF:
                y[0] += following
                residual(work, y, R)
                return CONVERGED, iteration, ahead, abs(R[0])
            if not ahead <= FAST * length or limited(following, y[0]) < 1:
                break
            y[0] += following
            residual(work, y, R)
            previous = length = correction = ahead
    return TOO_MANY, limit, correction, abs(R[0])
