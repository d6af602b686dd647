"""The measure (22) by a Gauss rule."""

import math
from collections.abc import Callable
from dataclasses import dataclass

from ...accuracy.quadrature import panels
from ...arrays import Vector


@dataclass(frozen=True)
class Shape:
    """The acceleration of a periodic motion in ``[0, T)``, and where it jumps."""

    t1: float
    T: float
    acceleration: Callable[[Vector], Vector]


def acceleration_difference(found: Shape, reference: Shape, waves: int) -> float:
    """Return (22): the relative L2 difference of accelerations on normalised time.

    waves : int
        Highest harmonic in either.
    """
    breaks = [found.t1 / found.T, reference.t1 / reference.T]
    theta, weights = panels(breaks, max(waves, 2))
    expected = reference.acceleration(theta * reference.T)
    difference = found.acceleration(theta * found.T) - expected
    return math.sqrt((weights @ difference**2) / (weights @ expected**2))
