"""Orbits of one order of phases on a grid of two parameters, each from its neighbours.

The equations of a cell are series in two parameters, each in [-1, 1] over the grid (see
`plane`).  From the orbit at a point Newton's method continues to the neighbouring points.  The
prediction extrapolates from the point on the other side; steps are halved where the corrections
fall slowly, and the sign of the determinant must not change, as it does at a fold.  Orbits that
violate a monitor are dropped.  The orbits at one point are a linked list without duplicates.

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
from ..branch.walk import LOST
from ..branch.watch import watched
from ..iteration.iteration import scale_rows
from ..iteration.linear import factorise
from ..stability.cell_map import cell_map, end_rates

#: Size of the last correction, before quadratic convergence; most of the first ratio of two.
CLOSE, FIRST_FALL = 1e-9, 0.1

#: Least step between two points, as a part of it, and that for a tangent; difference of orbits
#: that are equal.
SHORTEST, PROBE, SAME = 1.0 / 64, 1e-4, 1e-6

#: Changes of row and column to the right, left, up, down.  The opposite of side s is s ^ 1.
DOWN, ALONG = (0, 0, 1, -1), (1, -1, 0, 0)


def row_of(plane: Any, b: float) -> Any:
    """Return the equations along the first parameter, as `extended` takes them."""
    kinds, setting, series, divided, weights, before, sign, known = plane
    waves = chebyshev_at(b, series.shape[2])
    rows = series.reshape(-1, len(waves))
    along_a = np.dot(rows, waves).reshape(series.shape[0], series.shape[1])
    return kinds, setting, along_a, divided, weights, before, sign, known


def settled(plane: Any, z: Vector, a: float, b: float) -> tuple[bool, float, float]:
    """Correct `z` to the orbit at (a, b) by Newton's method.

    Returned are whether it converges, the ratio of the second correction to the first, and the
    sign of the determinant of the Jacobian.
    """
    case, n, weights = case_at(row_of(plane, b), a), len(z), plane[4]
    J, scales, rows = np.empty((n, n)), np.empty(n), np.empty(n, np.int64)
    step, before, fall, sign = np.empty(n), np.inf, 0.0, 0.0
    for correction in range(CORRECTIONS):
        residual_and_jacobian(case, plane[3], z, step, J)
        J /= weights[:n]
        scale_rows(J, scales)
        if not factorise(J, rows):
            return False, fall, 0.0
        sign = 1.0
        for j in range(n):
            sign = -sign if (J[j, j] < 0) != (rows[j] != j) else sign
        size = newton_step(z, step, J, rows, scales, weights)
        if not isfinite(size):
            return False, fall, sign
        if correction == 1:
            fall = size / before
        if size <= CLOSE:
            return True, fall, sign
        if correction > 0 and size > FALL * before:
            return False, fall, sign
        before = size
    return False, fall, sign


def continued(
    plane: Any, z: Vector, sign: float, at: Any, to: Any, slope: Vector
) -> tuple[bool, Vector]:
    """Continue an orbit from one point to another; whether that succeeds, and the orbit.

    slope : ndarray, shape (n,)
        Predicted change of the orbit; zero if unknown.
    """
    t, h, orbit, rate = 0.0, 1.0, z, slope
    if not np.any(slope):  # unknown: along the tangent
        trial = z.copy()
        a, b = at[0] + PROBE * (to[0] - at[0]), at[1] + PROBE * (to[1] - at[1])
        converged, _, _ = settled(plane, trial, a, b)
        if converged:
            rate = (trial - z) / PROBE
    while t < 1:
        trial, u = orbit + h * rate, t + h
        a, b = at[0] + u * (to[0] - at[0]), at[1] + u * (to[1] - at[1])
        converged, fall, side = settled(plane, trial, a, b)
        if converged and fall <= FIRST_FALL and side == sign:
            rate, orbit, t = (trial - orbit) / h, trial, u
            h = min(2 * h, 1 - t)
        else:
            h /= 2
            if h < SHORTEST:
                return False, orbit
    return True, orbit


def holds(plane: Any, table: Any, z: Vector, a: float, b: float, maps: Any) -> bool:
    """Whether no monitor of an orbit is negative; fill in the map of its cell.

    maps : ndarray, shape (2, n, n)
        See `cell_map`.
    """
    case = case_at(row_of(plane, b), a)
    count, before = len(case[0]), plane[5]
    values, nothing = np.empty((len(table), 3)), np.empty((0, 2))
    watched(case, table, z, values, nothing)
    if (values < -LOST).any() or not (z[before : before + count] >= 0).all():
        return False
    reached, speed = end_rates(case, z), 0.0
    for p in range(len(reached)):
        speed = max(speed, abs(z[2 * p + 1]), abs(reached[p, 0]))
    maps[0], maps[1], _ = cell_map(case, z, reached, speed)
    return True


def change(plane: Any, z: Vector, other: Vector) -> Vector:
    """Return the difference of two orbits, with the phase of the forcing modulo 2 pi."""
    difference = z - other
    if len(z) > plane[5] + len(plane[0]):
        difference[-1] -= 2 * pi * round(difference[-1] / (2 * pi))
    return difference


def number_of(
    plane: Any, table: Any, A: Vector, B: Vector, point: int, z: Vector, sign: float,
    count: int, orbits: Any,
) -> int:  # fmt: skip
    """Return the number of an orbit at a point; it is added if new.  -1 if not admissible."""
    Z, at, signs, _, heads, others, maps = orbits
    k = heads[point]
    while k >= 0:
        if np.abs(change(plane, z, Z[k]) * plane[4][: len(z)]).max() <= SAME:
            return int(k)
        k = others[k]
    i, j = divmod(point, len(A))
    if not holds(plane, table, z, A[j], B[i], maps[count]):
        return -1
    Z[count], at[count], signs[count] = z, point, sign
    others[count], heads[point] = heads[point], count
    return count


def around(links: Any, k: int, side: int) -> int:
    """Return the neighbour of orbit k on a side if it is known by a detour; else -1."""
    for turn in (0, 1) if side > 1 else (2, 3):
        beside = links[k, turn]
        beyond = links[beside, side] if beside >= 0 else -1
        if beyond >= 0 and links[beyond, turn ^ 1] >= 0:
            return int(links[beyond, turn ^ 1])
    return -1


def sown(
    plane: Any, table: Any, A: Vector, B: Vector, wide: float, seeds: Matrix, orbits: Any
) -> int:
    """Continue known orbits to the grid points next to them; return how many are found.

    wide : float
        Distance of the rows of the grid.
    seeds : ndarray, shape (m, n + 2)
        Unknowns and both parameters of each orbit.
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
                arrived, orbit = continued(plane, z, sign, (a, b), (A[j], B[i]), np.zeros(n))
                if arrived:
                    point = int(i) * len(A) + int(j)
                    k = number_of(plane, table, A, B, point, orbit, sign, count, orbits)
                    count += 1 if k == count else 0
    return count


def fill(
    plane: Any, table: Any, A: Vector, B: Vector, begin: int, count: int, orbits: Any
) -> tuple[int, int]:
    """Continue each orbit to its neighbouring points, until none is new or the arrays are full.

    Parameters
    ----------
    begin, count : int
        The first orbit to continue from, and how many there are.
    orbits : tuple of ndarray
        Of each orbit: unknowns, point, sign of the determinant, neighbours to the right, left,
        up and down.  Of each point its last orbit.  Of each orbit the one before at its point,
        and the map of its cell.
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
                start, goal = (A[j], B[i]), (A[jj], B[ii])
                converged, z = continued(plane, Z[begin], signs[begin], start, goal, slope)
                point = ii * len(A) + jj
                if converged:
                    sign = signs[begin]
                    k = number_of(plane, table, A, B, point, z, sign, count, orbits)
                    count += 1 if k == count else 0
            if k >= 0:
                links[begin, side], links[k, side ^ 1] = k, begin
        begin += 1
    return begin, count
