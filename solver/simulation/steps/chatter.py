"""Switches that accumulate: infinitely many in a finite time, each jump a part of the last.

A mass that is pressed against a wall, and leaves it each time with a part r of its speed, is
away for ``2 v / |a|`` first, and then each time for r of the time before: in all for
``2 v / ((1 - r) |a|)``.  So it is under a constant force, and where the time is so short that
the change of the force does not count.
"""

from collections.abc import Sequence

#: Phases in a row, each shorter than this without units, that may be chatter.
CHATTER, SHORT = 12, 1e-6

#: How far the time that is left may be from that under a constant force, without units.
LEFT = 1e-16


def time_left(v: float, a: float, jerk: float, rho: float, resolved: float) -> float:
    """Return how long the jumps at a wall still go on; 0 while that is not known.

    Parameters
    ----------
    v, a, jerk : float
        The motion behind a jump: velocity, acceleration and its rate.
    rho : float
        The velocity there over that before.
    resolved : float
        Height of a jump that is seen: lower ones are rounding, if what presses them lasts.
    """
    if not (-1 < rho <= 0 and v * a < 0):
        return 0.0
    left = -2 * v / (a * (1 + rho))
    short = left * left * max(1.0, abs(jerk / a)) <= LEFT
    unseen = v * v <= 2 * abs(a) * resolved and left * abs(jerk) <= abs(a)
    return left if short or unseen else 0.0


def put_last(last: list[float], s: float) -> None:
    """Put the duration of a phase behind those of the last phases, and forget the first."""
    for i in range(CHATTER - 1):
        last[i] = last[i + 1]
    last[CHATTER - 1] = s


def accumulates(last: Sequence[float]) -> bool:
    """Whether the last phases are short, and their second half is shorter than the first."""
    first, second, half = 0.0, 0.0, CHATTER // 2
    for i in range(half):
        if last[i] >= SHORT or last[half + i] >= SHORT:
            return False
        first, second = first + last[i], second + last[half + i]
    return second <= 0.999 * first


def end_of(t: float, before: float, last: float) -> float:
    """Return when the switches accumulate, as a geometric series, without units.

    The last phase ends at t; the last two take the times `before` and `last`.
    """
    return t + last * last / (before - last) if 0 < last < before else t
