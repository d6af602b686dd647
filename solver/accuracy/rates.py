"""Rates of convergence of a sweep over orders: algebraic or geometric."""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from ..scenes.methods import about

#: Least number of orders with errors above rounding for a fit, by default.
FEWEST = 6

#: Errors below these are rounding: of the times, and of the derivative that jumps.
FLOORS = {"times": 1e-13, "discontinuous": 1e-12}

#: Plateau of geometric errors, rounding of an ill-conditioned orbit: errors below `NEAR` times
#: the least, over at least `MANY` orders, with a slope of less than `PART` of that before.
NEAR, MANY, PART = 10.0, 5, 0.5

TOO_FEW = "too few orders"


@dataclass(frozen=True)
class Rate:
    """Convergence of one method.

    Parameters
    ----------
    kind : {"power", "geometric"}
        The error is like ``N**-rate`` (methods with harmonics), or like ``10**(-rate N)``.
    times, discontinuous : float or None
        The rate of each error, by a least-squares fit of the logarithms of all errors above
        rounding; None if there are fewer than six.
    """

    kind: str
    times: float | None
    discontinuous: float | None

    def text(self, name: str) -> str:
        """Return one of the rates as text."""
        exponent: float | None = getattr(self, name)
        if exponent is None:
            return TOO_FEW
        return f"N^{-exponent:.3f}" if self.kind == "power" else f"10^({-exponent:.2f} N)"


def rate(method: str, errors: Sequence[tuple[int, dict[str, float]]]) -> Rate:
    """Return the rate of a method from its orders and errors; the errors by names of `FLOORS`.

    Examples
    --------
    >>> rows = [(N, {"times": N**-2.0, "discontinuous": 0.0}) for N in range(1, 9)]
    >>> rate("hb", rows).text("times"), rate("hb", rows).text("discontinuous")
    ('N^-2.000', 'too few orders')
    """
    power = about(method).power
    slopes = {
        name: slope([(order, errors_[name]) for order, errors_ in errors], floor, power=power)
        for name, floor in FLOORS.items()
    }
    return Rate("power" if power else "geometric", **slopes)


def slope(
    errors: Iterable[tuple[int, float]],
    floor: float,
    *,
    power: bool,
    upper_half: bool = False,
    fewest: int = FEWEST,
) -> float | None:
    """Return minus the slope of the logarithm of an error, by least squares.

    None if fewer than `fewest` errors are above rounding.

    Parameters
    ----------
    errors : iterable of (int, float)
        Order and error.
    floor : float
        Errors up to it are rounding, and left out; without `power`, a plateau at the end too.
    power : bool
        Whether the slope is over the logarithm of the order, or over the order.
    upper_half : bool
        Whether only the upper half of that scale is fitted, but at least `fewest` orders.
    fewest : int
        Least number of orders.

    Examples
    --------
    >>> slope([(N, N**-2.0) for N in range(2, 8)], 0.0, power=True)  # doctest: +ELLIPSIS
    2.0...
    """
    by_order = {order: abs(error) for order, error in errors}
    above = sorted(order for order, error in by_order.items() if floor < error < math.inf)
    if not power:
        above = _falling(above, by_order)
    if len(above) < fewest:
        return None
    scale: Callable[[float], float] = math.log10 if power else float
    x = np.array([scale(order) for order in above])
    y = np.log10([by_order[order] for order in above])
    if upper_half:
        first = min(int(np.searchsorted(x, (x[0] + x[-1]) / 2)), len(x) - fewest)
        x, y = x[first:], y[first:]
    return float(-np.polyfit(x, y, 1)[0])


def _falling(orders: list[int], errors: dict[int, float]) -> list[int]:
    """Return the orders before a plateau of the errors; all, if there is none."""
    near = NEAR * min((errors[order] for order in orders), default=0.0)
    first = next((i for i, order in enumerate(orders) if errors[order] <= near), 0)
    before, level = orders[: first + 1], orders[first:]
    if first == 0 or len(level) < MANY:
        return orders
    slopes = [
        np.polyfit(part, np.log([errors[q] for q in part]), 1)[0] for part in (before, level)
    ]
    return orders[:first] if slopes[1] > PART * slopes[0] else orders
