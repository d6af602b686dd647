"""The checks of the claims of the paper: each computes numbers and decides by them."""

from dataclasses import dataclass

from ..case import Case
from ..words import listed, percent

#: The band of the period that the paper names in Fig. 4.
BAND = 1e-3

#: Overshoot, relative to the jump, that is too small to be seen in a figure.
UNSEEN = 0.01

#: The order beyond which the paper makes claims about the C1 series.
THREE = 3

#: Orders at which a quantity is compared, to decide whether it falls.
DOUBLED = (10, 20, 40)


@dataclass(frozen=True)
class Finding:
    """The result of a check: whether the statement holds, and the numbers that decide.

    Parameters
    ----------
    holds : bool
    numbers : str
        In words.
    """

    holds: bool
    numbers: str


def doubled(case: Case, of: str, method: str) -> tuple[list[float], str]:
    """Return one of the `MEASURES` at N = 10, 20 and 40, and the same in words."""
    values = [case.measured(of, method, N) for N in DOUBLED]
    unit = "" if of == "acceleration" else " of the jump"
    words = listed([percent(value, 2) for value in values])
    return values, f"{words}{unit} at N = 10, 20 and 40"
