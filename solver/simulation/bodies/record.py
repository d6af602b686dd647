"""A phase of a simulated motion of a body."""

from dataclasses import dataclass

import numpy as np

from ...arrays import Matrix, Vector
from ..lasting import ROUNDING
from ..record import Segment
from .along import Along, seen
from .regime import Regime

#: What of a displacement may be in waves that are not resolved where it is drawn.
UNSEEN = 1e-3


@dataclass(frozen=True, eq=False, kw_only=True)
class BodySegment(Segment):
    """One phase of a simulated motion of a body; see `Segment`.

    It starts in the state ``Y = (y, cos, sin, 1, memory)``; the forms in `watched`, shape
    (F, W), may end it.
    """

    Y: Vector
    regime: Regime
    watched: Matrix

    @property
    def state(self) -> tuple[float, ...]:
        """What two states are compared by: those of the modes, and the memory."""
        n = self.regime.states
        return (*self.Y[:n], *self.Y[n + 3 :])

    def motion(self, s: Vector, omega: float, derivative: int) -> Vector:
        """Return a derivative of the first contact's displacement at local times."""
        row = self.regime.contacts[0 if derivative == 0 else 1, 0]
        for _ in range(derivative - 1):
            row = row @ self.regime.generator
        return self.seen(row, s)

    def force(self, s: Vector) -> Vector:
        """Return the force of the first contact at local times."""
        return self.seen(self.regime.contacts[2, 0], s)

    def seen(self, row: Vector, s: Vector) -> Vector:
        """Return a form at local times."""
        return np.asarray(seen(self.regime, self.Y, row[None], s)[0])

    def wave(self, omega: float) -> float:
        """Return the length of the shortest wave of the displacement that is seen."""
        along = Along(self.regime, self.Y, self.regime.contacts[0, :1])
        return 2 * np.pi / max(omega, 2.0 / self.regime.window, along.fastest(UNSEEN))

    def lasts(self, omega: float) -> bool:
        """Return whether it is shown that the phase lasts for ever."""
        along = Along(self.regime, self.Y, self.watched)
        return bool((along.least(self.s) >= -ROUNDING * along.sizes).all())
