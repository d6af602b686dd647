"""One phase of a simulated motion, without units."""

import math
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from ..arrays import Vector
from ..flow import flow
from ..scenes.cell import Phase
from ..scenes.orders import Step
from .steps.bounds import window


@dataclass(frozen=True)
class Segment:
    """One phase of a simulated motion, without units.

    Parameters
    ----------
    phase : Phase
        With its memory in numbers; a mirrored phase is the mirror image already.
    t : Fraction
        The start: the exact sum of the durations of all phases before.
    angle : float
        The angle of the forcing at the start, rounded only once.
    x, v : float
        The state at the start, after the switch.
    s : float
        The duration.
    step : Step or None
        The phase whose event ends it, as a step of an order of phases; None if none does.
    """

    phase: Phase
    index: int
    mirrored: bool
    t: Fraction
    angle: float
    x: float
    v: float
    s: float
    step: Step | None = None

    @property
    def state(self) -> tuple[float, ...]:
        """The state at the start, to compare with that of another segment."""
        return self.x, self.v

    @property
    def began(self) -> Step:
        """The phase in which it starts, as a step of an order of phases."""
        return Step(self.index, self.mirrored)

    @property
    def named(self) -> Step:
        """The step of an order of phases: by the event that ended it, if one did."""
        return self.step or self.began

    def motion(self, s: Vector, omega: float, derivative: int) -> Vector:
        """Return a derivative of the displacement at local times."""
        start = np.array([self.x, self.v])
        return flow.motion(self.phase, start, self.angle, omega, s, derivative)

    def force(self, s: Vector) -> Vector:
        """Return the force of the first contact at local times; only a body has one."""
        raise ValueError("force: the motion is that of one mass, expected one of a body")

    def wave(self, omega: float) -> float:
        """Return the shortest period in the motion; it may be infinite."""
        return math.pi * window(self.phase, omega)
