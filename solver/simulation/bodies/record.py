"""A phase of a simulated motion of a body."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...arrays import Vector
from ..segment import Segment
from .along import along_of, fastest
from .phases import Phases, forms_of, laws_of, poles_of
from .regime import Regime
from .state import BodyState

#: Relative amplitude of waves that a drawing need not resolve.
UNSEEN = 1e-3


@dataclass(frozen=True, eq=False, kw_only=True)
class BodySegment(Segment):
    """One phase of a simulated motion of a body, from the state `start`; see `Segment`."""

    start: BodyState
    regime: Regime

    @cached_property
    def Y(self) -> Vector:
        """The state at the start, ``Y = (y, cos, sin, 1, memory)``."""
        return self.start.full

    @property
    def state(self) -> tuple[float, ...]:
        """The state at the start, to compare with another: y and the memory."""
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
        """Return the values of a form at local times."""
        n, flow, Y = self.regime.states, self.regime.part.flow, self.Y
        wave = (Y[n] + 1j * Y[n + 1]) * np.exp(1j * flow.omega * s)
        values = flow.seen(row[None, :n], Y[:n], Y[n:], s)[0] + row[n + 2 :] @ Y[n + 2 :]
        return np.asarray(values + row[n] * wave.real + row[n + 1] * wave.imag)

    def wave(self, omega: float) -> float:
        """Return the shortest period in the displacement that a drawing resolves."""
        regimes, row = [self.regime], self.regime.contacts[0, :1]
        phases = Phases(poles_of(regimes), laws_of(regimes), forms_of(regimes, [row]))
        forms = np.zeros(1, dtype=int), np.ones(1), np.zeros(1, dtype=bool)
        along = along_of(phases, self.regime.part.flow.omega, 0, self.Y, *forms)
        return 2 * np.pi / max(omega, 2.0 / self.regime.window, fastest(along, UNSEEN))
