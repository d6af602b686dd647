"""Lists of orders on the command line."""

from collections.abc import Iterable

from ..problems import Problem

#: Most figures of a whole number.
MOST_FIGURES = 18


def is_whole(text: str) -> bool:
    """Return whether `text` is a whole number, and of a length that makes sense."""
    return text.isdecimal() and len(text) <= MOST_FIGURES


def parse_orders(text: str) -> list[int]:
    """Return the orders that `text` names, ascending, each once.

    A `Problem` is raised if a part is neither a number nor a range from a lower to a higher
    one.

    Examples
    --------
    >>> parse_orders("1-4,10")
    [1, 2, 3, 4, 10]
    >>> parse_orders("10,100,...,10000")
    [10, 100, 1000, 10000]
    """
    orders: set[int] = set()
    parts = [part.strip() for part in text.split(",")]
    for index, part in enumerate(parts):
        if part == "...":
            orders.update(_between(parts[:index][-2:], parts[index + 1 :][:1], text))
        else:
            orders.update(_range(part, text))
    return sorted(orders)


def _between(before: list[str], after: list[str], text: str) -> Iterable[int]:
    """Return the orders that ``...`` stands for: by the factor of the two before it."""
    neighbours = [*before, *after]
    expected = 'expected "..." between numbers a, b and c, where b/a multiplies on to c'
    problem = Problem(f"--orders: got {text!r}, {expected}")
    if len(neighbours) != 3 or not all(map(is_whole, neighbours)):
        raise problem
    first, second, last = map(int, neighbours)
    factor = second // first if first else 0
    if factor < 2 or factor * first != second:
        raise problem
    orders = []
    while second < last:
        orders.append(second)
        second *= factor
    if second != last:
        raise problem
    return orders


def _range(part: str, text: str) -> Iterable[int]:
    expected = "expected numbers from 1 and ranges, like 1-40 or 1,3,10-20"
    first, dash, last = part.partition("-")
    if not (is_whole(first) and (is_whole(last) or not dash)):
        raise Problem(f"--orders: got {text!r}, {expected}")
    low, high = int(first), int(last or first)
    if low < 1:
        raise Problem(f"--orders: got {text!r}, expected orders not below 1")
    if high < low:
        raise Problem(f"--orders: got {text!r}, expected ranges from low to high, not {part}")
    if high - low >= 10**6:
        raise Problem(f"--orders: got {text!r}, expected less than a million orders")
    return range(low, high + 1)
