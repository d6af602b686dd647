"""A branch of orbits along a parameter, in both directions, through all orders of phases."""

from bisect import bisect
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from ..existence.reasons import WithoutSwitches
from ..kernels.start import RoughTimes
from ..orbit.exact_orbit import ExactOrbit, from_times
from ..scenes.case import Case
from ..scenes.ordered import placed
from ..scenes.orders import Order, Step, image
from .across import across, after, followed_back
from .bodies.course import BodyCourse
from .course import Course
from .events.locate import Found
from .follow import CLOSED, NO_STEP, PART, Segment, follow, in_units
from .meeting import halved, symmetric
from .orders.change import beyond, why_none
from .piece import Piece
from .place import NoStepError, Place
from .walk import FLIP, FOLD, MEETS, NEUTRAL, OWN

#: Most segments in each direction; how many ever shorter ones are seen as without end.
MOST_SEGMENTS, DWINDLING = 60, 4

#: Step from an orbit at an event to one beside it.
ASIDE = 1e-4

#: How near to an event the orbits that are followed back to it must arrive, as a part of the
#: range.
SAME = 1e-9

#: Difference of durations, as a part of the cell, by which an orbit is another one.
DIFFERENT = 1e-6

#: Part of a range at which no parameter is special by chance.
GENERIC = 0.437

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
            [q for segment in way for q in segment.points] for way in (self.back, self.forth)
        )
        return [*reversed(back[1:]), *forth] if forth else [*reversed(back)]

    def events(self) -> list[Found]:
        """Return its events, in the same order."""
        back, forth = (
            [q for segment in way for q in segment.events] for way in (self.back, self.forth)
        )
        return [*reversed(back), *forth]

    def why(self) -> tuple[str, str]:
        """Return why it ends, at its start and at its end."""
        ends = [way[-1].why if way else "" for way in (self.back, self.forth)]
        back, forth = (CLOSED, CLOSED) if CLOSED in ends[:1] else ends
        return back or STOPPED, forth or STOPPED


def course_of(case: Case) -> Course:
    """Return the order of phases of a case of one motion."""
    kind = BodyCourse if case.scene.has_body else Course
    return kind(*placed(case.scene), case.cycles)


def start_of(
    orbit: ExactOrbit | WithoutSwitches, index: int, bounds: Bounds
) -> tuple[Piece, Place]:
    """Return an exact orbit as a place on a branch, its tangent towards larger parameters.

    Of a symmetric orbit only a half is followed: else two phases would vanish together, and the
    equations would be singular where symmetry is lost.  The whole is, where the parameter
    makes the oscillator unsymmetric.

    Raises
    ------
    NoStepError
        If its equations are singular: at a value there are orbits without end.
    """
    course = course_of(orbit.case)
    if isinstance(orbit, ExactOrbit) and not _lasts(course, orbit, index, bounds):
        orbit = _whole(orbit)
    case, course = orbit.case, course_of(orbit.case)
    if isinstance(orbit, WithoutSwitches):
        step = Step(course.base.phases.index(orbit.phase))
        course = replace(course, order=Order((step,)), endless=True, units=case.units)
        z = course.for_ever(case.numbers)
    else:
        z = course.unknowns(orbit)
    unknowns = np.append(z, case.numbers[index])
    piece = Piece.at(course, case, index, bounds, unknowns)
    y = piece.of_number(unknowns)
    half = symmetric(piece, y)
    if half is not None and _lasts(half, orbit, index, bounds):
        with suppress(ArithmeticError):  # another value may leave no image
            half_unknowns = halved(piece, half, y)
            piece, unknowns = Piece.at(half, case, index, bounds, half_unknowns), half_unknowns
    border, y = np.append(np.zeros(len(unknowns) - 1), 1.0), piece.of_number(unknowns)
    if case.values[piece.name] in bounds:  # there exactly
        y[-1] = np.copysign(1.0, y[-1])
    try:
        place = piece.place(piece.corrected(y, border), border)
    except NoStepError:  # the branch may turn there
        border = piece.singular_vectors(y)[-1]
        place = piece.place(piece.corrected(y, border), border)
        if abs(place.y[-1] - y[-1]) > ASIDE:  # another one: this orbit is not isolated
            raise NoStepError from None
    piece.place(place.y, -place.tangent)  # so it can be followed both ways
    return piece, place


def _lasts(
    course: Course, orbit: ExactOrbit | WithoutSwitches, index: int, bounds: Bounds
) -> bool:
    """Whether an order of phases is one elsewhere in a range, too: see `Course.exists`."""
    if not course.order.half_period:
        return True
    inside = bounds[0] + GENERIC * (bounds[1] - bounds[0])
    return course.exists(orbit.case.with_value(orbit.case.scene.parameters[index].name, inside))


def _whole(orbit: ExactOrbit) -> ExactOrbit:
    """Return a symmetric orbit as one whose cell is the whole period.

    Raises
    ------
    NoStepError
        If there is none.
    """
    case, half = orbit.case, course_of(orbit.case)
    cell = half.declares(case.numbers)
    images = tuple(filter(None, (image(cell, step) for step in half.order.steps)))
    course = replace(half, order=Order(half.order.steps + images))
    times = tuple(map(float, orbit.cell_durations)) * 2
    whole = from_times(course.case(case), RoughTimes(times, orbit.angle, "both of its halves"))
    if not whole.outcome.converged:
        raise NoStepError
    return whole


def go(
    branch: BothWays, start: tuple[Piece, Place], part: float = PART,
    progress: Callable[[float], None] = lambda value: None, least: float = 0.0,
) -> None:  # fmt: skip
    """Follow a branch from an orbit, backward, then forward; add the segments to `branch`.

    It ends where ever shorter segments follow each other, all shorter than the part `least` of
    the range.
    """
    piece, place = aside(*start)
    back = piece.place(place.y, -place.tangent)
    for segments, first in ((branch.back, back), (branch.forth, place)):
        orbit: tuple[Piece, Place] | None = (piece, first)
        end: Found | None = None
        while orbit is not None and len(segments) < MOST_SEGMENTS:
            segment = begun(end, orbit, part)
            segments.append(segment)
            follow(segment, (piece, first), part, progress)
            cut_where_violated(segment)
            orbit = across(segment, part) if segment.why == NO_STEP else None
            end = segment.end
            if end is not None and orbit is None and _dwindle(segments, least):
                segment.why = "beyond, orders of phases last over ever shorter ranges"
                break
            if end is not None and orbit is None:
                orbit = beyond(end) or after(end, part)
            if end is not None and orbit is None:
                segment.why = f"{end.kind}, beyond which {why_none(end)}"
            if orbit is not None and len(orbit[0].course.order.steps) > orbit[0].course.most:
                segment.why = f"beyond, an orbit has more than {orbit[0].course.most} phases"
                orbit = None
        if orbit is not None:
            segments[-1].why = f"{MOST_SEGMENTS} sequences of phases are the most of a branch"
        if segments[-1].why == CLOSED:
            return


def _dwindle(segments: Sequence[Segment], least: float) -> bool:
    """Whether the last `DWINDLING` segments are ever shorter, all shorter than `least`."""
    last = segments[-DWINDLING:]
    widths = [segment.width for segment in last]
    falls = all(after < before for before, after in pairwise(widths))
    return len(last) == DWINDLING and falls and widths[0] < least


def aside(piece: Piece, place: Place) -> tuple[Piece, Place]:
    """Return an orbit to begin with: one beside the given one if that is at an event.

    A monitor that is zero at the first orbit changes its sign in no step, and the table would
    take derivatives that vanish there by chance for identically zero.
    """
    orbit = place.monitors[len(place.monitors) - OWN :]
    special = (np.abs(orbit[[FOLD, FLIP, MEETS]]) <= NEUTRAL).any()
    for distance in (ASIDE, -ASIDE):
        with suppress(ArithmeticError):
            beside = piece.stepped(place, distance)
            y = beside.y
            if abs(y[-1]) > 1 or not piece.admits(beside):
                continue
            table = piece.course.table(piece.numbers(y), y[:-1], piece.rows)
            if not np.array_equal(table, piece.table):
                return piece.moved(beside)
            return (piece, beside) if special else (piece, place)
    return piece, place


def begun(since: Found | None, orbit: tuple[Piece, Place], part: float) -> Segment:
    """Return a segment from an event on: the orbits from it to the first one found beyond.

    These are found by following the branch back to the event, where the multipliers may change
    without bounds.
    """
    piece, segment = orbit[0], Segment([orbit])
    if since is None:
        return segment
    back = followed_back(orbit, part)
    tolerance = SAME * (piece.bounds[1] - piece.bounds[0])
    if back.end is not None and abs(back.end.value - since.value) <= tolerance:
        segment.points = [*reversed(back.points[1:-1]), orbit]
        segment.events = [*reversed(back.events[:-1])]
    return segment


def cut_where_violated(segment: Segment) -> None:
    """Cut a segment where its orbits violate a condition that is not monitored.

    Such conditions are that a phase does not end sooner, and that no other phase follows.  A
    few orbits are checked, and the first violation between two of them is found by bisection.
    """
    points, admissible = segment.points, 0
    count = len(points) - (segment.end is not None)  # at its end an orbit is none any more
    checked = {count * part // 4 for part in (1, 2, 3)}
    if segment.end is None:
        checked.add(count - 1)
    for i in sorted(checked):
        if not _violations(*points[i]):
            admissible = i
            continue
        low = min(admissible + 1, i)
        first = low + bisect(range(low, i), 0, key=lambda j: len(_violations(*points[j])))
        segment.why = f"beyond, {_violations(*points[first])[0]}"
        del points[first:]
        remaining = {id(place) for _, place in points}
        segment.events = [event for event in segment.events if id(event.place) in remaining]
        return


def _violations(piece: Piece, place: Place) -> tuple[str, ...]:
    """Return what an orbit violates, in words; nothing where it does not converge.

    It must be the one to which its own equations lead from there.
    """
    orbit = piece.orbit(place.y)
    if orbit is None or not orbit.outcome.converged:
        return ()
    durations = piece.durations(place.y) * piece.case.units.time
    off = np.abs(durations - orbit.durations[: len(durations)]).max()
    if off > DIFFERENT * durations.sum():
        return ("its durations are not those of an orbit",)
    return orbit.violations


def orbits_at(branch: BothWays, value: float) -> Iterator[ExactOrbit]:
    """Yield the orbits of a branch at a value of its parameter, in order.

    Motions of one phase that never ends are left out.
    """
    points = branch.points()
    steps = list(pairwise(points)) or [(point, point) for point in points]
    for i, ((before, at), (piece, place)) in enumerate(steps):
        start, end, y = before.value(at.y), piece.value(place.y), place.y.copy()
        if not min(start, end) <= value <= max(start, end) or (start == value and i > 0):
            continue
        if before.course == piece.course and start != end:
            y += (value - end) / (start - end) * (in_units(before, piece, at.y) - y)
        orbit = piece.orbit(y, value)
        if orbit is not None and orbit.outcome.converged and orbit.admissible:
            yield orbit


def lasts_at(branch: BothWays, phase: str, value: float) -> bool:
    """Whether a branch has the motion without switches of a phase at a value."""
    points = [(q.value(place.y), q.course) for q, place in branch.points()]
    return any(
        course.endless
        and course.order.steps[0].called(course.base.phases) == phase
        and min(start, end) <= value <= max(start, end)
        for (start, course), (end, _) in pairwise(points)
    )
