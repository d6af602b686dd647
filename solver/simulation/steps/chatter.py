"""Chatter: infinitely many switches in a finite time, the jumps a geometric sequence.

A mass that is pressed against a wall with acceleration a, leaves it with speed v and rebounds
with a part r of its speed is away for ``2 v / |a|`` first, then each time for r of the time
before: in all for ``2 v / ((1 - r) |a|)``.  This holds under a constant force, or in a time so
short that the change of the force does not count.
"""

from collections.abc import Sequence

#: So many phases in a row, each shorter than `SHORT` without units, may be chatter.
CHATTER, SHORT = 12, 1e-6

#: Bound, without units, below which the change of the force is neglected in the time left.
LEFT = 1e-16


def time_left(v: float, a: float, jerk: float, rho: float, resolved: float) -> float:
    """Return the time until the jumps at a wall accumulate; 0 while it is not yet known.

    Parameters
    ----------
    v, a, jerk : float
        Velocity, acceleration and jerk just behind a jump.
    rho : float
        Ratio of the velocities behind and before it.
    resolved : float
        Least height of a jump above rounding: lower ones count as accumulating if the force
        hardly changes meanwhile.
    """
    if not (-1 < rho <= 0 and v * a < 0):
        return 0.0
    remaining = -2 * v / (a * (1 + rho))
    is_short = remaining * remaining * max(1.0, abs(jerk / a)) <= LEFT
    is_unseen = v * v <= 2 * abs(a) * resolved and remaining * abs(jerk) <= abs(a)
    return remaining if is_short or is_unseen else 0.0


def put_last(last: list[float], s: float) -> None:
    """Append the duration of a phase to those of the last phases, and drop the first."""
    for i in range(CHATTER - 1):
        last[i] = last[i + 1]
    last[CHATTER - 1] = s


def accumulates(last: Sequence[float]) -> bool:
    """Whether all the last phases are short, and the second half is shorter than the first."""
    first, second, half = 0.0, 0.0, CHATTER // 2
    for i in range(half):
        if last[i] >= SHORT or last[half + i] >= SHORT:
            return False
        first, second = first + last[i], second + last[half + i]
    return second <= 0.999 * first


def end_of(t: float, before: float, last: float) -> float:
    """Return when the switches accumulate, by the sum of a geometric series, without units.

    The last phase ends at t; `before` and `last` are the durations of the last two.
    """
    return t + last * last / (before - last) if 0 < last < before else t
