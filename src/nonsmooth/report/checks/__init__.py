"""What each claim of the paper is held against: numbers, each with what it decides."""

from dataclasses import dataclass

from ..case import Case
from ..words import listed, percent

#: The band of the period that the paper names in Fig. 4.
BAND = 1e-3

#: Overshoot, in jumps, that nobody sees in a figure.
UNSEEN = 0.01

#: The order after which the paper says things of the C1 series.
THREE = 3

#: Orders at which it is seen whether something falls, or stays.
DOUBLED = (10, 20, 40)


@dataclass(frozen=True)
class Finding:
    """Whether something holds, and the numbers that say so.

    Parameters
    ----------
    holds : bool
    numbers : str
        What was measured, in words.
    """

    holds: bool
    numbers: str


def doubled(case: Case, of: str, method: str) -> tuple[list[float], str]:
    """Return what is measured at N = 10, 20 and 40, and the same in words."""
    values = [case.measured(of, method, N) for N in DOUBLED]
    unit = "" if of == "acceleration" else " of the jump"
    words = listed([percent(value, 2) for value in values])
    return values, f"{words}{unit} at N = 10, 20 and 40"
