"""Functions of class C^k only (Section 3.3): a polynomial on each side of the attachment.

``u^(m)`` is a series of orthonormal Legendre polynomials on each segment, so that the stiffness
matrix of the bare structure is the identity.  Integrated m times it gives ``u`` with a matrix
``U`` of coefficients, and the mass matrix is ``U^T U``.  The singular values of ``U`` are the
inverse square roots of the eigenvalues: the lowest ones have full relative accuracy.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial import legendre

from ....generated.space.series import legendre_integral, legendre_norm_squared
from ...arrays import Matrix, Vector
from ..attached import Attached
from ..eigenvalues.bracketing import EPS
from .bare import BareModes, Values, joined


@dataclass(frozen=True)
class Pieces:
    """Piecewise Legendre series of several functions.

    Parameters
    ----------
    lengths : tuple of float
        Lengths of the segments, each rounded by itself.
    coefficients : ndarray, shape (2, degree + 1, count)
        Coefficients of shifted Legendre polynomials on each segment, a column a function.
    """

    lengths: tuple[float, float]
    coefficients: Values

    def combined(self, matrix: Matrix) -> "Pieces":
        """Return linear combinations of the functions, one for each column of a matrix."""
        return replace(self, coefficients=self.coefficients @ matrix)

    def mirrored(self) -> "Pieces":
        """Return the functions seen from the other end."""
        sign = (-1.0) ** np.arange(self.coefficients.shape[1])[:, None]
        return Pieces(self.lengths[::-1], sign * self.coefficients[::-1])

    def values(self, x: Vector, derivative: int, side: int = 0) -> Matrix:
        """Return a derivative at places `x`, a row for each function; see `Shapes`."""
        x, (a, b) = np.asarray(x, dtype=float), self.lengths
        before, behind = (
            legendre.legder(part, derivative) * (2 / h) ** derivative
            for part, h in zip(self.coefficients, self.lengths, strict=True)
        )
        left = legendre.legval(np.where(x < a, 2 * x / a - 1, 1.0), before)
        right = legendre.legval(np.where(x > a, 1 - 2 * (1 - x) / b, -1.0), behind)
        return joined(x, a, left, right, side)

    def hinge(self, x: Vector, derivative: int, side: int = 0) -> Vector:
        """Return a derivative of the function that is straight on both sides."""
        return np.asarray(_hat(self.lengths).values(x, derivative, side)[0])

    def orthonormal(self) -> Matrix:
        """Return the coefficients in orthonormal polynomials, both segments stacked."""
        _, size, count = self.coefficients.shape
        norms = _norms(self.lengths, size)
        return np.asarray((norms[:, :, None] * self.coefficients).reshape(-1, count))

    def integrated(self) -> "Pieces":
        """Return the integrals from 0, continuous at `a`."""
        _, size, count = self.coefficients.shape
        integrals, start = np.zeros((2, size + 1, count)), np.zeros(count)
        for integral, part, h in zip(integrals, self.coefficients, self.lengths, strict=True):
            scaled = legendre_integral(np.arange(size), h)[:, None] * part
            integral[1:] += scaled
            integral[:-2] -= scaled[1:]
            integral[0] += scaled[0] + start  # P_(-1)* = -1: zero at the start of the segment
            start = integral.sum(axis=0)
        return Pieces(self.lengths, integrals)

    def less_slope(self, slope: Vector) -> "Pieces":
        """Return the functions, of degree 1 at least, less ``slope x``."""
        coefficients, (a, b) = self.coefficients.copy(), self.lengths
        for part, h, middle in zip(coefficients, (a, b), (a / 2, a + b / 2), strict=True):
            part[0] -= slope * middle
            part[1] -= slope * h / 2
        return Pieces(self.lengths, coefficients)


def _norms(lengths: tuple[float, float], size: int) -> Matrix:
    """Return the norms of the polynomials on each segment, shape (2, size)."""
    squares = legendre_norm_squared(np.arange(size), np.array(lengths)[:, None])
    return np.asarray(np.sqrt(squares))


def _hat(lengths: tuple[float, float]) -> Pieces:
    """Return the function with slope ``-b`` left of `a` and ``a`` right of it: a unit jump."""
    a, b = lengths
    return Pieces(lengths, -a * b / 2 * np.array([[[1.0], [1.0]], [[1.0], [-1.0]]]))


def piecewise(attached: Attached, N: int, continuity: int | None = None) -> BareModes:
    """Return the bare modes of piecewise polynomials of class C^k.

    Parameters
    ----------
    attached : Attached
    N : int
        The degree of the derivative of order ``max(k + 1, m)`` on each segment.
    continuity : int, optional
        The class k, by default that of the structure.  With a higher one the modes do not
        converge to the exact ones.
    """
    structure = attached.structure
    m, k = structure.m, structure.k if continuity is None else continuity
    compliant = structure.kind == "compliance"
    degree = N + max(k + 1, m) - m
    start = _orthonormal(attached, degree)
    rows = _conditions(start, m, max(k, m - 1))
    basis = start.combined(_nullspace(rows, start.coefficients.shape[2]))
    u = _integrals(basis, m)
    vectors, sigma, turned = np.linalg.svd(u.orthonormal(), full_matrices=False)
    good = sigma > np.finfo(float).tiny ** 0.25
    vectors, sigma, turned = vectors[:, good], sigma[good], turned[good]
    modes = u.combined(turned.T / sigma)
    at_a = np.array(u.lengths[:1])
    felt = modes.values(at_a, structure.felt, -1)[
        :, 0
    ]  # from the shorter side: nothing cancels
    static, rest = float(np.sum((felt * sigma) ** 2)), 0.0
    if compliant:
        higher = (0, u.coefficients.shape[1] - 2)
        hat = np.pad(_hat(u.lengths).coefficients, ((0, 0), higher, (0, 0)))
        column = Pieces(u.lengths, hat).orthonormal()[:, 0]
        felt = column @ vectors
        residual = column - vectors @ felt
        static, rest = float(column @ column), float(residual @ residual)
    if 2 * attached.a > 1:
        modes, felt = modes.mirrored(), (-1) ** structure.felt * felt
    has_static = compliant or k <= structure.k
    return BareModes(
        eigenvalues=sigma**-2.0,
        felt=felt,
        static_rest=0.0 if has_static else float(attached.static_sum) - static,
        hinge_rest=rest,
        unknowns=len(sigma) + compliant,
        shapes=modes,
        off=4 * EPS * static,
        # singular values are off by a rounding error of the largest
        inexact=1 + np.sqrt(len(sigma)) * sigma[0] / sigma,
    )


def _orthonormal(attached: Attached, degree: int) -> Pieces:
    """Return the orthonormal polynomials of both segments, up to a degree.

    The shorter segment is the first.
    """
    size, near = degree + 1, min(attached.a, 1 - attached.a)
    lengths = float(near), float(1 - near)
    scaled = np.diag(1 / _norms(lengths, size).ravel())
    return Pieces(lengths, scaled.reshape(2, size, 2 * size))


def _conditions(start: Pieces, m: int, k: int) -> list[Vector]:
    """Return the rows of conditions on ``u^(m)``: continuity at `a`; for a string, its ends."""
    rows, at_a = [], np.array(start.lengths[:1])
    for derivative in range(k - m + 1):
        before, behind = (start.values(at_a, derivative, side)[:, 0] for side in (-1, 1))
        rows.append(behind - before)
    if m == 1:  # the integral over the length
        rows.append(np.array(start.lengths) @ start.coefficients[:, 0])
    return rows


def _nullspace(rows: list[Vector], size: int) -> Matrix:
    """Return an orthonormal basis of the null space of some rows."""
    if not rows:
        return np.eye(size)
    matrix = np.array([row / np.linalg.norm(row) for row in rows])
    whole, _ = np.linalg.qr(matrix.T, mode="complete")
    return np.asarray(whole[:, len(rows) :])


def _integrals(basis: Pieces, m: int) -> Pieces:
    """Return the displacements, zero at both ends."""
    integrals = basis.integrated()
    if m == 1:
        return integrals
    integrals = integrals.integrated()
    return integrals.less_slope(integrals.values(np.ones(1), 0)[:, 0])
