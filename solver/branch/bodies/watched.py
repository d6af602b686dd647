"""Minima of the demands of a body inside its phases, along a branch; see `branch.watch`.

The functions stand for those of the same names there.  Plain Python, or compiled by numba.
"""

from math import inf, isnan, nan
from typing import Any

import numpy as np

from ...arrays import Matrix, Vector
from ..watch import (
    BEGINS,
    BEHIND,
    END,
    INTO,
    IS_END,
    KIND,
    LEAST,
    PHASE,
    START,
    WITHIN,
    polynomial,
)
from .equations import initial_states
from .exponential import by_basis
from .ways import ahead, along, expanded, halves, may_change, moves_of, over, way_of

#: A dip or a peak of the rate is looked into if the tangents at its ends meet nearer to zero
#: than this part of it.
SHALLOW = 0.5

#: Most steps of a phase that are halved; how often they are until it is seen which matter.
MOST_STEPS, AT_ONCE = 8192, 3

#: Corrections of a critical point by Newton's method.
POLISH = 6

#: Halvings about where a derivative vanishes, before it is taken for a line.
NARROWED = 8


def least_inside(
    way: Any, grid: Matrix, s: float, finer: Any, terms: Matrix, begins: int
) -> tuple[float, float]:
    """Return the least value of a form at its critical points inside a phase, and its time.

    NaN without one.  Within a step the rate may change its sign, or pass zero and come back:
    see `watch.least_inside`.  A body has many minima: those that cannot be the least are left
    out.

    Parameters
    ----------
    way, grid
        See `ways.way_of` and `ways.along`.
    s : float
        The duration.
    finer
        The `ways.halves` of a step of the grid.
    terms : ndarray
        See `ways.expanded`.
    begins : int
        Order of the first derivative of the form that is not identically zero at the start.
    """
    least, time, h, starts = nan, nan, s / (grid.shape[1] - 1), grid
    times, series = h * np.arange(grid.shape[1] - 1), terms[:3] @ grid
    begin, end = series[:, :-1].copy(), series[:, 1:].copy()
    if len(finer[1]) > 0:
        starts, times, halvings = narrowed(way, grid, h, finer[1], terms)
        if len(times) == 0:
            return nan, nan
        h, step = h / 2.0**halvings, finer[1][halvings - 1]
        ends = starts + by_basis(way[1], way[2], way[3], step, h, starts)
        begin, end = terms[:3] @ starts, terms[:3] @ ends
        for j in range(len(times) - 1):
            if times[j + 1] - times[j] < 1.5 * h:  # the same point, with the same rounding
                end[:, j] = begin[:, j + 1]
        finer = (finer[0], finer[1][halvings:])
    if begins > 1:
        begin[1] = np.where(times == 0, np.dot(terms[begins], grid[:, 0].copy()), begin[1])
    falls = (begin[1] < 0) & (end[1] >= 0)
    dips = (begin[1] >= 0) & (end[1] >= 0) & (begin[2] < 0) & (end[2] > 0)
    peaks = (begin[1] < 0) & (end[1] < 0) & (begin[2] > 0) & (end[2] < 0)
    tangents = meeting(begin[1], end[1], 2 * begin[2], 2 * end[2], h)
    dips &= tangents <= SHALLOW * np.minimum(begin[1], end[1])
    peaks &= tangents >= SHALLOW * np.maximum(begin[1], end[1])
    for i in np.flatnonzero(falls | dips | peaks):
        value, offset, left, y = nan, 0.0, h, starts[:, i].copy()
        rises = falls[i]
        if dips[i]:
            y, offset, u = turning(way, y, h, h, finer, terms, 2)
            y, offset = ahead(way, u, y), offset + u
            rises = np.dot(terms[1], y) < 0
        elif peaks[i]:
            top, left, u = turning(way, y, h, h, finer, -terms, 2)
            left += u
            rises = np.dot(terms[1], ahead(way, u, top)) > 0
        if rises:
            value, u = risen(way, y, left - offset, h, finer, terms)
            offset += u
        if not isnan(value) and (isnan(least) or value < least):
            least, time = value, times[i] + offset
    return least, time


def narrowed(
    way: Any, grid: Matrix, h: float, finer: Any, terms: Matrix
) -> tuple[Matrix, Vector, int]:
    """Return short steps in which a form may have its least value at a critical point.

    The steps of the grid are halved; left out are those in which the form stays above a
    minimum that is known, or its rate keeps its sign.

    Parameters
    ----------
    finer : ndarray of complex
        The `ways.halves` of a step h, by the eigenbasis; one at least.

    Returns
    -------
    starts : ndarray
        The coordinates at the start of each step, by column.
    times : ndarray
        Their times, which increase.
    halvings : int
        How often h is halved: until the fastest pole is resolved, if that takes no more than
        `MOST_STEPS` steps, and once at least if any step is left.
    """
    heights, known, halvings, first = terms[0] @ grid, inf, 0, grid[:, 0].copy()
    for i in range(1, len(heights) - 1):
        if heights[i] <= min(heights[i - 1], heights[i + 1]):
            known = min(known, heights[i])
    starts, times = grid[:, :-1].copy(), h * np.arange(grid.shape[1] - 1)
    while halvings < len(finer) and (halvings == 0 or len(times) <= MOST_STEPS):
        moves = moves_of(way, h, starts)
        may = terms[0] @ starts - may_change(way, h, first, moves, terms[0]) <= known
        may &= np.abs(terms[1] @ starts) <= may_change(way, h, first, moves, terms[1])
        starts, times = starts[:, may], times[may]
        if len(times) == 0:
            break
        for _ in range(min(AT_ONCE, len(finer) - halvings)):
            h /= 2
            middles = starts + by_basis(way[1], way[2], way[3], finer[halvings], h, starts)
            starts = np.concatenate((starts, middles), axis=1)
            times = np.concatenate((times, times + h))
            halvings += 1
    order = np.argsort(times)
    return starts[:, order], times[order], halvings


def meeting(first: Vector, last: Vector, slope: Vector, last_slope: Vector, h: float) -> Vector:
    """Return the height at which the tangents at both ends of each step meet.

    A convex curve lies above it, a concave one below.
    """
    bend = slope - last_slope
    u = (last - first - last_slope * h) / np.where(bend == 0, np.nan, bend)
    return first + slope * u


def turning(
    way: Any, y: Vector, left: float, h: float, finer: Any, terms: Matrix, derivative: int
) -> tuple[Vector, float, float]:
    """Return where a derivative of a form changes from minus to plus, in the time `left`.

    The coordinates a little before, their time, and how much later the derivative vanishes.
    """
    t, width = 0.0, h
    for j in range(max(len(finer[0]), len(finer[1]))):
        width /= 2
        if t + width < left:
            middle = over(way, finer, j, width, y)
            if np.dot(terms[derivative], middle) < 0:
                y, t = middle, t + width
    series, low, high = terms @ y, 0.0, min(width, left - t)
    for _ in range(NARROWED):
        middle_t = (low + high) / 2
        if polynomial(series, middle_t, derivative) < 0:
            low = middle_t
        else:
            high = middle_t
    below, above = polynomial(series, low, derivative), polynomial(series, high, derivative)
    if below < 0 < above:
        low += (high - low) * below / (below - above)
    return y, t, low


def risen(
    way: Any, y: Vector, left: float, h: float, finer: Any, terms: Matrix
) -> tuple[float, float]:
    """Return the value of a form where its rate rises through zero, and the time."""
    y, t, u = turning(way, y, left, h, finer, terms, 1)
    series = terms @ y
    for _ in range(POLISH):
        bend = polynomial(series, u, 2)
        if bend > 0:
            u = min(max(u - polynomial(series, u, 1) / bend, 0.0), left - t)
    return polynomial(series, u, 0), t + u


def watched(case: Any, table: Any, z: Vector, values: Matrix, extremes: Matrix) -> None:
    """Fill in the values of the watched forms, and the extremes of the first contact.

    See `watch.watched`.
    """
    starts, states = initial_states(case, z), case[1].shape[1] - 3
    values[:, :] = nan
    extremes[:, 0], extremes[:, 1] = np.inf, -np.inf
    for p in range(len(case[0])):
        if len(extremes) == 0 and not (table[:, PHASE] == p).any():
            continue
        way, s = way_of(case, p), z[states + p]
        grid = along(way, s, starts[p])
        finer = halves(way, s / (grid.shape[1] - 1))
        first, last = grid[:, 0].copy(), grid[:, -1].copy()
        for row in range(len(table)):
            if table[row, PHASE] != p:
                continue
            into, begins = table[row, INTO], table[row, BEGINS]
            terms = expanded(way, case[6][row])
            end = np.dot(terms[0], last)
            if table[row, KIND] == WITHIN:
                values[row, START] = np.dot(terms[begins], first)
                inside, _ = least_inside(way, grid, s, finer, terms, begins)
                values[row, LEAST] = inside
                values[row, END] = -np.dot(terms[1], last) if table[row, IS_END] != 0 else end
                continue
            end = -end if table[row, KIND] == BEHIND else end
            if isnan(values[into, END]) or end > values[into, END]:
                values[into, END] = end
        for j in range(len(extremes)):
            terms = expanded(way, case[4][p, j])
            ends = np.dot(terms[0], first), np.dot(terms[0], last)
            for sign in (1.0, -1.0):
                inside, _ = least_inside(way, grid, s, finer, sign * terms, 0)
                for value in (ends[0], ends[1], sign * inside):
                    if not isnan(value):
                        extremes[j, 0] = min(extremes[j, 0], value)
                        extremes[j, 1] = max(extremes[j, 1], value)


def when_least(case: Any, table: Any, z: Vector, row: int) -> float:
    """Return the time in its phase of the least value of a form at a critical point."""
    p = table[row, PHASE]
    way, s = way_of(case, p), z[case[1].shape[1] - 3 + p]
    grid = along(way, s, initial_states(case, z)[p])
    finer, terms = halves(way, s / (grid.shape[1] - 1)), expanded(way, case[6][row])
    return least_inside(way, grid, s, finer, terms, table[row, BEGINS])[1]
