"""The exact equations of a cell with a parameter as one more unknown, and their tangent.

The unknowns are those of `flow.exact_system`, and ``q`` in [-1, 1], the coordinate of the
parameter on an interval.  The coefficients of the equations are Chebyshev series in ``q`` (see
`along`).  Newton's method, arclength and tangent use scaled coordinates: each unknown times its
weight.

Where a phase begins on the surface at which it ends, the row of its event vanishes with its
duration.  The change of the event's form over the phase is then divided by the duration; twice,
where the phase begins without speed (see `along.divided_phases`).

Plain Python, or compiled by numba with the exact equations.
"""

from math import copysign, pi, sqrt
from typing import Any

import numpy as np

from ..arrays import Matrix, Vector
from ..flow.exact_system import angles, ends, phase_numbers, places
from ..flow.responses import by_change, by_force, by_forcing
from ..iteration.iteration import ROUNDOFF, scale_rows
from ..iteration.linear import factorise, solve_factorised
from ..rows.joints import (
    E_0,
    E_V,
    E_X,
    MEMORY,
    add_angle,
    add_event,
    event,
    joint_rates,
    joints,
)

#: Step of the central difference by the parameter: its error is the square.
DIFFERENCE = 2.0**-17

#: Least duration in a residual, whose square is not 0 in float64; least one in derivatives,
#: whose terms would cancel.
AN_INSTANT, A_MOMENT = 1e-100, 1e-8

#: Most corrections of a step; size of the last one; most of the ratio of two corrections.
CORRECTIONS, SMALL, FALL = 8, 1e-9, 0.5

#: Size of a correction from which Newton's method does not come back; series overflow there.
ASTRAY = 1e6

#: If a correction is at most `NEAR`, and at most `FAST_FALL` times the one before, the next is
#: by the same Jacobian.
NEAR, FAST_FALL = 1e-4, 0.1


def chebyshev_at(q: float, count: int) -> Vector:
    """Return the values of the first Chebyshev polynomials, two or more, at q."""
    waves = np.ones(count)
    waves[1] = q
    for j in range(2, count):
        waves[j] = 2 * q * waves[j - 1] - waves[j - 2]
    return waves


def series_at(series: Matrix, q: float) -> Vector:
    """Return the values of Chebyshev series at q, a row of coefficients each."""
    values: Vector = np.dot(series, chebyshev_at(q, series.shape[1]))
    return values


def case_at(along: Any, q: float) -> Any:
    """Return the arrays of the cell at q, followed by its watched forms."""
    kinds, setting = along[0], along[1]
    values = series_at(along[2], q)
    count, memories = len(kinds), len(setting)
    first = count * (MEMORY + 2 * memories)
    second = first + 4 * memories
    numbers = values[:first].reshape(count, MEMORY + 2 * memories)
    memory = values[first:second].reshape(memories, 4)
    forms = values[second + 3 :].reshape(-1, 4 + memories)
    return kinds, numbers, setting, memory, values[second : second + 3], forms


def with_least_durations(case: Any, z: Vector, least: float) -> Vector:
    """Return unknowns with durations of at least `least`: events are divided by them."""
    unknowns, first = z.copy(), 2 * len(case[0]) + len(case[2])
    for i in range(first, first + len(case[0])):
        if abs(unknowns[i]) < least:
            unknowns[i] = copysign(least, unknowns[i])
    return unknowns


def residual_along(along: Any, z: Vector, q: float, R: Vector) -> None:
    """Fill R with the residual of the equations at a value of the parameter."""
    residual_of(case_at(along, q), along[3], z, R)


def residual_of(case: Any, divided: Any, z: Vector, R: Vector) -> None:
    """Fill R with the residual of the equations of a cell."""
    at, count, z = places(case), len(case[0]), with_least_durations(case, z, AN_INSTANT)
    theta = angles(case, z, at)
    gained, _ = ends(case, z, theta)
    joints(case, z, at, theta, gained, gained, R, 0)
    for p in range(count):
        if divided[p] != 0:
            s = z[2 * count + len(case[2]) + p]
            R[2 * count + p] = divided_event(case, divided, z, at, gained, theta, p, s)
        if divided[p] == 3:  # not that it gains nothing, which is so at the event alone
            R[2 * next_phase(count, p)] = event_behind(case, z, p)


def divided_event(
    case: Any, divided: Any, z: Vector, at: Any, gained: Any, theta: Vector, p: int, s: float
) -> float:
    """Return the change of an event over its phase, divided by a power of the duration.

    Power 1: the phase begins on the surface at which it ends.  Power 2: it begins there without
    speed (the change is that by its forces), or it begins without speed and acceleration and
    ends without speed (the change is that by the forcing).  Power 3: it begins without speed
    and acceleration on the surface at which it ends.
    """
    if divided[p] == 1:
        _, change = event(case, z, at, gained, theta, p)
        return float(change / s)
    m, c, k, f, g = phase_numbers(case, z, p)
    if divided[p] == 3:
        change = by_change(m, c, k, case[4][1], theta[p], float(s))
        return float(case[1][p, E_X] * g * change / (s * s * s))
    by_wave, _, by_angle, _ = by_forcing(m, c, k, case[4][1], theta[p], s)
    if case[1][p, E_X] == 0:
        return float(case[1][p, E_V] * case[4][1] * g * by_angle / (s * s))
    by, _ = by_force(m, c, k, s)
    return float(case[1][p, E_X] * ((f - k * z[2 * p]) * by + g * by_wave) / (s * s))


def next_phase(count: int, p: int) -> int:
    """Return the number of the phase after phase p, cyclically."""
    return p + 1 if p + 1 < count else 0


def event_behind(case: Any, z: Vector, p: int) -> float:
    """Return the event of a phase, a form of the displacement, where the next phase begins."""
    q = next_phase(len(case[0]), p)
    x = z[2 * q] * (case[4][0] if q == 0 else 1.0)
    return float(case[1][p, E_X] * x + case[1][p, E_0])


def fastest_rate(case: Any, z: Vector, p: int) -> float:
    """Return the largest rate of a phase: of its waves, its decay, the forcing, the cell."""
    m, c, k, _, _ = phase_numbers(case, z, p)
    first = 2 * len(case[0]) + len(case[2])
    cell = 1 / np.sum(z[first : first + len(case[0])])
    return float(max(sqrt(abs(k) / m), abs(c) / m, case[4][1], cell))


def residual_and_jacobian(case: Any, divided: Any, z: Vector, R: Vector, J: Matrix) -> None:
    """Fill R with the residual of the equations of a cell, J with its derivatives by z."""
    unclipped, z = z, with_least_durations(case, z, A_MOMENT)
    at, count = places(case), len(case[0])
    theta = angles(case, z, at)
    gained, gained_by = ends(case, z, theta)
    joints(case, z, at, theta, gained, gained, R, 0)
    J[:, :] = 0.0
    joint_rates(case, z, at, theta, gained_by, gained_by, J, 0)
    for p in range(count):
        if divided[p] != 0:
            row, at_s = 2 * count + p, 2 * count + len(case[2]) + p
            s, n = z[at_s], divided[p]
            R[row] = divided_event(case, divided, z, at, gained, theta, p, s)
            J[row, :] = 0.0
            if n == 1 or (n == 2 and case[1][p, E_X] != 0):
                add_event(case, J, row, at, gained_by, theta, p, 0.0, 1 / s**n)
                J[row, at_s] -= n * R[row] / s
            else:  # a wave: a quarter of a turn on it is its own derivative
                by_angle = divided_event(case, divided, z, at, gained, theta + pi / 2, p, s)
                add_angle(J, row, by_angle, case[4][1], 2 * count + len(case[2]), p)
            if n == 3:  # see `residual_of`
                q = 2 * next_phase(count, p)
                R[q], J[q, :] = event_behind(case, z, p), 0.0
                J[q, q] = case[1][p, E_X] * (case[4][0] if q == 0 else 1.0)
            if n > 1:  # differences, since terms cancel where the duration vanishes
                J[row, 2 * p + 1] = 0.0
                h = DIFFERENCE / fastest_rate(case, z, p)
                above = divided_event(case, divided, z, at, gained, theta, p, s + h)
                below = divided_event(case, divided, z, at, gained, theta, p, s - h)
                J[row, at_s] = (above - below) / (2 * h)
    if (unclipped != z).any():
        residual_of(case, divided, unclipped, R)


def jacobian_along(along: Any, z: Vector, q: float, J: Matrix) -> None:
    """Fill J with the Jacobian of the residual; the last column is by the parameter."""
    n = len(z)
    residual_and_jacobian(case_at(along, q), along[3], z, np.empty(n), J[:n, :n])
    above, below = np.empty(n), np.empty(n)
    residual_along(along, z, q + DIFFERENCE, above)
    residual_along(along, z, q - DIFFERENCE, below)
    for i in range(n):
        J[i, n] = (above[i] - below[i]) / (2 * DIFFERENCE)


def bordered(along: Any, y: Vector, border: Vector, J: Matrix, scales: Vector) -> None:
    """Fill J with the Jacobian in scaled coordinates, bordered by a row; scale its rows."""
    n = len(y) - 1
    jacobian_along(along, y[:n], y[n], J)
    J[:n] /= along[4]
    J[n] = border
    scale_rows(J, scales)


def newton_step(
    y: Vector, step: Vector, J: Matrix, rows: Any, scales: Vector, weights: Vector
) -> float:
    """Correct unknowns by a Newton step; return its length in scaled coordinates.

    `step` holds the residual and becomes the correction; J is the factorised, scaled Jacobian.
    """
    for i in range(len(step)):
        step[i] /= scales[i]
    solve_factorised(J, rows, step)
    square = 0.0
    for j in range(len(step)):
        square += step[j] * step[j]
        y[j] -= step[j] / weights[j]
    return sqrt(square)


def corrected(along: Any, y: Vector, border: Vector) -> tuple[bool, float]:
    """Correct `y` to the branch, orthogonally to `border`, by Newton's method.

    Returns
    -------
    converged : bool
    fall : float
        The ratio of the second correction to the first; 0 without a second one, or where the
        first is so small that both may be rounding.
    """
    n = len(y) - 1
    J, scales, rows = np.empty((n + 1, n + 1)), np.empty(n + 1), np.empty(n + 1, np.int64)
    step, before, fall, size = np.zeros(n + 1), np.inf, 0.0, np.inf
    for turn in range(CORRECTIONS):
        residual_along(along, y[:n], y[n], step)
        step[n] = 0.0
        if not (size <= NEAR and size <= FAST_FALL * before):
            bordered(along, y, border, J, scales)
            if not factorise(J, rows):
                return False, fall
        before, size = size, newton_step(y, step, J, rows, scales, along[4])
        if not size < ASTRAY:
            return False, fall
        if turn == 1 and before > SMALL:
            fall = size / before
        if size <= ROUNDOFF or (size <= SMALL and size > FALL * before):
            return True, fall
        if turn > 0 and size > FALL * before:
            return False, fall
    return size <= SMALL, fall


def tangent(along: Any, y: Vector, border: Vector) -> tuple[Vector, float]:
    """Return the unit tangent in scaled coordinates, with a positive product with `border`.

    The second value is the least pivot of the bordered Jacobian with the sign of its
    determinant: zero where branches meet, and unlike the determinant of moderate size.
    """
    n = len(y) - 1
    J, scales, rows = np.empty((n + 1, n + 1)), np.empty(n + 1), np.empty(n + 1, np.int64)
    direction, least_pivot, sign = np.zeros(n + 1), np.inf, 1.0
    direction[n] = 1.0
    bordered(along, y, border, J, scales)
    if not factorise(J, rows):  # a pivot is 0, or nothing is known
        return direction * np.nan, 0.0 if np.isfinite(J).all() else np.nan
    for j in range(n + 1):
        least_pivot = min(least_pivot, abs(J[j, j]))
        if (J[j, j] < 0) == (rows[j] == j):
            sign = -sign
    solve_factorised(J, rows, direction)
    return direction / sqrt(np.dot(direction, direction)), sign * least_pivot
