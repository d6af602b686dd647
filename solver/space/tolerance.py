"""The lowest order whose modes are all within a tolerance."""

from collections.abc import Callable
from typing import TypeVar

Found = TypeVar("Found")

#: Orders that are tried, in this sequence.
TRIED = (*range(1, 17), 20, 24, 28, 32, 40, 48, 64, 80, 96, 128, 192, 256, 384, 512, 1024, 4096)


class ToleranceNotMet(ValueError):  # noqa: N818  (named like the other errors of the package)
    """No order of a method brings all modes within the tolerance."""


def to_tolerance(
    at_order: Callable[[int], Found],
    off: Callable[[Found], float],
    orders: range,
    tol: float,
    name: str,
) -> Found:
    """Return the result of the lowest order of `TRIED` that is within a tolerance.

    Parameters
    ----------
    at_order : callable
        Result of an order; raises a ValueError if it has fewer modes than wanted.
    off : callable
        Error of a result.
    orders : range
        From the order that surely has enough modes to the highest.
    tol : float
    name : str
        Name of the method, for the message.

    Raises
    ------
    ToleranceNotMet
        If none is within it.
    """
    last, order = None, 0
    for candidate in (*(q for q in TRIED if q < orders[-1]), orders[-1]):
        try:
            outcome = at_order(candidate)
        except ValueError:
            if candidate < orders[0]:
                continue  # fewer modes than wanted
            raise
        last, order = off(outcome), candidate
        if last <= tol:
            return outcome
    reached = "" if last is None else f"; order {order} reaches {last:.1e}"
    raise ToleranceNotMet(f"tol: got {tol:g}, no order of {name} is within it{reached}")
