"""The cheapest orbit that is as accurate as asked for, by the estimate of its error."""

import math
from collections.abc import Callable, Iterator, Sequence

from ...case.parameters import is_number
from ...trade.not_certified import MARGIN
from ..accuracy.estimate import Estimate
from ..orbit.methods import METHODS, check_belt, check_method
from ..orbit.oscillator import StickSlip
from ..search.search import MOST_DENSE
from .choice import LEAST, Choice, NotCertifiedOrbit, Trial, attempt
from .first_orders import first_order

#: How the errors fall with the order, ``N**-rate`` (make sweep); for 3.2 their envelope.
RATES = {
    "hb": {"period": 1.0, "acceleration": 0.5},
    "hb-c1": {"period": 3.0, "acceleration": 1.5},
}

#: Orders of the C1 series beyond which nothing is left but rounding.
MOST_C1 = 40

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
    if N > MOST_DENSE:
        return 5000 + 2 * N if method == "hb" else 10_000 + 2.5 * N
    dense = 4 + 0.7 * N + 0.012 * N**2 + 1.8e-4 * N**3
    return dense if method == "hb" else 2.4 * dense + 8


def check_tolerance(name: str, tolerance: object) -> float:
    """Return a tolerance as a float.

    Raises
    ------
    ValueError
        If it is not a number between 0 and 1.
    """
    if not (is_number(tolerance) and 0 < float(tolerance) < 1):  # type: ignore[arg-type]
        raise ValueError(f"{name}: got {tolerance!r}, expected a number between 0 and 1")
    return float(tolerance)  # type: ignore[arg-type]


def within(
    belt: StickSlip,
    tol: float | None = None,
    tol_acceleration: float | None = None,
    *,
    methods: Sequence[str] = tuple(METHODS),
    many: bool = False,
    progress: Callable[[str], None] = lambda now: None,
) -> Choice:
    """Return the cheapest orbit whose estimated errors are within the tolerances.

    Of a Fourier series only orders are tried that resolve slip; after one without an orbit,
    not less than twice as many harmonics.

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
        Whether to compile the kernels at once.
    progress : callable
        Called with what is tried next, in words.

    Raises
    ------
    ValueError
        If a tolerance is not between 0 and 1, none is given, or a method is unknown.
    NotCertifiedOrbit
        If float64 cannot, or the estimate cannot say so.

    Examples
    --------
    >>> from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
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
    check_belt(belt)
    trials: list[Trial] = []
    # Orders below have no prospect.
    lowest = {name: first_order(name, belt.alpha, wanted, EARLY) for name in names}
    hopeless = any(MARGIN * tol <= LEAST[error] for error, tol in wanted.items())
    for name, order in () if hopeless else _candidates(names):
        if order < lowest[name]:
            continue
        progress(f"{name}, N = {order}")
        orbit = attempt(belt, name, order, many)
        trials.append(Trial(name, order, None if orbit is None else orbit.estimate))
        if orbit is None:
            lowest[name] = order if name not in RATES else 2 * order
            continue
        estimate = orbit.estimate
        if all(getattr(estimate, error) <= MARGIN * tol for error, tol in wanted.items()):
            return Choice(orbit, tuple(trials))
        lowest[name] = _foretold(name, order, estimate, wanted)
    beyond = {name: N for name, N in lowest.items() if METHODS[name].highest_order < N}
    raise NotCertifiedOrbit(wanted, tuple(trials), beyond)


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
