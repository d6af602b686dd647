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

from ..arrays import Vector
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
)

#: A correction that is at most this part of the one before is taken without a derivative.
FAST = 0.5

#: Most points of the inverse function; they are used up by rounding long before.
POINTS = 8

#: What is expected to be left of an error where the iteration ends, as a part of `ROUNDOFF`.
LEFT = 1 / 16


def residual(work: Any, y: float) -> float:
    """Stand for the residual of the kernel."""
    raise NotImplementedError


def jacobian(work: Any, y: float) -> float:
    """Stand for its derivative, where the residual was evaluated last."""
    raise NotImplementedError


def limited(step: float, y: float) -> float:
    """Return the damping that keeps a step within the limit of a duration."""
    return min(1.0, DURATION_STEP * abs(y) / max(abs(step), 1e-300))


def iterate_single(
    work: Any, y: float, limit: int, points: Vector, differences: Vector
) -> tuple[int, int, float, float, float]:
    """Solve ``residual(work, y) = 0`` from `y`; there is room for `POINTS` of them.

    It ends where the correction that would follow is at rounding level, or corrections no
    longer fall; the last evaluation is at the solution.  Returned are status, derivatives, that
    correction, norm of the residual, and solution; see `iteration.iterate_scene`.
    """
    value, damping, previous, correction = residual(work, y), 1.0, np.inf, np.inf
    for iteration in range(1, limit + 1):
        slope = jacobian(work, y)
        if slope == 0:
            return SINGULAR, iteration, correction, abs(value), y
        begin, size, step = y, max(abs(y), 1e-300), -value / slope
        length = abs(step) / size
        if not np.isfinite(length):
            return OVERFLOW, iteration, correction, abs(value), y
        correction = length
        if length <= SETTLED and (length <= ROUNDOFF or length > 0.5 * previous):
            y = begin + limited(step, begin) * step
            return CONVERGED, iteration, correction, abs(residual(work, y)), y
        points[0], points[1] = value, value
        damping = min(1.0, 2.0 * damping, limited(step, begin))
        while True:
            y = begin + damping * step
            value = residual(work, y)
            if abs(value) <= (1 - damping / 4) * abs(points[0]) or length <= SETTLED:
                break
            damping /= 2
            if damping < SMALLEST_STEP:
                return NO_DESCENT, iteration, correction, abs(residual(work, begin)), begin
        previous = length
        if damping < 1:
            continue
        # divided differences of the inverse function, over the newest points first; the first
        # point stands there twice, for its slope
        differences[0], differences[1] = begin, 1.0 / slope
        for count in range(2, POINTS):
            points[count] = value
            newer, product, following = y, 1.0, 0.0
            for j in range(count):
                older, inverse = differences[j], 1.0 / (value - points[count - 1 - j])
                differences[j] = newer
                newer = (newer - older) * inverse
                product *= -points[count - j]
                following += newer * product
            differences[count] = newer
            ahead = abs(following) / size
            if not ahead <= max(FAST * length, ROUNDOFF) or limited(following, y) < 1:
                break
            y += following
            value = residual(work, y)
            # errors fall by a factor that is squared each time
            left = ahead * (ahead / length) ** 2
            if min(ahead, left / LEFT) <= ROUNDOFF:
                return CONVERGED, iteration, min(ahead, left), abs(value), y
            previous = length = correction = ahead
    return TOO_MANY, limit, correction, abs(value), y
