"""``--vary NAME=FROM:TO:POINTS``: the position or a parameter of a structure, varied."""

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from ..problems import Problem
from ..values.orders import is_whole

if TYPE_CHECKING:
    from nonsmooth.solver.space.attached import Attached

#: Points of a family.
MOST_POINTS = 10_000

EXPECTED = "expected NAME=FROM:TO:POINTS, such as position=1/20:1/2:10"


@dataclass(frozen=True)
class Vary:
    """A parameter, its values, and the structure with each of them.

    Parameters
    ----------
    name : str
        As its flag has it.
    values : tuple of float
    labels : tuple of str
        The same for a reader.
    structures : tuple of Attached
    log : bool
    """

    name: str
    values: tuple[float, ...]
    labels: tuple[str, ...]
    structures: "tuple[Attached, ...]"
    log: bool


def parse_vary(text: str, log: bool, attached: "Attached") -> Vary:
    """Return what ``--vary`` asks for.

    Raises
    ------
    Problem
        If `text` is not of this form, or one of its values cannot be.
    """
    from nonsmooth.solver.scenes.parameter_error import ParameterError
    from nonsmooth.solver.space.attached import attach

    name, _, rest = text.partition("=")
    parts = [part.strip() for part in rest.split(":")]
    key = name.strip().replace("-", "_")
    known = ("position", *attached.values)
    if len(parts) != 3:
        raise Problem(f"--vary: got {text!r}, {EXPECTED}")
    if key not in known:
        names = ", ".join(q.replace("_", "-") for q in known)
        raise Problem(f"--vary: unknown parameter {name!r}, expected one of {names}")
    values = _values(text, parts, log)
    try:
        structures = tuple(
            attach(attached.structure, value, **attached.values)
            if key == "position"
            else attach(
                attached.structure, attached.a, **{**attached.values, key: float(value)}
            )
            for value in values
        )
    except ParameterError as error:
        raise Problem(f"--vary: {error}") from error
    labels = tuple(
        str(v) if key == "position" and v.denominator < 1000 else f"{float(v):.6g}"
        for v in values
    )
    flag = key.replace("_", "-")
    return Vary(flag, tuple(map(float, values)), labels, structures, log)


def _values(text: str, parts: list[str], log: bool) -> list[Fraction]:
    """Return the values, evenly spaced as fractions, or by a constant factor."""
    try:
        first, last = Fraction(parts[0]), Fraction(parts[1])
        ends = float(first), float(last)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise Problem(f"--vary: got {text!r}, {EXPECTED}") from error
    if not all(map(math.isfinite, ends)) or first == last:
        raise Problem(f"--vary: got {text!r}, expected two different numbers as the ends")
    if not is_whole(parts[2]) or not 2 <= int(parts[2]) <= MOST_POINTS:
        expected = f"a whole number from 2 to {MOST_POINTS}"
        raise Problem(f"--vary: got {parts[2]!r} points, expected {expected}")
    steps = int(parts[2]) - 1
    if not log:
        return [first + (last - first) * Fraction(i, steps) for i in range(steps + 1)]
    if not min(ends) > 0:
        raise Problem(f"--log: got an end of {text!r} that is not above 0")
    ratio = ends[1] / ends[0]
    inside = [Fraction(repr(ends[0] * ratio ** (i / steps))) for i in range(1, steps)]
    return [first, *inside, last]
