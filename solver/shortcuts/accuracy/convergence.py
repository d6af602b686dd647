"""How fast a sweep converges: a power of the order, or a factor with each order."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ..orbit.methods import METHODS
from .errors import Errors

#: Errors below this are rounding: of the times, and of the measure (22).
FLOORS = {"period": 1e-12, "t1": 1e-12, "acceleration": 1e-6}


@dataclass(frozen=True)
class Rate:
    """Convergence of one method, fitted over the upper half of the orders above rounding.

    The period error of 3.2 changes sign with the order, within an envelope of ``N**-3``:
    a fit to few orders says little.

    Parameters
    ----------
    kind : {"power", "geometric"}
        The error is ``N**-rate``: a Fourier series; or ``10**(-rate N)``: the C1 series.
    period, t1, acceleration : float or None
        The rate of each error; None if fewer than two orders are above rounding.
    """

    kind: str
    period: float | None
    t1: float | None
    acceleration: float | None

    def text(self, name: str) -> str:
        """Return one rate as it is printed; empty without one."""
        rate = getattr(self, name)
        if rate is None:
            return ""
        return f"N^{-rate:.3f}" if self.kind == "power" else f"10^({-rate:.2f} N)"


def rate(method: str, rows: Sequence[tuple[int, Errors]]) -> Rate:
    """Return the rate of one method from its orders and their errors.

    Examples
    --------
    >>> rows = [(N, Errors(1 / N, 2 / N, N**-0.5, N**-0.5)) for N in (10, 100, 1000)]
    >>> rate("hb", rows).text("acceleration")
    'N^-0.500'
    """
    power = METHODS[method].c1_terms is not None
    scale: Callable[[float], float] = math.log10 if power else float
    slopes = {name: _slope(rows, name, scale) for name in FLOORS}
    return Rate("power" if power else "geometric", **slopes)


def _slope(
    rows: Sequence[tuple[int, Errors]], name: str, scale: Callable[[float], float]
) -> float | None:
    """Return minus the slope of the logarithm of an error, over the upper half."""
    errors = [(scale(N), abs(getattr(found, name))) for N, found in rows]
    points = sorted((x, math.log10(error)) for x, error in errors if error > FLOORS[name])
    if len(points) < 2:
        return None
    middle = (points[0][0] + points[-1][0]) / 2
    points = [*points[-2:], *(point for point in points[:-2] if point[0] >= middle)]
    x, y = np.array(points).T
    return float(-np.polyfit(x, y, 1)[0])
