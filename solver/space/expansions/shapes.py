"""The shape of a mode from its eigenvalue, as a combination of bare modes."""

import math
from dataclasses import dataclass

import numpy as np

from ...arrays import Vector
from ..attached import Attached
from ..eigenvalues.bracketing import EPS
from ..eigenvalues.secular import Roots
from .bare import BareModes


@dataclass(frozen=True)
class Shape:
    """A mode shape with a mean square of one: coefficients of bare modes.

    `hinge` is the coefficient of the function with a unit jump, for a compliance.
    """

    bare: BareModes
    coefficients: Vector
    hinge: float

    def values(self, x: Vector, derivative: int, side: int = 0) -> Vector:
        """Return a derivative at places `x` in units of the length.

        At the attachment it is the limit from a side, -1 or 1, or for 0 the mean of both.
        """
        x = np.asarray(x, dtype=float)
        values = self.coefficients @ self.bare.shapes.values(x, derivative, side)
        if self.hinge:
            values = values + self.hinge * self.bare.shapes.hinge(x, derivative, side)
        return np.asarray(values)


def shape_of(attached: Attached, bare: BareModes, roots: Roots, i: int) -> Shape:
    """Return the shape of eigenvalue `i` of `roots`, with a positive slope at ``x = 0``."""
    hinge = 0.0
    if roots.untouched[i] >= 0:
        coefficients = np.zeros(len(bare.eigenvalues))
        coefficients[roots.untouched[i]] = 1.0
    else:
        away = (bare.eigenvalues - roots.origin[i]) - roots.shift[i]
        # rounding may put a root on a pole with a negligible weight
        away = np.where(away == 0, EPS * bare.eigenvalues, away)
        coefficients = bare.felt / away
        if attached.structure.kind == "compliance":
            coefficients, hinge = coefficients * float(roots.values[i]), 1.0
    whole = coefficients + hinge * bare.felt  # with the projection of the function with a jump
    scale = float(1 / np.sqrt(whole @ whole + hinge**2 * bare.hinge_rest))
    shape = Shape(bare, coefficients * scale, hinge * scale)
    if shape.values(np.zeros(1), 1)[0] < 0:
        return Shape(bare, -shape.coefficients, -shape.hinge)
    return shape


def jump_mismatch(attached: Attached, shape: Shape, eigenvalue: float) -> float | None:
    """Return the jump of a shape over that by the law of the attachment, less one.

    Both are of the shape at the attachment: an error that needs no exact solution.  It is -1 if
    the functions have no jump, and None if the law demands none.
    """
    structure, a = attached.structure, np.array([float(attached.a)])
    before, behind = (shape.values(a, structure.broken, side)[0] for side in (-1, 1))
    law = attached.law(eigenvalue) * shape.values(a, structure.felt)[0]
    mismatch = float((behind - before) / law - 1) if law else math.nan
    return mismatch if math.isfinite(mismatch) else None
