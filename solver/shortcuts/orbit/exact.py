"""The exact periodic orbit (Section 2), dimensionless: the reference of every error.

Time in ``1/omega_n``, length in ``V/omega_n``, origin at ``x_s``.  Stick:
``y = -alpha + t``.  Slip: ``y = alpha cos(t - t1) + sin(t - t1)``.
"""

import math

import numpy as np

from ...arrays import Vector


def times(alpha: float) -> tuple[float, float]:
    """Return the exact ``t1 = 2 alpha`` and ``T = t1 + pi + 2 atan(1/alpha)``."""
    t1 = 2.0 * alpha
    return t1, t1 + math.pi + 2.0 * math.atan2(1.0, alpha)


def evaluate(alpha: float, t: Vector, derivative: int) -> Vector:
    """Return the exact motion at times in ``[0, T)``.

    Parameters
    ----------
    alpha : float
        The parameter of the oscillator.
    t : ndarray, shape (n,)
        Dimensionless times in ``[0, T)``.
    derivative : {0, 1, 2}
        Displacement, velocity or acceleration.

    Returns
    -------
    ndarray, shape (n,)
    """
    t1, _ = times(alpha)
    tau = t - t1
    cos, sin = np.cos(tau), np.sin(tau)
    slip = (alpha * cos + sin, cos - alpha * sin, -alpha * cos - sin)[derivative]
    stick = (t - alpha, np.ones_like(t), np.zeros_like(t))[derivative]
    return np.where(t < t1, stick, slip)
