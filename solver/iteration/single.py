"""Newton's method and inverse interpolation for a single unknown duration, compiled by numba.

The first step is Newton's.  Each further residual is a point of the inverse function, duration
against residual.  The next iterate is the value at 0 of the Hermite interpolant through all
points, with the slope at the first.  Its error is of the order of the product of all earlier
errors, the first squared, without a new derivative.  If corrections do not decrease fast, the
method restarts with a Newton step, damped and limited as in `iteration`.

`linking` links ``residual`` and ``jacobian`` to those of a kernel.
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

#: Largest ratio of a correction to the one before with which interpolation goes on.
FAST = 0.5

#: Most points of the inverse function; rounding ends the iteration long before.
POINTS = 8

#: Expected error at which the iteration ends, in units of `ROUNDOFF`.
LEFT = 1 / 16


def residual(work: Any, y: float) -> float:
    """Return the residual; a placeholder for that of the kernel."""
    raise NotImplementedError


def jacobian(work: Any, y: float) -> float:
    """Return the derivative at the last point of `residual`; a placeholder."""
    raise NotImplementedError


def limited(step: float, y: float) -> float:
    """Return the largest damping factor, at most 1, that keeps the limit of a duration."""
    return min(1.0, DURATION_STEP * abs(y) / max(abs(step), 1e-300))


def iterate_single(
    work: Any, y: float, limit: int, points: Vector, differences: Vector
) -> tuple[int, int, float, float, float]:
    """Solve ``residual(work, y) = 0`` from `y`, with workspace for `POINTS` points.

    It ends when the next correction is at rounding level, or corrections no longer decrease;
    the last evaluation is at the solution.  Return the status, the number of derivatives, that
    correction, the modulus of the residual, and the solution; see `iteration.iterate_scene`.
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
        # divided differences of the inverse function, newest points first; the first point
        # counts twice, for its slope
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
            remaining = ahead * (ahead / length) ** 2
            if min(ahead, remaining / LEFT) <= ROUNDOFF:
                return CONVERGED, iteration, min(ahead, remaining), abs(value), y
            previous = length = correction = ahead
    return TOO_MANY, limit, correction, abs(value), y
