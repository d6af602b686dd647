"""How fast a sweep converges: a power of the order, or a factor with each order."""

from collections.abc import Sequence
from dataclasses import dataclass

from ...accuracy.rates import as_text, slope
from ..orbit.methods import METHODS
from .errors import Errors

#: Errors below this are rounding: of the times, and of the measure (22).
FLOORS = {"period": 1e-12, "t1": 1e-12, "acceleration": 1e-6}


@dataclass(frozen=True)
class Rate:
    """Convergence of one method, fitted over the upper half of the orders above rounding.

    The period error of 3.2 changes sign with the order, within an envelope of ``N**-3``:
    a fit to few orders says little, and fewer than six are not fitted.

    Parameters
    ----------
    kind : {"power", "geometric"}
        The error is ``N**-rate``: a Fourier series; or ``10**(-rate N)``: the C1 series.
    period, t1, acceleration : float or None
        The rate of each error; None if fewer than six orders are above rounding.
    """

    kind: str
    period: float | None
    t1: float | None
    acceleration: float | None

    def text(self, name: str) -> str:
        """Return one rate as it is printed."""
        return as_text(self.kind, getattr(self, name))


def rate(method: str, rows: Sequence[tuple[int, Errors]]) -> Rate:
    """Return the rate of one method from its orders and their errors.

    Examples
    --------
    >>> rows = [(N, Errors(1 / N, 2 / N, N**-0.5, N**-0.5)) for N in range(10, 16)]
    >>> rate("hb", rows).text("acceleration")
    'N^-0.500'
    """
    power = METHODS[method].c1_terms is not None
    slopes = {
        name: slope(
            [(N, getattr(found, name)) for N, found in rows],
            floor,
            power=power,
            upper_half=True,
        )
        for name, floor in FLOORS.items()
    }
    return Rate("power" if power else "geometric", **slopes)
