"""Lists of methods and orders on the command line."""

from collections.abc import Iterable

from .equations import METHODS
from .problems import Problem


def parse_orders(text: str) -> list[int]:
    """Return the orders that `text` names, ascending, each once.

    Examples
    --------
    >>> parse_orders("1-4,10")
    [1, 2, 3, 4, 10]

    Raises
    ------
    Problem
        If a part is neither a number nor a range from a lower to a higher one.
    """
    orders: set[int] = set()
    for part in text.split(","):
        orders.update(_range(part.strip(), text))
    return sorted(orders)


def _range(part: str, text: str) -> Iterable[int]:
    expected = "expected numbers from 1 and ranges, like 1-40 or 1,3,10-20"
    first, dash, last = part.partition("-")
    if not (first.isdecimal() and (last.isdecimal() or not dash)):
        raise Problem(f"--orders: got {text!r}, {expected}")
    low, high = int(first), int(last or first)
    if low < 1:
        raise Problem(f"--orders: got {text!r}, expected orders not below 1")
    if high < low:
        raise Problem(f"--orders: got {text!r}, expected ranges from low to high, not {part}")
    if high - low >= 10**6:
        raise Problem(f"--orders: got {text!r}, expected less than a million orders")
    return range(low, high + 1)


def parse_methods(text: str) -> list[str]:
    """Return the methods that `text` names, in its order, each once.

    Raises
    ------
    Problem
        If one of them is unknown.
    """
    names = list(dict.fromkeys(part.strip() for part in text.split(",")))
    for name in names:
        if name not in METHODS:
            known = ", ".join(METHODS)
            raise Problem(f"--methods: got {name!r}, expected some of {known}")
    return names
