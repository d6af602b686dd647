"""Where a branch meets that of orbits of half the period, or of orbits with a symmetry.

There the halves of an orbit become the same, or each the image of the other, and behind it they
have changed places: it is followed no further.  The equations of the longer orbit are singular
there, those of the shorter one are not, and on the branch of that something vanishes: it is a
flip, or where symmetry is lost.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ..arrays import Vector
from ..scenes.orders import Order, image
from .course import Course
from .locate import Found, estimated, root
from .piece import NoStepError, Piece, Place
from .walk import FLIP, LEAST_STEP, MOST_STEP, OWN

#: What halves are apart that is rounding, and what is left of it, as a part, where they meet.
ROUNDING, LEFT = 1e-9, 1e-6

#: Steps along the branch of the shorter orbit, as parts of the last step along the parameter.
STEPS = 1.0, 4.0, 16.0, 64.0


def shorter(piece: Piece) -> Course | None:
    """Return the order of half the phases of which that of a piece is twice; None without one.

    Either half is a period, or each is the image of the other.
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
    """Return by what the halves of an orbit differ, or a half from the image of the other."""
    steps, durations = piece.course.order.steps, piece.durations(y)
    half = len(durations) // 2
    states = piece.course.halves(y)
    sign = 1.0 if steps[half:] == steps[:half] else -1.0
    apart = np.subtract(*np.split(states * np.repeat([1.0, sign], len(states) // 2), 2))
    return np.concatenate([apart, durations[:half] - durations[half:]])


def met(piece: Piece, places: Sequence[Place]) -> tuple[int, float] | None:
    """Return the first step from place to place in which halves meet, and at which part of it.

    None if they do in no step.
    """
    apart = [halves_apart(piece, place.y * piece.along.weights) for place in places]
    for i, (one, other) in enumerate(pairwise(apart)):
        own, both = float(one @ one), float(one @ other)
        if np.sqrt(own) > ROUNDING and both <= LEFT * own:
            return i, own / (own - both)
    return None


def halved(piece: Piece, half: Course, y: Vector) -> Vector:
    """Return the first half of an orbit as an order of half the phases has it."""
    count = len(half.order.steps)
    states = piece.course.states(piece.equations(y), y)[:count]
    angle = float(y[-2]) if piece.cell.forced else 0.0
    z = half.gathered(piece.numbers(y), states, piece.durations(y)[:count], angle)
    return np.append(z, piece.number(y))


def symmetric(piece: Piece, y: Vector) -> Course | None:
    """Return the order of half an orbit, if the other half is its image; else None."""
    half = shorter(piece)
    if half is None or not half.order.half_period:
        return None
    apart, size = halves_apart(piece, y), float(np.abs(y[:-1]).max())
    return half if np.abs(apart).max() <= ROUNDING * size else None


def meeting(piece: Piece, half: Course, before: Place, after: Place) -> Found:
    """Return where halves meet in a step, located on the branch of the shorter orbit.

    Where that is not found, within what the parameter goes with the square of the way to it: a
    few times what the step changes.
    """
    try:
        at = _located(piece, half, before, after)
    except ArithmeticError:
        apart = 4 * abs(piece.value(after.y) - piece.value(before.y))
        return Found("branch-point", None, None, piece, before, estimate=apart)
    y = before.y.copy()
    y[-1] = piece.interval.q(at.piece.number(at.place.y))
    there = replace(before, y=y)
    return Found("branch-point", None, None, piece, there, estimate=at.estimate)


def _located(piece: Piece, half: Course, before: Place, after: Place) -> Found:
    """Return where the shorter orbit is the longer one as well.

    Raises
    ------
    NoStepError
        If it is not found.
    """
    y, own = before.y, halved(piece, half, before.y)
    short = Piece.at(half, piece.case, piece.index, piece.bounds, own, ())
    along = np.append(np.zeros(len(own) - 1), 1.0)
    begin = short.place(short.led(short.of_number(own), along), along)
    gauge = len(begin.gauges) - OWN + FLIP
    change = abs(piece.value(after.y) - piece.value(y)) / short.sizes[-1]
    for part in STEPS:
        length = float(np.clip(part * change, LEAST_STEP, MOST_STEP))
        for step in (length, -length):
            end = short.stepped(begin, step)
            if begin.gauges[gauge] * end.gauges[gauge] < 0:
                _, place = root(short, begin, (0.0, step), gauge)
                found = Found("flip", None, None, short, place, gauge)
                return estimated(found, end, step)
    raise NoStepError
