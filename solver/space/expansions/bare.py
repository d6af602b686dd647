"""Modes of the bare structure in an expansion, and the simplest ones: sines."""

from dataclasses import dataclass
from typing import Any, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from ...arrays import Matrix, Vector
from ..attached import Attached
from .sums import left_out

#: Values of one function, or of several, a row each.
Values: TypeAlias = npt.NDArray[np.floating[Any]]


class Shapes(Protocol):
    """The shape functions of bare modes."""

    def values(self, x: Vector, derivative: int, side: int = 0) -> Matrix:
        """Return a derivative of each mode, as rows, at places relative to the length.

        At the attachment it is the limit from a side, -1 or 1, or for 0 the mean of both.
        """

    def hinge(self, x: Vector, derivative: int, side: int = 0) -> Vector:
        """Return the same for the function with a unit jump, which a compliance needs."""


def joined(x: Vector, a: float, left: Values, right: Values, side: int = 0) -> Matrix:
    """Return `left` for x < a and `right` for x > a; at a, by `side`, as in `Shapes`."""
    at_a = ((1 - side) * left + (1 + side) * right) / 2
    return np.asarray(np.where(x < a, left, np.where(x > a, right, at_a)))


@dataclass(frozen=True)
class BareModes:
    """The modes of the bare structure in an expansion, mass-normalised, the lowest first.

    The attachment enters by a scalar equation only: the modes do not depend on its strength.

    Parameters
    ----------
    eigenvalues : ndarray, shape (P,)
    felt : ndarray, shape (P,)
        ``r_i = psi_i^(j)(a)``; for a compliance, the inner product with the function that has
        a unit jump.
    static_rest : float
        For a stiffness, the sum of ``r_n^2/mu_n`` over all exact modes less that over these: 0
        if the static response is one of their combinations.
    hinge_rest : float
        For a compliance, the mean square of the function with a unit jump less its projection
        onto these modes.
    unknowns : int
        Number of unknown coefficients of the expansion.
    shapes : Shapes
        Their shape functions.
    off : float
        Bound of the error of the sum of ``r_i^2/(Lambda_i - lambda)`` besides the rounding of
        its terms.
    inexact : ndarray, shape (P,)
        Rounding error of each eigenvalue in units.
    """

    eigenvalues: Vector
    felt: Vector
    static_rest: float
    hinge_rest: float
    unknowns: int
    shapes: Shapes
    off: float
    inexact: Vector

    @property
    def count(self) -> int:
        """Number of modes with the attachment: a function with a jump adds one."""
        return len(self.eigenvalues) + (self.hinge_rest > 0)


@dataclass(frozen=True)
class Sines:
    """The functions ``sqrt(2) sin(n pi x)``, n = 1, ..., N."""

    N: int

    def values(self, x: Vector, derivative: int, side: int = 0) -> Matrix:
        """Return a derivative of each at places `x`, shape (N, len(x))."""
        wave = np.pi * np.arange(1, self.N + 1)[:, None]
        turned = wave * np.asarray(x)[None, :] + derivative * np.pi / 2
        return np.asarray(np.sqrt(2.0) * wave**derivative * np.sin(turned))

    def hinge(self, x: Vector, derivative: int, side: int = 0) -> Vector:
        """Return zeros: sines have no jump."""
        return np.zeros_like(np.asarray(x, dtype=float))


def ritz(attached: Attached, N: int) -> BareModes:
    """Return the bare modes of the expansion in N sines.

    A compliance does not affect them, for sines have no jump in the slope.
    """
    n, kind = np.arange(1, N + 1), attached.structure.kind
    tail = left_out(attached, N, 1) if kind == "stiffness" else None
    return BareModes(
        eigenvalues=attached.bare(n),
        felt=np.zeros(N) if kind == "compliance" else attached.felt(n),
        static_rest=float(tail.sums[0]) if tail else 0.0,
        hinge_rest=0.0,
        unknowns=N,
        shapes=Sines(N),
        off=0.0,
        inexact=np.ones(N),
    )
