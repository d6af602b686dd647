"""Computing time against error for a case: each method at some orders, and the exact orbit."""

import statistics
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any, TypeVar

from ..exact import exact_orbit
from ..kernels import registry
from ..no_orbit import NoOrbit
from ..scenes.case import Case
from ..scenes.methods import EXACT, about, in_order
from ..solve import number_of_functions, solve_case

# The result of the work that is timed.
Found = TypeVar("Found")

#: Orders that are measured, of a method of algebraic convergence and of a geometric one.
POWER_ORDERS = (1, 2, 4, 8, 16, 32, 64)
FACTOR_ORDERS = (2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 16, 18, 20)

#: Timing is repeated until it has taken so many seconds, or so many rounds.
MEASURED, MOST_ROUNDS = 0.01, 25

#: Smaller errors are shown as this one: they are rounding.
ROUNDING = 2e-16


@dataclass(frozen=True)
class TradePoint:
    """Computing time and error of a method at an order.

    Parameters
    ----------
    method : str
        Generic name, or `EXACT`.
    order, functions : int or None
        None if it has none.
    seconds : float
        Median time of one orbit, with its search from rough times and its checks; of the exact
        orbit, started from its own times.
    error, estimate : float
        Error of the times relative to the period, at least `ROUNDING`; and its estimate without
        the exact orbit, 0 for the exact orbit.
    front : bool
        Whether it is on the Pareto front: no other point is both faster and as accurate.
    """

    method: str
    order: int | None
    functions: int | None
    seconds: float
    error: float
    estimate: float
    front: bool = False


@dataclass(frozen=True)
class Trade:
    """The points that `trade` has measured, in the order of the methods."""

    case: Case
    points: tuple[TradePoint, ...]

    def front_of(self, method: str) -> list[tuple[float, float]]:
        """Return times and errors of a method's own Pareto front, fastest first."""
        every = [(p.seconds, p.error) for p in self.points if p.method == method]
        return sorted(every[i] for i in front(every))

    def as_dict(self) -> dict[str, Any]:
        """Return the points as the document that ``tradeoff --json`` writes."""
        return {
            "scene": self.case.scene.name,
            "class": f"C{self.case.scene.k}",
            "parameters": dict(self.case.values),
            "points": [asdict(point) for point in self.points],
        }


def trade(case: Case, progress: Callable[[str], None] = lambda done: None) -> Trade:
    """Return computing time and error of the times, by every method at several orders.

    Parameters
    ----------
    case : Case
        The oscillator.
    progress : callable, optional
        Called with method and order after each measurement, in words.

    Raises
    ------
    NoOrbit
        If no exact orbit is found to compare with.
    """
    exact = exact_orbit(case)
    start = exact.durations[: len(exact.case.cell.phases)], exact.forcing_phase or 0.0
    _, seconds = timed(lambda: exact_orbit(exact.case, *start))  # without a start it is cached
    points = [TradePoint(EXACT, None, None, seconds, ROUNDING, 0.0)]
    progress(EXACT)
    for method, order in ways(case):
        points += _measured(case, method, order)
        progress(f"{method}, N = {order}")
    chosen = front([(point.seconds, point.error) for point in points])
    return Trade(case, tuple(replace(p, front=i in chosen) for i, p in enumerate(points)))


def ways(case: Case) -> list[tuple[str, int]]:
    """Return the methods and orders that `trade` measures."""
    pairs = []
    for method in in_order(registry.methods(case.scene)):
        count = number_of_functions(case, method, None)
        pairs += [(method, order) for order in orders(case, method, count)]
    return pairs


def orders(case: Case, method: str, functions: int | None) -> list[int]:
    """Return the orders of a method that are measured, from its lowest on."""
    lowest = registry.kernel(case.scene, method, functions).lowest
    every = POWER_ORDERS if about(method).power else FACTOR_ORDERS
    return [order for order in every if order >= lowest]


def _measured(case: Case, method: str, order: int) -> Iterable[TradePoint]:
    """Return the point of a method and order; none if there is no orbit with known errors."""
    try:
        orbit, seconds = timed(lambda: solve_case(case, method, order))
    except NoOrbit:
        return []
    if orbit.errors is None:
        return []
    error, judged = max(orbit.errors.times, ROUNDING), orbit.estimate.times
    return [TradePoint(orbit.method, order, orbit.functions, seconds, error, judged)]


def front(points: Sequence[tuple[float, float]]) -> set[int]:
    """Return the indices of the Pareto front of times and errors; of equal points the first.

    Examples
    --------
    >>> sorted(front([(3, 1e-9), (1, 1e-2), (2, 1e-2), (4, 1e-8)]))
    [0, 1]
    """
    best, indices = float("inf"), set()
    for index in sorted(range(len(points)), key=lambda i: points[i]):
        if points[index][1] < best:
            best = points[index][1]
            indices.add(index)
    return indices


def timed(work: Callable[[], Found]) -> tuple[Found, float]:
    """Return the result of `work`, and its median time in repeated runs, with filled caches."""
    outcome = work()
    durations: list[float] = []
    while len(durations) < MOST_ROUNDS and sum(durations) < MEASURED:
        begin = time.perf_counter()
        work()
        durations.append(time.perf_counter() - begin)
    return outcome, statistics.median(durations)
