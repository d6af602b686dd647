"""What is written on the command line for numbers: orders, times, ranges."""

import math
import re
from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Generic, TypeVar

from ..nearest import one_of
from .problems import Problem

#: The orders of a sweep that names none, and how several are named.
ORDERS = "1-20"
SEVERAL = "Orders N: numbers and ranges, as 4,8-12 or 10,20,...,80"

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


UNITS = {"us": 1e-6, "ms": 1e-3, "s": 1.0}


def parse_seconds(text: str) -> float:
    """Return a time in seconds; a `Problem` if it is not a positive number and a unit.

    Examples
    --------
    >>> parse_seconds("250us"), parse_seconds("1.5 ms"), parse_seconds("2s")
    (0.00025, 0.0015, 2.0)
    """
    match = re.fullmatch(r"(\d+(?:\.\d*)?(?:e-?\d+)?)\s*(us|ms|s)", text.strip())
    value = float(match[1]) * UNITS[match[2]] if match else 0.0
    if not 0 < value < float("inf"):
        raise Problem(f"--budget: got {text!r}, expected a time like 200us, 1ms or 2s")
    return value


Number = TypeVar("Number", float, Fraction)


@dataclass(frozen=True)
class Vary(Generic[Number]):
    """A parameter and its values, evenly spaced, or by a constant factor if `log`."""

    parameter: str
    first: Number
    last: Number
    count: int
    log: bool

    @property
    def flag(self) -> str:
        """The name of the parameter on the command line."""
        return self.parameter.replace("_", "-")


def parse_vary(
    text: str, log: bool, names: Collection[str], most: int | None, example: str,
    number: Callable[[str], Number], option: str = "--vary",
) -> Vary[Number]:  # fmt: skip
    """Return what ``--vary``, or another option, asks for, of the parameters with these names.

    At `most` so many points; without that none are given, and `Vary.count` is 0.  A `Problem`,
    with an example, is raised if `text` is not of this form, or its numbers make no range.

    Examples
    --------
    >>> parse_vary("my-gap=0.1:10:3", True, ["my_gap"], 100, "", float)
    Vary(parameter='my_gap', first=0.1, last=10.0, count=3, log=True)
    """
    form = "NAME=FROM:TO" if most is None else "NAME=FROM:TO:POINTS"
    expected = f"expected {form}, such as {example}"
    name, _, span = text.partition("=")
    parts = [part.strip() for part in span.split(":")]
    if len(parts) != (2 if most is None else 3):
        raise Problem(f"{option}: got {text!r}, {expected}")
    parameter = name.strip().replace("-", "_")
    if parameter not in names:
        listed = one_of(name.replace("_", "-"), [flag.replace("_", "-") for flag in names])
        raise Problem(f"{option}: unknown parameter {name!r}, expected {listed}")
    try:
        first, last = number(parts[0]), number(parts[1])
        low, high = sorted((float(first), float(last)))
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise Problem(f"{option}: got {text!r}, {expected}") from error
    if not (math.isfinite(low) and math.isfinite(high) and first != last):
        raise Problem(f"{option}: got {text!r}, expected two different numbers as the ends")
    if most is None:
        return Vary(parameter, first, last, 0, log)
    if not is_whole(parts[2]) or not 2 <= int(parts[2]) <= most:
        raise Problem(
            f"{option}: got {parts[2]!r} points, expected a whole number from 2 to {most}"
        )
    if log and not low > 0:
        raise Problem(f"--log: got an end of {text!r} that is not above 0")
    return Vary(parameter, first, last, int(parts[2]), log)


def values_of(vary: Vary[Number]) -> list[Number]:
    """Return the values of a parameter; fractions are spaced evenly without rounding.

    Examples
    --------
    >>> values_of(Vary("my_gap", 0.1, 10.0, 3, True))
    [0.1, 1.0, 10.0]
    >>> values_of(Vary("position", Fraction(1, 3), Fraction(1, 2), 3, False))
    [Fraction(1, 3), Fraction(5, 12), Fraction(1, 2)]
    """
    number, steps = type(vary.first), vary.count - 1
    values: list[Number] = [vary.first]
    for i in range(1, steps):
        if vary.log:
            between = _part_of_the_way(float(vary.first), float(vary.last), i / steps)
            values.append(number(repr(between)))
        else:
            values.append(vary.first + i * ((vary.last - vary.first) / steps))
    values.append(vary.last)
    return values


def _part_of_the_way(first: float, last: float, part: float) -> float:
    """Return the number at a part of the way by a constant factor, whatever that is."""
    factor = last / first
    if 0 < factor < math.inf:
        return float(first * factor**part)
    return float(first ** (1 - part) * last**part)
