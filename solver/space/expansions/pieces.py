"""Functions of class C^k only (Section 3.3): a polynomial on each side of the attachment.

``u^(m)`` is a Legendre series on each segment, orthonormal, so that the stiffness matrix of
the bare structure is the identity; integrated m times it gives ``u``, whose coefficients are a
matrix ``U``, and the mass matrix is ``U^T U``. The singular values of ``U`` are the inverse
square roots of the eigenvalues: the lowest keep all digits.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial import legendre

from ...arrays import Matrix, Vector
from ..attached import Attached
from ..eigenvalues.bracketing import EPS
from .bare import BareModes, joined


@dataclass(frozen=True)
class Pieces:
    """Piecewise Legendre series: column by column the coefficients of some functions.

    Parameters
    ----------
    lengths : tuple of float
        Of the segments; each has its own digits, however short it is.
    left, right : ndarray, shape (degree + 1, count)
        Coefficients of the shifted Legendre polynomials of each segment.
    """

    lengths: tuple[float, float]
    left: Matrix
    right: Matrix

    def combined(self, matrix: Matrix) -> "Pieces":
        """Return combinations of the functions, a column each."""
        return replace(self, left=self.left @ matrix, right=self.right @ matrix)

    def mirrored(self) -> "Pieces":
        """Return the functions seen from the other end."""
        sign = (-1.0) ** np.arange(len(self.left))[:, None]
        return Pieces(self.lengths[::-1], sign * self.right, sign * self.left)

    def ends(self, derivative: int) -> tuple[Vector, Vector, Vector, Vector]:
        """Return a derivative at 0, left and right of `a`, and at 1."""
        rows = []
        for part, h in zip((self.left, self.right), self.lengths, strict=True):
            found = _derivative(part, h, derivative)
            rows += [np.asarray(legendre.legval(place, found)) for place in (-1.0, 1.0)]
        return rows[0], rows[1], rows[2], rows[3]

    def values(self, x: Vector, derivative: int, side: int = 0) -> Matrix:
        """Return a derivative at places `x`, a row a function; at `a` as `Shapes` has it."""
        x, (a, b) = np.asarray(x, dtype=float), self.lengths
        before, behind = np.minimum(2 * x / a - 1, 1), np.maximum(1 - 2 * (1 - x) / b, -1)
        left = legendre.legval(before, _derivative(self.left, a, derivative), tensor=True)
        right = legendre.legval(behind, _derivative(self.right, b, derivative), tensor=True)
        return joined(x, a, left, right, side)

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
        return Pieces(self.lengths, parts[0], parts[1])

    def less_slope(self, slope: Vector) -> "Pieces":
        """Return the functions less ``slope x``, of which the degree is 1 at least."""
        left, right, (a, b) = self.left.copy(), self.right.copy(), self.lengths
        for part, h, middle in ((left, a, a / 2), (right, b, a + b / 2)):
            part[0] -= slope * middle
            part[1] -= slope * h / 2
        return Pieces(self.lengths, left, right)


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

    def values(self, x: Vector, derivative: int, side: int = 0) -> Matrix:
        """Return a derivative of each mode at places `x`."""
        return self.modes.values(x, derivative, side)

    def hinge(self, x: Vector, derivative: int, side: int = 0) -> Vector:
        """Return a derivative of the function that is straight on both sides."""
        return np.asarray(_hat(self.modes.lengths).values(x, derivative, side)[0])


def _hat(lengths: tuple[float, float]) -> Pieces:
    """Return the function with slope ``-b`` before `a`, ``a`` behind it: a unit jump."""
    a, b = lengths
    return Pieces(
        lengths,
        np.array([[-a * b / 2], [-a * b / 2]]),
        np.array([[-a * b / 2], [a * b / 2]]),
    )


def piecewise(attached: Attached, N: int, continuity: int | None = None) -> BareModes:
    """Return the bare modes of the series of functions of one class.

    Parameters
    ----------
    attached : Attached
    N : int
        The degree of the derivative ``max(k + 1, m)`` on each segment.
    continuity : int, optional
        The class k; that of the structure if not given.  A higher one than the exact modes
        have never converges to them.
    """
    structure = attached.structure
    m, k = structure.m, structure.k if continuity is None else continuity
    compliant = structure.kind == "compliance"
    degree = N + max(k + 1, m) - m
    start = _orthonormal(attached, degree)
    rows = _conditions(start, m, max(k, m - 1))
    basis = start.combined(_nullspace(rows, start.left.shape[1]))
    u = _integrals(basis, attached)
    each, sigma, turned = np.linalg.svd(u.orthonormal(attached), full_matrices=False)
    good = sigma > np.finfo(float).tiny ** 0.25
    each, sigma, turned = each[:, good], sigma[good], turned[good]
    modes = u.combined(turned.T / sigma)
    _, felt, _, _ = modes.ends(structure.felt)  # from the shorter side: nothing cancels
    static, rest = float(np.sum((felt * sigma) ** 2)), 0.0
    if compliant:
        hat, size = _hat(u.lengths), len(u.left)
        padded = Pieces(u.lengths, _padded(hat.left, size), _padded(hat.right, size))
        column = padded.orthonormal(attached)[:, 0]
        felt = column @ each
        left = column - each @ felt
        static, rest = float(column @ column), float(left @ left)
    if 2 * attached.a > 1:
        modes, felt = modes.mirrored(), (-1) ** structure.felt * felt
    has_static = compliant or k <= structure.k
    return BareModes(
        eigenvalues=sigma**-2.0,
        felt=felt,
        static_rest=0.0 if has_static else float(attached.static_sum) - static,
        hinge_rest=rest,
        unknowns=len(sigma) + compliant,
        shapes=PieceModes(modes),
        off=4 * EPS * static,
        # singular values are off by a rounding error of the largest
        inexact=1 + np.sqrt(len(sigma)) * sigma[0] / sigma,
    )


def _orthonormal(attached: Attached, degree: int) -> Pieces:
    """Return the orthonormal polynomials of both segments, up to a degree.

    The shorter segment is the first.
    """
    size, near = degree + 1, min(attached.a, 1 - attached.a)
    lengths, zeros = (float(near), float(1 - near)), np.zeros((size, size))
    left, right = Pieces(lengths, zeros, zeros).norms(attached)
    return Pieces(
        lengths,
        np.hstack([np.diag(1 / left), zeros]),
        np.hstack([zeros, np.diag(1 / right)]),
    )


def _conditions(start: Pieces, m: int, k: int) -> list[Vector]:
    """Return the rows that are zero of ``u^(m)``: continuity at `a`, and of a string, ends."""
    rows = []
    for derivative in range(k - m + 1):
        _, left, right, _ = start.ends(derivative)
        rows.append(right - left)
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


def _padded(part: Matrix, size: int) -> Matrix:
    return np.vstack([part, np.zeros((size - len(part), part.shape[1]))])
