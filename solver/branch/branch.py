"""A branch of orbits along a parameter, in both directions, through all orders of phases."""

from bisect import bisect
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from ..arrays import Vector
from ..orbit.exact_orbit import ExactOrbit
from ..scenes.case import Case
from ..scenes.orders import Order, OrderedScene, Step
from .bodies.course import BodyCourse
from .course import Course
from .follow import CLOSED, PART, Segment, follow, in_units
from .locate import Found
from .meeting import halved, symmetric
from .orders.change import beyond
from .piece import NoStepError, Piece, Place
from .walk import FLIP, FOLD, MEETS, NEUTRAL, OWN

#: Most segments in each direction.
MOST_SEGMENTS = 60

#: Step from an orbit at an event to one beside it.
ASIDE = 1e-4

#: Most orbits followed back to an event, about; how near to it they must arrive, as a part of
#: the range.
FEW, SAME = 16, 1e-9

#: Why a branch ends where it was interrupted.
STOPPED = "it was followed no further"

Bounds = tuple[float, float]


@dataclass(eq=False)
class BothWays:
    """A branch from one orbit on, in both directions.

    Parameters
    ----------
    index : int
        Of the parameter.
    course : Course or None
        The order of phases of its first orbit, if the case has none of its own.
    back, forth : list of Segment
        Backward and forward, in order from that orbit.
    """

    index: int
    course: Course | None = None
    back: list[Segment] = field(default_factory=list)
    forth: list[Segment] = field(default_factory=list)

    def points(self) -> list[tuple[Piece, Place]]:
        """Return its orbits, from end to end."""
        back, forth = (
            [q for each in way for q in each.points] for way in (self.back, self.forth)
        )
        return [*reversed(back[1:]), *forth] if forth else [*reversed(back)]

    def events(self) -> list[Found]:
        """Return its events, in the same order."""
        back, forth = (
            [q for each in way for q in each.events] for way in (self.back, self.forth)
        )
        return [*reversed(back), *forth]

    def why(self) -> tuple[str, str]:
        """Return why it ends, at its start and at its end."""
        ends = [way[-1].why if way else "" for way in (self.back, self.forth)]
        back, forth = (CLOSED, CLOSED) if CLOSED in ends[:1] else ends
        return back or STOPPED, forth or STOPPED


def course_of(case: Case) -> Course:
    """Return the order of phases of a case of one motion."""
    scene = case.scene
    made = BodyCourse if scene.has_body else Course
    if isinstance(scene, OrderedScene):
        return made(scene.base, scene.order, case.cycles)
    base = scene.whole.fullest
    steps = tuple(Step(base.phases.index(name)) for name in scene.phases)
    return made(base, Order(steps, scene.half_period), case.cycles)


def start_of(orbit: ExactOrbit, index: int, bounds: Bounds) -> tuple[Piece, Place]:
    """Return an exact orbit as a place on a branch, its tangent towards larger parameters.

    Of a symmetric orbit only a half is followed: else two phases would vanish together, and the
    equations would be singular where symmetry is lost.

    Raises
    ------
    NoStepError
        If its equations are singular.
    """
    case, course = orbit.case, course_of(orbit.case)
    own = np.append(course.unknowns(orbit), case.numbers[index])
    piece = Piece.at(course, case, index, bounds, own)
    y = piece.of_number(own)
    half = symmetric(piece, y)
    if half is not None:
        with suppress(ArithmeticError):  # another value may leave no image
            shorter = halved(piece, half, y)
            piece, own = Piece.at(half, case, index, bounds, shorter), shorter
    border, y = np.append(np.zeros(len(own) - 1), 1.0), piece.of_number(own)
    if case.values[piece.name] in bounds:  # there exactly
        y[-1] = np.copysign(1.0, y[-1])
    try:
        place = piece.place(piece.corrected(y, border), border)
    except NoStepError:  # the branch may turn there
        border = piece.singular_vectors(y)[-1]
        place = piece.place(piece.corrected(y, border), border)
    piece.place(place.y, -place.tangent)  # so it can be followed both ways
    return piece, place


def go(
    found: BothWays, start: tuple[Piece, Place], part: float = PART,
    seen: Callable[[float], None] = lambda value: None,
) -> None:  # fmt: skip
    """Follow a branch from an orbit, backward, then forward; add the segments to `found`."""
    piece, place = aside(*start)
    back = piece.place(place.y, -place.tangent)
    for way, first in ((found.back, back), (found.forth, place)):
        there: tuple[Piece, Place] | None = (piece, first)
        end: Found | None = None
        while there is not None and len(way) < MOST_SEGMENTS:
            segment = begun(end, there, part)
            way.append(segment)
            follow(segment, (piece, first), part, seen)
            cut_where_violated(segment)
            end = segment.end
            there = None if end is None else beyond(end)
            if there is not None and len(there[0].course.order.steps) > there[0].course.most:
                segment.why = f"beyond, an orbit has more than {there[0].course.most} phases"
                there = None
        if way[-1].why == CLOSED:
            return


def aside(piece: Piece, place: Place) -> tuple[Piece, Place]:
    """Return an orbit to begin with: one beside the given one if that is at an event.

    A monitor that is zero at the first orbit changes its sign in no step, and the table would
    take derivatives that vanish there by chance for identically zero.
    """
    orbit = place.monitors[len(place.monitors) - OWN :]
    special = (np.abs(orbit[[FOLD, FLIP, MEETS]]) <= NEUTRAL).any()
    for side in (ASIDE, -ASIDE):
        with suppress(ArithmeticError):
            there = piece.stepped(place, side)
            y = there.y
            if abs(y[-1]) > 1 or not piece.admits(there):
                continue
            table = piece.course.table(piece.numbers(y), y[:-1], piece.rows)
            if not np.array_equal(table, piece.table):
                return piece.moved(there)
            return (piece, there) if special else (piece, place)
    return piece, place


def begun(since: Found | None, there: tuple[Piece, Place], part: float) -> Segment:
    """Return a segment from an event on: the orbits from it to the first one found beyond.

    These are found by following the branch back to the event, where the multipliers may change
    without bounds.
    """
    piece, place = there
    segment = Segment([there])
    if since is None:
        return segment
    first = piece, piece.place(place.y, -place.tangent)
    back = Segment([first])
    follow(back, first, part, most=FEW)
    near = SAME * (piece.bounds[1] - piece.bounds[0])
    if back.end is not None and abs(back.end.value - since.value) <= near:
        segment.points = [*reversed(back.points[1:-1]), there]
        segment.events = [*reversed(back.events[:-1])]
    return segment


def cut_where_violated(segment: Segment) -> None:
    """Cut a segment where its orbits violate a condition that is not monitored.

    Such conditions are that a phase does not end sooner, and that no other phase follows.  A
    few orbits are checked, and the first violation between two of them is found by bisection.
    """
    points, last = segment.points, 0
    count = len(points) - (segment.end is not None)  # at its end an orbit is none any more
    asked = {count * part // 4 for part in (1, 2, 3)}
    if segment.end is None:
        asked.add(count - 1)
    for i in sorted(asked):
        if not _violations(*points[i]):
            last = i
            continue
        low = min(last + 1, i)
        first = low + bisect(range(low, i), 0, key=lambda j: len(_violations(*points[j])))
        segment.why = f"beyond, {_violations(*points[first])[0]}"
        del points[first:]
        kept = {id(place) for _, place in points}
        segment.events = [event for event in segment.events if id(event.place) in kept]
        return


def _violations(piece: Piece, place: Place) -> tuple[str, ...]:
    """Return what an orbit violates, in words; nothing where it does not converge."""
    orbit = piece.orbit(place.y)
    return () if orbit is None or not orbit.outcome.converged else orbit.violations


def orbits_at(found: BothWays, value: float) -> Iterator[ExactOrbit]:
    """Yield the orbits of a branch at a value of its parameter, in order.

    Motions of one phase that never ends are left out.
    """
    points = found.points()
    steps = list(pairwise(points)) or [(point, point) for point in points]
    for i, ((before, at), (piece, place)) in enumerate(steps):
        start, end, y = before.value(at.y), piece.value(place.y), place.y.copy()
        if not min(start, end) <= value <= max(start, end) or (start == value and i > 0):
            continue
        if before.course == piece.course and start != end:
            y += (value - end) / (start - end) * (in_units(before, piece, at.y) - y)
        orbit = _exactly(piece, y, value)
        if orbit is not None:
            yield orbit


def _exactly(piece: Piece, y: Vector, value: float) -> ExactOrbit | None:
    """Return the orbit at a value of the parameter from one close by, if it is admissible."""
    if piece.course.endless:
        return None
    case = piece.case.with_value(piece.name, value)
    orbit = piece.course.orbit(case, piece.in_units_of(case, y))
    return orbit if orbit.outcome.converged and orbit.admissible else None
