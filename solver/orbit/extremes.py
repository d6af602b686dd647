"""The ends of a motion: over every phase, between its critical points."""

from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Vector
from . import chebyshev

if TYPE_CHECKING:
    from .motion import Motion

#: Points of a phase at which the size of a motion is looked at.
LOOK = np.linspace(0.0, 1.0, 65)


def extremes(motion: "Motion", derivative: int) -> tuple[float, float]:
    """Return the least and the largest value of a derivative over a period, in SI units."""
    cell, count = motion.case.cell, len(motion.case.cell.phases)
    size = max(float(np.abs(motion.part(p, LOOK, derivative)).max()) for p in range(count))
    low, high = np.inf, -np.inf
    for p in range(count):

        def value(u: Vector, p: int = p) -> Vector:
            return motion.part(p, u, derivative)

        ends = chebyshev.extremes(value, size)
        low, high = min(low, ends[0]), max(high, ends[1])
    if cell.sign < 0:
        low, high = min(low, -high), max(high, -low)
    unit = motion.case.units.of_motion(derivative)
    return low * unit, high * unit
