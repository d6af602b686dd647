"""The sums of ``r_n^2/mu_n^q`` over the modes that an expansion leaves out."""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.special import zeta

from ...arrays import Vector
from ..attached import Attached
from ..eigenvalues.bracketing import EPS
from .beyond import ROUNDINGS, beyond

#: Number of modes that are summed one by one: at least, at most, and between them as many as
#: the cosine in ``r_n^2`` needs for `TURNS` turns: before the first it nearly cancels the 1.
FEWEST, MOST, TURNS = 1_000, 50_000, 4


@dataclass(frozen=True)
class LeftOut:
    """Sums of ``r_n^2/mu_n^q`` over ``n > N``, for a compliance ``r_n^2/mu_n^(q+1)``.

    For q = 1, 2, ...; `error` bounds the error of the first.
    """

    sums: Vector
    error: float


def left_out(attached: Attached, N: int, most: int) -> LeftOut:
    """Return the sums over the modes beyond the first `N`, up to ``q = most``."""
    oscillations = TURNS / float(min(attached.a, 1 - attached.a))
    summed = int(min(max(FEWEST, oscillations), MOST))
    lower = attached.structure.lowest_sum
    with_errors = [_summed(attached, N, q + lower, N + summed) for q in range(most)]
    return LeftOut(np.array([total for total, _ in with_errors]), with_errors[0][1])


def _summed(attached: Attached, N: int, q: int, last: int) -> tuple[float, float]:
    """Return the sum over ``n > N``, and a bound of its error.

    Modes up to `last` are added one by one.  Beyond, ``r_n^2 = (n pi)^(2j) (1 -+ cos(2 pi n
    a))``: the 1 is summed by the Hurwitz zeta function, the cosine by `beyond`.
    """
    weights, bare = _terms(attached, last)
    j = attached.structure.felt
    power = 2 * attached.structure.m * q - 2 * j
    unit = bare[N]  # whose powers do not overflow
    head = float(np.sum((weights[N:] * (unit / bare[N:]) ** q)[::-1]) * unit**-q)
    angle = 2 * np.pi * float(min(attached.a, 1 - attached.a))
    cosines = float(beyond(power, last, np.array([angle]))[0].real)
    rest = math.pi**-power * (zeta(power, last + 1) - (-1) ** j * cosines)
    error = ROUNDINGS * EPS * math.pi**-power * (last + 1.0) ** (1 - power)
    return head + rest, error + 4 * EPS * head


@lru_cache(maxsize=8)
def _terms(attached: Attached, last: int) -> tuple[Vector, Vector]:
    """Return ``r_n^2`` and ``mu_n`` for n up to `last`."""
    n = np.arange(1, last + 1)
    return attached.felt(n) ** 2, attached.bare(n)
