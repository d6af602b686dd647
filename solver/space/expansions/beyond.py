"""Sums of ``exp(i n theta)/n^p`` over ``n > N``, with full relative accuracy.

A closed form less its first N terms would cancel.  With ``v = N + 1`` and ``n^-p`` as a Laplace
integral, the geometric series inside can be summed (the Lerch transcendent):

    v^(1-p) E_p(-i v theta)
        + e^(i v theta) v^-p/(p-1)! int_0^inf x^(p-1) e^-x h(x/v - i theta) dx,

``h(w) = 1/(1 - e^-w) - 1/w``.  The pole of the kernel at 0 gives the exponential integral
``E_p``; the remainder is smooth, for its nearest poles are at ``2 pi i`` and ``-2 pi i``.
"""

from functools import lru_cache
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
from scipy.special import exp1, roots_genlaguerre

from ...arrays import Vector

#: Values of exponentials.
Complex: TypeAlias = npt.NDArray[np.complexfloating[Any, Any]]

#: Terms up to n = `FIRST` are added one by one.  Beyond, the poles are at least 50 units of x
#: away, and `NODES` quadrature nodes are exact to rounding.
FIRST, NODES = 16, 14

#: Modulus below which ``E_p`` is by recurrence from ``E_1``; levels of its continued fraction.
NEAR, LEVELS = 5.0, 40

#: Error of a sum in units of rounding, relative to ``v^(1-p)``.
ROUNDINGS = 100


def beyond(p: int, N: int, theta: Vector) -> Complex:
    """Return the sums over ``n > N`` at angles from -2 pi to 2 pi, `p` from 2."""
    theta = np.asarray(theta, dtype=float)
    n = np.arange(N + 1.0, max(N + 1, FIRST))[:, None]
    first = np.sum(np.exp(1j * n * theta) / n**p, axis=0)
    v = float(max(N + 1, FIRST))
    angle = theta - 2 * np.pi * np.round(theta / (2 * np.pi))
    x, weights = _laguerre(p)
    w = x[:, None] / v - 1j * angle
    smooth = weights @ (-1 / np.expm1(-w) - 1 / w)
    turned = 1j * v * angle
    last = v * exponential_integral(p, -turned) + np.exp(turned) * smooth
    return np.asarray(first + last / v**p)


@lru_cache(maxsize=128)
def _laguerre(p: int) -> tuple[Vector, Vector]:
    """Return nodes and weights for ``x^(p-1) e^-x/(p-1)!``."""
    x, weights = roots_genlaguerre(NODES, p - 1)
    return x, weights / weights.sum()


def exponential_integral(p: int, z: Complex) -> Complex:
    """Return ``E_p(z)``, the integral of ``e^(-z t)/t^p`` from 1 on, for imaginary `z`."""
    values, near = np.exp(-z), np.abs(z) < NEAR
    if near.any():
        inside = np.where(z == 0, 1e-300j, z)[near]
        last = exp1(inside)
        for q in range(1, p):
            last = (values[near] - inside * last) / q
        values[near] = last
    fraction = far = z[~near]
    if far.size:
        for level in range(LEVELS, 0, -1):
            fraction = far + (p + level - 1) / (1 + level / fraction)
        values[~near] /= fraction
    return values
