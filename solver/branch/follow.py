"""Follow a branch of one order of phases to its end, or to where the order changes."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field

import numpy as np

from ..arrays import Vector
from ..scenes.parameter_error import ParameterError
from .along import EQUAL
from .course import Course
from .events.in_step import EDGE, events_in, in_turn, shows_event
from .events.locate import Found, estimated
from .meeting import meeting, met, shorter
from .orders.change import begun_anew
from .piece import Piece, unit_of
from .place import NoStepError, Place
from .walk import EVENT, GROWN, LEAST_STEP, MEETS, OWN, STUCK, TURN

#: First step, in scaled coordinates; most steps of one walk.
FIRST, ROOM = 0.01, 32

#: Most of the range of the parameter in a step, and most orbits of a branch.
PART, MOST_POINTS = 1 / 80, 20_000

#: Distance from the first orbit, in steps, within which a branch may be closed.
NEAR = 1.0

#: Steps tried across a place where branches meet.
LEAPS = 1e-4, 1e-3, 1e-2, 0.1

#: How far ahead, as a part of the range, the parameters are checked where no step succeeds.
AHEAD = 1e-6

#: Why a walk is cut: it has come back to the first orbit of the branch.
CLOSES = -1

#: Why a branch ends.
CLOSED, RANGE = "the branch is closed", "the end of the range"
TWICE = "the orbit becomes one of half its period"
NO_STEP = "the step cannot get smaller"
GROWS = "the orbit grows beyond all bounds"

#: Size of an unknown, without units, at which an orbit is said to grow beyond all bounds; and
#: of a state where no step succeeds.
MOST, MUCH = 1e8, 1e4


@dataclass(eq=False)
class Segment:
    """The orbits of one order of phases along a branch, in order, and the events among them."""

    points: list[tuple[Piece, Place]]
    events: list[Found] = field(default_factory=list)
    why: str = ""

    @property
    def end(self) -> Found | None:
        """The event at its end at which the order of phases changes, if there is one."""
        return self.events[-1] if self.events and self.events[-1].changes else None

    @property
    def width(self) -> float:
        """The part of the range of the parameter over which its orbits lie."""
        values = [piece.value(place.y) for piece, place in self.points]
        return float(np.ptp(values) / np.ptp(self.points[0][0].bounds))


def follow(
    segment: Segment, first: tuple[Piece, Place],
    part: float = PART, progress: Callable[[float], None] = lambda value: None,
    most: int = MOST_POINTS,
) -> None:  # fmt: skip
    """Follow a branch from the last orbit of a segment on, along its tangent.

    Parameters
    ----------
    segment : Segment
        It gets the orbits and events.
    first : (Piece, Place)
        The first orbit of the branch: back there it is closed.
    part : float
        Largest step, as a part of the range of the parameter.
    progress : callable
        Called with the parameter of each orbit.
    most : int
        Most orbits.
    """
    (piece, place), length = segment.points[-1], FIRST
    longest = part * (piece.bounds[1] - piece.bounds[0])
    half, origins = shorter(piece), begun_anew(*first, piece.course)
    if piece.ends_at(place.y) and place.y[-1] * place.tangent[-1] > 0:
        segment.why = RANGE
    while len(segment.points) < most and not segment.why:
        places, lengths, why, length = piece.walk(place, length, longest, ROOM)
        begins = segment.points[-1] == first
        closed = _closed(first[0], origins, piece, [place, *places], lengths, begins)
        if closed is not None:
            places, lengths, why = closed
        if half is not None and _meets(segment, half, piece, [place, *places], lengths, why):
            return
        smooth = places[:-1] if why == EVENT else places
        segment.points += [(piece, each) for each in smooth]
        place = smooth[-1] if smooth else place  # of this piece: it may just have moved
        progress(piece.value(place.y))
        if why == CLOSES:
            segment.why = CLOSED
        elif why == EVENT:
            try:
                piece, place = _pass(segment, piece, place, places[-1], float(lengths[-1]))
                if closed is not None and place is places[-1]:
                    segment.why = CLOSED
            except ArithmeticError:
                length = float(lengths[-1]) / 2
                why = why if length > LEAST_STEP else STUCK
        elif why == GROWN:
            try:
                piece, place = piece.moved(place)
            except ArithmeticError:
                segment.why = _why_stuck(piece, place)
            if np.abs(place.y).max() > MOST:
                segment.why = GROWS
        if why == STUCK:
            (piece, place), length = _leapt(segment, piece, place), FIRST
    segment.why = segment.why or f"{most} orbits are the most that a branch has"


def _leapt(segment: Segment, piece: Piece, place: Place) -> tuple[Piece, Place]:
    """Leap over a place where branches meet, next to which no step succeeds.

    Returns where the branch goes on.  Without such a place, the segment gets why it ends.
    """
    for length in LEAPS:
        with suppress(ArithmeticError):
            after = piece.stepped(place, length)
            signs = np.sign([q.monitors[len(q.monitors) - OWN + MEETS] for q in (place, after)])
            if signs[0] != signs[1] and place.tangent @ after.tangent >= TURN:
                return _pass(segment, piece, place, after, length)
    segment.why = _why_stuck(piece, place)
    return piece, place


def _why_stuck(piece: Piece, place: Place) -> str:
    """Return why no step succeeds: what the parameter or the orbit is ahead, if known."""
    at, edge = piece.value(place.y), piece.bounds[int(place.tangent[-1] > 0)]
    if abs(at - edge) <= EQUAL * abs(edge):
        return RANGE
    unit, parameters = unit_of(piece.case, piece.index), piece.case.numbers
    reach = AHEAD * float(np.copysign(piece.bounds[1] - piece.bounds[0], place.tangent[-1]))
    ahead = at + reach
    if piece.bounds[0] <= ahead <= piece.bounds[1]:
        numbers = (*parameters[: piece.index], ahead / unit, *parameters[piece.index + 1 :])
        try:
            piece.course.cell(numbers)
        except ParameterError as error:
            return f"beyond, {error}"
    return GROWS if np.abs(place.y[: piece.along.before]).max(initial=0.0) > MUCH else NO_STEP


def _meets(
    segment: Segment, half: Course, piece: Piece, places: list[Place], lengths: Vector, why: int
) -> bool:
    """Add where the branch meets that of half the phases to a segment; whether it does.

    Not if the order of phases changes before.
    """
    encounter = met(piece, places)
    if encounter is None:
        return False
    i, part = encounter
    before, after = places[i : i + 2]
    if why == EVENT and i + 2 == len(places):
        length = float(lengths[i])
        with suppress(NoStepError):
            events = events_in(piece, before, after, length)
            if any(event and event.changes and at < part * length for at, event in events):
                return False
    segment.points += [(piece, place) for place in places[1 : i + 1]]
    segment.events.append(meeting(piece, half, before, after))
    segment.why = TWICE
    return True


def _pass(
    segment: Segment, piece: Piece, before: Place, after: Place, length: float
) -> tuple[Piece, Place]:
    """Add the events of a step to a segment; return where the branch goes on behind them.

    Raises
    ------
    NoStepError
        If an event is not located.
    """
    points, events, why = [], [], ""
    for event in in_turn(events_in(piece, before, after, length)):
        points.append((piece, event.place))
        if event.kind == EDGE:
            why = RANGE if piece.ends_at(event.place.y) else ""
            points[-1] = points[-1] if why else piece.moved(event.place)
            break
        events.append(estimated(event, after, length))
        if event.changes:
            why = event.kind
            break
    else:
        points.append((piece, after))
    segment.points += points
    segment.events += events
    segment.why = why
    return points[-1]


def _closed(
    first: Piece, origins: list[Vector], piece: Piece, places: list[Place], lengths: Vector,
    begins: bool,
) -> tuple[list[Place], Vector, int] | None:  # fmt: skip
    """Return a walk up to the first orbit of a branch, if it comes back there; else None.

    Parameters
    ----------
    first : Piece
        Of that orbit.
    origins : list of ndarray
        Its unknowns, begun at different phases.
    piece, places, lengths
        The orbits of the walk and where it begins, and the lengths of its steps.
    begins : bool
        Whether it begins at the first orbit of the branch.

    Returns
    -------
    places, lengths, why
        See `Piece.walk`; the last step ends at the first orbit.
    """
    passed: list[tuple[int, Vector]] = []
    behind = np.array([place.y for place in places[1:]])
    for unknowns in origins if len(behind) else []:
        origin = np.tile(in_units(first, piece, unknowns), (len(behind), 1))
        if piece.cell.forced:  # a whole turn later the forcing is the same
            turns = np.round((behind[:, -2] - origin[:, -2]) / (2 * np.pi))
            origin[:, -2] += 2 * np.pi * turns
        offsets = (behind - origin) * piece.along.weights
        ahead = (offsets * np.array([other.tangent for other in places[1:]])).sum(axis=1)
        is_near = np.linalg.norm(offsets, axis=1) <= NEAR * lengths
        steps = np.flatnonzero(is_near & (ahead >= 0) & (ahead <= lengths)).tolist()
        passed += [(i, origin[i]) for i in steps if i >= begins]
    if not passed:
        return None
    i, y = min(passed, key=lambda each: each[0])
    before, last, why = places[i], places[i + 1], CLOSES
    with suppress(NoStepError):
        last = piece.place(piece.corrected(y, before.tangent), before.tangent)
        why = EVENT if shows_event(before, last) else CLOSES
    length = float(before.tangent @ ((last.y - before.y) * piece.along.weights))
    return [*places[1 : i + 1], last], np.append(lengths[:i], length), why


def in_units(other: Piece, piece: Piece, y: Vector) -> Vector:
    """Return the unknowns of an orbit of the piece `other` in the units of `piece`."""
    unknowns = y * other.sizes / piece.sizes
    unknowns[-1] = piece.interval.q(other.value(y) / unit_of(piece.case, piece.index))
    return np.asarray(unknowns)
