"""What an expansion makes of the bare structure: modes, and what is felt of each."""

from dataclasses import dataclass
from typing import Protocol

from ...arrays import Matrix, Vector


class Shapes(Protocol):
    """The functions behind bare modes."""

    def values(self, x: Vector, derivative: int) -> Matrix:
        """Return a derivative of each mode, a row a mode, at places in units of the length.

        At the attachment itself, the mean of both sides.
        """

    def hinge(self, x: Vector, derivative: int) -> Vector:
        """Return the same of the function with a unit jump, of a compliance."""


@dataclass(frozen=True)
class BareModes:
    """The modes of the bare structure in an expansion, mass-normalised, the lowest first.

    The attachment enters by a scalar equation: none of the matrices behind these knows it,
    however strong it is.

    Parameters
    ----------
    eigenvalues : ndarray, shape (P,)
    felt : ndarray, shape (P,)
        ``r_i = psi_i^(j)(a)``; of a compliance, the inner product with the function that has
        a unit jump.
    at_a : ndarray, shape (P,)
        ``psi_i^(j)(a)``, of a compliance as well.
    jumps : ndarray, shape (P,)
        The jump of the broken derivative of each.
    hinge_mass : float
        Of a compliance, the inner product of the function with a unit jump with itself.
    hinge_rest : float
        The same of what the bare modes leave of that function.
    hinge_at_a : float
        Its felt derivative at the attachment.
    unknowns : int
        How many unknown coefficients the expansion has.
    shapes : Shapes
    off : float
        By how much the sum of ``r_i^2/(Lambda_i - lambda)`` may be off, at most, but for
        the rounding of its terms.
    inexact : ndarray, shape (P,)
        By how many units of rounding each eigenvalue may be off.
    """

    eigenvalues: Vector
    felt: Vector
    at_a: Vector
    jumps: Vector
    hinge_mass: float
    hinge_rest: float
    hinge_at_a: float
    unknowns: int
    shapes: Shapes
    off: float
    inexact: Vector
