"""Demands along a branch as monitors that are smooth through every event.

A demand is a linear form of the state that must not be negative.  Watched are: its first
derivative that is not identically zero where the phase begins; its least value at critical
points inside; its value where the phase ends, or if the phase ends by it, its rate of fall.

Plain Python, or compiled by numba with the exact equations.
"""

from math import ceil, cos, isnan, nan, sin, sqrt
from typing import Any

import numpy as np

from ..arrays import Matrix, Vector
from ..flow.exact_system import angles, ends, phase_numbers, places
from ..flow.responses import by_force, by_forcing, by_start
from ..rows.joints import FREE, F

# Columns of the table of forms: the phase; where the form is evaluated; the order of the
# derivative at the start; whether the phase ends by it; the row that takes the value.
PHASE, KIND, BEGINS, IS_END, INTO = 0, 1, 2, 3, 4

# Where a form is evaluated: in the phase, at its end, or behind the switch there.
WITHIN, AT_SWITCH, BEHIND = 0, 1, 2

# Columns of the values of a form.
START, LEAST, END = 0, 1, 2

#: Points per radian of the fastest rate of a phase; most points; terms of a Taylor series.
DENSITY, MOST_POINTS, EXPANDED = 3.0, 4096, 14

#: Bisections to the minimum of a rate, and most steps to its root.
HALVINGS = 24


def sampled(case: Any, z: Vector, p: int, angle: float) -> Matrix:
    """Return a phase on a grid that resolves its waves.

    Columns: time, displacement, velocity, cosine and sine of the forcing's phase.
    """
    m, c, k, f, g = phase_numbers(case, z, p)
    omega, x, v = case[4][1], z[2 * p], z[2 * p + 1]
    s = z[2 * len(case[0]) + len(case[2]) + p]
    if case[0][p, FREE] == 0:
        v = case[1][p, F]
    rate = max(sqrt(abs(k) / m), abs(c) / m, omega)
    count = int(min(4 + ceil(rate * abs(s) * DENSITY), MOST_POINTS))
    grid, h = np.empty((count + 1, 5)), s / count
    xx, xv, vx, vv, _, _ = by_start(m, c, k, h)
    moved, moving, wave_x, wave_v, turn_x, turn_v = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    if f != 0:
        moved, moving = by_force(m, c, k, h)
    if g != 0:
        wave_x, wave_v, turn_x, turn_v = by_forcing(m, c, k, omega, 0.0, h)
    for i in range(count + 1):
        grid[i, 0], grid[i, 1], grid[i, 2] = i * h, x, v
        wave, turned = cos(angle + omega * i * h), sin(angle + omega * i * h)
        grid[i, 3], grid[i, 4] = wave, turned
        push = g * (wave_x * wave + turn_x * turned)
        pushed = g * (wave_v * wave + turn_v * turned)
        x, v = xx * x + xv * v + f * moved + push, vx * x + vv * v + f * moving + pushed
    return grid


def taylor(equation: Vector, omega: float, angle: float, x: float, v: float, form: Any) -> Any:
    """Return the Taylor coefficients in time of a form along a phase, about a state."""
    m, c, k, f, g = equation
    wave, turned = cos(angle), sin(angle)
    coefficients, power, factor = np.empty(EXPANDED), 1.0, 1.0
    x_j, v_j = x, v
    for j in range(EXPANDED):
        turn = j % 4
        value = wave if turn == 0 else -turned if turn == 1 else -wave if turn == 2 else turned
        force = g * value * power + (f if j == 0 else 0.0)
        coefficients[j] = factor * (form[0] * x_j + form[1] * v_j + form[2] * value * power)
        x_j, v_j = v_j, (force - c * v_j - k * x_j) / m
        power, factor = power * omega, factor / (j + 1)
    coefficients[0] += form[3]
    return coefficients


def polynomial(terms: Vector, t: float, derivative: int) -> float:
    """Return the derivative of order 0 to 2 of a polynomial."""
    value = 0.0
    for j in range(len(terms) - 1, derivative - 1, -1):
        factor = 1.0 if derivative == 0 else j if derivative == 1 else j * (j - 1.0)
        value = value * t + factor * terms[j]
    return value


def least_inside(
    equation: Vector, omega: float, angle: float, grid: Matrix, form: Any, begins: int
) -> tuple[float, float]:
    """Return the least value of a form at its critical points inside a phase, and its time.

    NaN without one.  Between two times of the grid the rate may change its sign, or pass zero
    and come back, at any scale: from above just behind a jump of the velocity, from below just
    before the end of the phase.

    equation : ndarray, shape (5,)
        See `phase_numbers`.
    begins : int
        Order of the first derivative of the form that is not identically zero at the start.
    """
    m, c, k, f, g = equation
    least, time, before, bent = nan, nan, 0.0, 0.0
    for i in range(len(grid)):
        t, x, v, wave, turned = grid[i]
        a = (f + g * wave - c * v - k * x) / m
        rate = form[0] * v + form[1] * a - form[2] * omega * turned
        jerk = -(g * omega * turned + c * a + k * v) / m
        bend = form[0] * a + form[1] * jerk - form[2] * omega * omega * wave
        if i == 0 and begins > 1:
            rate = taylor(equation, omega, angle + omega * t, x, v, form)[begins]
        falls = i > 0 and before < 0 <= rate
        dips = i > 0 and before >= 0 <= rate and bent < 0 < bend
        peaks = i > 0 and before < 0 and rate < 0 and bent > 0 > bend
        if falls or dips or peaks:
            start, h = grid[i - 1], t - grid[i - 1, 0]
            terms = taylor(equation, omega, angle + omega * start[0], start[1], start[2], form)
            low = lowest_rate(terms, h) if dips else 0.0
            u = rises(terms, low, lowest_rate(-terms, h) if peaks else h)
            value = polynomial(terms, u, 0)
            if not isnan(u) and (isnan(least) or value < least):
                least, time = value, start[0] + u
        before, bent = rate, bend
    return least, time


def lowest_rate(terms: Vector, h: float) -> float:
    """Return where the rate of a polynomial is least in a time `h`; NaN if it is not negative.

    Its second derivative changes from minus to plus.
    """
    low, high = 0.0, h
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        if polynomial(terms, middle, 2) < 0:
            low = middle
        else:
            high = middle
    return high if polynomial(terms, high, 1) < 0 else nan


def rises(terms: Vector, low: float, high: float) -> float:
    """Return where the rate of a polynomial, negative at `low`, rises through zero.

    That is up to `high`, by Newton's method, with bisection where that leaves the bracket.
    """
    u = (low + high) / 2
    for _ in range(HALVINGS):
        rate, steep = polynomial(terms, u, 1), polynomial(terms, u, 2)
        if rate < 0:
            low = u
        else:
            high = u
        last, u = u, u - rate / steep if steep > 0 else low
        if not low < u < high:
            u = (low + high) / 2
        if u == last:
            break
    return u


def form_of(case: Any, z: Vector, row: int) -> Vector:
    """Return a form over x, v, cos and 1, with the memory inserted."""
    forms, count = case[5], len(case[0])
    form: Vector = forms[row, :4].copy()
    for i in range(len(case[2])):
        form[3] += forms[row, 4 + i] * z[2 * count + i]
    return form


def watched(case: Any, table: Any, z: Vector, values: Matrix, extremes: Matrix) -> None:
    """Fill in the values of the watched forms, and the extremes of displacement and velocity.

    table : ndarray of int, shape (R, 5)
        A row for each form of the case; the columns are named above.
    values : ndarray, shape (R, 3)
        Filled: START, LEAST, END of each form; NaN where there is none.
    extremes : ndarray, shape (2, 2) or (0, 2)
        Filled with least and largest displacement and velocity in the cell, if it has rows.
    """
    at, count, omega = places(case), len(case[0]), case[4][1]
    theta = angles(case, z, at)
    gained, _ = ends(case, z, theta)
    values[:, :] = nan
    extremes[:, 0], extremes[:, 1] = np.inf, -np.inf
    for p in range(count):
        if len(extremes) == 0 and not (table[:, PHASE] == p).any():
            continue
        equation, grid = phase_numbers(case, z, p), sampled(case, z, p, theta[p])
        x, v = z[2 * p] + gained[p, 0], z[2 * p + 1] + gained[p, 1]
        for row in range(len(table)):
            if table[row, PHASE] != p:
                continue
            form, into = form_of(case, z, row), table[row, INTO]
            if table[row, KIND] == WITHIN:
                begins = table[row, BEGINS]
                first = taylor(equation, omega, theta[p], grid[0, 1], grid[0, 2], form)
                last = taylor(equation, omega, theta[p + 1], x, v, form)
                values[row, START] = first[begins]
                values[row, LEAST], _ = least_inside(
                    equation, omega, theta[p], grid, form, begins
                )
                values[row, END] = -last[1] if table[row, IS_END] != 0 else last[0]
                continue
            value = form[0] * x + form[1] * v + form[2] * cos(theta[p + 1]) + form[3]
            value = -value if table[row, KIND] == BEHIND else value
            if isnan(values[into, END]) or value > values[into, END]:
                values[into, END] = value
        for j in range(len(extremes)):
            form, ends_at = np.zeros(4), (grid[0, 1 + j], x if j == 0 else v)
            for sign in (1.0, -1.0):
                form[j] = sign
                inside, _ = least_inside(equation, omega, theta[p], grid, form, 0)
                for value in (*ends_at, sign * inside):
                    if not isnan(value):
                        extremes[j, 0] = min(extremes[j, 0], value)
                        extremes[j, 1] = max(extremes[j, 1], value)


def when_least(case: Any, table: Any, z: Vector, row: int) -> float:
    """Return the time in its phase of the least value of a form at a critical point."""
    p, at = table[row, PHASE], places(case)
    angle = angles(case, z, at)[p]
    grid, form = sampled(case, z, p, angle), form_of(case, z, row)
    equation = phase_numbers(case, z, p)
    return least_inside(equation, case[4][1], angle, grid, form, table[row, BEGINS])[1]
