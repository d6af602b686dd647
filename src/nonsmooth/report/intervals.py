"""For which normal forces a statement holds: a scan over alpha, and bisection of the ends.

With the other parameters fixed, `F_N` is proportional to alpha, and alpha alone decides, but
for the direction of friction in stick: that depends on ``mu_k/mu_s``, whatever `F_N`.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip

from .case import at_alpha
from .finding import Part
from .words import listed, number

#: Values of alpha that are looked at, from the first to the last.
FIRST, LAST, SCANNED = 0.01, 10.0, 97

#: An end of an interval is known to this factor.
CLOSE = 1.005


@dataclass(frozen=True)
class Interval:
    """Values of alpha between which a statement holds.

    Parameters
    ----------
    low, high : float or None
        None where it holds to that end of the scan.
    """

    low: float | None
    high: float | None

    def contains(self, alpha: float) -> bool:
        """Return whether this `alpha` of the scan is inside."""
        return (self.low or FIRST) <= alpha <= (self.high or LAST)


#: Where each part of the claims holds.
Intervals = dict[Part, list[Interval]]


def grid() -> list[float]:
    """Return the values of alpha of the scan."""
    return [float(alpha) for alpha in np.geomspace(FIRST, LAST, SCANNED)]


def scan(
    belt: StickSlip, parts: list[Part], progress: Callable[[str], None] = lambda done: None
) -> Intervals:
    """Return the intervals of alpha in which each part holds.

    Parameters
    ----------
    belt : StickSlip
        The oscillator whose normal force varies.
    parts : list of Part
        The statements.
    progress : callable, optional
        Called in words, `SCANNED` times and once a part.

    Notes
    -----
    What is narrower than a step of the scan, 7.5 %, can be missed.
    """
    holds: dict[Part, list[bool]] = {part: [] for part in parts}
    for alpha in grid():
        case = at_alpha(belt, alpha)
        for part in parts:
            holds[part].append(part.of(case).holds)
        progress(f"alpha = {alpha:.3g}")
    found = {}
    for part in parts:
        found[part] = _intervals(belt, part, holds[part])
        progress(part.words)
    return found


def _intervals(belt: StickSlip, part: Part, holds: list[bool]) -> list[Interval]:
    ends: list[float | None] = [None] if holds[0] else []
    for (left, before), (right, after) in pairwise(zip(grid(), holds, strict=True)):
        if before != after:
            ends.append(_bisect(lambda a: part.of(at_alpha(belt, a)).holds, left, right, after))
    if holds[-1]:
        ends.append(None)
    return [Interval(low, high) for low, high in zip(ends[::2], ends[1::2], strict=True)]


def _bisect(holds: Callable[[float], bool], left: float, right: float, after: bool) -> float:
    """Return where a statement becomes `after` between two values, to a factor `CLOSE`."""
    while right / left > CLOSE:
        middle = float(np.sqrt(left * right))
        if holds(middle) == after:
            right = middle
        else:
            left = middle
    return float(np.sqrt(left * right))


def in_words(belt: StickSlip, found: list[Interval]) -> str:
    """Return the normal forces of some intervals.

    Examples
    --------
    >>> from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
    >>> in_words(DEFAULT, [Interval(None, 0.1), Interval(1, None)])
    'up to 40.0 N and from 400 N up'
    >>> in_words(DEFAULT, [Interval(None, None)]), in_words(DEFAULT, [])
    ('everywhere', 'nowhere')
    """
    if found == [Interval(None, None)]:
        return "everywhere"
    return listed([_words(belt, interval) for interval in found]) if found else "nowhere"


def _words(belt: StickSlip, interval: Interval) -> str:
    ends = [
        number(force(belt, end)) if end is not None else None
        for end in (interval.low, interval.high)
    ]
    if ends[0] is None:
        return f"up to {ends[1]} N"
    return f"from {ends[0]} N up" if ends[1] is None else f"from {ends[0]} to {ends[1]} N"


def force(belt: StickSlip, alpha: float) -> float:
    """Return the normal force in N that gives this `alpha`."""
    return belt.normal_force * alpha / belt.alpha
