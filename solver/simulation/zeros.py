"""The first zero of a polynomial on [0, 1], by its Bernstein coefficients.

Where all of them are positive there is none: the polynomial is within their hull.  Elsewhere
the interval is halved, the left half first.  Nothing is sampled, so no zero is passed over.
"""

from collections.abc import Sequence
from functools import cache
from itertools import pairwise
from math import comb
from operator import mul

#: Halvings of an interval that may hold the first zero.
DEPTH = 24

#: Newton's steps behind them.
STEPS = 4


@cache
def _bernstein(degree: int) -> list[list[float]]:
    """Return the matrix from powers to Bernstein coefficients, without its zeros."""
    rows = range(degree + 1)
    return [[comb(i, j) / comb(degree, j) for j in range(i + 1)] for i in rows]


def first_zero(powers: Sequence[float]) -> float | None:
    """Return the first zero on (0, 1] of a polynomial that is positive at 0.

    Parameters
    ----------
    powers : sequence of float
        Its coefficients, that of the power 0 first: positive.

    Returns
    -------
    float or None
        Not above the first zero, and as near to it as Newton's method comes; None if there is
        none.

    Examples
    --------
    >>> round(first_zero([1.0, -4.0, 3.0]), 12)
    0.333333333333
    >>> first_zero([1.0, -2.0, 1.001])
    """
    rows = _bernstein(len(powers) - 1)
    whole = [sum(map(mul, row, powers)) for row in rows]
    waiting = [(whole, 0.0, 1.0, 0)]
    while waiting:
        coefficients, start, width, depth = waiting.pop()
        if min(coefficients) > 0:
            continue
        if depth == DEPTH:
            return _polished(powers, start, width)
        left, right = _halves(coefficients)
        half = width / 2
        waiting.append((right, start + half, half, depth + 1))
        waiting.append((left, start, half, depth + 1))
    return None


def _halves(coefficients: list[float]) -> tuple[list[float], list[float]]:
    """Return the Bernstein coefficients on both halves of an interval: de Casteljau's way."""
    left, right, row = [coefficients[0]], [coefficients[-1]], coefficients
    while len(row) > 1:
        row = [(a + b) / 2 for a, b in pairwise(row)]
        left.append(row[0])
        right.append(row[-1])
    return left, right[::-1]


def _polished(powers: Sequence[float], start: float, width: float) -> float:
    """Return the zero in a short interval, or its start where the polynomial only touches."""
    u = start
    for _ in range(STEPS):
        value, rate = _value(powers, u), _slope(powers, u)
        if not rate < 0 < value:
            break
        moved = u + value / -rate
        if moved > start + 2 * width:
            break
        below = _value(powers, moved)
        if below < 0:  # too far along an arc that falls ever faster: its chord is below it
            moved = u + (moved - u) * value / (value - below)
        u = moved
    return u


def _value(powers: Sequence[float], u: float) -> float:
    found = 0.0
    for factor in reversed(powers):
        found = found * u + factor
    return found


def _slope(powers: Sequence[float], u: float) -> float:
    return _value([j * factor for j, factor in enumerate(powers)][1:], u)
