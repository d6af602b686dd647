"""How fast the errors of a sweep fall: a power of the order, or a factor with each order."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..case.methods import about

#: Orders above rounding that a fit takes at least: fewer say too little.
FEWEST = 6

#: Errors below these are rounding: of the times, and of the derivative that jumps.
FLOORS = {"times": 1e-13, "discontinuous": 1e-12}

TOO_FEW = "too few orders"


@dataclass(frozen=True)
class Rate:
    """Convergence of one method.

    Parameters
    ----------
    kind : {"power", "geometric"}
        The error is ``N**-rate``, of a method with harmonics; or ``10**(-rate N)``.
    times, discontinuous : float or None
        The rate of each error, by least squares over the logarithms of all errors above
        rounding; None if there are fewer than six.
    """

    kind: str
    times: float | None
    discontinuous: float | None

    def text(self, name: str) -> str:
        """Return one rate as it is printed."""
        rate = getattr(self, name)
        if rate is None:
            return TOO_FEW
        return f"N^{-rate:.3f}" if self.kind == "power" else f"10^({-rate:.2f} N)"


def rate(method: str, errors: Sequence[tuple[int, dict[str, float]]]) -> Rate:
    """Return the rate of a method from its orders and their errors.

    Parameters
    ----------
    method : str
        Its generic name; `about` says whether it converges by a power.
    errors : sequence of (int, dict)
        Order, and the errors by the names of `FLOORS`.

    Examples
    --------
    >>> rows = [(N, {"times": N**-2.0, "discontinuous": 0.0}) for N in range(1, 9)]
    >>> rate("hb", rows).text("times"), rate("hb", rows).text("discontinuous")
    ('N^-2.000', 'too few orders')
    """
    power = about(method).power
    slopes = {name: _slope(errors, name, power) for name in FLOORS}
    return Rate("power" if power else "geometric", **slopes)


def _slope(
    errors: Sequence[tuple[int, dict[str, float]]], name: str, power: bool
) -> float | None:
    """Return minus the slope of the logarithm of an error."""
    points = [
        (math.log10(order) if power else float(order), math.log10(abs(found[name])))
        for order, found in errors
        if FLOORS[name] < abs(found[name]) < math.inf
    ]
    if len({x for x, _ in points}) < FEWEST:
        return None
    x, y = np.array(points).T
    return float(-np.polyfit(x, y, 1)[0])
