"""Ritz with forced modes: sines, and functions of the class of the exact solution beside them.

With the tails ``t_q = g_q`` less its first N sines the matrices of the bare structure are
diagonal but for a block of the sums ``s_q``, and a small eigenproblem makes effective modes of
it: the nodes of the Gauss quadrature of what the sines leave out.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import eigh

from ...arrays import Matrix, Vector
from ..attached import Attached
from .bare import BareModes
from .sines import Sines, ritz
from .sums import left_out


@dataclass(frozen=True)
class ForcedModes:
    """The forced modes of a structure, as polynomials on each side of the attachment."""

    attached: Attached

    def values(self, q: int, x: Vector, derivative: int) -> Vector:
        """Return a derivative of ``g_q`` at places `x`; at `a`, the mean of both sides."""
        a, b = float(self.attached.a), float(1 - self.attached.a)
        x = np.asarray(x, dtype=float)
        module, j = self.attached.structure.module, self.attached.structure.felt
        left = _odd_polynomial(module.forced_modes(a)[q - 1], x, derivative)
        right = _odd_polynomial(module.forced_modes(b)[q - 1], 1 - x, derivative)
        right = (-1) ** (j + derivative) * right
        return np.where(x < a, left, np.where(x > a, right, (left + right) / 2))

    def tail(self, q: int, N: int, x: Vector, derivative: int) -> Vector:
        """Return the same of ``g_q`` less its first N sines."""
        n = np.arange(1, N + 1)
        factors = self.attached.felt(n) / self.attached.bare(n) ** q
        summed = factors @ Sines(N).values(x, derivative)
        return np.asarray(self.values(q, x, derivative) - summed)


def _odd_polynomial(coefficients: Sequence[float], x: Vector, derivative: int) -> Vector:
    """Return a derivative of the polynomial with coefficients of ``x, x^3, ...``."""
    whole = np.zeros(2 * len(coefficients))
    whole[1::2] = coefficients
    found = np.polynomial.Polynomial(whole)
    return np.asarray(found.deriv(derivative)(x) if derivative else found(x))


@dataclass(frozen=True)
class WithForcedModes:
    """Sines and effective modes, each a combination of tails of forced modes."""

    attached: Attached
    N: int
    chosen: tuple[int, ...]
    combination: Matrix

    def values(self, x: Vector, derivative: int) -> Matrix:
        """Return a derivative of each mode at places `x`, sines first."""
        x = np.asarray(x, dtype=float)
        sines = Sines(self.N).values(x, derivative)
        if not self.chosen:
            return sines
        forced = ForcedModes(self.attached)
        tails = np.array([forced.tail(q, self.N, x, derivative) for q in self.chosen])
        return np.vstack([sines, self.combination @ tails])

    def hinge(self, x: Vector, derivative: int) -> Vector:
        """Return a derivative of ``g_1``."""
        return ForcedModes(self.attached).values(1, x, derivative)


def ritz_forced(attached: Attached, N: int, chosen: tuple[int, ...]) -> BareModes:
    """Return the bare modes of N sines and some forced modes.

    Parameters
    ----------
    attached : Attached
    N : int
    chosen : tuple of int
        Which forced modes, ascending; ``(1, 2)`` are the first two.
    """
    if not chosen:
        return ritz(attached, N)
    structure = attached.structure
    compliant = structure.kind == "compliance"
    hinged = compliant and chosen[0] == 1
    tails = tuple(q for q in chosen if not (compliant and q == 1))
    sines = ritz(attached, N)
    coupling = sines.at_a / sines.eigenvalues if compliant else sines.at_a
    felt = coupling if hinged or not compliant else np.zeros(N)
    shapes = WithForcedModes(attached, N, tails, np.empty((0, 0)))
    hinge_mass = float(structure.module.static_sum(float(attached.a))) if hinged else 0.0
    at_a = ForcedModes(attached).values(1, np.array([float(attached.a)]), structure.felt)
    found = BareModes(
        eigenvalues=sines.eigenvalues,
        felt=felt,
        at_a=sines.at_a,
        jumps=sines.jumps,
        hinge_mass=hinge_mass,
        hinge_rest=left_out(attached, N, 1).sums[0] if hinged else 0.0,
        hinge_at_a=float(at_a[0]) if hinged else 0.0,
        unknowns=N + len(chosen),
        shapes=shapes,
        off=0.0,
        inexact=np.ones(N),
    )
    return _with_tails(found, attached, N, tails) if tails else found


def _with_tails(
    sines: BareModes, attached: Attached, N: int, tails: tuple[int, ...]
) -> BareModes:
    """Return the modes with the effective ones of the tails behind them."""
    compliant = attached.structure.kind == "compliance"
    next_bare = float(attached.bare(np.array([N + 1]))[0])
    first = 2 if compliant else 1  # the first sum that there is
    most = 2 * tails[-1]
    powers = np.arange(first, most + 1.0)
    left = left_out(attached, N, most - first + 1)
    scaled = left.sums * next_bare**powers

    def sums(index: Matrix) -> Matrix:
        return np.asarray(scaled[np.asarray(index) - first])

    q = np.array(tails)
    pair = q[:, None] + q[None, :]
    theta, vectors = eigh(sums(pair), sums(pair - 1))
    order = np.argsort(theta)[::-1]
    theta, combination = theta[order], (vectors / np.sqrt(theta)).T[order]
    at_a = combination @ sums(q)
    # <g_1, t_q> is the next sum; the tails are scaled by the q-th power
    coupled = combination @ sums(q + 1) / next_bare if compliant else at_a
    unit = combination * next_bare ** q[None, :].astype(float)
    jumps = unit[:, list(tails).index(1)] if 1 in tails else np.zeros(len(tails))
    felt = coupled if sines.hinge_mass or not compliant else 0 * at_a
    return BareModes(
        eigenvalues=np.append(sines.eigenvalues, next_bare / theta),
        felt=np.append(sines.felt, felt),
        at_a=np.append(sines.at_a, at_a),
        jumps=np.append(sines.jumps, attached.structure.jump * jumps),
        hinge_mass=sines.hinge_mass,
        hinge_rest=sines.hinge_rest - float(felt @ felt) if sines.hinge_mass else 0.0,
        hinge_at_a=sines.hinge_at_a,
        unknowns=sines.unknowns,
        shapes=WithForcedModes(attached, N, tails, unit),
        off=left.error,
        inexact=np.ones(N + len(tails)),
    )
