"""Where a branch meets that of orbits of half the period, or of symmetric orbits.

There the two halves of an orbit become equal, or mirror images; behind it they have exchanged
places, and the branch is followed no further.  The equations of the longer orbit are singular
there.  Those of the shorter one are regular, and its own branch has a flip there, or loses its
symmetry.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ..arrays import Vector
from ..scenes.orders import Order, image
from .course import Course
from .events.locate import Found, estimated
from .events.root import root
from .piece import Piece
from .place import NoStepError, Place
from .walk import FLIP, LEAST_STEP, MOST_STEP, OWN

#: Difference of two halves that is rounding; part of it that may be left where they meet.
ROUNDING, LEFT = 1e-9, 1e-6

#: Steps tried along the branch of the shorter orbit, by the change of the parameter.
STEPS = 1.0, 4.0, 16.0, 64.0


def shorter(piece: Piece) -> Course | None:
    """Return the order of phases of which that of a piece is the double; None without one.

    Its second half repeats the first, or is the mirror image of it.
    """
    course = piece.course
    steps, cycles = course.order.steps, course.cycles
    half, odd = divmod(len(steps), 2)
    if odd or course.order.half_period or course.endless:
        return None
    first, second = steps[:half], steps[half:]
    if first == second:
        twice = cycles % 2 == 0
        return replace(course, order=Order(first), cycles=cycles // 2) if twice else None
    cell = course.declares(piece.case.numbers)
    if second == tuple(image(cell, step) for step in first):
        return replace(course, order=Order(first, True))
    return None


def halves_apart(piece: Piece, y: Vector) -> Vector:
    """Return the first half of an orbit less the second, or less the image of that."""
    steps, durations = piece.course.order.steps, piece.durations(y)
    half = len(durations) // 2
    states = piece.course.halves(y)
    sign = 1.0 if steps[half:] == steps[:half] else -1.0
    difference = np.subtract(*np.split(states * np.repeat([1.0, sign], len(states) // 2), 2))
    return np.concatenate([difference, durations[:half] - durations[half:]])


def met(piece: Piece, places: Sequence[Place]) -> tuple[int, float] | None:
    """Return the number of the first step in which the halves meet, and at which part of it.

    None if they meet in none.
    """
    differences = [halves_apart(piece, place.y * piece.along.weights) for place in places]
    for i, (difference, next_difference) in enumerate(pairwise(differences)):
        square, product = float(difference @ difference), float(difference @ next_difference)
        if np.sqrt(square) > ROUNDING and product <= LEFT * square:
            return i, square / (square - product)
    return None


def halved(piece: Piece, half: Course, y: Vector) -> Vector:
    """Return the unknowns of the first half of an orbit, for the order of half the phases."""
    count = len(half.order.steps)
    states = piece.course.states(piece.equations(y), y)[:count]
    angle = float(y[-2]) if piece.cell.forced else 0.0
    z = half.gathered(piece.numbers(y), states, piece.durations(y)[:count], angle)
    return np.append(z, piece.number(y))


def symmetric(piece: Piece, y: Vector) -> Course | None:
    """Return the order of the first half of an orbit if the second is its image; else None."""
    half = shorter(piece)
    if half is None or not half.order.half_period:
        return None
    difference, size = halves_apart(piece, y), float(np.abs(y[:-1]).max())
    return half if np.abs(difference).max() <= ROUNDING * size else None


def meeting(piece: Piece, half: Course, before: Place, after: Place) -> Found:
    """Return where the halves meet in a step, located on the branch of the shorter orbit.

    If that fails, the orbit before, with an estimate of four times the step in the parameter.
    """
    try:
        flip = _located(piece, half, before, after)
    except ArithmeticError:
        estimate = 4 * abs(piece.value(after.y) - piece.value(before.y))
        return Found("branch-point", None, None, piece, before, estimate=estimate)
    y = before.y.copy()
    y[-1] = piece.interval.q(flip.piece.number(flip.place.y))
    place = replace(before, y=y)
    return Found("branch-point", None, None, piece, place, estimate=flip.estimate)


def _located(piece: Piece, half: Course, before: Place, after: Place) -> Found:
    """Return the flip on the branch of the shorter orbit.

    Raises
    ------
    NoStepError
        If it is not found.
    """
    y, unknowns = before.y, halved(piece, half, before.y)
    short = Piece.at(half, piece.case, piece.index, piece.bounds, unknowns, ())
    border = np.append(np.zeros(len(unknowns) - 1), 1.0)
    begin = short.place(short.corrected(short.of_number(unknowns), border), border)
    monitor = len(begin.monitors) - OWN + FLIP
    change = abs(piece.value(after.y) - piece.value(y)) / short.sizes[-1]
    for part in STEPS:
        length = float(np.clip(part * change, LEAST_STEP, MOST_STEP))
        for step in (length, -length):
            end = short.stepped(begin, step)
            if begin.monitors[monitor] * end.monitors[monitor] < 0:
                _, place = root(short, begin, (0.0, step), monitor)
                flip = Found("flip", None, None, short, place, monitor)
                return estimated(flip, end, step)
    raise NoStepError
