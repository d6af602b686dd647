"""What an engineer knows before solving: the start of Newton's method.

The stick duration follows from the transition condition; the slip duration lies between
half a natural period (a slow belt) and a whole one (a fast belt); and at given times the
equations are linear in the coefficients.  The exact orbit is not used.
"""

import math

import numpy as np
from scipy.linalg import lapack

from ...arrays import Vector
from .kernels import Kernel


def rough_times(alpha: float) -> tuple[float, float]:
    """Return a first ``t1`` and ``T``.

    Stick carries the mass over ``2 alpha`` at unit speed.  For the slip duration, a
    fraction in `alpha` between its limits ``2 pi`` at 0 and ``pi + 2/alpha`` far out.
    """
    t1 = 2.0 * alpha
    return t1, t1 + math.pi + 2.0 / (alpha + 2.0 / math.pi)


def cubic_slip(kernel: Kernel, terms: int, order: int, t1: float, T: float) -> Vector:
    """Return unknowns of the symmetric kernel: stick at the belt's velocity, a cubic in slip.

    That is ``g1`` of (12), scaled: the one cubic that joins stick in displacement and
    velocity at both ends.

    Parameters
    ----------
    kernel : Kernel
        ``"hb-symmetric"``.
    terms : int
        Number of C1 functions.

    Returns
    -------
    ndarray, shape (order + terms + 2,)
        Coefficients, `t1`, `T`.
    """
    z = np.empty(kernel.size(order, terms))
    z[-2:] = t1, T
    kernel.functions["rough_motion"](terms, z)
    return z


def with_coefficients(kernel: Kernel, alpha: float, order: int, t1: float, T: float) -> Vector:
    """Return unknowns with these times and the coefficients that suit them best.

    The conditions at fixed times are two more than the coefficients, and linear in them:
    least squares.

    Returns
    -------
    ndarray, shape (size,)
        Coefficients, `t1`, `T`.
    """
    size = kernel.size(order)
    z = np.zeros(size)
    z[-2:] = t1, T
    R, J = np.empty(size), np.empty((size, size))
    kernel.residual(alpha, z, R)
    kernel.jacobian(alpha, z, J)
    *_, solution, _ = lapack.dgels(J[:, :-2], -R)
    z[:-2] = solution[: size - 2]
    return z
