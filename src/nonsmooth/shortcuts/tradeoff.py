"""Time against error for one oscillator, measured here: in float64 and in many digits.

In float64 a row is a whole `solve`, checks included: by compiled kernels, but for `c1-tau`,
which the solver of all scenes finds by plain ones.  Beyond, the same equations are refined in
high precision (`twin`), derivation not counted: ten times slower, and without a floor.
"""

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from importlib.util import find_spec

from ..solver.no_orbit import NoOrbit
from ..solver.shortcuts.accuracy.convergence import rate
from ..solver.shortcuts.orbit.methods import name_with_terms
from ..solver.shortcuts.orbit.orbit import Orbit
from ..solver.shortcuts.orbit.oscillator import StickSlip
from ..solver.shortcuts.search.solve import solve
from ..solver.trade.measured import front
from ..solver.trade.timing import median_seconds

#: Method and its C1 functions, with the orders in float64.  Of 3.2 with several functions
#: those numbers that are the first of their order of convergence.
ORDERS: dict[tuple[str, int], tuple[int, ...]] = {
    ("hb", 1): (1, 2, 4, 8, 16, 32, 64, 128, 256, 1024, 4096, 16_384, 65_536),
    ("hb-c1", 1): (1, 2, 4, 8, 16, 32, 64, 128, 256, 1024, 4096, 16_384),
    ("hb-c1", 3): (2, 4, 8, 16, 32, 64, 128),
    ("hb-c1", 5): (2, 4, 8, 16, 32),
    ("c1", 1): (2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 17, 20),
    ("c1-tau", 1): (3, 4, 5, 6, 7, 8, 9, 10, 11, 13),
}

#: The C1 series with all polynomials of low degree as tests, which is not the paper's.
TAU = "c1-tau"

#: Digits of the period beyond float64, by the C1 series.
DIGITS = (20, 30, 50)

#: An error below this is as good as any other in float64.
ROUNDING = 2e-16


@dataclass(frozen=True)
class Point:
    """One way to the orbit: what it takes, and how good it is.

    Parameters
    ----------
    regime : {"float64", "precise"}
        Arithmetic; the second is high precision.
    method, c1_terms, order : str, int, int
        `c1_terms` are the C1 functions of ``"hb-c1"``.
    digits : int or None
        Decimal digits in high precision.
    seconds : float
        Median time of one orbit.
    error, estimate : float or None
        Error of the period, without sign: true, and as estimated (float64 only).
    front : bool
        Whether it is on the Pareto front: nothing measured is both faster and as accurate.
    """

    regime: str
    method: str
    c1_terms: int
    order: int
    digits: int | None
    seconds: float
    error: float
    estimate: float | None
    front: bool = False


def measure(
    belt: StickSlip, progress: Callable[[str], None] = lambda done: None
) -> list[Point]:
    """Return all points, the front marked.

    Parameters
    ----------
    belt : StickSlip
        The oscillator.
    progress : callable, optional
        Called with what has just been measured, in words.
    """
    points = []
    for (method, terms), orders in ORDERS.items():
        for order in orders:
            points += _float64(belt, method, terms, order)
            progress(f"{name_with_terms(method, terms)}, N = {order}")
    if find_spec("flint") is not None:
        slope, offset = _geometric(belt)
        for digits in DIGITS:
            points += _precise(belt, int((digits + offset) / slope) + 2, digits)
            progress(f"{digits} digits")
    return with_front(points)


def count() -> int:
    """Return how many rows `measure` reports to its progress, at most."""
    return sum(map(len, ORDERS.values())) + len(DIGITS)


def _float64(belt: StickSlip, method: str, terms: int, order: int) -> list[Point]:
    """Return the point of one method and order; none where there is no orbit."""
    if method == TAU:
        return _tau(belt, order)

    def orbit() -> Orbit:
        return solve(belt, method, order, c1_terms=terms, many=True)

    try:
        found = orbit()
    except NoOrbit:
        return []
    seconds = median_seconds(orbit)
    error = max(abs(found.errors.period), ROUNDING)
    judged = found.estimate.period
    return [Point("float64", method, terms, order, None, seconds, error, judged)]


def _tau(belt: StickSlip, order: int) -> list[Point]:
    """Return the point of the C1 series with Legendre's tests; none where it has no orbit."""
    from ..solver.case.registry import load  # noqa: PLC0415
    from ..solver.solve import solve_case  # noqa: PLC0415

    case = load("stick-slip")(**asdict(belt))
    try:
        found = solve_case(case, TAU, order)
    except NoOrbit:
        return []
    if found.errors is None:  # no exact orbit near it
        return []
    seconds = median_seconds(lambda: solve_case(case, TAU, order))
    error = max(abs(found.errors.period), ROUNDING)
    judged = found.estimate.period
    return [Point("float64", TAU, 1, order, None, seconds, error, judged)]


def _geometric(belt: StickSlip) -> tuple[float, float]:
    """Return decimal digits of the period by the C1 series: each order's, and the first's."""
    rows = []
    for order in ORDERS["c1", 1]:
        try:
            rows.append((order, solve(belt, "c1", order, many=True).errors))
        except NoOrbit:
            continue
    slope = rate("c1", rows).period or 0.5
    order, errors = max((row for row in rows if abs(row[1].period) > 1e-12), default=rows[-1])
    return slope, slope * order + math.log10(max(abs(errors.period), ROUNDING))


def _precise(belt: StickSlip, order: int, digits: int) -> list[Point]:
    """Return the point of the C1 series in many digits."""
    from .twin import PrecisionError, precise  # noqa: PLC0415

    try:
        orbit = solve(belt, "c1", order, many=True)
        found = precise(orbit, digits)
        seconds = median_seconds(lambda: precise(orbit, digits))
    except (NoOrbit, PrecisionError, ValueError):
        return []
    error = max(abs(float(found.error_period)), 10.0**-digits)
    return [Point("precise", "c1", 1, order, digits, seconds, error, None)]


def with_front(points: list[Point]) -> list[Point]:
    """Return the points, those marked that no other beats in time and error."""
    chosen = front([(point.seconds, point.error) for point in points])
    return [replace(point, front=index in chosen) for index, point in enumerate(points)]
