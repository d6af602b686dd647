"""Time since the start of a motion as the exact sum of its durations.

Sums in float64 drift: each is rounded to the digits of the whole time.  Here a time is the sum
itself, and the angle of the forcing is rounded once, from it, behind any number of cycles.
"""

import math
from dataclasses import dataclass, replace
from fractions import Fraction

#: A whole turn in rad.
TURN = Fraction("6.28318530717958647692528676655900576839433879875021164194988918461563281257")


@dataclass(frozen=True)
class Clock:
    """An instant of a motion, without units.

    Parameters
    ----------
    first, omega : Fraction
        The angle of the forcing is ``first + omega t``.
    t : Fraction
        Time since the start.

    Examples
    --------
    >>> clock = Clock.of(0.5, 1.0)
    >>> for _ in range(10):
    ...     clock = clock.later(0.1)
    >>> float(clock.t), clock.angle
    (1.0, 1.5)
    """

    first: Fraction
    omega: Fraction
    t: Fraction = Fraction(0)

    @classmethod
    def of(cls, angle: float, omega: float) -> "Clock":
        """Return the start, where the forcing has an angle."""
        if abs(angle) > TURN:
            angle = math.atan2(math.sin(angle), math.cos(angle))
        return cls(Fraction(angle), Fraction(omega))

    def later(self, s: float) -> "Clock":
        """Return a later instant."""
        return replace(self, t=self.t + Fraction(s))

    @property
    def angle(self) -> float:
        """The angle of the forcing, from 0 to 2 pi."""
        return float((self.first + self.omega * self.t) % TURN)
