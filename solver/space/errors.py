"""How far mode shapes are off: relative L2 errors against the exact ones."""

from functools import lru_cache

import numpy as np

from ..arrays import Vector
from .attached import Attached
from .eigenvalues.exact import ExactModes
from .expansions.shapes import Shape

#: Points of Gauss quadrature for each half wave of what is integrated, and at least.
POINTS, LEAST = 8, 40


def shape_errors(
    attached: Attached, shape: Shape, exact: ExactModes, number: int, waves: int
) -> tuple[float, ...]:
    """Return the relative L2 error of a mode and of each derivative up to the broken one.

    Parameters
    ----------
    number : int
        Of the mode, from 1.
    waves : int
        Half waves of the finest function in `shape`.
    """
    x, weights = _quadrature(float(attached.a), max(LEAST, POINTS * (waves + number)))
    u, u_exact = shape.values(x, 0), exact.shape(number, x, 0)
    scale = 1 / np.sqrt(weights @ u_exact**2)
    scale = scale if weights @ (u * u_exact) > 0 else -scale
    found = []
    for derivative in range(attached.structure.broken + 1):
        wanted = scale * exact.shape(number, x, derivative)
        off = shape.values(x, derivative) - wanted
        found.append(float(np.sqrt(weights @ off**2 / (weights @ wanted**2))))
    return tuple(found)


@lru_cache(maxsize=16)
def _quadrature(a: float, points: int) -> tuple[Vector, Vector]:
    """Return places and weights of Gauss quadrature on both sides of the attachment."""
    sides = []
    for start, h in ((0.0, a), (a, 1 - a)):
        number = max(LEAST, int(points * h) + 1)
        nodes, weights = np.polynomial.legendre.leggauss(number)
        sides.append((start + h * (nodes + 1) / 2, h * weights / 2))
    (x1, w1), (x2, w2) = sides
    return np.concatenate([x1, x2]), np.concatenate([w1, w2])
