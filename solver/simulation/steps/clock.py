"""The angle of the forcing behind any number of phases, to its own rounding.

A sum of durations in float64 drifts: each is rounded to the digits of the sum.  Here the angle
through which the forcing has turned is kept in double-double arithmetic, an unevaluated sum of
two floats, modulo whole turns; 2 pi is a sum of three floats.  Products and sums of two floats
are error-free (Dekker, Knuth); only the lower part is rounded.  A phase through an angle a adds
an error of about ``2**-104 a``, and so does the truncation of 2 pi: 1e-27 after a hundred
thousand turns.  So an angle is the float64 nearest to the exact one, unless that is as close to
the midpoint of two.
"""

from math import atan2, cos, floor, frexp, ldexp, sin
from typing import NamedTuple

#: 2 pi as a sum of three floats.
TURN = (6.283185307179586, 2.4492935982947064e-16, -5.989539619436679e-33)

#: Dekker's factor, which splits a float into two of half its digits.
SPLIT = 2.0**27 + 1

#: Turns in one phase beyond which the angle has no correct digits.
MOST_TURNS = 1e15


class Clock(NamedTuple):
    """An instant of a motion.

    Parameters
    ----------
    first : float
        The angle of the forcing at the start.
    omega : float
        Frequency of the forcing; 0 where nothing forces.
    turns : int
        Whole turns since the start; where nothing forces, of an angle with frequency 1.
    high, low : float
        The rest of that angle, as a double-double.

    Examples
    --------
    >>> clock = at_start(0.5, 1.0)
    >>> for _ in range(70):
    ...     clock = later(clock, 0.1)
    >>> clock.turns, angle_of(clock)
    (1, 1.216814692820414)
    """

    first: float
    omega: float
    turns: int
    high: float
    low: float


def at_start(angle: float, omega: float) -> Clock:
    """Return the clock at the start, where the forcing has a given angle."""
    if abs(angle) > TURN[0]:
        angle = atan2(sin(angle), cos(angle))
    return Clock(angle, omega, 0, 0.0, 0.0)


def later(clock: Clock, s: float) -> Clock:
    """Return the clock after a time `s`."""
    mantissa, power = frexp(clock.omega if clock.omega > 0 else 1.0)  # no product overflows
    angle, error = product(mantissa, ldexp(s, power))
    high, rest = total(clock.high, angle)
    turns, high, low = whole_turns(high, rest + (clock.low + error))
    return Clock(clock.first, clock.omega, clock.turns + turns, high, low)


def angle_of(clock: Clock) -> float:
    """Return the angle of the forcing, from 0 to 2 pi."""
    if not clock.omega > 0:
        return clock.first
    high, low = total(clock.first, clock.high)
    _, high, _ = whole_turns(high, low + clock.low)
    return high


def time_to(clock: Clock, turns: int) -> float:
    """Return the time until `turns` whole turns since the start; 0 if they have passed."""
    high, low = less(-clock.high, -clock.low, clock.turns - turns)
    return max(high + low, 0.0) / (clock.omega if clock.omega > 0 else 1.0)


def whole_turns(high: float, low: float) -> tuple[int, float, float]:
    """Return the number of whole turns in an angle, and the rest as a double-double."""
    turns = floor(min(high / TURN[0], MOST_TURNS))
    high, low = less(high, low, turns)
    if high < 0:  # it was rounded up to a whole turn
        turns -= 1
        high, low = less(high, low, -1)
    return turns, high, low


def less(high: float, low: float, turns: int) -> tuple[float, float]:
    """Return an angle minus whole turns, as a double-double."""
    for part in TURN:
        angle, error = product(float(turns), part)
        high, rest = total(high, -angle)
        low += rest - error
    return total(high, low)


def total(a: float, b: float) -> tuple[float, float]:
    """Return the sum of two numbers, and its rounding error."""
    rounded = a + b
    of_b = rounded - a
    return rounded, (a - (rounded - of_b)) + (b - of_b)


def product(a: float, b: float) -> tuple[float, float]:
    """Return the product of two numbers, and its rounding error."""
    ab = a * b
    x, y = SPLIT * a, SPLIT * b
    high_a, high_b = x - (x - a), y - (y - b)
    low_a, low_b = a - high_a, b - high_b
    return ab, ((high_a * high_b - ab) + high_a * low_b + low_a * high_b) + low_a * low_b
