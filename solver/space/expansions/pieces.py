"""Functions of class C^k only (Section 3.3): a polynomial on each side of the attachment.

``u^(m)`` is a Legendre series on each segment, orthonormal, so that the stiffness matrix of
the bare structure is the identity; integrated m times it gives ``u``, whose coefficients are a
matrix ``U``, and the mass matrix is ``U^T U``. The singular values of ``U`` are the inverse
square roots of the eigenvalues: the lowest keep all digits.
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre

from ...arrays import Matrix, Vector
from ..attached import Attached
from ..eigenvalues.bracketing import EPS
from .bare import BareModes


@dataclass(frozen=True)
class Pieces:
    """Piecewise Legendre series: column by column the coefficients of some functions.

    Parameters
    ----------
    a : float
        Where the segments meet.
    left, right : ndarray, shape (degree + 1, count)
        Coefficients of the shifted Legendre polynomials of each segment.
    """

    a: float
    left: Matrix
    right: Matrix

    @property
    def lengths(self) -> tuple[float, float]:
        """Lengths of the segments."""
        return self.a, 1 - self.a

    def combined(self, matrix: Matrix) -> "Pieces":
        """Return combinations of the functions, a column each."""
        return Pieces(self.a, self.left @ matrix, self.right @ matrix)

    def ends(self, derivative: int) -> tuple[Vector, Vector, Vector, Vector]:
        """Return a derivative at 0, left and right of `a`, and at 1."""
        rows = []
        for part, h in zip((self.left, self.right), self.lengths, strict=True):
            found = _derivative(part, h, derivative)
            rows += [np.asarray(legendre.legval(place, found)) for place in (-1.0, 1.0)]
        return rows[0], rows[1], rows[2], rows[3]

    def values(self, x: Vector, derivative: int) -> Matrix:
        """Return a derivative at places `x`, a row a function; at `a`, the mean."""
        x, found = np.asarray(x, dtype=float), []
        for part, h, start in zip(
            (self.left, self.right), self.lengths, (0, self.a), strict=True
        ):
            local = 2 * (x - start) / h - 1
            found.append(legendre.legval(local, _derivative(part, h, derivative), tensor=True))
        left, right = found
        return np.asarray(
            np.where(x < self.a, left, np.where(x > self.a, right, (left + right) / 2))
        )

    def norms(self, attached: Attached) -> tuple[Vector, Vector]:
        """Return the square roots of the integrals of the squares of the polynomials."""
        norm_squared = attached.structure.module.legendre_norm_squared
        degrees = np.arange(len(self.left))
        left, right = (np.sqrt(norm_squared(degrees, h)) for h in self.lengths)
        return left, right

    def orthonormal(self, attached: Attached) -> Matrix:
        """Return the coefficients in orthonormal polynomials, both segments stacked."""
        left, right = self.norms(attached)
        return np.vstack([left[:, None] * self.left, right[:, None] * self.right])

    def integrated(self, attached: Attached) -> "Pieces":
        """Return the integrals from 0, continuous at `a`."""
        factor = attached.structure.module.legendre_integral
        parts, start = [], np.zeros(self.left.shape[1])
        for part, h in zip((self.left, self.right), self.lengths, strict=True):
            degrees = np.arange(len(part))
            found = np.zeros((len(part) + 1, part.shape[1]))
            scaled = factor(degrees, h)[:, None] * part
            found[1:] += scaled
            found[:-2] -= scaled[1:]
            found[0] += scaled[0] + start  # P_(-1)* = -1: zero at the start of the segment
            parts.append(found)
            start = found.sum(axis=0)
        return Pieces(self.a, parts[0], parts[1])

    def less_slope(self, slope: Vector) -> "Pieces":
        """Return the functions less ``slope x``, of which the degree is 1 at least."""
        left, right = self.left.copy(), self.right.copy()
        for part, h, start in zip((left, right), self.lengths, (0, self.a), strict=True):
            part[0] -= slope * (start + h / 2)
            part[1] -= slope * h / 2
        return Pieces(self.a, left, right)


def _derivative(part: Matrix, h: float, derivative: int) -> Matrix:
    if derivative == 0:
        return part
    if derivative >= len(part):
        return np.zeros((1, part.shape[1]))
    return np.asarray(legendre.legder(part, derivative) * (2 / h) ** derivative)


@dataclass(frozen=True)
class PieceModes:
    """Bare modes as pieces, and the function with a unit jump of a compliance."""

    modes: Pieces

    def values(self, x: Vector, derivative: int) -> Matrix:
        """Return a derivative of each mode at places `x`."""
        return self.modes.values(x, derivative)

    def hinge(self, x: Vector, derivative: int) -> Vector:
        """Return a derivative of the function that is straight on both sides."""
        return np.asarray(_hat(self.modes.a).values(x, derivative)[0])


def _hat(a: float) -> Pieces:
    """Return the function with slope ``-b`` before `a`, ``a`` behind it: a unit jump."""
    b = 1 - a
    return Pieces(
        a,
        np.array([[-a * b / 2], [-a * b / 2]]),
        np.array([[-a * b / 2], [a * b / 2]]),
    )


def piecewise(
    attached: Attached, N: int, continuity: int | None = None, natural: bool = False
) -> BareModes:
    """Return the bare modes of the series of functions of one class.

    Parameters
    ----------
    attached : Attached
    N : int
        The degree of the derivative ``max(k + 1, m)`` on each segment.
    continuity : int, optional
        The class k; that of the structure if not given.  A higher one than the exact modes
        have never converges to them.
    natural : bool
        Whether the moment of a beam is made zero at the ends, too.
    """
    structure, a = attached.structure, float(attached.a)
    m, k = structure.m, structure.k if continuity is None else continuity
    compliant = structure.kind == "compliance"
    degree = N + max(k + 1, m) - m
    start = _orthonormal(attached, degree)
    rows = _conditions(start, m, max(k, m - 1), natural)
    basis = start.combined(_nullspace(rows, start.left.shape[1]))
    u = _integrals(basis, attached)
    _, sigma, turned = np.linalg.svd(u.orthonormal(attached), full_matrices=False)
    good = sigma > np.finfo(float).tiny ** 0.25
    sigma, turned = sigma[good], turned[good]
    modes = u.combined(turned.T / sigma)
    felt, jump = _at(modes, structure.felt), _jump(modes, structure.broken)
    coupled, hat_mass, rest = felt, 0.0, 0.0
    if compliant:
        hat, size = _hat(a), len(modes.left)
        padded = Pieces(a, _padded(hat.left, size), _padded(hat.right, size))
        column, each = padded.orthonormal(attached)[:, 0], modes.orthonormal(attached)
        coupled = column @ each
        left = column - each @ coupled
        left -= each @ (left @ each)
        hat_mass, rest = float(column @ column), float(left @ left)
    return BareModes(
        eigenvalues=sigma**-2.0,
        felt=coupled,
        at_a=felt,
        jumps=np.zeros(len(sigma)) if compliant else jump,
        hinge_mass=hat_mass,
        hinge_rest=rest,
        hinge_at_a=0.0,
        unknowns=len(sigma) + compliant,
        shapes=PieceModes(modes),
        off=4 * EPS * (hat_mass or float(np.sum((felt * sigma) ** 2))),
        # singular values are off by a rounding error of the largest
        inexact=1 + np.sqrt(len(sigma)) * sigma[0] / sigma,
    )


def _orthonormal(attached: Attached, degree: int) -> Pieces:
    """Return the orthonormal polynomials of both segments, up to a degree."""
    size, a = degree + 1, float(attached.a)
    empty = Pieces(a, np.zeros((size, 1)), np.zeros((size, 1)))
    left, right = empty.norms(attached)
    zeros = np.zeros((size, size))
    return Pieces(
        a,
        np.hstack([np.diag(1 / left), zeros]),
        np.hstack([zeros, np.diag(1 / right)]),
    )


def _conditions(start: Pieces, m: int, k: int, natural: bool) -> list[Vector]:
    """Return the rows that are zero of ``u^(m)``: continuity at `a`, and of a string, ends."""
    rows = []
    for derivative in range(k - m + 1):
        first, left, right, last = start.ends(derivative)
        rows.append(right - left)
    if natural:
        first, _, _, last = start.ends(0)
        rows += [first, last]
    if m == 1:  # the integral over the length
        rows.append(
            sum(
                h * part[0]
                for h, part in zip(start.lengths, (start.left, start.right), strict=True)
            )
        )
    return rows


def _nullspace(rows: list[Vector], size: int) -> Matrix:
    """Return an orthonormal basis of what all rows are zero of."""
    if not rows:
        return np.eye(size)
    matrix = np.array([row / np.linalg.norm(row) for row in rows])
    whole, _ = np.linalg.qr(matrix.T, mode="complete")
    return np.asarray(whole[:, len(rows) :])


def _integrals(basis: Pieces, attached: Attached) -> Pieces:
    """Return the displacements, zero at both ends."""
    found = basis.integrated(attached)
    if attached.structure.m == 1:
        return found
    found = found.integrated(attached)
    return found.less_slope(found.ends(0)[3])


def _at(modes: Pieces, derivative: int) -> Vector:
    _, left, right, _ = modes.ends(derivative)
    return (left + right) / 2


def _jump(modes: Pieces, derivative: int) -> Vector:
    _, left, right, _ = modes.ends(derivative)
    return right - left


def _padded(part: Matrix, size: int) -> Matrix:
    return np.vstack([part, np.zeros((size - len(part), part.shape[1]))])
