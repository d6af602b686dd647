"""The order of phases beyond an event, by the motion that begins on the orbit there.

Where several things happen at once, or one brings another with it, the motion shows what a list
of changes would have to foresee.
"""

from dataclasses import replace

import numpy as np

from ...arrays import Vector
from ...scenes.orders import image
from ...simulation.steps.clock import at_start
from ...simulation.walk import Place, walk
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
    return [place for place in places if abs(place[-1]) <= 1]


def by_motion(event: Found, y: Vector) -> Candidate:
    """Return the phases of a cell of the motion that begins on an orbit.

    Parameters
    ----------
    event : Found
        Before it the orbit has other phases.
    y : ndarray
        Its unknowns: see `places_beside`.  The motion begins within the longest phase.

    Raises
    ------
    NoStepError
        If the motion does not come back to that phase.
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
    until = cell.duration if cell.forced else float(durations.sum())
    segments, _, ended, _ = walk(piece.case, machine, begin, until)
    if ended or len(segments) == 1 or not all(q.step for q in segments[:-1]):
        raise NoStepError
    first, *between, last = segments
    half = course.order.half_period
    named = image(machine.cell, first.named) if half else first.named
    if named is None or machine.node(named).law != machine.node(last.began).law:
        raise NoStepError
    slots = [Slot(q.named, q.state, q.s) for q in (*between, last)]
    slots[-1] = replace(slots[-1], step=named, s=first.s + last.s)
    return Candidate(tuple(slots), half, segments[1].angle)
