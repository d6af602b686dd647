"""The normal forces for which a statement holds: a scan over alpha, and bisection of the ends.

With the other parameters fixed, `F_N` is proportional to alpha.  All statements depend on alpha
alone, except that on the direction of friction in stick, which depends on ``mu_k/mu_s``.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from functools import cache, partial
from itertools import pairwise
from typing import Any

import numpy as np

import nonsmooth as ns

from .case import at_alpha
from .claims import Claim, Part
from .words import listed, number

#: The first and the last value of alpha in the scan, and their number.
FIRST, LAST, SCANNED = 0.01, 10.0, 49

#: The ends of intervals are bisected to this factor.
CLOSE = 1.005

#: The intervals of alpha in which each part of the claims holds; they begin at 0 or end at
#: infinity if the part holds at that end of the scan.
Intervals = dict[Part, list[tuple[float, float]]]


#: A step of the scan within which parts change: its ends, and whether each part holds after it.
Step = tuple[float, float, tuple[tuple[Part, bool], ...]]


def grid() -> list[float]:
    """Return the values of alpha of the scan."""
    return [float(alpha) for alpha in np.geomspace(FIRST, LAST, SCANNED)]


def scan(
    belt: ns.StickSlip,
    parts: list[Part],
    progress: Callable[[str], None] = lambda done: None,
    run: Callable[..., Iterable[Any]] = map,
) -> Intervals:
    """Return the intervals of alpha in which each part holds.

    Intervals narrower than a step of the scan, 15 %, can be missed.

    Parameters
    ----------
    belt : StickSlip
        The oscillator whose normal force varies.
    parts : list of Part
        The statements.
    progress : callable, optional
        Called in words, `SCANNED` times and once for each part.
    run : callable, optional
        `map`, or a function like it that uses several processes.
    """
    holds: list[list[bool]] = []
    verdicts = run(partial(_holding, belt, parts), grid())
    for alpha, verdict in zip(grid(), verdicts, strict=True):
        holds.append(verdict)
        progress(f"alpha = {alpha:.3g}")
    ends = {part: [0.0] if first else [] for part, first in zip(parts, holds[0], strict=True)}
    steps = list(_steps(parts, holds))
    last_step = {part: step for step in steps for part, _ in step[2]}
    for part in parts:
        if part not in last_step:
            progress(part.words)
    for step, places in zip(steps, run(partial(_ends, belt), steps), strict=True):
        for (part, _), place in zip(step[2], places, strict=True):
            ends[part].append(place)
            if last_step[part] is step:
                progress(part.words)
    for part, at_last in zip(parts, holds[-1], strict=True):
        ends[part] += [math.inf] if at_last else []
    return {part: list(zip(ends[part][::2], ends[part][1::2], strict=True)) for part in parts}


def _holding(belt: ns.StickSlip, parts: list[Part], alpha: float) -> list[bool]:
    """Return whether each part holds at one alpha."""
    case = at_alpha(belt, alpha)
    return [part.of(case).holds for part in parts]


def _steps(parts: list[Part], holds: list[list[bool]]) -> Iterator[Step]:
    """Yield the steps of the scan within which a part changes."""
    for (left, before), (right, after) in pairwise(zip(grid(), holds, strict=True)):
        compared = zip(parts, before, after, strict=True)
        changes = tuple((part, later) for part, sooner, later in compared if sooner != later)
        if changes:
            yield left, right, changes


def _ends(belt: ns.StickSlip, step: Step) -> list[float]:
    """Return the alpha at which each part changes; the parts share their orbits."""
    left, right, changes = step
    case = cache(partial(at_alpha, belt))

    def holds(part: Part, alpha: float) -> bool:
        return part.of(case(alpha)).holds

    return [_bisect(partial(holds, part), left, right, after) for part, after in changes]


def _bisect(holds: Callable[[float], bool], left: float, right: float, after: bool) -> float:
    """Return the value at which a statement becomes `after`, to a factor `CLOSE`."""
    while right / left > CLOSE:
        middle = math.sqrt(left * right)
        left, right = (left, middle) if holds(middle) == after else (middle, right)
    return math.sqrt(left * right)


def segments(claim: Claim, intervals: Intervals) -> list[tuple[float, float, str]]:
    """Return intervals of alpha with the verdict on a claim: from, to, verdict."""
    ends = {end for part in claim.parts for ends in intervals[part] for end in ends}
    edges = [FIRST, *sorted(end for end in ends if FIRST < end < LAST), LAST]
    merged: list[tuple[float, float, str]] = []
    for low, high in pairwise(edges):
        middle = math.sqrt(low * high)
        holds = [any(a < middle < b for a, b in intervals[part]) for part in claim.parts]
        verdict = claim.verdict(holds)
        start = merged.pop()[0] if merged and merged[-1][2] == verdict else low
        merged.append((start, high, verdict))
    return merged


def force(belt: ns.StickSlip, alpha: float) -> float:
    """Return the normal force in N that gives this `alpha`."""
    return belt.normal_force * alpha / belt.alpha


def in_words(belt: ns.StickSlip, intervals: list[tuple[float, float]]) -> str:
    """Return intervals of alpha in words, as normal forces.

    Examples
    --------
    >>> from nonsmooth.report.case import DEFAULT
    >>> in_words(DEFAULT, [(0, 0.1), (0.2, 0.3), (1, math.inf)])
    'up to 40.0 N, from 80.0 to 120 N and from 400 N up'
    >>> in_words(DEFAULT, [(0, math.inf)]), in_words(DEFAULT, [])
    ('everywhere', 'nowhere')
    """
    return listed([_words(belt, low, high) for low, high in intervals]) or "nowhere"


def _words(belt: ns.StickSlip, low: float, high: float) -> str:
    start, end = (number(force(belt, alpha)) for alpha in (low, high))
    if low == 0:
        return "everywhere" if high == math.inf else f"up to {end} N"
    return f"from {start} N up" if high == math.inf else f"from {start} to {end} N"
