"""The attachment as a scalar (secular) equation: every eigenvalue in its own bracket.

With eigenvalues ``Lambda_i`` of bare modes, and their derivatives ``r_i`` at the attachment,
the eigenvalues are the roots of

    stiffness    1 + s sum r_i^2/(Lambda_i - lambda)                       = 0
    inertia      1 - s lambda sum r_i^2/(Lambda_i - lambda)                = 0
    compliance   1 - s lambda [h + sum Lambda_i r_i^2/(Lambda_i - lambda)] = 0

each monotone between the ``Lambda_i``: the roots interlace with them, and none can be missed.
A mode with ``r_i = 0`` keeps its eigenvalue.  The unknown is the distance from the nearer end
of the bracket, so that small shifts have all digits.

A spring raises the eigenvalues: there is one above each ``Lambda_i``.  Every other attachment,
and a spring of negative stiffness, lowers them: the lowest is between 0 and ``Lambda_1``.  For
such a spring it goes to 0 with the margin of stability ``1 + s sum r_i^2/Lambda_i``.  Near 0
the equation is written with this margin:

    margin + s lambda sum r_i^2/(Lambda_i (Lambda_i - lambda)) = 0
"""

from dataclasses import dataclass

import numpy as np

from ...arrays import Matrix, Vector
from ..attached import Attached
from ..expansions.bare import BareModes
from ..position import Integers
from .bracketing import EPS, bracketed
from .exact import exact_modes

#: Rounding error of each term, and of each eigenvalue, in units of `EPS`.
ROUNDINGS = 4


@dataclass(frozen=True)
class Roots:
    """Eigenvalues ``origin + shift``, in the order of the exact ones; shape (n,) each.

    Parameters
    ----------
    origin, shift : ndarray
        The nearer end of the bracket, 0 or an eigenvalue of the bare structure; and the
        distance from it.
    untouched : ndarray of int
        The index of the bare mode, if the attachment does not affect it, else -1.
    rounding : ndarray
        Bounds of the rounding errors.
    """

    origin: Vector
    shift: Vector
    untouched: Vector
    rounding: Vector

    @property
    def values(self) -> Vector:
        """The eigenvalues."""
        return self.origin + self.shift


def eigenvalues(bare: BareModes, attached: Attached, count: int) -> Roots:
    """Return the lowest eigenvalues of a structure with its attachment, from bare modes."""
    felt, unit = bare.felt != 0, ROUNDINGS * EPS
    uncoupled, terms = np.flatnonzero(~felt)[:count], _Terms(bare, attached, felt)
    origin, shift = _coupled(terms, count)
    rounding = unit * (origin + shift)
    if origin.size:
        rounding += unit * _sensitivity(terms, bare.inexact[felt], bare.off, origin, shift)
    every = Roots(
        np.append(origin, bare.eigenvalues[uncoupled]),
        np.append(shift, np.zeros(len(uncoupled))),
        np.append(np.full(len(origin), -1), uncoupled),
        np.append(rounding, unit * bare.eigenvalues[uncoupled] * bare.inexact[uncoupled]),
    )
    order = _order(attached, every, uncoupled, count)
    return Roots(*(field[order] for field in vars(every).values()))


def _order(attached: Attached, every: Roots, kept: Integers, count: int) -> Integers:
    """Return the indices that sort eigenvalues like the exact modes.

    In `every`, eigenvalues of modes that are `kept` come last.  A root near a kept one may be
    on the wrong side of it, so the order is taken from the exact modes; it is ascending if
    there are not enough of each kind.
    """
    exact, coupled = exact_modes(attached, count), len(every.values) - len(kept)
    same, node = np.cumsum(exact.untouched == 0), exact.n - 1
    if len(same) and same[-1] <= coupled and np.isin(node[exact.untouched], kept).all():
        return np.where(exact.untouched, coupled + np.searchsorted(kept, node), same - 1)
    return np.argsort(every.values, kind="stable")[:count]


class _Terms:
    """The equation of a structure: poles ``Lambda_i``, numerators over them, and constants."""

    def __init__(self, bare: BareModes, attached: Attached, felt: Vector) -> None:
        self.kind, self.s, self.raises = attached.structure.kind, attached.s, attached.raises
        self.poles, self.weights = bare.eigenvalues[felt], bare.felt[felt] ** 2
        if self.kind == "compliance":
            self.weights = self.weights * self.poles
        self.h, self.margin = bare.hinge_rest, 1.0
        if self.kind == "stiffness":
            self.margin = attached.margin - self.s * bare.static_rest


def _sensitivity(
    terms: _Terms, inexact: Vector, off: float, origin: Vector, shift: Vector
) -> Vector:
    """Return the condition of the roots: the sum of the moduli of terms over the slope.

    Times the unit of rounding, it bounds the change of each root if every term has one unit of
    rounding, and every bare eigenvalue `inexact` units.
    """
    poles, weights, s = terms.poles, terms.weights, abs(terms.s)
    away = (poles[None, :] - origin[:, None]) - shift[:, None]
    away = np.where(away == 0, EPS * poles, away)  # a pole with a negligible weight
    moduli = np.abs(weights / away)
    slopes, value = moduli / np.abs(away), origin + shift
    if terms.kind == "stiffness":
        zero = origin == 0
        part = np.where(zero[:, None], 2 * value[:, None] / poles, 1.0)
        sizes = (part * (moduli + slopes * poles * inexact)).sum(axis=1)
        constant = np.where(zero, terms.margin, 1.0) / s
        return np.asarray((constant + sizes + part[:, 0] * off / EPS) / slopes.sum(axis=1))
    sizes = terms.h + off / EPS + (moduli + slopes * poles * inexact).sum(axis=1)
    slope = terms.h + (slopes * poles).sum(axis=1)
    return np.asarray((1 / s + value * sizes) / slope)


def _coupled(terms: _Terms, count: int) -> tuple[Vector, Vector]:
    """Return origin and shift of the roots between poles of modes that are affected."""
    poles, h = terms.poles, terms.h
    if poles.size == 0 and h <= 0:
        return np.empty(0), np.empty(0)
    if terms.raises:
        low, high = poles, np.append(poles[1:], poles[-1:] + terms.s * terms.weights.sum())
    elif h > 0:
        low, high = np.append(0.0, poles), np.append(poles, _beyond(terms))
    else:
        low, high = np.append(0.0, poles[:-1]), poles
    low, high = low[:count], high[:count]
    half = (high - low) / 2
    start = -1.0 if terms.raises else 1.0  # the sign just above the lower end
    below = np.sign(_Function(terms, low)(half)) != start
    is_pole = np.isin(high, poles)
    origin = np.where(below | ~is_pole, low, high)
    # without a pole at its upper end, the last bracket is searched from the lower one
    end = np.where(is_pole, np.where(below, half, -half), high - low)
    return origin, bracketed(_Function(terms, origin), end)


def _beyond(terms: _Terms) -> float:
    """Return a number above the highest root of a compliance, whose equation falls to -inf."""
    poles, weights, h, s = terms.poles, terms.weights, terms.h, terms.s
    last = float(poles[-1]) if poles.size else 0.0
    step = max(last, 1 / (s * h))
    while 1 - s * (last + step) * (h + np.sum(weights / (poles - last - step))) >= 0:
        step *= 2
    return last + step


class _Function:
    """The left sides of the equations, times the distance from the pole at the origin.

    The product is smooth there.  For the origin 0, which is no pole, it is the equation itself.
    """

    def __init__(self, terms: _Terms, origin: Vector) -> None:
        self.terms, self.origin = terms, origin
        self.distance: Matrix = terms.poles[None, :] - origin[:, None]
        self.own = self.distance == 0
        self.at_pole = self.own.any(axis=1)
        self.from_zero = (origin == 0) & (terms.kind == "stiffness")
        over = np.where(self.from_zero[:, None], terms.poles[None, :], 1.0)
        self.weights: Matrix = terms.weights[None, :] / over
        self.own_weight = np.where(self.own, self.weights, 0.0).sum(axis=1)

    def __call__(self, shift: Vector) -> Vector:
        terms = self.terms
        away = np.where(self.own, 1.0, self.distance - shift[:, None])
        sums = np.where(self.own, 0.0, self.weights / away).sum(axis=1)
        factor = np.where(self.at_pole, shift, 1.0)
        total = factor * (terms.h + sums) - self.own_weight
        if terms.kind == "stiffness":
            constant = np.where(self.from_zero, terms.margin, factor)
            return np.asarray(constant + terms.s * np.where(self.from_zero, shift, 1.0) * total)
        return np.asarray(factor - terms.s * (self.origin + shift) * total)
