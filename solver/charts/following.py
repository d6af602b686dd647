"""A curve of events in two parameters: orbits on which a monitor vanishes.

Beside those of a branch there is one more unknown, the second parameter, and one more equation,
the monitor.  That of a fold is the determinant of the equations.

Plain Python, or compiled by numba with the equations along a branch.
"""

from math import isfinite, nan, sqrt
from typing import Any

import numpy as np

from ..arrays import Matrix, Vector
from ..branch.extended import (
    DIFFERENCE,
    SMALL,
    case_at,
    jacobian_along,
    residual_along,
    tangent,
)
from ..branch.walk import FLIP, MEETS, multiplier_monitors, tangent_and_monitors
from ..branch.watch import INTO, PHASE, watched
from ..iteration.iteration import ROUNDOFF, scale_rows
from ..iteration.linear import factorise, solve_factorised
from ..stability.cell_map import cell_map, end_rates
from .filling import row_of

#: Most corrections; most of them with a new Jacobian.
MOST_CORRECTIONS, FRESH = 16, 3

#: Ratio of two corrections above which they are rounding; below which the Jacobian is kept,
#: since a new one costs as much as twenty corrections.
FALLING, QUICK = 0.7, 0.1


def monitors_at(plane: Any, table: Any, y: Vector) -> Vector:
    """Return the monitors at an orbit."""
    n = len(y) - 2
    border, extremes, maps = np.zeros(n + 1), np.empty((2, 2)), np.empty((2, 0, 0))
    border[n] = 1.0
    _, values = tangent_and_monitors(
        row_of(plane, y[n + 1]), table, y[: n + 1], border, extremes, maps
    )
    monitors: Vector = values
    return monitors


def monitor_at(plane: Any, table: Any, monitor: int, y: Vector) -> float:
    """Return one of the monitors at an orbit, without computing the others."""
    n, along, row = len(y) - 2, row_of(plane, y[len(y) - 1]), monitor // 3
    p = monitor - 3 * len(table)
    own, case = p - len(along[0]), case_at(along, y[n])
    if own == MEETS:
        border = np.zeros(n + 1)
        border[n] = 1.0
        _, meets = tangent(along, y[: n + 1], border)
        return float(meets)
    if own >= 0:
        through, _, _ = cell_map(case, y[:n], end_rates(case, y[:n]), 1.0)
        if not np.isfinite(through).all():
            return nan
        flip, _, pairs = multiplier_monitors(along[6] * through)
        return float(flip if own == FLIP else pairs)
    if p >= 0:
        return float(y[along[5] + p])
    needed, values = table.copy(), np.empty((len(table), 3))
    for i in range(len(table)):
        if i != row and table[i, INTO] != row:
            needed[i, PHASE] = -1
    watched(case, needed, y[:n], values, np.empty((0, 2)))
    return float(values[row, monitor % 3])


def residuals(plane: Any, table: Any, monitor: int, y: Vector, R: Vector) -> None:
    """Fill R with the residual of the equations, the monitor and zero."""
    n = len(y) - 2
    residual_along(row_of(plane, y[n + 1]), y[:n], y[n], R[:n])
    R[n], R[n + 1] = monitor_at(plane, table, monitor, y), 0.0


def bordered_jacobian(
    plane: Any, table: Any, monitor: int, y: Vector, border: Vector, J: Matrix
) -> None:
    """Fill J with the Jacobian of `residuals` in scaled coordinates, bordered by a row."""
    n, weights = len(y) - 2, plane[4]
    jacobian = np.empty((n, n + 1))
    jacobian_along(row_of(plane, y[n + 1]), y[:n], y[n], jacobian)
    J[:n, : n + 1] = jacobian
    above, below = np.empty(n), np.empty(n)
    residual_along(row_of(plane, y[n + 1] + DIFFERENCE), y[:n], y[n], above)
    residual_along(row_of(plane, y[n + 1] - DIFFERENCE), y[:n], y[n], below)
    for i in range(n):
        J[i, n + 1] = (above[i] - below[i]) / (2 * DIFFERENCE)
    for j in range(n + 2):
        weight = weights[j] if j < n else 1.0
        ends = np.empty(2)
        for k in range(2):
            moved = y.copy()
            moved[j] += (1 - 2 * k) * DIFFERENCE / weight
            ends[k] = monitor_at(plane, table, monitor, moved)
        for i in range(n):
            J[i, j] /= weight
        J[n, j], J[n + 1, j] = (ends[0] - ends[1]) / (2 * DIFFERENCE), border[j]


def pinned(
    plane: Any, table: Any, monitor: int, y: Vector, border: Vector
) -> tuple[bool, Vector, Vector]:
    """Correct `y` to the curve, orthogonally to a border.

    Returned are whether that converges, the tangent there, and all monitors.

    border : ndarray, shape (unknowns + 2,)
        In scaled coordinates; its product with the tangent is positive.
    """
    n = len(y)
    J, scales, rows = np.empty((n, n)), np.empty(n), np.empty(n, np.int64)
    step, before, direction = np.empty(n), np.inf, np.zeros(n)
    direction[n - 1] = 1.0
    formed, fresh = 0, True
    for turn in range(MOST_CORRECTIONS):
        residuals(plane, table, monitor, y, step)
        if fresh:
            formed += 1
            bordered_jacobian(plane, table, monitor, y, border, J)
            scale_rows(J, scales)
            if not factorise(J, rows):
                return False, direction, direction
        for i in range(n):
            step[i] /= scales[i]
        solve_factorised(J, rows, step)
        size = 0.0
        for j in range(n):
            size += step[j] * step[j]
        size = sqrt(size)
        if not isfinite(size) or (turn > 0 and size > FALLING * before):
            break
        for j in range(n):
            y[j] -= step[j] / (plane[4][j] if j < n - 2 else 1.0)
        fresh, before = formed < FRESH and size > QUICK * before, size
        if size <= ROUNDOFF:
            break
    solve_factorised(J, rows, direction)
    direction = direction / sqrt(np.dot(direction, direction))
    return before <= SMALL, direction, monitors_at(plane, table, y)
