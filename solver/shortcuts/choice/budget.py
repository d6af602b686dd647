"""The best orbit that is quick enough, timed on this machine."""

import math
from collections.abc import Callable, Sequence

from ...case.parameters import is_number
from ...trade.not_certified import TooSlow
from ...trade.timing import median_seconds
from ..orbit.methods import METHODS, check_belt, check_method
from ..orbit.orbit import Orbit
from ..orbit.oscillator import StickSlip
from ..search.solve import solve
from .choice import Choice, Trial, attempt

#: Orders among which a budget chooses.
_DOUBLING = (1, 2, 4, 8, 16, 32, 64, 128, 256, 1024, 4096, 16_384, 65_536, 262_144, 1_000_000)
ORDERS = {
    "hb": _DOUBLING,
    "hb-c1": _DOUBLING,
    "c1": (2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 17, 20, 24),
}


#: For those whom a single solve is too slow.
MANY = "for many orbits see nonsmooth.solver.shortcuts.polynomials.batch"


def fitting(
    belt: StickSlip,
    budget: float,
    *,
    methods: Sequence[str] = tuple(METHODS),
    progress: Callable[[str], None] = lambda now: None,
) -> Choice:
    """Return the orbit with the smallest estimated error of the period within a time.

    Every candidate is solved and timed here, by compiled kernels and with its checks; a
    method is left at the first order that takes too long.

    Parameters
    ----------
    belt : StickSlip
        The oscillator.
    budget : float
        Seconds for one orbit.
    methods : sequence of {"hb", "hb-c1", "c1"}
        Methods to choose from.
    progress : callable
        Called with what is tried next, in words.

    Raises
    ------
    ValueError
        If the budget is not a positive number of seconds, or a method is unknown.
    TooSlow
        If nothing fits.
    """
    if not (is_number(budget) and budget > 0):
        raise ValueError(f"budget: got {budget!r}, expected a positive number of seconds")
    names = [check_method(name).name for name in methods]
    check_belt(belt)
    trials: list[Trial] = []
    best: Orbit | None = None
    for name in names:
        for order in ORDERS[name]:
            progress(f"{name}, N = {order}")
            orbit = attempt(belt, name, order, many=True)
            if orbit is None:
                trials.append(Trial(name, order, None))
                continue
            seconds = _seconds(belt, name, order)
            trials.append(Trial(name, order, orbit.estimate, seconds))
            if seconds > budget:
                break
            if best is None or orbit.estimate.period < best.estimate.period:
                best = orbit
    if best is None:
        times = [trial.seconds for trial in trials if trial.seconds is not None]
        raise TooSlow(budget, min(times, default=math.inf), MANY)
    return Choice(best, tuple(trials))


def _seconds(belt: StickSlip, method: str, order: int) -> float:
    """Return the median time of one solve."""
    return median_seconds(lambda: solve(belt, method, order, many=True))
