"""A curve of events in two parameters: orbits on which a monitor vanishes.

Beside those of a branch there is one more unknown, the second parameter, and one more equation,
the monitor.  That of a fold is the determinant of the equations.

Plain Python, or compiled by numba with the equations along a branch.
"""

from math import isfinite, sqrt
from typing import Any

import numpy as np

from ..arrays import Matrix, Vector
from ..branch.extended import DIFFERENCE, SMALL, jacobian_along, residual_along
from ..branch.walk import tangent_and_monitors
from ..iteration.iteration import ROUNDOFF, scale_rows
from ..iteration.linear import factorise, solve_factorised
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


def residuals(plane: Any, table: Any, monitor: int, y: Vector, R: Vector) -> None:
    """Fill R with the residual of the equations, the monitor and zero."""
    n = len(y) - 2
    residual_along(row_of(plane, y[n + 1]), y[:n], y[n], R[:n])
    R[n], R[n + 1] = monitors_at(plane, table, y)[monitor], 0.0


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
            ends[k] = monitors_at(plane, table, moved)[monitor]
        for i in range(n):
            J[i, j] /= weight
        J[n, j], J[n + 1, j] = (ends[0] - ends[1]) / (2 * DIFFERENCE), border[j]


def pinned(
    plane: Any, table: Any, monitor: int, y: Vector, border: Vector
) -> tuple[bool, Vector]:
    """Correct `y` to the curve, orthogonally to a border; return convergence and tangent.

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
                return False, direction
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
    return before <= SMALL, direction / sqrt(np.dot(direction, direction))
