"""Orbits of one order of phases on a grid of two parameters, each from its neighbours.

The equations of a cell are series in two parameters, each from -1 to 1 over the grid (see
`plane`).  From an orbit at a point Newton's method leads to those at the points beside it:
predicted from the point on the other side, in smaller steps where its corrections do not fall
quickly, and never through a fold, where the determinant changes its sign.  What it leads to
counts if all that is watched holds.  Several orbits may be at one point: they are kept in a
list, and two are one where they do not differ.

Plain Python, or compiled by numba with the equations along a branch.
"""

from math import isfinite, pi
from typing import Any

import numpy as np

from ..arrays import Matrix, Vector
from ..branch.extended import (
    CORRECTIONS,
    FALL,
    case_at,
    chebyshev_at,
    newton_step,
    residual_and_jacobian,
)
from ..branch.watch import watched
from ..iteration.iteration import scale_rows
from ..iteration.linear import factorise
from ..stability.cell_map import cell_map, end_rates

#: The last correction: the next one would be its square.  Corrections that show the way.
CLOSE, FIRST_FALL = 1e-9, 0.1

#: Smallest step, as a part of the way between two points; differences of orbits that are one.
SHORTEST, SAME = 1.0 / 16, 1e-6

#: Right, left, up, down: rows and columns.  The opposite of side s is s ^ 1.
DOWN, ALONG = (0, 0, 1, -1), (1, -1, 0, 0)


def row_of(plane: Any, b: float) -> Any:
    """Return the equations along the first parameter, as `extended` takes them."""
    kinds, setting, series, divided, weights, before, sign, known = plane
    waves = chebyshev_at(b, series.shape[2])
    rows = series.reshape(-1, len(waves))
    found = np.dot(rows, waves).reshape(series.shape[0], series.shape[1])
    return kinds, setting, found, divided, weights, before, sign, known


def settled(plane: Any, z: Vector, a: float, b: float) -> tuple[bool, float, float]:
    """Lead `z` to the orbit at a point; whether it gets there, and how.

    Then the second correction as a part of the first, 0 where there is none, and the sign of
    the determinant of the equations.
    """
    case, n, weights = case_at(row_of(plane, b), a), len(z), plane[4]
    J, scales, rows = np.empty((n, n)), np.empty(n), np.empty(n, np.int64)
    step, before, fall, sign = np.empty(n), np.inf, 0.0, 0.0
    for turn in range(CORRECTIONS):
        residual_and_jacobian(case, plane[3], z, step, J)
        for i in range(n):
            J[i] /= weights[:n]
        scale_rows(J, scales)
        if not factorise(J, rows):
            return False, fall, 0.0
        sign = 1.0
        for j in range(n):
            sign = -sign if (J[j, j] < 0) != (rows[j] != j) else sign
        size = newton_step(z, step, J, rows, scales, weights)
        if not isfinite(size):
            return False, fall, sign
        if turn == 1:
            fall = size / before
        if size <= CLOSE:
            return True, fall, sign
        if turn > 0 and size > FALL * before:
            return False, fall, sign
        before = size
    return False, fall, sign


def led(
    plane: Any, z: Vector, sign: float, at: Any, to: Any, slope: Vector
) -> tuple[bool, Vector]:
    """Return whether there is a way from an orbit at a point to one at another, and that.

    slope : ndarray, shape (n,)
        How much the orbit changes on the way, as far as is known.
    """
    t, h, found, rate = 0.0, 1.0, z, slope
    while t < 1:
        trial, u = found + h * rate, t + h
        a, b = at[0] + u * (to[0] - at[0]), at[1] + u * (to[1] - at[1])
        converged, fall, side = settled(plane, trial, a, b)
        if converged and fall <= FIRST_FALL and side == sign:
            rate, found, t = (trial - found) / h, trial, u
            h = min(2 * h, 1 - t)
        else:
            h /= 2
            if h < SHORTEST:
                return False, found
    return True, found


def holds(plane: Any, table: Any, z: Vector, a: float, b: float, maps: Any) -> bool:
    """Whether all that is watched of an orbit holds; fill in what its cell makes of states.

    maps : ndarray, shape (2, n, n)
        See `cell_map`.
    """
    case = case_at(row_of(plane, b), a)
    count, before = len(case[0]), plane[5]
    values, nothing = np.empty((len(table), 3)), np.empty((0, 2))
    watched(case, table, z, values, nothing)
    for row in range(len(values)):
        for j in range(3):
            if values[row, j] < 0:
                return False
    for p in range(count):
        if not z[before + p] >= 0:
            return False
    reached, speed = end_rates(case, z), 0.0
    for p in range(len(reached)):
        speed = max(speed, abs(z[2 * p + 1]), abs(reached[p, 0]))
    maps[0], maps[1], _ = cell_map(case, z, reached, speed)
    return True


def change(plane: Any, z: Vector, other: Vector) -> Vector:
    """Return by what two orbits differ, the phase of the forcing up to whole turns."""
    found = z - other
    if len(z) > plane[5] + len(plane[0]):
        found[-1] -= 2 * pi * round(found[-1] / (2 * pi))
    return found


def number_of(
    plane: Any, table: Any, A: Vector, B: Vector, point: int, z: Vector, sign: float,
    count: int, orbits: Any,
) -> int:  # fmt: skip
    """Return the number of an orbit at a point, a new one if it is not known; -1 if none."""
    Z, at, signs, _, heads, others, maps = orbits
    k = heads[point]
    while k >= 0:
        apart = change(plane, z, Z[k])
        most = 0.0
        for j in range(len(z)):
            most = max(most, abs(apart[j] * plane[4][j]))
        if most <= SAME:
            return int(k)
        k = others[k]
    i, j = divmod(point, len(A))
    if not holds(plane, table, z, A[j], B[i], maps[count]):
        return -1
    Z[count], at[count], signs[count] = z, point, sign
    others[count], heads[point] = heads[point], count
    return count


def around(links: Any, k: int, side: int) -> int:
    """Return the orbit beside one, if it is known by way of the points on either hand."""
    for turn in (0, 1) if side > 1 else (2, 3):
        one = links[k, turn]
        two = links[one, side] if one >= 0 else -1
        if two >= 0 and links[two, turn ^ 1] >= 0:
            return int(links[two, turn ^ 1])
    return -1


def sown(
    plane: Any, table: Any, A: Vector, B: Vector, wide: float, seeds: Matrix, orbits: Any
) -> int:
    """Put orbits on a grid from others beside its points; return how many there are.

    wide : float
        Distance of the rows.
    seeds : ndarray, shape (m, n + 2)
        Unknowns and both parameters of each.
    """
    count, n = 0, seeds.shape[1] - 2
    for seed in seeds:
        a, b = seed[n], seed[n + 1]
        z = seed[:n].copy()
        converged, _, sign = settled(plane, z, a, b)
        if not converged:
            continue
        for i in np.flatnonzero(np.abs(B - b) < wide):
            for j in np.flatnonzero(np.abs(A - a) < A[1] - A[0]):
                ok, there = led(plane, z, sign, (a, b), (A[j], B[i]), np.zeros(n))
                if ok:
                    point = int(i) * len(A) + int(j)
                    k = number_of(plane, table, A, B, point, there, sign, count, orbits)
                    count += 1 if k == count else 0
    return count


def fill(
    plane: Any, table: Any, A: Vector, B: Vector, begin: int, count: int, orbits: Any
) -> tuple[int, int]:
    """Go from each orbit to the points beside it, until there are no new ones, or no room.

    Parameters
    ----------
    begin, count : int
        The first orbit from which to go on, and how many there are.
    orbits : tuple of ndarray
        Of each: unknowns, point, sign of the determinant, orbits to the right, left, up and
        down; of each point its last orbit; of each orbit the one before at its point, and the
        map of its cell.
    """
    Z, at, signs, links, _, _, _ = orbits
    while begin < count:
        i, j = divmod(at[begin], len(A))
        for side in range(4):
            ii, jj = i + DOWN[side], j + ALONG[side]
            inside = 0 <= ii < len(B) and 0 <= jj < len(A)
            if links[begin, side] >= 0 or not inside:
                continue
            k = around(links, begin, side)
            if k < 0:
                if count == len(Z):
                    return begin, count
                behind, slope = links[begin, side ^ 1], np.zeros(Z.shape[1])
                if behind >= 0:
                    slope = change(plane, Z[begin], Z[behind])
                here, there = (A[j], B[i]), (A[jj], B[ii])
                ok, z = led(plane, Z[begin], signs[begin], here, there, slope)
                point = ii * len(A) + jj
                if ok:
                    sign = signs[begin]
                    k = number_of(plane, table, A, B, point, z, sign, count, orbits)
                    count += 1 if k == count else 0
            if k >= 0:
                links[begin, side], links[k, side ^ 1] = k, begin
        begin += 1
    return begin, count
