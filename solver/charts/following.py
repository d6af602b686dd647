"""A curve of events in two parameters: orbits on which a monitor vanishes.

Beside those of a branch there is one more unknown, the second parameter, and one more equation,
the monitor.  That of a fold is the change of the first parameter along the tangent at a fixed
second one, with the sign of the determinant of the equations.

Plain Python, or compiled by numba with the equations along a branch.
"""

from math import copysign, nan, sqrt
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

#: Most corrections; most of them with a new Jacobian; length of one that leads elsewhere.
MOST_CORRECTIONS, FRESH, FARTHEST = 16, 3, 1.0

#: Ratio of two corrections above which they are rounding; below which the Jacobian is kept.
FALLING, QUICK = 0.7, 0.1

#: Most of the change of a duration in a difference, as a part of it.
SHORTER = 1.0 / 64

#: Times a square, the angle of an entry of a row that no border and no equation is like.
SCATTERED = 1.1


def monitors_at(plane: Any, table: Any, y: Vector) -> Vector:
    """Return the monitors at an orbit."""
    n = len(y) - 2
    border, extremes, maps = np.zeros(n + 1), np.empty((2, 2)), np.empty((2, 0, 0))
    border[n] = 1.0
    _, values = tangent_and_monitors(
        row_of(plane, y[n + 1]), table, y[: n + 1], border, extremes, maps
    )
    return values


def monitor_at(plane: Any, table: Any, monitor: int, y: Vector) -> float:
    """Return one of the monitors at an orbit, without computing the others."""
    n, along, row = len(y) - 2, row_of(plane, y[len(y) - 1]), monitor // 3
    p = monitor - 3 * len(table)
    own, case = p - len(along[0]), case_at(along, y[n])
    if own == MEETS:
        border = np.zeros(n + 1)
        border[n] = 1.0
        direction, meets = tangent(along, y[: n + 1], border)
        return float(copysign(direction[n], meets) if meets != 0 else meets)
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


def surface_jacobian(plane: Any, y: Vector, J: Matrix) -> None:
    """Fill the first rows of J with the derivatives of the equations in scaled coordinates."""
    n, weights = len(y) - 2, plane[4]
    along_a = np.empty((n, n + 1))
    jacobian_along(row_of(plane, y[n + 1]), y[:n], y[n], along_a)
    above, below = np.empty(n), np.empty(n)
    residual_along(row_of(plane, y[n + 1] + DIFFERENCE), y[:n], y[n], above)
    residual_along(row_of(plane, y[n + 1] - DIFFERENCE), y[:n], y[n], below)
    for i in range(n):
        J[i, : n + 1] = along_a[i] / weights
        J[i, n + 1] = (above[i] - below[i]) / (2 * DIFFERENCE)


def slope_of(
    plane: Any, table: Any, monitor: int, y: Vector, units: Vector, direction: Vector
) -> float:
    """Return the derivative of a monitor in a direction, in scaled coordinates.

    By a difference in which no phase becomes much shorter.
    """
    first, h = plane[5], DIFFERENCE
    for i in range(first, first + len(plane[0])):
        change = abs(direction[i] * units[i])
        if y[i] > 0 and h * change > SHORTER * y[i]:
            h = SHORTER * y[i] / change
    step = h * direction * units
    above = monitor_at(plane, table, monitor, y + step)
    below = monitor_at(plane, table, monitor, y - step)
    return (above - below) / (2 * h)


def without(vector: Vector, unit: Vector) -> Vector:
    """Return a vector without its part along a unit vector."""
    rest: Vector = vector - np.dot(vector, unit) * unit
    return rest


def pinned(
    plane: Any, table: Any, monitor: int, y: Vector, border: Vector
) -> tuple[bool, Vector, Vector]:
    """Correct `y` to the curve, orthogonally to a border.

    The orbits near by are a surface.  One correction leads to it, another along it, across the
    curve, to where the monitor vanishes: so the monitor is differentiated in two directions
    only, however many unknowns there are.

    Returned are whether that converges, the tangent there, and all monitors.

    border : ndarray, shape (unknowns + 2,)
        In scaled coordinates; its product with the tangent is positive.
    """
    n = len(y)
    J, scales, rows = np.empty((n, n)), np.empty(n), np.empty(n, np.int64)
    units, across, along = np.ones(n), np.zeros(n), np.zeros(n)
    units[: n - 2] /= plane[4][: n - 2]
    before, slope, formed, fresh = np.inf, nan, 0, True
    for turn in range(MOST_CORRECTIONS):
        if fresh:
            formed += 1
            surface_jacobian(plane, y, J)
            J[n - 2], J[n - 1] = border, np.cos(SCATTERED * np.arange(n) ** 2)
            scale_rows(J, scales)
            if not factorise(J, rows):
                return False, across, across
            across[:], across[n - 1] = 0.0, 1.0
            solve_factorised(J, rows, across)
            across /= sqrt(np.dot(across, across))
            slope = slope_of(plane, table, monitor, y, units, across)
            if slope == 0:  # a form that is zero everywhere
                return False, across, across
        step = np.zeros(n)
        residual_along(row_of(plane, y[n - 1]), y[: n - 2], y[n - 2], step[: n - 2])
        step /= scales
        solve_factorised(J, rows, step)
        step = without(step, across)
        if not np.dot(step, step) <= FARTHEST:
            break
        step += monitor_at(plane, table, monitor, y - step * units) / slope * across
        size = sqrt(np.dot(step, step))
        if not size <= FARTHEST or (turn > 0 and size > FALLING * before):
            break
        y -= step * units
        fresh, before = formed < FRESH and size > QUICK * before, size
        if size <= ROUNDOFF:
            break
    if before > SMALL:
        return False, across, across
    along[n - 2] = 1.0
    solve_factorised(J, rows, along)
    along = without(along, across)
    along /= sqrt(np.dot(along, along))
    along -= slope_of(plane, table, monitor, y, units, along) / slope * across
    along /= sqrt(np.dot(along, along))
    return True, along, monitors_at(plane, table, y)
