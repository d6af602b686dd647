"""Minima of the demands of a body inside its phases, along a branch; see `branch.watch`.

The functions stand for those of the same names there.  Plain Python, or compiled by numba.
"""

from math import isnan, nan
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
from .ways import ahead, along, expanded, halves, over, way_of

#: A dip of the rate is looked into if the tangents at its ends meet below this part of it.
SHALLOW = 0.5

#: Corrections of a critical point by Newton's method.
POLISH = 6

#: Halvings about where a derivative vanishes, before it is taken for a line.
NARROWED = 8


def least_inside(
    way: Any, grid: Matrix, s: float, finer: Any, terms: Matrix, slopes: Matrix, begins: int
) -> tuple[float, float]:
    """Return the least value of a form at its critical points inside a phase, and its time.

    NaN without one.  Between two times of the grid the rate may change its sign, or dip below
    zero and come back, just behind a jump of the velocity at any scale.  A body has many
    minima: those that cannot be the least are left out.

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
    slopes : ndarray, shape (2, points)
        Rate and half the second derivative on the grid.
    begins : int
        Order of the first derivative of the form that is not identically zero at the start.
    """
    least, time, h = nan, nan, s / (grid.shape[1] - 1)
    rates, bends = slopes[0].copy(), slopes[1]
    if begins > 1:
        rates[0] = np.dot(terms[begins], grid[:, 0].copy())
    falls = (rates[:-1] < 0) & (rates[1:] >= 0)
    dips = (rates[:-1] >= 0) & (rates[1:] >= 0) & (bends[:-1] < 0) & (bends[1:] > 0)
    dips &= lowest(rates, 2 * bends, h) <= SHALLOW * np.minimum(rates[:-1], rates[1:])
    falls &= may_have_least(terms[0] @ grid, slopes, h, falls)
    for i in np.flatnonzero(falls | dips):
        value, offset, y = nan, 0.0, grid[:, i].copy()
        if dips[i]:
            y, offset, u = turning(way, y, h, h, finer, terms, 2)
            y, offset = ahead(way, u, y), offset + u
        if falls[i] or np.dot(terms[1], y) < 0:
            value, u = risen(way, y, h - offset, h, finer, terms)
            offset += u
        if not isnan(value) and (isnan(least) or value < least):
            least, time = value, i * h + offset
    return least, time


def may_have_least(heights: Vector, slopes: Matrix, h: float, falls: Any) -> Any:
    """Return for each step whether the least of the minima in the steps `falls` may be in it.

    It is not above any end of these steps.  Where a form is convex, it is above its tangents;
    their depth is doubled, since between the times of the grid it may be less convex.  A form
    may begin like a power of the time: the first step counts in any case.

    Parameters
    ----------
    heights : ndarray, shape (points,)
        The form on the grid.
    slopes
        See `least_inside`.
    """
    ends = np.minimum(heights[:-1], heights[1:])
    depth = ends - lowest(heights, slopes[0], h)
    may = (slopes[1, :-1] <= 0) | (slopes[1, 1:] <= 0)
    if falls.any():
        may |= ends - 2 * depth <= ends[falls].min()
    may[0] = True
    return may


def lowest(values: Vector, slopes: Vector, h: float) -> Vector:
    """Return the height at which the tangents at both ends of each step meet.

    A convex curve lies above it.
    """
    bend = slopes[:-1] - slopes[1:]
    u = (values[1:] - values[:-1] - slopes[1:] * h) / np.where(bend == 0, np.nan, bend)
    heights: Vector = values[:-1] + slopes[:-1] * u
    return heights


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
                slopes = terms[1:3] @ grid
                inside, _ = least_inside(way, grid, s, finer, terms, slopes, begins)
                values[row, LEAST] = inside
                values[row, END] = -np.dot(terms[1], last) if table[row, IS_END] != 0 else end
                continue
            end = -end if table[row, KIND] == BEHIND else end
            if isnan(values[into, END]) or end > values[into, END]:
                values[into, END] = end
        for j in range(len(extremes)):
            terms = expanded(way, case[4][p, j])
            ends = np.dot(terms[0], first), np.dot(terms[0], last)
            slopes = terms[1:3] @ grid
            for sign in (1.0, -1.0):
                inside, _ = least_inside(way, grid, s, finer, sign * terms, sign * slopes, 0)
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
    return least_inside(way, grid, s, finer, terms, terms[1:3] @ grid, table[row, BEGINS])[1]
