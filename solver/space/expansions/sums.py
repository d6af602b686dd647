"""The sums of ``r_n^2/mu_n^q`` over the modes that an expansion leaves out."""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.special import zeta

from ...arrays import Vector
from ..attached import Attached
from ..eigenvalues.bracketing import EPS

#: Modes that are summed one by one: at least, and at most; between them so many that the
#: cosine in ``r_n^2`` makes this many turns.
FEWEST, MOST, TURNS = 1_000, 50_000, 40


@dataclass(frozen=True)
class LeftOut:
    """Sums of ``r_n^2/mu_n^q`` over ``n > N``, of a compliance ``r_n^2/mu_n^(q+1)``.

    Parameters
    ----------
    sums : ndarray
        For q = 1, 2, ...
    error : float
        By how much the first may be off.
    """

    sums: Vector
    error: float


def left_out(attached: Attached, N: int, most: int, summed: int | None = None) -> LeftOut:
    """Return the sums over the modes beyond the first `N`, up to ``q = most``.

    Summed one by one they have their digits, but for the first of a load that converges
    slowly: that is the closed form less its first N terms.
    """
    if summed is None:
        turns = TURNS / float(min(attached.a, 1 - attached.a))
        summed = int(min(max(FEWEST, turns), MOST))
    lower = 1 if attached.structure.kind == "compliance" else 0
    found, first_off = [], 0.0
    for q in range(1 + lower, most + 1 + lower):
        total, off = _summed(attached, N, q, N + summed)
        if q == 1 + lower:
            closed, closed_off = _from_closed_form(attached, N, q)
            better = closed_off < off
            total, first_off = (closed, closed_off) if better else (total, off)
        found.append(total)
    return LeftOut(np.array(found), first_off)


def _from_closed_form(attached: Attached, N: int, q: int) -> tuple[float, float]:
    """Return the closed form less its first terms, and its rounding."""
    whole = float(attached.structure.module.static_sum(float(attached.a)))
    weights, bare = _terms(attached, N)
    return math.fsum([whole, *(-weights / bare**q)]), 2 * EPS * whole


def _summed(attached: Attached, N: int, q: int, last: int) -> tuple[float, float]:
    """Return the sum one by one and what it leaves, and how far off it may be.

    Beyond the last mode ``r_n^2`` is ``(n pi)^(2j) (1 -+ cos(2 pi n a))``: one, by the Hurwitz
    zeta function, and a cosine; see `_cosines`.
    """
    weights, bare = _terms(attached, last)
    j = attached.structure.felt
    power = 2 * attached.structure.m * q - 2 * j
    unit = bare[N]  # whose powers do not overflow
    head = float(np.sum((weights[N:] * (unit / bare[N:]) ** q)[::-1]) * unit**-q)
    cosines, off = _cosines(power, last, float(attached.a))
    rest = math.pi**-power * (zeta(power, last + 1) - (-1) ** j * cosines)
    return head + rest, math.pi**-power * off + 2 * EPS * head


def _cosines(p: int, last: int, a: float) -> tuple[float, float]:
    """Return the sum of ``cos(2 pi n a)/n^p`` over ``n > last``, and how far it may be off.

    With ``z = exp(2 pi i a)`` and ``F(t) = sum of exp((n + 1/2) (t + 2 pi i a))``, which is
    ``i/(2 sin(pi a))`` at 0, it is the real part of ``z^(last + 1/2)`` times the Taylor series
    of ``n^-p`` about ``last + 1/2``, with the derivatives of F for powers: three terms of it.
    """
    x, angle = last + 0.5, math.fmod((2 * last + 1) * a, 2.0) * math.pi
    sine, cosine = math.sin(math.pi * a), math.cos(math.pi * a)
    turned = math.sin(angle) / (2 * sine)
    first = p / x * math.cos(angle) * cosine / (4 * sine**2)
    second = p * (p + 1) / x**2 * math.sin(angle) * (1 + cosine**2) / (16 * sine**3)
    third = p * (p + 1) * (p + 2) / (2 * x * sine) ** 3 / sine
    return x**-p * (first + second - turned), x**-p * third


@lru_cache(maxsize=8)
def _terms(attached: Attached, last: int) -> tuple[Vector, Vector]:
    n = np.arange(1, last + 1)
    return attached.felt(n) ** 2, attached.bare(n)
