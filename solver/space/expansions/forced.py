"""Ritz method with forced modes: sines, and functions ``g_q`` of the class of the exact modes.

With the tails ``t_q``, g_q less its first N sines, the matrices of the bare structure are
diagonal but for a block of sums ``s_q``.  The small eigenproblem of this block gives effective
modes: the nodes of a Gauss quadrature of the modes that the sines leave out.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache

import numpy as np
from scipy.linalg import eigh

from ...arrays import Matrix, Vector
from ..attached import Attached
from ..structure import Structure
from .bare import BareModes, Sines, joined, ritz
from .beyond import beyond
from .sums import left_out


@dataclass(frozen=True)
class ForcedModes:
    """The forced modes of a structure, as polynomials on each side of the attachment."""

    attached: Attached

    def values(self, q: int, x: Vector, derivative: int, side: int = 0) -> Vector:
        """Return a derivative of ``g_q`` at places `x`; at `a`, by `side`, as in `Shapes`."""
        x, a, structure = np.asarray(x, dtype=float), self.attached.a, self.attached.structure
        left = _odd_polynomial(_coefficients(structure, a)[q - 1], x, derivative)
        right = _odd_polynomial(_coefficients(structure, 1 - a)[q - 1], 1 - x, derivative)
        right = (-1) ** (structure.felt + derivative) * right
        return joined(x, float(a), left, right, side)

    def tail(self, q: int, N: int, x: Vector, derivative: int, side: int = 0) -> Vector:
        """Return a derivative of the tail: of ``g_q`` less its first N sines.

        It is the sum of ``r_n/mu_n^q phi_n`` over ``n > N``, whose products of two waves are
        split into waves of sum and difference.  For the derivative of ``g_1`` that jumps, and
        higher ones, this sum diverges: they are the closed form less N sines.
        """
        m, j = self.attached.structure.m, self.attached.structure.felt
        power = 2 * m * q - j - derivative
        if power < 2:
            n = np.arange(1, N + 1)
            factors = self.attached.felt(n) / self.attached.bare(n) ** q
            summed = factors @ Sines(N).values(x, derivative)
            return np.asarray(self.values(q, x, derivative, side) - summed)
        x, a = np.asarray(x, dtype=float), float(self.attached.a)
        minus = 1j ** (derivative - j) * beyond(power, N, np.pi * (x - a))
        plus = 1j ** (derivative + j) * beyond(power, N, np.pi * (x + a))
        return np.asarray((minus - plus).real / np.pi**power)


@lru_cache(maxsize=64)
def _coefficients(structure: Structure, a: Fraction) -> tuple[tuple[float, ...], ...]:
    """Return the coefficients of each forced mode left of `a`, computed exactly."""
    rows = structure.module.forced_modes(a)
    return tuple(tuple(map(float, row)) for row in rows)


def _odd_polynomial(coefficients: Sequence[float], x: Vector, derivative: int) -> Vector:
    """Return a derivative of the polynomial with coefficients of ``x, x^3, ...``."""
    whole = np.zeros(2 * len(coefficients))
    whole[1::2] = coefficients
    return np.asarray(np.polynomial.Polynomial(whole).deriv(derivative)(x))


@dataclass(frozen=True)
class WithForcedModes:
    """Sines and effective modes, each a combination of tails of forced modes."""

    attached: Attached
    N: int
    chosen: tuple[int, ...]
    combination: Matrix

    def values(self, x: Vector, derivative: int, side: int = 0) -> Matrix:
        """Return a derivative of each mode at places `x`, sines first."""
        sines, forced = Sines(self.N).values(x, derivative), ForcedModes(self.attached)
        if not self.chosen:
            return sines
        tails = np.array([forced.tail(q, self.N, x, derivative, side) for q in self.chosen])
        return np.vstack([sines, self.combination @ tails])

    def hinge(self, x: Vector, derivative: int, side: int = 0) -> Vector:
        """Return a derivative of ``g_1``."""
        return ForcedModes(self.attached).values(1, x, derivative, side)


def ritz_forced(attached: Attached, N: int, chosen: tuple[int, ...]) -> BareModes:
    """Return the bare modes of N sines and the forced modes of ascending numbers `chosen`."""
    if not chosen:
        return ritz(attached, N)
    compliant = attached.structure.kind == "compliance"
    hinged = compliant and chosen[0] == 1
    tails = tuple(q for q in chosen if not (compliant and q == 1))
    n, sines = np.arange(1, N + 1), ritz(attached, N)
    modes = replace(
        sines,
        felt=attached.felt(n) / attached.bare(n) if hinged else sines.felt,
        hinge_rest=float(left_out(attached, N, 1).sums[0]) if hinged else 0.0,
        unknowns=N + len(chosen),
        shapes=WithForcedModes(attached, N, tails, np.empty((0, 0))),
    )
    return _with_tails(modes, attached, N, tails) if tails else modes


def _with_tails(
    sines: BareModes, attached: Attached, N: int, tails: tuple[int, ...]
) -> BareModes:
    """Return the sines followed by the effective modes of the tails."""
    next_bare = float(attached.bare(np.array([N + 1]))[0])
    first = attached.structure.lowest_sum
    most = 2 * tails[-1]
    tail = left_out(attached, N, most - first + 1)
    scaled = tail.sums * next_bare ** np.arange(first, most + 1.0)

    def sums(index: Matrix) -> Matrix:
        return np.asarray(scaled[np.asarray(index) - first])

    q = np.array(tails)
    pair = q[:, None] + q[None, :]
    theta, vectors = eigh(sums(pair), sums(pair - 1))
    order = np.argsort(theta)[::-1]
    theta, combination = theta[order], (vectors / np.sqrt(theta)).T[order]
    felt = combination @ sums(q)
    hinged, static_rest = sines.hinge_rest > 0, 0.0
    if attached.structure.kind == "compliance":
        # <g_1, t_q> is the next sum; the tails are scaled by the q-th power
        felt = combination @ sums(q + 1) / next_bare if hinged else np.zeros(len(tails))
    elif tails[0] > 1:
        static_rest = sines.static_rest - float(felt**2 @ theta) / next_bare
    return replace(
        sines,
        eigenvalues=np.append(sines.eigenvalues, next_bare / theta),
        felt=np.append(sines.felt, felt),
        static_rest=static_rest,
        hinge_rest=sines.hinge_rest - float(felt @ felt) if hinged else 0.0,
        shapes=WithForcedModes(attached, N, tails, combination * next_bare ** q.astype(float)),
        off=tail.error,
        inexact=np.ones(N + len(tails)),
    )
