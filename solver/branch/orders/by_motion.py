"""The order of phases beyond an event, by the motion that begins on the orbit there.

Where several things happen at once, or one brings another with it, the motion shows what a list
of changes would have to foresee.
"""

from dataclasses import replace

import numpy as np

from ...arrays import Vector
from ...scenes.orders import image
from ...simulation.segment import Segment
from ...simulation.steps.clock import at_start
from ...simulation.walk import ACCUMULATE, Place, walk
from ..events.locate import Found
from ..place import NoStepError
from .candidate import Candidate, Slot

#: Component of the parameter in the tangent, below which no step along the branch changes it.
STEEP = 1e-6


def places_beside(event: Found, distance: float) -> list[Vector]:
    """Return the unknowns beyond an event, and those at it at parameters beside it."""
    y, tangent = event.place.y, event.place.tangent
    side = np.append(np.zeros(len(y) - 1), np.copysign(distance, tangent[-1]))
    places = [y + side, y - side]
    if abs(tangent[-1]) > STEEP:
        places.insert(0, y + distance * tangent / event.piece.along.weights)
    low, high = event.piece.bounds
    return [place for place in places if low <= event.piece.value(place) <= high]


def motion_from(event: Found, y: Vector, cells: int = 1) -> list[Segment]:
    """Return the phases of the motion that begins within the longest phase of an orbit.

    Parameters
    ----------
    event : Found
        Before it the orbit has other phases.
    y : ndarray
        Its unknowns: see `places_beside`.
    cells : int
        For how many cells the motion is followed.

    Raises
    ------
    NoStepError
        If it ends, or the orbit has no phases.
    """
    piece, course = event.piece, event.piece.course
    if course.endless:
        raise NoStepError
    numbers, durations = piece.numbers(y), piece.durations(y)
    cell, machine = course.cell(numbers), course.machine(numbers)
    p = int(np.argmax(durations))
    t = float(durations[p]) / 2
    angle = float(y[-2] + cell.omega * (durations[:p].sum() + t)) if cell.forced else 0.0
    state = course.whole_state(piece.equations(y), y[:-1], p, t, angle)
    begin = Place(machine.number(course.order.steps[p]), state, at_start(angle, cell.omega))
    lasting = cell.duration if cell.forced else float(durations.sum())
    segments, _, ended, _ = walk(piece.case, machine, begin, cells * lasting)
    if ended:
        raise NoStepError(ended)
    return segments


def by_motion(event: Found, y: Vector) -> Candidate:
    """Return the phases of a cell of the motion that begins on an orbit; see `motion_from`.

    Raises
    ------
    NoStepError
        If the motion does not come back to the phase in which it begins.
    """
    segments = motion_from(event, y)
    if len(segments) == 1 or not all(q.step for q in segments[:-1]):
        raise NoStepError
    first, *between, last = segments
    course, half = event.piece.course, event.piece.course.order.half_period
    machine = course.machine(event.piece.numbers(y))
    named = image(machine.cell, first.named) if half else first.named
    if named is None or machine.node(named).law != machine.node(last.began).law:
        raise NoStepError
    slots = [Slot(q.named, q.state, q.s) for q in (*between, last)]
    slots[-1] = replace(slots[-1], step=named, s=first.s + last.s)
    return Candidate(tuple(slots), half, segments[1].angle)


def told(event: Found, y: Vector) -> str:
    """Return in words what the motion that begins on an orbit comes to; empty if not known.

    A phase holds it for ever (under a forcing, for a whole period), or its switches accumulate.
    """
    try:
        last, cell = motion_from(event, y, 4)[-1], event.piece.cell
    except NoStepError as error:
        return "the switches accumulate" if str(error).startswith(ACCUMULATE) else ""
    lasts = cell.forced and last.s >= 2 * cell.duration
    return f"the motion stays in {last.phase.name}" if lasts and last.phase.held else ""
