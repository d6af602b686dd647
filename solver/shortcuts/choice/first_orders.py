"""The order of a Fourier series at which it is worth while to begin, from alpha alone.

Where stick is long, what counts is the number of harmonics in slip, ``n = N s/T``.  Below one
there is no slip to be seen, and the search for an orbit takes longest where there is none.
Above, the errors approach ``period * alpha * n**-p`` and ``acceleration * sqrt(alpha) *
n**(-p/2)``, with the rates ``p`` of `tolerance.RATES`; ``tests/accuracy/test_first_orders.py``
measures the factors.
"""

import math
from dataclasses import dataclass

from ..orbit.methods import SMALLEST_ALPHA
from ..search.start import rough_times

#: From this alpha on stick is long: the errors are those above, or up to twice as large.
LONG_STICK = 3.0

#: Errors above which what is said above does not hold.
SMALL = 0.05

#: Error of the period times alpha, beyond which no orbit of 3.2 has been found.
FARTHEST_OFF = 10.0


@dataclass(frozen=True)
class Errors:
    """Errors of a Fourier series by harmonics in slip, where stick is long.

    Parameters
    ----------
    period, acceleration : float
        Factors; the least that were measured from ``alpha = 3`` on.
    rate : float
        Of the period; that of the acceleration is half of it.
    """

    period: float
    acceleration: float
    rate: float

    def harmonics(self, alpha: float, wanted: dict[str, float]) -> float:
        """Return the harmonics in slip for which the errors are as wanted, at least one."""
        needed = [1.0]
        if "period" in wanted:
            needed.append((self.period * alpha / wanted["period"]) ** (1 / self.rate))
        if "acceleration" in wanted:
            part = self.acceleration * math.sqrt(alpha) / wanted["acceleration"]
            needed.append(part ** (2 / self.rate))
        return max(needed)


ERRORS = {"hb": Errors(0.1, 0.43, 1.0), "hb-c1": Errors(0.012, 0.17, 3.0)}


def first_order(method: str, alpha: float, wanted: dict[str, float], early: float) -> float:
    """Return the order at which a search for errors as small as wanted begins.

    Parameters
    ----------
    method : str
    alpha : float
    wanted : dict
        Tolerances of ``"period"`` and ``"acceleration"``.
    early : float
        Part of the order that the errors are said to need at which it begins.

    Examples
    --------
    >>> first_order("c1", 1.0, {"period": 1e-6}, 0.7), first_order("hb", 0.1, {}, 0.7)
    (1.0, 1.0)
    >>> f"{first_order('hb-c1', 14_149.0, {'period': 1e-5}, 0.7):.0e}"  # 1e6 can be computed
    '2e+06'
    """
    if method not in ERRORS:
        return 1.0
    t1, T = rough_times(max(alpha, SMALLEST_ALPHA))
    resolved = math.floor(T / (T - t1))
    if alpha < LONG_STICK:
        return float(resolved)
    small = {error: tol for error, tol in wanted.items() if tol <= SMALL}
    n = [1.0, early * ERRORS[method].harmonics(alpha, small)]
    if method == "hb-c1":
        least = {"period": min(SMALL, FARTHEST_OFF / alpha)}
        n.append(ERRORS[method].harmonics(alpha, least))
    return max(n) * T / (T - t1)
