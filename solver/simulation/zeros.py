"""The first zero of a polynomial on [0, 1], by its Bernstein coefficients.

Where all of them are positive there is none: the polynomial is within their hull.  Elsewhere
the interval is halved, the left half first.  Nothing is sampled, so no zero is passed over.
"""

from functools import cache
from math import comb

import numpy as np

from ..arrays import Matrix, Vector

#: Halvings of an interval that may hold the first zero.
DEPTH = 24

#: Newton's steps behind them.
STEPS = 4


@cache
def _bernstein(degree: int) -> Matrix:
    """Return the matrix from powers to Bernstein coefficients."""
    return np.array(
        [
            [comb(i, j) / comb(degree, j) if j <= i else 0.0 for j in range(degree + 1)]
            for i in range(degree + 1)
        ]
    )


@cache
def _left(degree: int) -> Matrix:
    """Return the matrix to the coefficients of the left half; turned, of the right."""
    rows = range(degree + 1)
    return np.array([[comb(i, j) / 2**i if j <= i else 0.0 for j in rows] for i in rows])


def first_zero(powers: Vector) -> float | None:
    """Return the first zero on (0, 1] of a polynomial that is positive at 0.

    Parameters
    ----------
    powers : ndarray
        Its coefficients, that of the power 0 first: positive.

    Returns
    -------
    float or None
        Not above the first zero, and as near to it as Newton's method comes; None if there is
        none.

    Examples
    --------
    >>> round(first_zero(np.array([1.0, -4.0, 3.0])), 12)
    0.333333333333
    >>> first_zero(np.array([1.0, -2.0, 1.001]))
    """
    degree = len(powers) - 1
    left = _left(degree)
    right = left[::-1, ::-1]
    waiting = [(_bernstein(degree) @ powers, 0.0, 1.0, 0)]
    while waiting:
        coefficients, start, width, depth = waiting.pop()
        if (coefficients > 0).all():
            continue
        if depth == DEPTH:
            return _polished(powers, start, width)
        half = width / 2
        waiting.append((right @ coefficients, start + half, half, depth + 1))
        waiting.append((left @ coefficients, start, half, depth + 1))
    return None


def _polished(powers: Vector, start: float, width: float) -> float:
    """Return the zero in a short interval, or its start where the polynomial only touches."""
    polynomial = np.polynomial.Polynomial(powers)
    slope = polynomial.deriv()
    u = start
    for _ in range(STEPS):
        value, rate = polynomial(u), slope(u)
        if not rate < 0 < value:
            break
        moved = u + value / -rate
        if moved > start + 2 * width:
            break
        below = polynomial(moved)
        if below < 0:  # too far along an arc that falls ever faster: its chord is below it
            moved = u + (moved - u) * value / (value - below)
        u = float(moved)
    return u
