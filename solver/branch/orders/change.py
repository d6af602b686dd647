"""Which order of phases a branch has beyond an event at which its own ends.

`candidates` proposes orders; the first with an admissible orbit a little beyond is taken.
"""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import islice

import numpy as np

from ...arrays import Vector
from ...scenes.loaded import UnknownScene
from ...scenes.orders import Order
from ...scenes.parameter_error import ParameterError
from ...simulation.outcome import unset
from ..course import Course
from ..events.locate import Found
from ..meeting import halves_apart
from ..piece import Piece, unit_of
from ..place import NoStepError, Place
from ..walk import MEETS, OWN
from .by_motion import by_motion, places_beside, told
from .candidate import Candidate
from .candidates import AtEvent
from .reading import BESIDE

#: Durations tried for an inserted phase, as parts of a cell, or steps tried along the branch.
#: The last is for chatter, where a fold is as close.
AHEAD = (1e-3, 1e-2, 1e-4, 1e-5)

#: How far off, in scaled coordinates, an orbit at the event may be found in another order; and
#: one in which a phase has been inserted.
SAME, FAR = 1e-4, 1.0

#: How far beside an event a motion is followed; how far off the orbit may be there, as a
#: multiple of the square root of that: by so much it moves where something is just touched.
BY_MOTION, WIDTH = (1e-3, 1e-4, 1e-5), 3.0

#: Steps tried away from a flip.
ASIDE = (1e-4, 1e-2, 1e-3, 3e-2, 1e-1)

#: The same across a branch that another one meets: nearer, it is not told from the first.
FARTHER = (1e-1, 3e-2, 1e-2)


def beyond(event: Found) -> tuple[Piece, Place] | None:
    """Return an orbit beyond an event in one of its candidates; None without one."""
    at_event = AtEvent(event)
    for candidate in map(at_event.as_declared, at_event.candidates()):
        for ahead in AHEAD:
            with suppress(ArithmeticError, ParameterError, UnknownScene):
                return _orbit_beyond(event, candidate, ahead)
    return None


def moved_on(event: Found) -> tuple[Piece, Place] | None:
    """Return an orbit beside an event in the order of phases of a motion there; else None."""
    at_event = AtEvent(event)
    for distance in BY_MOTION:
        for y in places_beside(event, distance):
            with suppress(ArithmeticError, ParameterError, UnknownScene):
                return _by_motion(at_event, y, WIDTH * np.sqrt(distance))
    return None


def _by_motion(at_event: AtEvent, y: Vector, most: float) -> tuple[Piece, Place]:
    """Return an orbit beyond an event, in the order of phases that a motion has there.

    Raises
    ------
    NoStepError
        If there is none of another order, or it is farther than `most`: of another branch.
    """
    piece = at_event.event.piece
    candidate = at_event.as_declared(by_motion(at_event.event, y))
    course, number = candidate.course(piece.course), piece.number(y)
    if any(each.course(piece.course) == piece.course for each in at_event.rotations(candidate)):
        raise NoStepError
    z = _unknowns(course, candidate, piece.numbers(y))
    unknowns = np.append(z, number)
    bare = Piece.at(course, piece.case, piece.index, piece.bounds, unknowns, ())
    border = np.append(np.zeros(len(z)), np.copysign(1.0, y[-1] - at_event.event.place.y[-1]))
    return _admitted(bare, _near(bare, bare.of_number(unknowns), border, most), border)


def why_none(event: Found) -> str:
    """Return in words why there is no orbit `beyond` an event, as far as that is known."""
    course, p = event.piece.course, event.phase
    if event.column is None and p is not None:  # it vanishes
        cell = course.declares(event.piece.numbers(event.place.y))
        over = {each.phase for each in (event, *event.at_once) if each.column is None}
        left = {step.phase for i, step in enumerate(course.order.steps) if i not in over}
        lasts = len(left) == 1 and not AtEvent(event).leaps(p)  # what sets a memory is over
        memory = next(iter(cell.memory), None) if lasts else unset(cell, left)
        if memory is not None:
            return f"nothing sets {memory.name}, which may have any of many values"
    for y in places_beside(event, BY_MOTION[0]):
        with suppress(ArithmeticError, ParameterError, UnknownScene):
            words = told(event, y)
            if words:
                return words
    return "no order of phases is found"


def doubled(event: Found) -> tuple[Piece, Place] | None:
    """Return an orbit of twice the period beside a flip, or an unsymmetric one; else None.

    The equations of the doubled orbit have a two-dimensional null space at the flip.  The
    search starts along its direction in which the two halves of the orbit differ.  Where
    branches meet, the orbit itself has such a null space: there across its own branch.
    """
    at_event, piece, place = AtEvent(event), event.piece, event.place
    if at_event.course.endless:
        return None
    if event.monitor == len(place.monitors) - OWN + MEETS:
        one, other = piece.singular_vectors(place.y)[-2:]
        across = (other @ place.tangent) * one - (one @ place.tangent) * other
        return _aside(piece, place.y, across / np.linalg.norm(across), FARTHER)
    slots = (*at_event.slots, *map(at_event.next_cell, at_event.slots))
    order = Order(tuple(slot.step for slot in slots))
    cycles = piece.course.cycles * (1 if at_event.half else 2)
    course = replace(piece.course, order=order, cycles=cycles)
    z = _unknowns(course, Candidate(slots, False, at_event.angle), piece.numbers(place.y))
    unknowns = np.append(z, piece.number(event.place.y))
    bare = Piece.at(course, piece.case, piece.index, piece.bounds, unknowns, ())
    y = bare.of_number(unknowns)
    null_space = bare.singular_vectors(y)[-2:]
    differences = [halves_apart(bare, direction) for direction in null_space]
    border = np.linalg.svd(np.array(differences).T)[2][0] @ null_space
    return _aside(bare, y, border)


def _aside(
    bare: Piece, y: Vector, border: Vector, distances: Sequence[float] = ASIDE
) -> tuple[Piece, Place] | None:
    """Return an admissible orbit that is aside from one in a direction; None without one."""
    for distance in distances:
        with suppress(ArithmeticError, ParameterError):
            y_aside = bare.corrected(y + distance * border / bare.along.weights, border)
            return _admitted(bare, y_aside, border)
    return None


def begun_anew(piece: Piece, place: Place, course: Course) -> list[Vector]:
    """Return the unknowns of an orbit, begun at each phase from which its order is a given one.

    Parameters
    ----------
    piece, place : Piece, Place
        The orbit.
    course : Course
        The order.
    """
    every_begin = [place.y] if course == piece.course else []
    at_event = AtEvent(Found("", None, None, piece, place))
    for each in islice(at_event.rotations(at_event.orbit), 1, None):
        if each.course(piece.course) == course:
            with suppress(ArithmeticError):  # with a memory no state may belong to these times
                z = _unknowns(course, each, piece.numbers(place.y))
                every_begin.append(np.append(z, place.y[-1]))
    return every_begin


def _orbit_beyond(event: Found, candidate: Candidate, ahead: float) -> tuple[Piece, Place]:
    """Return an orbit of a candidate a little beyond an event.

    Raises
    ------
    NoStepError
        If there is none.
    """
    piece = event.piece
    course = candidate.course(piece.course)
    z = _unknowns(course, candidate, piece.numbers(event.place.y))
    count, forced = len(candidate.slots), piece.cell.forced
    at_s = len(z) - count - forced
    inserted = [at_s + i for i in candidate.grows]
    z[inserted] = ahead * z[at_s : at_s + count].sum()
    for i in inserted if len(inserted) > 1 else ():  # else one may come out negative
        for neighbour in (i - 1, at_s + (i - at_s + 1) % count):
            z[neighbour] -= z[i] / 2
    number = piece.number(event.place.y)
    beside = np.append(z, number + _beside(piece, number))
    bare = Piece.at(course, piece.case, piece.index, piece.bounds, beside, ())
    y = bare.of_number(np.append(z, number))
    if inserted:
        border = np.zeros(len(y))
        border[inserted[0]] = 1.0
        return _admitted(bare, _near(bare, y, border, FAR), border)
    border = bare.singular_vectors(y)[-1]
    border *= np.copysign(1.0, border[-1])
    y = _near(bare, y, border, SAME)
    for distance in (ahead, -ahead):
        with suppress(NoStepError):
            y_aside = bare.corrected(y + distance * border / bare.along.weights, border)
            return _admitted(bare, y_aside, distance * border)
    raise NoStepError


def _beside(piece: Piece, number: float) -> float:
    """Return the way to a value beside an event: at it two surfaces may be one by chance."""
    ends = (bound / unit_of(piece.case, piece.index) - number for bound in piece.bounds)
    return BESIDE * max(ends, key=abs)


def _near(bare: Piece, y: Vector, border: Vector, most: float) -> Vector:
    """Return the orbit to which Newton's method leads, if it is no farther than `most`.

    Raises
    ------
    NoStepError
        If it is another one.
    """
    corrected = bare.corrected(y, border)
    if not np.linalg.norm((corrected - y) * bare.along.weights) <= most:
        raise NoStepError
    return corrected


def _admitted(bare: Piece, y: Vector, border: Vector) -> tuple[Piece, Place]:
    """Return an orbit with its monitors.

    Raises
    ------
    NoStepError
        If it is not admissible, or beyond the range.
    """
    if abs(y[-1]) > 1:
        raise NoStepError
    unknowns = np.append(y[:-1], bare.number(y))
    piece = Piece.at(bare.course, bare.case, bare.index, bare.bounds, unknowns)
    place = piece.place(piece.of_number(unknowns), border)
    if not piece.admits(place):
        raise NoStepError
    return piece, place


def _unknowns(course: Course, candidate: Candidate, numbers: tuple[float, ...]) -> Vector:
    """Return the unknowns of a candidate for parameters without units."""
    if candidate.endless:
        return course.for_ever(numbers)
    states, durations = zip(*((slot.state, slot.s) for slot in candidate.slots), strict=True)
    return course.gathered(numbers, states, np.array(durations), candidate.angle)
