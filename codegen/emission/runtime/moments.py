"""The one integral of all expansions: moments of shifted Legendre polynomials with a cosine."""

from math import cos, sin

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
    if turn == count - 1:
        return j
    top, left = count, 1.0
    while left > 1e-18:  # of an error of the ratio at `top`, at `count`: ratios squared
        top += 1
        q = 2 * top + 1
        left *= (x * q / (q * q - 2 * x * x)) ** 2
    ratio = 0.0
    for n in range(top, turn, -1):
        ratio = x / ((2 * n + 1) - x * ratio)
        if n < count:
            j[n] = ratio
    for n in range(turn + 1, count):
        j[n] *= j[n - 1]
    return j


def legendre_moments(count, kappa, theta):
    """Return the moments of cosines with shifted Legendre polynomials, ``kappa >= 0``.

    Returns
    -------
    ndarray, shape (2, count)
        ``int_0^1 P_l*(u) cos(kappa u + theta) du`` for ``l < count``, and the same a quarter
        turn on, with ``theta + pi/2``.
    """
    bessel = spherical_bessel(count, kappa / 2)
    middle = kappa / 2 + theta
    c, s = cos(middle), sin(middle)
    moments = np.empty((2, count))
    for l in range(count):
        turn = l % 4
        value = c if turn == 0 else -s if turn == 1 else -c if turn == 2 else s
        ahead = -s if turn == 0 else -c if turn == 1 else s if turn == 2 else c
        moments[0, l], moments[1, l] = bessel[l] * value, bessel[l] * ahead
    return moments
