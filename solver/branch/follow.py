"""A branch of one order of phases, step by step, to where it ends or another order begins."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from ..arrays import Vector
from .along import returns
from .course import Course
from .piece import NoStepError, Piece, Place, unit_of
from .walk import EVENT, GROWN, LEAST_STEP, OWN, STUCK, happens
from .watch import END

#: First step, in coordinates of size 1; orbits that are found at a time.
FIRST, ROOM = 0.01, 32

#: Most of the range of the parameter in a step, and most orbits of a branch.
PART, MOST_POINTS = 1 / 80, 20_000

#: How far a point may be from the first, in steps, for the branch to be closed.
NEAR = 1.0

#: How far such orbits are apart, in steps.
TOGETHER = 100.0

#: How far back what happens in a step is looked for again, in steps.
BACK = 1.25

#: Why a branch ends.
CLOSED, RANGE = "the branch is closed", "the end of the range"
TWICE = "the orbit becomes one of half its period"

#: Step within which an orbit may become one of half its period: there two branches meet, and
#: the equations across the branch are singular.
SHORTER = 1e-3

#: Size of an unknown, without units, that no orbit has that is worth following.
MOST = 1e8

#: Beyond it a value where an event was located is a pole, not a zero, as a part of its change.
ZERO = 1e-6

#: What is watched, without units, may be below zero by this: it is rounding.
ROUNDING = 4 * float(np.finfo(float).eps)

#: What may be apart of events that are one, as a part of where they are.
SAME = 1e-9

#: The words for what happens to an orbit itself, in the order of `walk.OWN`.
OF_THE_ORBIT = "fold", "flip", "torus", "branch-point"

#: Where the parameter leaves its interval: no event.
EDGE = "edge"


@dataclass(frozen=True, eq=False)
class Found:
    """Something that happens on a branch.

    Parameters
    ----------
    kind : str
        The word for it.
    phase : int or None
        The phase that it happens in; None where it is of the whole orbit.
    column : int
        Of `watch`: where in the phase; its duration, without one.
    piece : Piece
    place : Place
    gauge : int
        Which of `Place.gauges` vanishes.
    estimate : float
        Of the error of the parameter: what finding it from the other side gives otherwise.
    """

    kind: str
    phase: int | None
    column: int | None
    piece: Piece
    place: Place
    gauge: int = -1
    estimate: float = 0.0

    @property
    def row(self) -> int:
        """Of the form that vanishes among those that are watched, if it is one."""
        return self.gauge // 3

    @property
    def changes(self) -> bool:
        """Whether the order of the phases is another one beyond."""
        return self.phase is not None

    @property
    def value(self) -> float:
        """The parameter, in SI units."""
        return self.piece.value(self.place.y)


@dataclass(eq=False)
class Segment:
    """Orbits of one order of phases along a branch, in turn, and what happens there."""

    course: Course
    points: list[tuple[Piece, Place]] = field(default_factory=list)
    events: list[Found] = field(default_factory=list)
    why: str = ""

    @property
    def end(self) -> Found | None:
        """The event at which the order of the phases changes, if it ends so."""
        return self.events[-1] if self.events and self.events[-1].changes else None


def follow(
    found: Segment, first: tuple[Piece, Place],
    part: float = PART, seen: Callable[[float], None] = lambda value: None,
) -> None:  # fmt: skip
    """Follow a branch from the last orbit of a segment on, along its tangent.

    Parameters
    ----------
    found : Segment
        To which the orbits are added, one by one.
    first : (Piece, Place)
        Where the branch began: back there it is closed.
    part : float
        Most of the range of the parameter in a step.
    seen : callable
        Called with the parameter of each orbit.
    """
    (piece, place), length = found.points[-1], FIRST
    most = part * (piece.bounds[1] - piece.bounds[0])
    while len(found.points) < MOST_POINTS and not found.why:
        places, lengths, why, length = piece.walk(place, length, most, ROOM)
        closed = _closed(first, piece, places, lengths)
        if closed is not None and found.points[-1] != first:
            found.points += [(piece, each) for each in places[: closed + 1]]
            found.why = CLOSED
            return
        smooth = places[:-1] if why == EVENT else places
        found.points += [(piece, each) for each in smooth]
        place = found.points[-1][1]
        seen(piece.value(place.y))
        if why == STUCK:
            found.why = "the step cannot get smaller"
        elif why == EVENT:
            try:
                piece, place = _pass(found, piece, place, places[-1], float(lengths[-1]))
            except ArithmeticError:
                length = float(lengths[-1]) / 2
                found.why = "" if length > LEAST_STEP else "the step cannot get smaller"
                if length < SHORTER and _is_twice(piece, place, length):
                    found.events.append(_meeting(piece, place, places[-1]))
                    found.why = TWICE
        elif why == GROWN:
            try:
                piece, place = piece.moved(place)
            except ArithmeticError:
                found.why = "the step cannot get smaller"
            if np.abs(place.y).max() > MOST:
                found.why = "the orbit grows beyond all bounds"
    found.why = found.why or f"{MOST_POINTS} orbits are the most that a branch has"


def _pass(
    found: Segment, piece: Piece, before: Place, after: Place, length: float
) -> tuple[Piece, Place]:
    """Return where a branch goes on behind a step in which something happens; note what does.

    Raises
    ------
    NoStepError
        If it is not located.
    """
    points, events, why = [], [], ""
    for event in _in_turn(_events(piece, before, after, length)):
        points.append((piece, event.place))
        if event.kind == EDGE:
            why = RANGE if piece.ends_at(event.place.y) else ""
            points[-1] = points[-1] if why else piece.moved(event.place)
            break
        events.append(_estimated(event, after, length))
        if event.changes:
            why = event.kind
            break
    else:
        points.append((piece, after))
    found.points += points
    found.events += events
    found.why = why
    return points[-1]


def _is_twice(piece: Piece, place: Place, length: float) -> bool:
    """Whether an orbit is within a few steps of one of half its period, or of its image."""
    if len(piece.along.kinds) % 2 or piece.course.order.half_period:
        return False
    apart = halves_apart(piece, place.y * piece.along.weights)
    return float(np.abs(apart).max()) <= TOGETHER * length


def halves_apart(piece: Piece, y: Vector) -> Vector:
    """Return by what the halves of an orbit differ, or a half from the image of the other."""
    steps, durations = piece.course.order.steps, piece.durations(y)
    half = len(durations) // 2
    states = piece.course.halves(y)
    sign = 1.0 if steps[half:] == steps[:half] else -1.0
    apart = np.subtract(*np.split(states * np.repeat([1.0, sign], len(states) // 2), 2))
    return np.concatenate([apart, durations[:half] - durations[half:]])


def _meeting(piece: Piece, before: Place, after: Place) -> Found:
    """Return where a branch meets that of an orbit of half the period, in the last step.

    The parameter goes with the square of the way to it: it is less than a few times off what
    the step changes.
    """
    apart = 4 * abs(piece.value(after.y) - piece.value(before.y))
    return Found("branch-point", None, None, piece, before, estimate=apart)


def _in_turn(found: Iterable[tuple[float, Found | None]]) -> list[Found]:
    """Return what happens in a step in turn, each once, up to where the order changes.

    Where several things are watched that vanish at one place, one of them stands for all: a
    change of the order before others, of those the end of a phase.
    """
    every = sorted(found, key=lambda each: each[0])
    events = [(at, event) for at, event in every if event is not None]
    first = next((at for at, event in events if event.changes), None)
    if any(event is None and (first is None or at <= first) for at, event in every):
        raise NoStepError
    if first is None:
        return [event for _, event in events]
    here = [event for at, event in events if event.changes and at - first <= SAME * first]
    change = min(here, key=lambda each: -1 if each.column is None else (END - each.column) % 3)
    near = SAME * abs(change.value)
    before = (event for at, event in events if at < first and not event.changes)
    return [*(q for q in before if abs(q.value - change.value) > near), change]


def _closed(
    first: tuple[Piece, Place], piece: Piece, places: list[Place], lengths: Vector
) -> int | None:
    """Return which step leads past the first orbit of a branch, in its direction, if any."""
    there, place = first
    if piece.course != there.course or not places:
        return None
    begin = in_units(there, piece, place.y)
    away = (np.array([each.y for each in places]) - begin) * piece.along.weights
    ahead = (away * np.array([each.direction for each in places])).sum(axis=1)
    near = np.linalg.norm(away, axis=1) <= NEAR * lengths
    passed = np.flatnonzero(near & (ahead >= 0) & (ahead <= lengths))
    return int(passed[0]) if len(passed) else None


def in_units(there: Piece, piece: Piece, y: Vector) -> Vector:
    """Return the unknowns of an orbit of one piece as another has them."""
    found = y * there.sizes / piece.sizes
    found[-1] = piece.interval.q(there.value(y) / unit_of(piece.case, piece.index))
    return np.asarray(found)


def _events(
    piece: Piece, before: Place, after: Place, length: float
) -> Iterator[tuple[float, Found | None]]:
    """Yield what happens in a step, with where in it; None of what is not seen where it is."""
    start, end = before.gauges, after.gauges
    for i in range(len(start)):
        if happens(start[i], end[i], i < len(start) - OWN):
            yield from _located(piece, before, length, i, float(end[i]))
    edge = float(after.y[-1])
    if abs(edge) > 1:
        side = float(np.copysign(1.0, edge))
        at = (side - float(before.y[-1])) / (edge - float(before.y[-1]))
        y = before.y + at * (after.y - before.y)
        y[-1] = side
        there = piece.led(y, np.append(np.zeros(len(y) - 1), 1.0))
        yield at * length, Found(EDGE, None, None, piece, piece.place(there, before.direction))


def _root(piece: Piece, before: Place, length: float, i: int) -> tuple[float, Place]:
    """Return where in a step something vanishes, and the orbit there."""
    from scipy.optimize import brentq  # noqa: PLC0415  (300 ms)

    def value(at: float) -> float:
        found = float((piece.stepped(before, at) if at else before).gauges[i])
        return 1.0 if np.isnan(found) else found

    try:
        at = float(brentq(value, 0.0, length, xtol=1e-300, rtol=1e-14, maxiter=200))
    except (ValueError, RuntimeError):  # no change of the sign, or too many trials
        raise NoStepError from None
    return at, piece.stepped(before, at)


def _estimated(event: Found, after: Place, length: float) -> Found:
    """Return something that happens in a step, with what finding it from behind changes."""
    piece, value = event.piece, event.value
    least = float(np.spacing(abs(value)))
    try:
        _, place = _root(piece, after, -BACK * length, event.gauge)
    except NoStepError:  # behind a phase that has no duration nothing is smooth
        return replace(event, estimate=least)
    return replace(event, estimate=max(least, abs(piece.value(place.y) - value)))


def _located(
    piece: Piece, before: Place, length: float, i: int, end: float
) -> Iterator[tuple[float, Found | None]]:
    """Yield where something that is watched vanishes in a step, if it does."""
    forms, phases = 3 * len(piece.table), len(piece.along.kinds)
    at, place = _root(piece, before, length, i)
    if not abs(float(place.gauges[i])) <= ZERO * abs(end):
        if i < forms + phases and abs(end) > ROUNDING:  # there is no orbit beyond
            yield at, None
        return
    if i < forms:
        row, column = piece.rows[i // 3], i % 3
        yield at, Found(piece.course.word(row, column), row.phase, column, piece, place, i)
    elif i < forms + phases:
        p = i - forms
        yield at, Found(_word_of_duration(piece, p), p, None, piece, place, i)
    else:
        kind = OF_THE_ORBIT[i - forms - phases]
        if kind == "flip" and piece.cell.sign < 0:  # of half a period: the symmetry is lost
            kind = "branch-point"
        if kind != "torus" or np.iscomplex(np.linalg.eigvals(piece.maps(place)[0])).any():
            yield at, Found(kind, None, None, piece, place, i)


def _word_of_duration(piece: Piece, p: int) -> str:
    """Return what it is called where a phase of a cell gets no duration."""
    still = piece.along.divided[p] > 1  # it begins without speed: a rest could
    if piece.cell.phases[p].held or (still and piece.course.can_rest):
        return "sticking"
    return "grazing" if returns(piece.cell, p) else "vanishing"
