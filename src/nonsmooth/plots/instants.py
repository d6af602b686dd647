"""Instants of a period at which a motion is looked at."""

from itertools import pairwise
from typing import Protocol

import numpy as np

from nonsmooth.solver.arrays import Vector

#: The first and the last instant of a phase, from its ends, as a part of it.
INSIDE = 1e-9

#: Instants of each phase.
POINTS = 400


class WithDurations(Protocol):
    """A motion in phases."""

    @property
    def durations(self) -> tuple[float, ...]:
        """Durations of the phases of one period in s."""


def instants(motion: WithDurations, points: int = POINTS) -> Vector:
    """Return times over one period in s: both sides of every switch are among them.

    Parameters
    ----------
    motion : Motion or any other with durations
        What is looked at.
    points : int
        How many times on each phase.
    """
    ends = np.cumsum([0.0, *motion.durations])
    part = np.linspace(INSIDE, 1 - INSIDE, points)
    return np.concatenate([low + (high - low) * part for low, high in pairwise(ends)])
