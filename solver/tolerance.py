"""The cheapest orbit that is as accurate as asked for, or the best that is quick enough."""

import math
import statistics
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from .belt import StickSlip
from .estimate import ACCELERATION_ROUNDING, ROUNDING, Estimate
from .methods import METHODS, check_alpha, check_method
from .no_orbit import NoOrbit
from .orbit import Orbit
from .solve import solve

#: Harmonics up to which 3.1 and 3.2 are solved densely; see `search`.
DENSE = 256

#: How the errors fall with the order, ``N**-rate`` (make sweep); for 3.2 their envelope.
RATES = {
    "hb": {"period": 1.0, "acceleration": 0.5},
    "hb-c1": {"period": 3.0, "acceleration": 1.5},
}

#: Below these no estimate goes: rounding.
LEAST = {"period": ROUNDING, "acceleration": ACCELERATION_ROUNDING}

#: Part of the tolerance that an estimate may use up; it is itself off by a few per cent.
MARGIN = 0.9

#: Orders of the C1 series beyond which nothing is left but rounding.
MOST_C1 = 40

#: Orders among which a budget chooses; seconds and rounds that are spent on measuring one.
_DOUBLING = (1, 2, 4, 8, 16, 32, 64, 128, 256, 1024, 4096, 16_384, 65_536, 262_144, 1_000_000)
ORDERS = {
    "hb": _DOUBLING,
    "hb-c1": _DOUBLING,
    "c1": (2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 17, 20, 24),
}
MEASURED, MOST_ROUNDS = 0.01, 25

#: Part of the order that a rate foretells at which trying begins.
EARLY = 0.7


def cost(method: str, order: int) -> float:
    """Return about how many microseconds a compiled solve takes.

    Fitted to medians of ``make bench-kernels`` and ``make bench``; for the order in which
    candidates are tried, to which only ratios matter.

    Examples
    --------
    >>> cost("c1", 10) < cost("hb", 40) < cost("hb-c1", 40)
    True
    """
    N = float(order)
    if method == "c1":
        return 3 + 0.6 * N + 0.027 * N**2
    if N > DENSE:
        return 5000 + 2 * N if method == "hb" else 10_000 + 2.5 * N
    dense = 4 + 0.7 * N + 0.012 * N**2 + 1.8e-4 * N**3
    return dense if method == "hb" else 2.4 * dense + 8


@dataclass(frozen=True)
class Trial:
    """One candidate.

    Parameters
    ----------
    method, order : str, int
    estimate : Estimate or None
        Of its errors; None where it has no orbit.
    seconds : float or None
        Of one solve, measured; None where nothing was to be measured.
    """

    method: str
    order: int
    estimate: Estimate | None
    seconds: float | None = None


@dataclass(frozen=True)
class Choice:
    """What a tolerance or a budget led to.

    Parameters
    ----------
    orbit : Orbit
        The first candidate whose estimate is within the tolerance; the best within the
        budget.
    trials : tuple of Trial
        All candidates, in the order in which they were tried.
    """

    orbit: Orbit
    trials: tuple[Trial, ...]


class NotCertified(Exception):  # noqa: N818  (a finding, not a fault)
    """No orbit in float64 is as accurate as asked for, as far as the estimate can say.

    Parameters
    ----------
    wanted : dict
        The tolerances.
    trials : tuple of Trial
        What was tried.
    foretold : dict
        Order that a method would need, by its rate, where that is beyond its highest.
    """

    def __init__(
        self, wanted: dict[str, float], trials: tuple[Trial, ...], foretold: dict[str, float]
    ) -> None:
        super().__init__(wanted, trials, foretold)
        self.wanted = wanted
        self.trials = trials
        self.foretold = foretold

    def __str__(self) -> str:
        parts = [" and ".join(f"{name} to {tol:g}" for name, tol in self.wanted.items())]
        for name, tol in self.wanted.items():
            if MARGIN * tol <= LEAST[name]:
                parts.append(f"no estimate in float64 goes below {LEAST[name]:g}")
        found = [(trial.estimate, trial) for trial in self.trials if trial.estimate is not None]
        name = next(iter(self.wanted))
        if found:
            estimate, best = min(found, key=lambda pair: getattr(pair[0], name))
            value = getattr(estimate, name)
            parts.append(f"the best was {value:.1e} by {best.method}, N = {best.order}")
        parts += [f"{name} would need N of about {N:.0e}" for name, N in self.foretold.items()]
        return "; ".join(parts)


class TooSlow(Exception):  # noqa: N818  (a finding, not a fault)
    """No orbit is computed within the budget.

    Parameters
    ----------
    budget, fastest : float
        Seconds.
    """

    def __init__(self, budget: float, fastest: float) -> None:
        super().__init__(budget, fastest)
        self.budget = budget
        self.fastest = fastest

    def __str__(self) -> str:
        return (
            f"a budget of {self.budget:.2g} s: the fastest orbit takes {self.fastest:.2g} s "
            "here; for many orbits see nonsmooth.solver.batch"
        )


def check_tolerance(name: str, tolerance: object) -> float:
    """Return a tolerance as a float.

    Raises
    ------
    ValueError
        If it is not a number between 0 and 1.
    """
    good = isinstance(tolerance, int | float) and not isinstance(tolerance, bool)
    if not (good and 0 < float(tolerance) < 1):  # type: ignore[arg-type]
        raise ValueError(f"{name}: got {tolerance!r}, expected a number between 0 and 1")
    return float(tolerance)  # type: ignore[arg-type]


def chosen(
    belt: StickSlip,
    method: str | None,
    order: int | None,
    tol: float | None,
    tol_acceleration: float | None,
    budget: float | None,
    *,
    many: bool = False,
) -> Choice:
    """Return what the tolerances or the budget lead to; see `within` and `fitting`.

    Raises
    ------
    ValueError
        If an order is given, or tolerances and a budget, or one of them is wrong.
    """
    if order is not None:
        raise ValueError(f"order: got {order!r} beside a tolerance or budget, which chooses it")
    methods = tuple(METHODS) if method is None else (method,)
    if budget is None:
        return within(belt, tol, tol_acceleration, methods=methods, many=many)
    if tol is not None or tol_acceleration is not None:
        raise ValueError(f"budget: got {budget!r} beside a tolerance, expected one of them")
    return fitting(belt, budget, methods=methods)


def within(
    belt: StickSlip,
    tol: float | None = None,
    tol_acceleration: float | None = None,
    *,
    methods: Sequence[str] = tuple(METHODS),
    many: bool = False,
) -> Choice:
    """Return the cheapest orbit whose estimated errors are within the tolerances.

    Parameters
    ----------
    belt : StickSlip
        The oscillator.
    tol : float, optional
        Relative error of the period.
    tol_acceleration : float, optional
        The measure (22).
    methods : sequence of {"hb", "hb-c1", "c1"}
        Methods to choose from.
    many : bool
        Whether more orbits are to follow: compile the kernels.

    Raises
    ------
    ValueError
        If a tolerance is not between 0 and 1, none is given, or a method is unknown.
    NotCertified
        If float64 cannot, or the estimate cannot say so.

    Examples
    --------
    >>> from nonsmooth.solver.belt import DEFAULT
    >>> choice = within(DEFAULT, 1e-8)
    >>> choice.orbit.method, choice.orbit.order
    ('c1', 9)
    """
    asked = {"period": ("tol", tol), "acceleration": ("tol_acceleration", tol_acceleration)}
    wanted = {
        error: check_tolerance(name, value)
        for error, (name, value) in asked.items()
        if value is not None
    }
    if not wanted:
        raise ValueError("tol: got None, expected a number between 0 and 1")
    names = [check_method(name).name for name in methods]
    check_alpha(belt.alpha)
    trials: list[Trial] = []
    lowest: dict[str, float] = dict.fromkeys(names, 0.0)  # orders below have no prospect
    hopeless = any(MARGIN * tol <= LEAST[error] for error, tol in wanted.items())
    for name, order in () if hopeless else _candidates(names):
        if order < lowest[name]:
            continue
        orbit = _attempt(belt, name, order, many)
        trials.append(Trial(name, order, None if orbit is None else orbit.estimate))
        if orbit is None:
            continue
        estimate = orbit.estimate
        if all(getattr(estimate, error) <= MARGIN * tol for error, tol in wanted.items()):
            return Choice(orbit, tuple(trials))
        lowest[name] = _foretold(name, order, estimate, wanted)
    beyond = {name: N for name, N in lowest.items() if METHODS[name].highest_order < N}
    raise NotCertified(wanted, tuple(trials), beyond)


def fitting(
    belt: StickSlip, budget: float, *, methods: Sequence[str] = tuple(METHODS)
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

    Raises
    ------
    ValueError
        If the budget is not a positive number of seconds, or a method is unknown.
    TooSlow
        If nothing fits.
    """
    if not (isinstance(budget, int | float) and 0 < budget < math.inf):
        raise ValueError(f"budget: got {budget!r}, expected a positive number of seconds")
    names = [check_method(name).name for name in methods]
    check_alpha(belt.alpha)
    trials: list[Trial] = []
    best: Orbit | None = None
    for name in names:
        for order in ORDERS[name]:
            orbit = _attempt(belt, name, order, many=True)
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
        raise TooSlow(budget, min(times, default=math.inf))
    return Choice(best, tuple(trials))


def _seconds(belt: StickSlip, method: str, order: int) -> float:
    """Return the median time of one solve, which has been done once."""
    seen: list[float] = []
    while len(seen) < MOST_ROUNDS and sum(seen) < MEASURED:
        begin = time.perf_counter()
        solve(belt, method, order, many=True)
        seen.append(time.perf_counter() - begin)
    return statistics.median(seen)


def _candidates(methods: Sequence[str]) -> Iterator[tuple[str, int]]:
    """Yield methods and orders by their cost."""
    pairs = [
        (name, order)
        for name in methods
        for order in (range(2, MOST_C1 + 1) if name == "c1" else _spread(name))
    ]
    yield from sorted(pairs, key=lambda pair: cost(*pair))


def _spread(method: str) -> Iterator[int]:
    """Yield orders of a Fourier series, each about a tenth above the one before."""
    order, most = 1, METHODS[method].highest_order
    while order < most:
        yield order
        order = max(order + 1, int(1.1 * order))
    yield most


def _attempt(belt: StickSlip, method: str, order: int, many: bool) -> Orbit | None:
    try:
        return solve(belt, method, order, many=many)
    except NoOrbit:
        return None


def _foretold(method: str, order: int, found: Estimate, wanted: dict[str, float]) -> float:
    """Return the order from which the tolerances may be met, as the rates have it."""
    if method not in RATES:
        return order
    factors = [
        (getattr(found, error) / tol) ** (1 / RATES[method][error])
        for error, tol in wanted.items()
    ]
    finite: list[float] = [factor for factor in factors if math.isfinite(factor)]
    return EARLY * order * max([1.0, *finite])
