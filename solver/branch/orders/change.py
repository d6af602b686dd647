"""Which order of phases a branch has beyond a place where its own ends.

A phase is put in with no duration, or taken out: see `candidates`.  What counts is an orbit a
little further on that is admissible.
"""

from dataclasses import replace

import numpy as np

from ...arrays import Vector
from ...scenes.loaded import UnknownScene
from ...scenes.orders import Order
from ...scenes.parameter_error import ParameterError
from ..course import Course
from ..locate import Found
from ..meeting import halves_apart
from ..piece import NoStepError, Piece, Place
from .candidates import AtEvent, Candidate

#: Durations of a phase that is put in, in turn, as parts of a cell; steps of the parameter.
#: Near chatter a fold is as close as the last.
AHEAD = (1e-3, 1e-2, 1e-4, 1e-5)

#: Steps beside a flip, in turn.
ASIDE = (1e-4, 1e-2, 1e-3, 3e-2, 1e-1)


def beyond(found: Found) -> tuple[Piece, Place] | None:
    """Return an orbit beyond a place where the order of the phases changes; None without one.

    Parameters
    ----------
    found : Found
        What happens at that place.
    """
    at = AtEvent(found)
    for candidate in map(at.as_declared, at.candidates()):
        for ahead in AHEAD:
            try:
                return _led(found, candidate, ahead)
            except (NoStepError, ParameterError, UnknownScene, ArithmeticError):
                continue
    return None


def doubled(found: Found) -> tuple[Piece, Place] | None:
    """Return an orbit of twice the period beside a flip; of half a period, without symmetry.

    It is looked for along what the equations of the longer orbit leave free there, but for
    the branch of the shorter one: where its halves differ.  None without one.
    """
    at, old = AtEvent(found), found.piece
    if at.course.endless:
        return None
    slots = (*at.slots, *map(at.next_cell, at.slots))
    order = Order(tuple(slot.step for slot in slots))
    cycles = old.course.cycles * (1 if at.half else 2)
    course = replace(old.course, order=order, cycles=cycles)
    z = _unknowns(found, course, Candidate(slots, False, at.angle))
    here = np.append(z, old.number(found.place.y))
    bare = Piece.at(course, old.case, old.index, old.bounds, here, ())
    y = bare.of_number(here)
    free = bare.free(y)[-2:]
    apart = [halves_apart(bare, each) for each in free]
    border = np.linalg.svd(np.array(apart).T)[2][0] @ free
    for ahead in ASIDE:
        try:
            led = bare.led(y + ahead * border / bare.along.weights, border)
            return _admitted(bare, led, border)
        except (NoStepError, ParameterError, ArithmeticError):
            continue
    return None


def _led(found: Found, candidate: Candidate, ahead: float) -> tuple[Piece, Place]:
    """Return an orbit of another order a little beyond an event.

    Raises
    ------
    NoStepError
        If there is none.
    """
    old = found.piece
    course = candidate.course(old.course)
    z = _unknowns(found, course, candidate)
    count, forced = len(candidate.slots), old.cell.forced
    at_s = len(z) - count - forced
    if candidate.grows is not None:
        z[at_s + candidate.grows] = ahead * z[at_s : at_s + count].sum()
    at = np.append(z, old.number(found.place.y))
    bare = Piece.at(course, old.case, old.index, old.bounds, at, ())
    y = bare.of_number(at)
    if candidate.grows is not None:
        border = np.zeros(len(y))
        border[at_s + candidate.grows] = 1.0
        return _admitted(bare, bare.led(y, border), border)
    border = bare.free(y)[-1]
    border *= np.copysign(1.0, border[-1])
    y = bare.led(y, border)
    for side in (ahead, -ahead):
        try:
            return _admitted(bare, bare.led(y + side * border, border), side * border)
        except NoStepError:
            continue
    raise NoStepError


def _admitted(bare: Piece, y: Vector, border: Vector) -> tuple[Piece, Place]:
    """Return an orbit with what is watched there.

    Raises
    ------
    NoStepError
        If it is not admissible, or beyond the range.
    """
    if abs(y[-1]) > 1:
        raise NoStepError
    own = np.append(y[:-1], bare.number(y))
    piece = Piece.at(bare.course, bare.case, bare.index, bare.bounds, own)
    place = piece.place(piece.of_number(own), border)
    if not piece.admits(place):
        raise NoStepError
    return piece, place


def _unknowns(found: Found, course: Course, candidate: Candidate) -> Vector:
    """Return the unknowns of an order at an event, in the units of its piece."""
    numbers, durations = found.piece.numbers(found.place.y), [q.s for q in candidate.slots]
    states = [slot.state for slot in candidate.slots]
    return course.gathered(numbers, states, np.array(durations), candidate.angle)
