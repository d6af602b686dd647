"""Sums over the harmonics that a series leaves out: ``sum_{m > N} exp(i m x)/m**p``."""

import math

import numpy as np
import numpy.typing as npt

#: Nodes in ``w = log y``, where the trapezoidal rule below has its integrand.
STEP = 0.1
NODES = np.exp(np.arange(-10.0, 5.0, STEP))


def tail_sums(N: int, x: float, highest: int) -> npt.NDArray[np.complex128]:
    """Return ``sum_{m > N} exp(i m x)/m**p`` for ``p = 0..highest``; right from ``p = 4`` on.

    With ``1/m**p = int_0^inf y**(p-1) exp(-m y) dy / Gamma(p)`` the sum is geometric; what
    remains is a smooth integral in ``log y`` for every `x`, zero included, to which the
    trapezoidal rule converges geometrically.

    Parameters
    ----------
    N : int
        Harmonics that are not left out.
    x : float
        Angle in radians; exact near 0, so the caller reduces it.
    highest : int
        Largest power.

    Returns
    -------
    ndarray of complex, shape (highest + 1,)

    Examples
    --------
    >>> round(10**3 * float(tail_sums(0, 0.0, 4)[4].real), 6)  # zeta(4)
    1082.323234
    """
    y = NODES
    geometric = -1 / np.expm1(1j * x - y / (N + 1))
    weights = STEP * np.exp(-y) * geometric * np.exp(1j * (N + 1) * x)
    sums = np.zeros(highest + 1, dtype=complex)
    for p in range(4, highest + 1):
        scale = math.lgamma(p) + p * math.log(N + 1)
        sums[p] = weights @ np.exp(p * np.log(y) - scale)
    return sums
