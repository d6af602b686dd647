"""Solutions of 3.2 with several C1 functions, where rounding hides some of the functions."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from ...arrays import Matrix, Vector
from .kernels import Kernel
from .newton import (
    CONVERGED,
    OUT_OF_RANGE,
    OVERFLOW,
    REASONS,
    ROUNDOFF,
    SINGULAR,
    TOO_MANY,
    Outcome,
    time_norm,
)

#: Roundings of the largest unknown by which equations that hold may be missed.
ROUNDINGS = 16.0

#: Steps of least norm after which a solution is given up; from a neighbour few are needed.
MOST_STEPS = 20


def padded(z: Vector, size: int) -> Vector:
    """Return unknowns with coefficients 0 for the functions that they do not have.

    Examples
    --------
    >>> padded(np.array([1.0, 0.2, 6.0]), 5)
    array([1. , 0. , 0. , 0.2, 6. ])
    """
    return np.concatenate([z[:-2], np.zeros(size - len(z)), z[-2:]])


def residual_within_rounding(kernel: Kernel, case: object, z: Vector) -> tuple[float, bool]:
    """Return the norm of the residual, and whether rounding alone would leave as much.

    That is: whether each equation holds for unknowns that are changed by a few roundings of
    the largest.
    """
    R, J = _equations(kernel, case, z)
    return float(np.abs(R).max()), _within_rounding(R, J, z)


def _equations(kernel: Kernel, case: object, z: Vector) -> tuple[Vector, Matrix]:
    """Return the residual and the Jacobian."""
    n = len(z)
    R, J = np.empty(n), np.empty((n, n))
    kernel.residual(case, z, R)
    kernel.jacobian(case, z, J)
    return R, J


def _within_rounding(R: Vector, J: Matrix, z: Vector) -> bool:
    left = ROUNDINGS * np.finfo(float).eps * np.abs(z).max() * np.abs(J).max(axis=1)
    return bool((np.abs(R) <= left).all())


def first_within_rounding(
    kernel: Kernel, case: object, size: int, tried: Iterable[Outcome]
) -> Outcome | None:
    """Return the first of these that solves the equations but for rounding, if one does.

    Parameters
    ----------
    kernel, case : Kernel, object
        The equations.
    size : int
        Number of their unknowns; what has fewer C1 functions is padded.
    tried : iterable of Outcome
        Left out are those whose last correction of the times was more than rounding.
    """
    for each in tried:
        if each.correction <= ROUNDOFF:
            z = padded(each.unknowns, size)
            norm, solved = residual_within_rounding(kernel, case, z)
            if solved:
                return replace(each, unknowns=z, converged=True, residual_norm=norm)
    return None


def least_norm_step(R: Vector, J: Matrix) -> Vector:
    """Return the shortest step that solves ``J step = -R`` as far as rounding tells it.

    The rows of `J`, then its columns, are scaled to a largest entry of 1.  Of what is left,
    singular values below `ROUNDINGS` roundings an unknown, as a part of the largest, are 0 but
    for rounding: the step does not go in their directions.

    Examples
    --------
    Two functions that differ by no more than rounding have equal parts of what is missing:

    >>> J = np.array([[1.0, 1.0], [1.0, 1.0 + 1e-15]])
    >>> least_norm_step(np.array([-2.0, -2.0]), J).round(12)
    array([1., 1.])
    """
    rows = np.abs(J).max(axis=1)
    scaled = J / rows[:, None]
    columns = np.abs(scaled).max(axis=0)
    U, sizes, V = np.linalg.svd(scaled / columns)
    kept = sizes > ROUNDINGS * np.finfo(float).eps * len(R) * sizes[0]
    step: Vector = V[kept].T @ ((U[:, kept].T @ (-R / rows)) / sizes[kept]) / columns
    return step


def solve_by_least_norm(kernel: Kernel, case: object, start: Vector) -> Outcome:
    """Solve by Newton's method with `least_norm_step`, undamped, from a neighbour.

    The end is where the equations hold but for rounding and the correction of the times is
    rounding, too.  The coefficients of functions that rounding hides never settle; here they
    do not move.

    Parameters
    ----------
    kernel, case : Kernel, object
        The equations.
    start : ndarray, shape (n,)
        A solution with fewer functions, `padded`.
    """
    z, correction, status, iteration = start.copy(), np.inf, TOO_MANY, 0
    with np.errstate(all="ignore"):  # what is not finite is reported as such
        while status == TOO_MANY and iteration < MOST_STEPS:
            R, J = _equations(kernel, case, z)
            iteration += 1
            if correction <= ROUNDOFF and _within_rounding(R, J, z):
                status = CONVERGED
            elif not (np.isfinite(R).all() and np.isfinite(J).all()):
                status = OVERFLOW
            elif not (J.any(axis=0).all() and J.any(axis=1).all()):
                status = SINGULAR
            else:
                step = least_norm_step(R, J)
                ahead, correction = z + step, time_norm(step, z)
                if 0 < ahead[-2] < ahead[-1] < np.inf:
                    z = ahead
                else:
                    status = OUT_OF_RANGE
    norm = float(np.abs(R).max())
    return Outcome(z, status == CONVERGED, iteration, correction, norm, REASONS[status])
