"""Gauss rules for functions that jump and oscillate."""

import math
from itertools import pairwise

import numpy as np

from ..arrays import Vector

#: Nodes and weights on ``(-1, 1)`` of the Gauss rule in each panel.
RULE = np.polynomial.legendre.leggauss(20)


def panels(breaks: list[float], waves: int) -> tuple[Vector, Vector]:
    """Return nodes and weights of a composite Gauss rule on ``(0, 1)``.

    The integrand may jump at the breaks.  No panel has more than one wave of the highest
    harmonic, of which there are `waves` in ``(0, 1)``.
    """
    x, w = RULE
    edges = np.array(sorted({0.0, *breaks, 1.0}))
    points, weights = [], []
    for left, right in pairwise(edges):
        count = max(1, math.ceil(waves * (right - left)))
        ends = np.linspace(left, right, count + 1)
        half = np.diff(ends)[:, None] / 2
        points.append((ends[:-1, None] + half * (1 + x)).ravel())
        weights.append((half * w).ravel())
    return np.concatenate(points), np.concatenate(weights)
