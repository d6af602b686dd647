"""The one integral of all expansions: moments of shifted Legendre polynomials with a cosine."""

from math import cos, sin, sqrt

import numpy as np


def spherical_bessel(count, x):
    """Return ``j_0(x), ..., j_(count - 1)(x)`` for ``x >= 0``, each to rounding.

    Upwards as far as that is stable, up to ``n = x``; beyond, by the ratios of neighbours from
    the continued fraction downwards.
    """
    j = np.zeros(count)
    if x == 0.0:
        j[0] = 1.0
        return j
    turn = min(int(x), count - 1)
    j[0] = sin(x) / x
    if turn >= 1:
        j[1] = (j[0] - cos(x)) / x
    for n in range(2, turn + 1):
        j[n] = (2 * n - 1) / x * j[n - 1] - j[n - 2]
    top = count + 20 + int(2 * sqrt(x))
    ratio = 0.0
    for n in range(top, turn, -1):
        ratio = x / ((2 * n + 1) - x * ratio)
        if n < count:
            j[n] = ratio
    for n in range(turn + 1, count):
        j[n] *= j[n - 1]
    return j


def legendre_moments(count, kappa, theta):
    """Return ``int_0^1 P_l*(u) cos(kappa u + theta) du`` for ``l < count``; ``kappa >= 0``."""
    moments = spherical_bessel(count, kappa / 2)
    middle = kappa / 2 + theta
    c, s = cos(middle), sin(middle)
    for l in range(count):
        turn = l % 4
        moments[l] *= c if turn == 0 else -s if turn == 1 else -c if turn == 2 else s
    return moments
