"""Branches along some lines of a map: the orbits and events that it starts from."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..arrays import Matrix, Vector
from ..branch.branch import BothWays
from ..branch.course import Course, Row
from ..branch.events.locate import Found
from ..branch.every_way import every_way
from ..branch.piece import Piece
from ..branch.place import Place
from ..scenes.case import Case
from .plane import Bounds

#: Values on a line at which orbits are looked for.
VALUES = 5

#: The part of a cell of the map below which ever shorter orders of phases are not followed: a
#: cascade of impacts has any number of them.
LEAST = 1 / 64

#: What vanishes at an event: a form and where; or None and which of the monitors, counted from
#: the last.
Monitor = tuple[Row | None, int]


@dataclass(frozen=True)
class Stretch:
    """Orbits of one order of phases on a line, and the case of the one in the middle.

    Each row of `points`, shape (m, n + 2), has the unknowns and both parameters, in SI units.
    """

    course: Course
    case: Case
    points: Matrix

    @property
    def middle(self) -> Vector:
        """The unknowns of the orbit in the middle."""
        return self.points[len(self.points) // 2, :-2]


@dataclass(frozen=True)
class Happening:
    """An event on a line: its kind, and its orbit as in `Stretch`.

    The parameter number `across` does not vary on the line.
    """

    kind: str
    course: Course
    monitor: Monitor
    point: Vector
    across: int


Line = tuple[list[Stretch], list[Happening]]


def line_of(
    case: Case, names: tuple[str, str], bounds: Bounds, across: int, count: int
) -> Line:
    """Return the orbits and the events on a line.

    Parameters
    ----------
    case : Case
        With the value of the parameter that is constant on the line.
    across : int
        The number of that parameter, 0 or 1.
    count : int
        How many values of the other one the map has.
    """
    along = 1 - across
    stretches: list[Stretch] = []
    happened: list[Happening] = []
    ways = every_way(
        case, names[along], bounds[along], VALUES, {"branch-point"}, least=LEAST / count
    )
    for followed in ways:
        if followed.course is None or followed.course.cycles == case.cycles:
            stretches += _stretches(case.values[names[across]], followed, across)
            happened += _happenings(case.values[names[across]], followed, across)
    return stretches, happened


def _stretches(value: float, both: BothWays, across: int) -> Iterator[Stretch]:
    for segment in (*both.back, *both.forth):
        points = segment.points[1:-1] or segment.points[:1]  # something happens at the ends
        if points:
            piece, place = points[len(points) // 2]
            middle = piece.case.with_value(piece.name, piece.value(place.y))
            rows = [_point(value, piece, place, across) for piece, place in points]
            yield Stretch(piece.course, middle, np.array(rows))


def _happenings(value: float, both: BothWays, across: int) -> Iterator[Happening]:
    for event in both.events():
        if event.monitor >= 0:
            point = _point(value, event.piece, event.place, across)
            yield Happening(event.kind, event.piece.course, monitor_of(event), point, across)


def _point(value: float, piece: Piece, place: Place, across: int) -> Vector:
    """Return the unknowns of an orbit and both parameters, in SI units."""
    parameters = [piece.value(place.y), value]
    y: Vector = place.y[:-1] * piece.sizes[:-1]
    return np.concatenate([y, parameters if across == 1 else parameters[::-1]])


def monitor_of(event: Found) -> Monitor:
    """Return what vanishes at an event."""
    rows, i = event.piece.rows, event.monitor
    if i < 3 * len(rows):
        return rows[i // 3], i % 3
    return None, i - len(event.place.monitors)
