"""What is watched of the contact forms of a body along a branch; see `branch.watch`.

The functions stand for those of the same names there.  Plain Python, or compiled by numba.
"""

from math import ceil, isnan, log2, nan
from typing import Any

import numpy as np

from ...arrays import Matrix, Vector
from ..watch import (
    BEGINS,
    BEHIND,
    END,
    EXPANDED,
    INTO,
    IS_END,
    KIND,
    LEAST,
    PHASE,
    POLISH,
    START,
    WITHIN,
    polynomial,
)
from .equations import starts
from .exponential import gained, norm

#: Points of a phase for 1 of the size of its generator, at least and at most.
CLOSE, FEWEST, MOST = 2.0, 32, 1024

#: Halvings about where a derivative vanishes, before it is taken for a line.
NARROWED = 8


def along_phase(case: Any, p: int, s: float, Y: Vector) -> Matrix:
    """Return the states at equal times of a phase, as close as its waves; shape (points, W)."""
    states, one = len(Y) - 3, np.eye(len(Y))
    size = norm(case[1][p, :states, :states]) * abs(s)
    count = int(min(max(ceil(CLOSE * size), FEWEST), MOST))
    found, done = np.empty((count + 1, len(Y))), 1
    found[0], step = Y, gained(case, p, s / count, one)
    while done <= count:
        more = min(done, count + 1 - done)
        found[done : done + more] = found[:more] + found[:more] @ step.T
        done, step = done + more, 2 * step + step @ step
    return found


def halves(case: Any, p: int, h: float) -> Any:
    """Return ``exp(G t) - 1`` over a half, a quarter, ... of a step, to one that is short."""
    width = case[1].shape[1]
    size = norm(case[1][p, : width - 3, : width - 3]) * abs(h) * CLOSE
    count = ceil(log2(size)) if size > 1 else 0
    found = np.empty((count, width, width))
    if count > 0:
        found[count - 1] = gained(case, p, h / 2.0**count, np.eye(width))
    for j in range(count - 2, -1, -1):
        found[j] = found[j + 1] @ found[j + 1] + 2 * found[j + 1]
    return found


def expanded(generator: Matrix, form: Vector) -> Matrix:
    """Return the forms that are the Taylor coefficients of a form, shape (EXPANDED, W)."""
    found = np.empty((EXPANDED, len(form)))
    found[0] = form
    for j in range(1, EXPANDED):
        found[j] = found[j - 1] @ generator / j
    return found


def least_inside(
    generator: Matrix, grid: Matrix, s: float, finer: Any, terms: Matrix, begins: int
) -> tuple[float, float]:
    """Return the least value of a form at its critical points inside a phase, and when.

    Not a number without one.  Between two times of the grid its rate may change its sign, or
    fall below zero and rise again: just behind a jump of the velocity at any scale.

    Parameters
    ----------
    generator, grid : ndarray
        See `along_phase`.
    s : float
        The duration.
    finer : ndarray
        The `halves` of a step of the grid.
    terms : ndarray
        See `expanded`.
    begins : int
        The first derivative of the form that is not zero by itself where the phase begins.
    """
    least, when, h = nan, nan, s / (len(grid) - 1)
    rates, bends = grid @ terms[1], grid @ terms[2]
    if begins > 1:
        rates[0] = np.dot(terms[begins], grid[0])
    falls = (rates[:-1] < 0) & (rates[1:] >= 0)
    dips = (rates[:-1] >= 0) & (rates[1:] >= 0) & (bends[:-1] < 0) & (bends[1:] > 0)
    for i in np.flatnonzero(falls | dips):
        value, at, Y = nan, 0.0, grid[i]
        if dips[i]:
            Y, at, u = turning(Y, h, h, finer, terms, 2)
            Y, at = shortly(generator, Y, u), at + u
        if falls[i] or np.dot(terms[1], Y) < 0:
            value, u = risen(Y, h - at, h, finer, terms)
            at += u
        if not isnan(value) and (isnan(least) or value < least):
            least, when = value, i * h + at
    return least, when


def turning(
    Y: Vector, left: float, h: float, finer: Any, terms: Matrix, derivative: int
) -> tuple[Vector, float, float]:
    """Return where a derivative of a form changes its sign from minus, in the time `left`.

    It is the state a little before, when that is, and how much later the derivative vanishes.
    """
    t, width = 0.0, h
    for j in range(len(finer)):
        width /= 2
        if t + width < left:
            middle = Y + finer[j] @ Y
            if np.dot(terms[derivative], middle) < 0:
                Y, t = middle, t + width
    own, low, high = terms @ Y, 0.0, min(width, left - t)
    for _ in range(NARROWED):
        middle_t = (low + high) / 2
        if polynomial(own, middle_t, derivative) < 0:
            low = middle_t
        else:
            high = middle_t
    below, above = polynomial(own, low, derivative), polynomial(own, high, derivative)
    if below < 0 < above:
        low += (high - low) * below / (below - above)
    return Y, t, low


def shortly(generator: Matrix, Y: Vector, t: float) -> Vector:
    """Return what a state becomes in a time that is short for its waves: a Taylor series."""
    found, term = Y.copy(), Y
    for j in range(1, EXPANDED):
        term = generator @ term * (t / j)
        found += term
    return found


def risen(Y: Vector, left: float, h: float, finer: Any, terms: Matrix) -> tuple[float, float]:
    """Return the value of a form where its rate rises through zero in a time, and when."""
    Y, t, u = turning(Y, left, h, finer, terms, 1)
    own = terms @ Y
    for _ in range(POLISH):
        bend = polynomial(own, u, 2)
        if bend > 0:
            u = min(max(u - polynomial(own, u, 1) / bend, 0.0), left - t)
    return polynomial(own, u, 0), t + u


def watched(case: Any, table: Any, z: Vector, values: Matrix, extremes: Matrix) -> None:
    """Fill in what is watched at an orbit, and the ends of its displacement and velocity.

    Of the first contact; see `watch.watched`.
    """
    begin, before = starts(case, z), case[1].shape[1] - 3
    values[:, :] = nan
    extremes[:, 0], extremes[:, 1] = np.inf, -np.inf
    for p in range(len(case[0])):
        generator, s = case[1][p], z[before + p]
        grid = along_phase(case, p, s, begin[p])
        first, last, finer = grid[0], grid[-1], halves(case, p, s / (len(grid) - 1))
        for row in range(len(table)):
            if table[row, PHASE] != p:
                continue
            form, into, begins = case[6][row], table[row, INTO], table[row, BEGINS]
            end = np.dot(form, last)
            if table[row, KIND] == WITHIN:
                terms = expanded(generator, form)
                values[row, START] = np.dot(terms[begins], first)
                values[row, LEAST], _ = least_inside(generator, grid, s, finer, terms, begins)
                values[row, END] = -np.dot(terms[1], last) if table[row, IS_END] != 0 else end
                continue
            end = -end if table[row, KIND] == BEHIND else end
            if isnan(values[into, END]) or end > values[into, END]:
                values[into, END] = end
        for j in range(len(extremes)):
            form = case[4][p, j]
            for side in (1.0, -1.0):
                turned = expanded(generator, side * form)
                inside, _ = least_inside(generator, grid, s, finer, turned, 0)
                for value in (np.dot(form, first), np.dot(form, last), side * inside):
                    if not isnan(value):
                        extremes[j, 0] = min(extremes[j, 0], value)
                        extremes[j, 1] = max(extremes[j, 1], value)


def when_least(case: Any, table: Any, z: Vector, row: int) -> float:
    """Return when in its phase a form has the least value at a critical point inside."""
    p = table[row, PHASE]
    generator, s = case[1][p], z[case[1].shape[1] - 3 + p]
    grid = along_phase(case, p, s, starts(case, z)[p])
    finer, terms = halves(case, p, s / (len(grid) - 1)), expanded(generator, case[6][row])
    return least_inside(generator, grid, s, finer, terms, table[row, BEGINS])[1]
