"""The attachment, put in as a scalar equation: every eigenvalue in its own bracket.

With bare modes ``Lambda_i`` and what the attachment feels of them, ``r_i``, the eigenvalues are
the roots of

    stiffness    1 + s sum r_i^2/(Lambda_i - lambda)                       = 0
    inertia      1 - s lambda sum r_i^2/(Lambda_i - lambda)                = 0
    compliance   1 - s lambda [h + sum Lambda_i r_i^2/(Lambda_i - lambda)] = 0

each monotone between the ``Lambda_i``: the roots interlace with them, and none can be missed.
A mode of which nothing is felt keeps its eigenvalue.  The unknown is the distance from the
nearer end of the bracket, which keeps its digits however small it is.
"""

from dataclasses import dataclass

import numpy as np

from ...arrays import Matrix, Vector
from ..expansions.bare import BareModes
from .bracketing import EPS, bracketed

#: Units of rounding by which each term, and each eigenvalue, may be off.
ROUNDINGS = 4


@dataclass(frozen=True)
class Roots:
    """Eigenvalues, the lowest first: ``origin + shift``.

    Parameters
    ----------
    origin, shift : ndarray, shape (n,)
        The end of the bracket that is nearer, 0 or an eigenvalue of the bare structure, and
        the distance from it.
    untouched : ndarray of int, shape (n,)
        Which of the bare modes it is, where the attachment feels nothing of it; else -1.
    rounding : ndarray, shape (n,)
        By how much rounding may have moved each of them.
    """

    origin: Vector
    shift: Vector
    untouched: Vector
    rounding: Vector

    @property
    def values(self) -> Vector:
        """The eigenvalues."""
        return self.origin + self.shift


def eigenvalues(bare: BareModes, kind: str, s: float, count: int) -> Roots:
    """Return the lowest eigenvalues of a structure with an attachment of strength `s`."""
    index = np.arange(len(bare.eigenvalues))
    felt = bare.felt != 0
    poles, weights, h = bare.eigenvalues[felt], bare.felt[felt] ** 2, bare.hinge_rest
    if kind == "compliance":
        weights = weights * poles
    origin, shift = _coupled(poles, weights, h, kind, s, count)
    kept = index[~felt][:count]
    all_origins = np.concatenate([origin, bare.eigenvalues[kept]])
    all_shifts = np.concatenate([shift, np.zeros(len(kept))])
    mark = np.concatenate([np.full(len(origin), -1), kept])
    order = np.argsort(all_origins + all_shifts, kind="stable")[:count]
    values = all_origins[order] + all_shifts[order]
    coupled = mark[order] < 0
    rounding = ROUNDINGS * EPS * values
    rounding[~coupled] *= bare.inexact[mark[order][~coupled]]
    if coupled.any():
        found = _sensitivity(
            poles, poles * bare.inexact[felt], weights, h, kind, s, bare.off,
            all_origins[order][coupled], all_shifts[order][coupled],
        )  # fmt: skip
        rounding[coupled] += ROUNDINGS * EPS * found
    return Roots(all_origins[order], all_shifts[order], mark[order], rounding)


def difference(roots: Roots, origins: Vector, shifts: Vector, i: int) -> float:
    """Return the `i`-th of some eigenvalues less that of others, given by origin and shift.

    Where both are near the same eigenvalue of the bare structure, by their shifts.
    """
    return float((roots.origin[i] - origins[i]) + (roots.shift[i] - shifts[i]))


def number(bare: BareModes, kind: str) -> int:
    """Return how many eigenvalues there are: a function with a jump brings one more."""
    return len(bare.eigenvalues) + (kind == "compliance" and bare.hinge_rest > 0)


def _sensitivity(
    poles: Vector, inexact: Vector, weights: Vector, h: float, kind: str, s: float, off: float,
    origin: Vector, shift: Vector,
) -> Vector:  # fmt: skip
    """Return the sum of the moduli of the terms over the slope of the equation.

    Times the unit of rounding, this is how far each root moves if every term is off by that,
    and every bare eigenvalue by so many of its units.
    """
    away = (poles[None, :] - origin[:, None]) - shift[:, None]
    away = np.where(away == 0, np.finfo(float).tiny, away)
    terms = np.abs(weights / away)
    slopes = terms / np.abs(away)
    sizes = h + off / EPS + (terms + slopes * inexact).sum(axis=1)
    if kind == "stiffness":
        return np.asarray((1 / s + sizes) / slopes.sum(axis=1))
    slope = h + (slopes * poles).sum(axis=1)
    return np.asarray((1 / s + (origin + shift) * sizes) / slope)


def _coupled(
    poles: Vector, weights: Vector, h: float, kind: str, s: float, count: int
) -> tuple[Vector, Vector]:
    """Return origin and shift of the roots between the poles."""
    if poles.size == 0 and h <= 0:
        return np.empty(0), np.empty(0)
    if kind == "stiffness":
        low, high = poles, np.append(poles[1:], poles[-1:] + s * weights.sum())
    else:
        low, high = np.append(0.0, poles[:-1]), poles
    if h > 0:
        low, high = np.append(0.0, poles), np.append(poles, _beyond(poles, weights, h, s))
    low, high = low[:count], high[:count]
    half = (high - low) / 2
    below = np.sign(_Function(poles, weights, kind, s, h, low)(half)) != _sign_below(kind)
    is_pole = np.isin(high, poles)
    origin = np.where(below | ~is_pole, low, high)
    # without a pole at its upper end, the last bracket is searched from the lower one
    end = np.where(is_pole, np.where(below, half, -half), high - low)
    function = _Function(poles, weights, kind, s, h, origin)
    zero = np.zeros_like(end)
    return origin, bracketed(function, zero, end, function(zero), function(end))


def _sign_below(kind: str) -> float:
    """Return the sign of the equation just above the lower end of a bracket."""
    return -1.0 if kind == "stiffness" else 1.0


def _beyond(poles: Vector, weights: Vector, h: float, s: float) -> float:
    """Return a place above the highest root of a compliance, whose equation falls to -inf."""
    last = float(poles[-1]) if poles.size else 0.0
    step = max(last, 1 / (s * h))
    while 1 - s * (last + step) * (h + np.sum(weights / (poles - last - step))) >= 0:
        step *= 2
    return last + step


class _Function:
    """The left sides of the equations, times the distance from the pole at the origin.

    So it is smooth there; where the origin is 0 and not a pole, it is the equation itself.
    """

    def __init__(
        self, poles: Vector, weights: Vector, kind: str, s: float, h: float, origin: Vector
    ) -> None:
        self.kind, self.s, self.h, self.origin = kind, s, h, origin
        self.weights = weights
        self.distance: Matrix = poles[None, :] - origin[:, None]
        self.own = self.distance == 0
        self.at_pole = self.own.any(axis=1)
        self.own_weight = np.where(self.own, weights[None, :], 0.0).sum(axis=1)

    def __call__(self, shift: Vector) -> Vector:
        away = np.where(self.own, 1.0, self.distance - shift[:, None])
        others = np.where(self.own, 0.0, self.weights[None, :] / away).sum(axis=1)
        factor = np.where(self.at_pole, shift, 1.0)
        total = factor * (self.h + others) - self.own_weight
        if self.kind == "stiffness":
            return np.asarray(factor + self.s * total)
        return np.asarray(factor - self.s * (self.origin + shift) * total)
