"""Switches that accumulate: infinitely many in a finite time, each jump a part of the last.

A mass that is pressed against a wall, and leaves it each time with a part r of its speed, is
away for ``2 v / |a|`` first, and then each time for r of the time before: in all for
``2 v / ((1 - r) |a|)``.  So it is under a constant force, and where the time is so short that
the change of the force does not count.
"""

from collections.abc import Sequence

from .bounds import Local
from .record import Segment

#: Phases in a row, each shorter than this without units, that may be chatter.
CHATTER, SHORT = 12, 1e-6

#: How far the time that is left may be from that under a constant force, without units.
LEFT = 1e-16


def time_left(at: Local, rho: float) -> float:
    """Return how long the jumps at a wall still go on; 0 while that is not known.

    Parameters
    ----------
    at : Local
        The motion behind a jump.
    rho : float
        Velocity behind a jump over the velocity before.
    """
    _, v, a, jerk, *_ = at.derivatives
    if not (-1 < rho <= 0 and v * a < 0):
        return 0.0
    left = -2 * v / (a * (1 + rho))
    return left if left * left * max(1.0, abs(jerk / a)) <= LEFT else 0.0


def accumulates(segments: Sequence[Segment]) -> bool:
    """Whether the last phases are short, and their second half is shorter than the first."""
    last = [q.s for q in segments[-CHATTER:]]
    if len(last) < CHATTER or max(last) >= SHORT:
        return False
    first, second = sum(last[: CHATTER // 2]), sum(last[CHATTER // 2 :])
    return second <= 0.999 * first


def end_of(segments: Sequence[Segment]) -> float:
    """Return when the switches accumulate, as a geometric series, without units."""
    before, last = segments[-2].s, segments[-1].s
    t = float(segments[-1].t) + last
    return t + last * last / (before - last) if 0 < last < before else t
