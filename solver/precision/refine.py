"""Iterative refinement of a float64 solution: residual in balls, correction in float64.

Each step gains about 16 digits less those that the condition of the Jacobian costs.  The last
correction, and the rounding of the residual, give the radius of a ball about each time.
"""

from typing import Any

import numpy as np
from flint import arb, ctx

from ..arrays import Matrix, Vector
from ..kernels.kernel import Kernel
from .balls import Residual, as_balls, residual_in_balls

#: Guard digits at first; largest working precision in digits; most steps.
GUARD, MOST_DIGITS, STEPS = 25, 2000, 60


class PrecisionError(ArithmeticError):
    """The refinement did not converge: the equations may have no solution near the start."""


def refine(
    kernel: Kernel,
    arguments: Any,
    start: Vector,
    digits: int,
    residual: Residual | None = None,
) -> tuple[Any, ...]:
    """Return the times of a solution of a kernel's equations to `digits` digits, as balls.

    Parameters
    ----------
    kernel : Kernel
        In plain Python; without `residual`, a generated one.
    arguments : object
        First argument of its functions; floats stand for their exact binary values.
    start : ndarray
        The solution in float64.
    digits : int
        Decimal digits of the times, relative to their sum.
    residual : callable, optional
        The same equations over balls, for `arguments`, at the precision in force; by default
        it is made from the source of the kernel.

    Raises
    ------
    PrecisionError
        If the corrections do not decrease.
    """
    J = np.empty((len(start), len(start)))
    kernel.jacobian(arguments, start, J)
    inverse = _inverse(J)
    working = digits + GUARD
    while working <= MOST_DIGITS:
        with ctx.workdps(working):
            in_balls, inputs = residual, arguments
            if in_balls is None:
                in_balls, inputs = residual_in_balls(kernel.residual), as_balls(arguments)
            times = _refined(kernel, in_balls, inputs, start, inverse, digits)
        if times is not None:
            return times
        working *= 2
    raise PrecisionError(f"{kernel.method}: {digits} digits are not had with {MOST_DIGITS}")


def _inverse(J: Matrix) -> Matrix:
    """Return the inverse of a Jacobian, computed with scaled rows."""
    rows = np.abs(J).max(axis=1)
    try:
        return np.asarray(np.linalg.inv(J / rows[:, None]) / rows)
    except np.linalg.LinAlgError:
        raise PrecisionError("the Jacobian is singular") from None


def _refined(
    kernel: Kernel, residual: Residual, arguments: Any, start: Vector, inverse: Matrix,
    digits: int,
) -> tuple[Any, ...] | None:  # fmt: skip
    """Return the times refined at the precision in force; None if the balls are too wide."""
    first = len(start) - kernel.durations - kernel.forced
    z = np.array([arb(float(value)) for value in start], dtype=object)
    R = np.full(len(z), arb(0), dtype=object)
    goal = arb(10) ** -(digits + 2) * float(np.sum(start[first : first + kernel.durations]))
    shortest = arb("inf")
    for _ in range(1, STEPS + digits):
        residual(arguments, z, R)
        radii = np.array([float(arb(value).rad()) for value in R])
        rounding = float((np.abs(inverse[first:]) @ radii).max())
        if not rounding < goal / 10:
            return None
        norm = max(abs(arb(value).mid()) for value in R)
        scale = norm if norm != 0 else arb(1)
        correction = inverse @ np.array([float((arb(value) / scale).mid()) for value in R])
        pairs = zip(z, correction, strict=True)
        z = np.array([(value - arb(float(q)) * scale).mid() for value, q in pairs])
        length = scale * float(np.abs(correction[first:]).max())
        if length < goal:
            radius = (length + rounding).upper()
            return tuple(arb(value, radius) for value in z[first:])
        if not length < 4 * shortest:
            raise PrecisionError(f"{kernel.method}: the refinement does not converge")
        shortest = min(shortest, length)
    raise PrecisionError(f"{kernel.method}: no convergence within {STEPS} steps at {ctx.dps}")
