"""The points of families, wherever they are, in the order in which files have them."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip
from nonsmooth.solver.shortcuts.search.family import Family
from nonsmooth.solver.shortcuts.search.family_points import COLUMNS, POINT, STATUS

from .. import checks
from ..errors import damaged

Array = npt.NDArray[np.void]

#: Points that are read or written at once.
CHUNK = 65_536


@dataclass(frozen=True)
class Head:
    """What families over the same values of a parameter have in common.

    Parameters
    ----------
    belt, parameter, order, c1_terms
        As `Family` has them.
    methods : tuple of str
        The method of each family.
    count : int
        Points of each.
    """

    belt: StickSlip
    parameter: str
    methods: tuple[str, ...]
    order: int
    c1_terms: int
    count: int


@dataclass(frozen=True)
class Points:
    """Families, one after another.

    Parameters
    ----------
    head : Head
        What they have in common.
    read : callable
        ``read(start, stop)`` returns points by their place among all.
    """

    head: Head
    read: Callable[[int, int], Array]

    def chunks(self) -> Iterator[tuple[int, int, Array]]:
        """Yield the number of a method, the number of the first point, and points."""
        count = self.head.count
        for i in range(len(self.head.methods)):
            for start in range(0, count, CHUNK):
                stop = min(start + CHUNK, count)
                yield i, start, self.read(i * count + start, i * count + stop)

    def rows(self) -> Iterator[list[tuple[Any, ...]]]:
        """Yield rows: method, order, status, columns; None where there is no orbit."""
        for i, _, points in self.chunks():
            method, order = self.head.methods[i], self.head.order
            listed = points.tolist()
            rows = [(method, order, STATUS[status], *rest) for status, *rest in listed]
            for k in np.flatnonzero(points["status"]):
                known = rows[k][:5]  # up to the value and its alpha
                rows[k] = (*known, *[None] * (len(rows[k]) - len(known)))
            yield rows


def of_families(families: Sequence[Family]) -> Points:
    """Return the points of families.

    Raises
    ------
    ValueError
        If they are not over the same values of one parameter.
    """
    first = families[0]
    for other in families[1:]:
        same = (other.belt, other.parameter, other.order, other.c1_terms)
        if same != (first.belt, first.parameter, first.order, first.c1_terms) or not (
            np.array_equal(other["value"], first["value"])
        ):
            raise ValueError("families: expected all over the same values of one parameter")
    every = np.concatenate([family.points for family in families])
    methods = tuple(family.method for family in families)
    head = Head(first.belt, first.parameter, methods, first.order, first.c1_terms, len(first))
    return Points(head, lambda start, stop: every[start:stop])


def to_families(path: Path, head: Head, rows: Sequence[Sequence[Any]]) -> list[Family]:
    """Return the families of all rows: method, status, columns; None is NaN.

    Raises
    ------
    FileError
        If rows are missing, or not where they should be.
    """
    if len(rows) != head.count * len(head.methods):
        raise damaged(path, f"{len(rows)} rows of {head.count * len(head.methods)}")
    found = []
    for i, method in enumerate(head.methods):
        points = np.empty(head.count, dtype=POINT)
        own = rows[i * head.count : (i + 1) * head.count]
        if any(row[0] != method for row in own):
            raise damaged(path, f"rows of another method among those of {method}")
        columns = list(zip(*own, strict=True))
        points["status"] = [STATUS.index(status) for status in columns[1]]
        for name, column in zip(COLUMNS, columns[2:], strict=True):
            points[name] = [np.nan if value is None else value for value in column]
        how = (head.parameter, method, head.order, head.c1_terms)
        found.append(Family(head.belt, *how, checked(points)))
    return found


def checked(points: Array) -> Array:
    """Return points, if they can be right.

    Raises
    ------
    NotRightError
        Naming what cannot, and at which value.
    """
    ok = points["status"] == 0
    if not np.isin(points["status"], range(len(STATUS))).all():
        raise checks.NotRightError("a status that there is not")
    of_orbits = points[ok]
    t1, T = of_orbits["t1"], of_orbits["period"]
    parts = of_orbits["stick_fraction"]
    for words, right in (
        ("a period that is not positive", (T > 0) & np.isfinite(T)),
        ("t1 that is not between 0 and the period", (t1 > 0) & (t1 < T)),
        ("a stick fraction that is not t1/period", np.abs(parts * T - t1) <= checks.SAME * T),
        ("an amplitude that is not positive", of_orbits["amplitude"] > 0),
        ("an estimate below 0", ~(of_orbits["estimate_period"] < 0)),
    ):
        if not right.all():
            value = of_orbits["value"][~right][0]
            raise checks.NotRightError(f"{words}, where the parameter is {value:g}")
    return points
