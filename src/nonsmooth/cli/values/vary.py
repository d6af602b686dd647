"""``--vary NAME=FROM:TO:POINTS``: the parameter of a sweep, and its values."""

import math
from collections.abc import Collection
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..problems import Problem
from .orders import is_whole

if TYPE_CHECKING:
    from nonsmooth.solver.arrays import Vector


@dataclass(frozen=True)
class Vary:
    """A parameter and its values, evenly spaced, or by a constant factor if `log`."""

    parameter: str
    first: float
    last: float
    count: int
    log: bool

    @property
    def flag(self) -> str:
        """The name of the parameter on the command line."""
        return self.parameter.replace("_", "-")

    def values(self, start: int, end: int) -> "Vector":
        """Return the values from number `start` up to, not including, number `end`."""
        import numpy as np

        numbers, steps = np.arange(start, end), self.count - 1
        part = numbers / steps
        if not self.log:
            found = self.first + numbers * ((self.last - self.first) / steps)
        elif 0 < self.last / self.first < math.inf:
            found = self.first * (self.last / self.first) ** part
        else:
            found = self.first ** (1 - part) * self.last**part
        found[numbers == steps] = self.last
        return np.asarray(found, dtype=np.float64)


def parse_vary(text: str, log: bool, names: Collection[str], most: int, example: str) -> Vary:
    """Return what ``--vary`` asks for.

    Parameters
    ----------
    text : str
        As typed.
    log : bool
        Whether the values are spaced by a constant factor.
    names : collection of str
        The parameters that there are.
    most : int
        Most points.
    example : str
        One that is right, for the message.

    Examples
    --------
    >>> parse_vary("my-gap=0.1:10:3", True, ["my_gap"], 100, "").values(0, 3)
    array([ 0.1,  1. , 10. ])

    Raises
    ------
    Problem
        If `text` is not of this form, or its numbers make no range.
    """
    expected = f"expected NAME=FROM:TO:POINTS, such as {example}"
    name, _, rest = text.partition("=")
    parts = rest.split(":")
    if len(parts) != 3:
        raise Problem(f"--vary: got {text!r}, {expected}")
    parameter = name.strip().replace("-", "_")
    if parameter not in names:
        known = ", ".join(flag.replace("_", "-") for flag in names)
        raise Problem(f"--vary: unknown parameter {name!r}, expected one of {known}")
    try:
        first, last = float(parts[0]), float(parts[1])
    except ValueError as error:
        raise Problem(f"--vary: got {text!r}, {expected}") from error
    if not (math.isfinite(first) and math.isfinite(last) and first != last):
        raise Problem(f"--vary: got {text!r}, expected two different numbers as the ends")
    if not is_whole(parts[2].strip()) or not 2 <= int(parts[2]) <= most:
        raise Problem(
            f"--vary: got {parts[2]!r} points, expected a whole number from 2 to {most}"
        )
    if log and not (first > 0 and last > 0):
        raise Problem(f"--log: got an end of {text!r} that is not above 0")
    return Vary(parameter, first, last, int(parts[2]), log)
