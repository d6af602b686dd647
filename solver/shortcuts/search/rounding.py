"""Solutions of 3.2 with several C1 functions, where rounding hides some of the functions."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from ...arrays import Vector
from .kernels import Kernel
from .newton import ROUNDOFF, Outcome

#: Roundings of the largest unknown by which equations that hold may be missed.
ROUNDINGS = 16.0


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
    n = len(z)
    R, J = np.empty(n), np.empty((n, n))
    kernel.residual(case, z, R)
    kernel.jacobian(case, z, J)
    left = ROUNDINGS * np.finfo(float).eps * np.abs(z).max() * np.abs(J).max(axis=1)
    return float(np.abs(R).max()), bool((np.abs(R) <= left).all())


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
