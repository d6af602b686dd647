"""Ritz: sines only, the modes of the bare structure, which are exact."""

from dataclasses import dataclass

import numpy as np

from ...arrays import Matrix, Vector
from ..attached import Attached
from .bare import BareModes
from .sums import left_out


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

    Of a compliance nothing is felt of any: sines have no jump in the slope.
    """
    n, kind = np.arange(1, N + 1), attached.structure.kind
    rest = left_out(attached, N, 1) if kind == "stiffness" else None
    return BareModes(
        eigenvalues=attached.bare(n),
        felt=np.zeros(N) if kind == "compliance" else attached.felt(n),
        static_rest=float(rest.sums[0]) if rest else 0.0,
        hinge_rest=0.0,
        unknowns=N,
        shapes=Sines(N),
        off=0.0,
        inexact=np.ones(N),
    )
