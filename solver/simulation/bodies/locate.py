"""The first event of a phase of a body, which no step can pass over.

Between two times a form is within ``B h**4/384`` of the cubic that has its values and slopes
at both, where B bounds its fourth derivative, and that cubic is above the least of its
Bernstein coefficients.  Intervals for which this leaves a zero are divided, until the form
falls all along one: then it has one zero there.  A form that falls below zero by no more than
its rounding only touches it.

Functions over `Along`: plain Python, or compiled by numba.
"""

from math import inf, isfinite
from typing import NamedTuple

import numpy as np

from ...arrays import Complex, Integers, Matrix, Vector
from ..steps.column import NONE
from ..steps.locate import BEYOND, CUT, EPS, EVENT, LOST, NOISE
from .along import NEVER, Along, put_bounds, value_at
from .modes import power_of, put_poles, wave_at
from .phases import TERMS

#: Intervals that are examined together; the factor by which they grow after each success.
POINTS, LONGER = 16, 4.0

#: Most rounds of a search.
MOST_ROUNDS = 20_000

#: Most steps of Newton's method with bisection, to a zero of a form and of a cubic.
STEPS, CUBIC = 60, 6

#: What is known of a form on an interval: it has no zero, may have one, is negative at the
#: end, or is negative there and decreasing throughout.
NO_ZERO, DOUBTFUL, BELOW, FALLING = range(4)


class Room(NamedTuple):
    """Room for what is computed at a time or on an interval: no array is made there.

    Parameters
    ----------
    z : ndarray of complex, shape (m,)
        The poles.
    throughout, own : ndarray, shape (F,)
        Bounds of fourth derivatives: on all intervals that are examined together, and on one.
    kinds : ndarray of int, shape (F,)
        What is known of each form on an interval.
    states : ndarray, shape (2, F, 2)
        Values and slopes at both ends.
    """

    z: Complex
    throughout: Vector
    own: Vector
    kinds: Integers
    states: Matrix


def room_for(along: Along) -> Room:
    """Return room for some forms."""
    count, z = len(along.sizes), np.zeros(len(along.free), np.complex128)
    bounds, kinds = np.zeros((2, count)), np.zeros(count, np.int64)
    return Room(z, bounds[0], bounds[1], kinds, np.zeros((2, count, 2)))


def first_event(along: Along, most: float) -> tuple[float, int, int]:
    """Return the time at which the first of some forms vanishes, how it ended, which form.

    How is `EVENT`, `CUT`, `BEYOND` or `LOST`.

    Parameters
    ----------
    along : Along
        Each form is not negative just after the start.
    most : float
        Time after which the search ends.
    """
    tolerance, first, watched = np.zeros(len(along.sizes)), min(most, along.window), False
    room = room_for(along)
    for f in range(len(tolerance)):
        if along.leading[f] == NEVER:
            tolerance[f] = inf
            continue
        tolerance[f], watched = NOISE * float(along.sizes[f]), True
        if 0 < along.leading[f] < TERMS:
            first = min(first, departs(along, f, most, room.throughout))
    t, h = 0.0, first / POINTS
    if not (watched and isfinite(h)):
        return (0.0, BEYOND, 0) if watched or not isfinite(most) else (most, CUT, 0)
    for _ in range(MOST_ROUNDS):
        if t >= most:
            return most, CUT, 0
        k, certain = first_doubt(along, t, h, most, first, tolerance, room)
        if k == NONE:
            return t, BEYOND, 0
        a, b, below = min(t + h * k, most), min(t + h * (k + 1), most), first_below(room.kinds)
        if k == POINTS:
            t, h = a, LONGER * h
        elif certain:
            return first_zero_of(along, room, a, b)
        elif b - a > 4 * EPS * b:
            t, h = a, (b - a) / POINTS
        elif below != NONE:
            return b, EVENT, below
        else:
            t, h = b, first / POINTS
    return t, LOST, 0


def first_doubt(
    along: Along, t: float, h: float, most: float, first: float, tolerance: Vector, room: Room
) -> tuple[int, bool]:
    """Return the first interval in which a form may have a zero, and whether that is certain.

    `POINTS` if there is none, `NONE` where a form is beyond float64 before.  In `room` is then
    what is known of each form there, and at both ends.  A form that starts at zero has no other
    zero before the time `first`.
    """
    states = room.states
    put_bounds(along, 4, t, min(t + h * POINTS, most) - t, room.throughout)
    total = put_state(along, t, room.z, states[1])
    for k in range(POINTS):
        a, b = min(t + h * k, most), min(t + h * (k + 1), most)
        if a == most:
            break
        for f in range(len(room.kinds)):
            states[0, f, 0], states[0, f, 1] = states[1, f, 0], states[1, f, 1]
        total += put_state(along, b, room.z, states[1])
        if not isfinite(total):
            return NONE, False
        doubts, certain = judged(along, a, b, first, room.throughout, tolerance, room)
        if doubts > certain:  # perhaps not by the bound of this interval alone
            put_bounds(along, 4, a, b - a, room.own)
            doubts, certain = judged(along, a, b, first, room.own, tolerance, room)
        if doubts > 0:
            return k, certain == doubts
    return POINTS, False


def put_state(along: Along, t: float, z: Complex, state: Matrix) -> float:
    """Fill in values and slopes at a time, shape (F, 2); return the sum of the values.

    `z` is room for the poles.
    """
    wave, total = wave_at(along.modes, t), 0.0
    put_poles(along.modes, t, wave, along.apart, z)
    for f in range(len(state)):
        state[f, 0], state[f, 1] = value_at(along, f, z, wave)
        total += state[f, 0]
    return total


def judged(
    along: Along, a: float, b: float, first: float, bound: Vector, tolerance: Vector, room: Room
) -> tuple[int, int]:
    """Fill in what is known of each form on an interval, by bounds of fourth derivatives.

    Return how many may have a zero, and how many certainly have.
    """
    doubts, certain, kinds, states = 0, 0, room.kinds, room.states
    for f in range(len(kinds)):
        kinds[f], counts = NO_ZERO, along.leading[f] == 0 or b > first
        if along.leading[f] == TERMS:
            counts = not waits(along, states[:, f, 0], b - a, float(tolerance[f]))
        if counts:
            cubic = cubic_of(states[0, f], states[1, f])
            kinds[f] = kind_of(cubic, b - a, float(bound[f]), float(tolerance[f]))
        doubts += kinds[f] != NO_ZERO
        certain += kinds[f] == FALLING
    return doubts, certain


def waits(along: Along, values: Vector, h: float, tolerance: float) -> bool:
    """Whether a form that starts at zero is still zero, to rounding, on an interval."""
    most = max(abs(float(values[0])), abs(float(values[1])))
    return bool(h <= along.window / POINTS and most <= tolerance)


def first_below(kinds: Integers) -> int:
    """Return the first form that is negative at the end of an interval, or `NONE`."""
    for f in range(len(kinds)):
        if kinds[f] >= BELOW:
            return f
    return NONE


def first_zero_of(along: Along, room: Room, a: float, b: float) -> tuple[float, int, int]:
    """Return the first zero of the forms that decrease throughout an interval."""
    first, form = inf, 0
    for f in range(len(room.kinds)):
        if room.kinds[f] == FALLING:
            cubic = cubic_of(room.states[0, f], room.states[1, f])
            zero = zero_of(along, f, a, b, cubic, room.z)
            first, form = (zero, f) if zero < first else (first, form)
    return first, EVENT, form


def departs(along: Along, f: int, most: float, limits: Vector) -> float:
    """Return a time in which a form that starts at zero has no other zero.

    Until then its first nonzero derivative keeps at least half of its value.  `limits` is room
    for the bounds of all forms.
    """
    most = min(most, 1 / along.growth) if along.growth > 0 else most
    put_bounds(along, int(along.leading[f]) + 1, 0.0, most, limits)
    bound = float(limits[f])
    return min(most, float(along.rate[f]) / (2 * bound)) if bound != 0 else most


def cubic_of(start: Vector, end: Vector) -> tuple[float, float, float, float]:
    """Return values and slopes at both ends of an interval."""
    return float(start[0]), float(end[0]), float(start[1]), float(end[1])


def kind_of(
    cubic: tuple[float, float, float, float], h: float, bound: float, tolerance: float
) -> int:
    """Return what is known of a form, by its cubic and the bound of its fourth derivative."""
    left, right, falls, rises = cubic
    inner = min(left + h * falls / 3, right - h * rises / 3)
    if min(left, right, inner) - bound * power_of(h, 4) / 384 > -tolerance:
        return NO_ZERO
    if not right < -tolerance:
        return DOUBTFUL
    mean = (right - left) / (h if h > 0 else 1.0)
    steep = max(falls, rises, 3 * mean - falls - rises)
    return FALLING if steep + bound * power_of(h, 3) / 124 < 0 else BELOW


def zero_of(
    along: Along, f: int, a: float, b: float, cubic: tuple[float, float, float, float],
    z: Complex,
) -> float:  # fmt: skip
    """Return the zero of a decreasing form between two times, by Newton's method.

    It starts from the zero of the cubic.  `z` is room for the poles.
    """
    low, high, h = max(0.0, 2 * a - b), b, b - a  # it may begin below, by rounding
    t = a + h * zero_of_cubic(cubic[0], cubic[1], h * cubic[2], h * cubic[3])
    last, rounding = EPS * b, NOISE * float(along.sizes[f])  # no step before the first
    for _ in range(STEPS):
        wave = wave_at(along.modes, t)
        put_poles(along.modes, t, wave, along.modes.least, z)
        value, slope = value_at(along, f, z, wave)
        if value == 0:
            return t
        low, high = (t, high) if value > 0 else (low, t)
        moved = t - value / slope if slope < 0 else inf
        if abs(value) <= rounding and slope < 0:
            return min(max(moved, low), high)
        moved = moved if low < moved < high else (low + high) / 2
        step = abs(moved - t)
        if step * min(1.0, power_of(step / last, 2)) <= EPS * t:  # they shrink by their squares
            return moved
        t, last = moved, step
    return t


def zero_of_cubic(start: float, end: float, falls: float, rises: float) -> float:
    """Return the zero in [0, 1] of a decreasing cubic.

    Examples
    --------
    >>> round(zero_of_cubic(1.0, -7.0, 0.0, -24.0), 6)
    0.5
    """
    second, third = 3 * (end - start) - 2 * falls - rises, 2 * (start - end) + falls + rises
    u = min(max(start / (start - end), 0.0), 1.0)
    for _ in range(CUBIC):
        slope = falls + u * (2 * second + 3 * u * third)
        value = start + u * (falls + u * (second + u * third))
        u = min(max(u - value / slope if slope < 0 else 0.5, 0.0), 1.0)
    return u
