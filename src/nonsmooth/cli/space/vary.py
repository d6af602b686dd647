"""``--vary NAME=FROM:TO:POINTS``: the position or a parameter of a structure, varied."""

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from ..problems import Problem
from ..values.vary import Vary, parse_vary

if TYPE_CHECKING:
    from nonsmooth.solver.space.attached import Attached

#: Points of a family.
MOST_POINTS = 10_000

EXAMPLE = "position=1/20:1/2:10"


@dataclass(frozen=True)
class Varied:
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


def varied(text: str, log: bool, attached: "Attached") -> Varied:
    """Return what ``--vary`` asks for.

    Raises
    ------
    Problem
        If `text` is not of this form, or one of its values cannot be.
    """
    from nonsmooth.solver.scenes.parameter_error import ParameterError
    from nonsmooth.solver.space.attached import attach

    names = ("position", *attached.values)
    vary = parse_vary(text, log, names, MOST_POINTS, EXAMPLE, Fraction)
    values, place = _values(vary), vary.parameter == "position"
    try:
        structures = tuple(
            attach(attached.structure, value, **attached.values)
            if place
            else attach(
                attached.structure,
                attached.a,
                **{**attached.values, vary.parameter: float(value)},
            )
            for value in values
        )
    except ParameterError as error:
        raise Problem(f"--vary: {error}") from error
    labels = tuple(
        str(v) if place and v.denominator < 1000 else f"{float(v):.6g}" for v in values
    )
    return Varied(vary.flag, tuple(map(float, values)), labels, structures, log)


def _values(vary: Vary[Fraction]) -> list[Fraction]:
    """Return the values, evenly spaced as fractions, or by a constant factor."""
    first, last, steps = vary.first, vary.last, vary.count - 1
    if not vary.log:
        return [first + (last - first) * Fraction(i, steps) for i in range(steps + 1)]
    ratio = float(last) / float(first)
    inside = [Fraction(repr(float(first) * ratio ** (i / steps))) for i in range(1, steps)]
    return [first, *inside, last]
