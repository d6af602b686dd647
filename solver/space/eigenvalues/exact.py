"""The exact eigenvalues: the characteristic equation with a bracket for each root.

The equation is that of `secular` with all modes; their sum is the closed form that SymPy
derived.  It is monotone between successive wave numbers ``n pi`` of modes that the attachment
affects.  The unknown is the distance from the nearer one, from which sines are computed too:
neither a weak attachment nor one near a node costs digits.
"""

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Vector
from ..attached import Attached
from ..expansions.bare import joined
from ..expansions.forced import ForcedModes
from ..expansions.sums import left_out
from ..position import Integers
from .bracketing import EPS, bracketed

if TYPE_CHECKING:
    from .secular import Roots

#: Near zero and near an end the closed form cancels.  There, for modes n up to `HIGHEST`, it is
#: a sum over ``2 n + LEAST`` modes, and a power series of `TERMS` terms for the others.
HIGHEST, LEAST, TERMS = 100, 4, 16


@dataclass(frozen=True)
class ExactModes:
    """Exact wave numbers of a structure, the lowest first: ``n pi + offset``.

    Parameters
    ----------
    n : ndarray of int, shape (count,)
    offset : ndarray, shape (count,)
    untouched : ndarray of bool, shape (count,)
        Whether the mode is ``sin(n pi x)``, which the attachment does not affect.
    """

    attached: Attached
    n: Integers
    offset: Vector
    untouched: Vector

    @property
    def beta(self) -> Vector:
        """The wave numbers times the length."""
        return np.asarray(self.n * np.pi + self.offset)

    @property
    def eigenvalues(self) -> Vector:
        """``beta^(2m)``."""
        return self.beta ** (2 * self.attached.structure.m)

    @property
    def shifts(self) -> Vector:
        """The eigenvalues less ``(n pi)^(2m)``, without cancellation."""
        return _shift(self.n, self.offset, self.attached.structure.m)

    def error(self, roots: "Roots", i: int) -> float:
        """Return the relative error of eigenvalue `i` of `roots`.

        Shifts from eigenvalues of the bare structure are compared, to avoid cancellation.
        """
        origin = self.attached.bare(self.n[i])
        difference = (roots.origin[i] - origin) + (roots.shift[i] - self.shifts[i])
        return float(difference) / float(self.eigenvalues[i])

    def shape(self, number: int, x: Vector, derivative: int) -> Vector:
        """Return a derivative, up to ``2m - 1``, of a mode at places relative to the length.

        The scale is arbitrary; at the attachment it is the mean of both sides.
        """
        x, i, structure = np.asarray(x, dtype=float), number - 1, self.attached.structure
        beta, most = self.beta[i], structure.most_forced
        if self.untouched[i] or self.offset[i] == 0:
            return np.asarray(beta**derivative * np.sin(beta * x + derivative * np.pi / 2))
        if (beta / np.pi) ** (2 * structure.m * most) < EPS:  # a power series, of forced modes
            forced, lam = ForcedModes(self.attached), self.eigenvalues[i]
            terms = (
                lam ** (q - 1) * forced.values(q, x, derivative) for q in range(1, most + 1)
            )
            return np.asarray(sum(terms))
        around = _Sines(self.attached, self.n[[i]], self.offset[[i]])

        def side(x: Vector, b: float, sine: Vector, cosine: Vector) -> Vector:
            """Return the response at ``x <= 1 - b``, the attachment at ``1 - b``."""
            inside = np.clip(x, 0, 1 - b)
            over = structure.module.shape_over_sine(beta, inside, sine, cosine)[derivative]
            rest = structure.module.shape_rest(beta, inside, b)[derivative]
            return np.asarray(over / around.sin + rest)

        a, b = float(self.attached.a), float(1 - self.attached.a)
        left = side(x, b, around.sin_b, around.cos_b)
        right = side(1 - x, a, around.sin_a, around.cos_a)
        return joined(x, a, left, (-1) ** (structure.felt + derivative) * right)


def of_frequency(error: float) -> float:
    """Return the relative error of a frequency from that of its eigenvalue."""
    return math.expm1(0.5 * math.log1p(error))


def _shift(n: Integers, d: Vector, m: int) -> Vector:
    """Return ``(n pi + d)^(2m) - (n pi)^(2m)``."""
    p = n * np.pi
    square = d * (2 * p + d)
    return np.asarray(square if m == 1 else square * (2 * p**2 + square))


class _Sines:
    """Sines and cosines of ``beta``, ``beta a``, ``beta b`` for ``beta = n pi + offset``."""

    def __init__(self, attached: Attached, n: Integers, offset: Vector) -> None:
        a, b = float(attached.a), float(1 - attached.a)
        sine, cosine = attached.sines(n)
        sign = np.where(n % 2 == 0, 1.0, -1.0)
        self.sin = sign * np.sin(offset)
        self.sin_a, self.cos_a = _turned(sine, cosine, offset * a)
        # n pi b is n pi less n pi a
        self.sin_b, self.cos_b = _turned(-sign * sine, sign * cosine, offset * b)


def _turned(sine: Vector, cosine: Vector, by: Vector) -> tuple[Vector, Vector]:
    """Return sine and cosine of an angle that is increased."""
    return sine * np.cos(by) + cosine * np.sin(by), cosine * np.cos(by) - sine * np.sin(by)


@lru_cache(maxsize=64)
def exact_modes(attached: Attached, count: int) -> ExactModes:
    """Return the lowest exact modes of a structure."""
    n = np.arange(1, 2 * count + 3)
    felt = attached.felt(n) != 0
    coupled, bare = n[felt][: count + 2], n[~felt][:count]
    low, high = coupled[:-1], coupled[1:]
    if not attached.raises:
        low, high = np.append(0, low), np.append(coupled[0], high)
    low, high = low[:count], high[:count]
    origin, offset = _roots(attached, low, high)
    every_n, every_offset = np.append(origin, bare), np.append(offset, np.zeros(len(bare)))
    untouched = np.append(np.zeros(len(origin), bool), np.ones(len(bare), bool))
    order = np.argsort(every_n * np.pi + every_offset, kind="stable")[:count]
    return ExactModes(attached, every_n[order], every_offset[order], untouched[order])


def _roots(attached: Attached, low: Integers, high: Integers) -> tuple[Integers, Vector]:
    """Return the nearer end of the bracket of each root, and the root's distance from it."""
    half = (high - low) * np.pi / 2
    start = -1.0 if attached.raises else 1.0
    below = np.sign(_Equation(attached, low)(half)) != start
    origin, end = np.where(below, low, high), np.where(below, half, -half)
    return origin, bracketed(_Equation(attached, origin), end)


class _Equation:
    """The characteristic equation times the distance from the wave number at the origin.

    For the origin 0, which is no wave number, it is the equation itself; for a spring, written
    with its margin of stability.
    """

    def __init__(self, attached: Attached, origin: Integers) -> None:
        self.attached, self.origin = attached, origin
        self.from_zero = (origin == 0) & (attached.structure.kind == "stiffness")
        end = np.pi * float(min(attached.a, 1 - attached.a))
        self.sums = np.flatnonzero((origin * end < 1) & (origin <= HIGHEST))

    def __call__(self, offset: Vector) -> Vector:
        structure = self.attached.structure
        # in place of 0 an offset so small that the limit is exact, and finite
        offset = np.where(offset == 0, np.finfo(float).tiny ** 0.5, offset)
        beta = self.origin * np.pi + offset
        factor = np.where(self.origin == 0, 1.0, offset)
        G = factor * self._receptance(beta, offset)
        if structure.kind == "stiffness":
            constant = np.where(self.from_zero, self.attached.margin, factor)
            return np.asarray(constant + self.attached.s * G)
        return np.asarray(factor - self.attached.s * beta ** (2 * structure.m) * G)

    def _receptance(self, beta: Vector, offset: Vector) -> Vector:
        """Return the receptance, for a compliance over lambda; from 0, less its value at 0."""
        module = self.attached.structure.module
        a, b = float(self.attached.a), float(1 - self.attached.a)
        q = _Sines(self.attached, self.origin, offset)
        with np.errstate(all="ignore"):
            over = module.receptance_over_sine(beta, q.sin_a, q.cos_a, q.sin_b, q.cos_b)
            receptance = np.array(over / q.sin + module.receptance_rest(beta, a, b))
        if self.sums.size:
            receptance[self.sums] = self._summed(offset[self.sums])
        return receptance

    def _summed(self, offset: Vector) -> Vector:
        """Return the same as a sum over modes, with a power series for the other modes."""
        attached, n = self.attached, self.origin[self.sums]
        poles, weights, rest = _sum(attached, 2 * int(n.max()) + LEAST)
        shift = _shift(n, offset, attached.structure.m)
        origin, from_zero = attached.bare(n), self.from_zero[self.sums]
        value = origin + shift
        terms = weights / ((poles - origin[:, None]) - shift[:, None])
        terms *= np.where(from_zero[:, None], value[:, None] / poles, 1.0)
        series = value[:, None] ** np.arange(TERMS) * rest
        series[from_zero, 0] = 0.0
        return np.asarray(terms.sum(axis=1) + series.sum(axis=1))


def _weights(attached: Attached, n: Integers) -> Vector:
    """Return ``r_n^2``, for a compliance over ``mu_n``."""
    if attached.structure.kind == "compliance":
        return np.asarray(2 * attached.sines(n)[0] ** 2)
    return attached.felt(n) ** 2


@lru_cache(maxsize=16)
def _sum(attached: Attached, last: int) -> tuple[Vector, Vector, Vector]:
    """Return eigenvalues and weights of bare modes, and the power series of the others."""
    n = np.arange(1, last + 1)
    return attached.bare(n), _weights(attached, n), left_out(attached, last, TERMS).sums
