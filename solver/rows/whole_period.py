"""Residual and Jacobian of a motion that is one series over the whole period, for any phases.

A case is arrays, as in `joints`.  The unknowns are the constant, twice the mean, unless the
cell is half a period; the amplitudes of sines and cosines; for the switch that begins each
phase the coefficients of functions with a break there or, without such functions, the jump of
the velocity if it jumps; then the memories, the durations, and the phase of the forcing.
Conditions are in the same sequence: harmonics, switches, events, memories, the duration of the
cell.  `rows` are those of `orthogonality`.
"""

from math import cos, pi, sin

import numpy as np

from ...generated.hb import by_time
from .breaking import add_break_states, add_breaks, break_tables, harmonic_moments, top
from .fourier import (
    amplitudes,
    jumps,
    legendre_on_phase,
    number,
    odd,
    places,
    series_at_ends,
    times,
    unknowns_beside,
    unknowns_of_switch,
    waves,
)
from .harmonics import harmonic_integrals, series_on_phase
from .joints import BESIDE, CLASS, E_0, E_COS, E_X, JUMP, MEMORY, RHO, F, G, add_angle
from .orthogonality import add_forces, add_harmonics, add_impulses, highest_number


def highest_derivative(kinds):
    """Return the highest derivative of the displacement in a condition."""
    highest = 1
    for p in range(len(kinds)):
        highest = max(highest, kinds[p, CLASS] + kinds[p, BESIDE])
    return highest


def beside_series(kinds, sign, z, at, highest, width):
    """Return the derivatives at begin and end of each phase, less those of the series.

    Returns
    -------
    ndarray, shape (P, 2, highest + 1, width)
        The last two axes as in `series_at_ends`.  Half of each jump of the velocity on either
        side, for the series has the mean there.
    """
    phases = len(kinds)
    states = np.zeros((phases, 2, highest + 1, width))
    for q in range(phases):
        if jumps(kinds, q):
            p, before = (q - 1, -0.5) if q > 0 else (phases - 1, -0.5 * sign)
            states[q, 0, 1, 0] += 0.5 * z[at[q]]
            states[p, 1, 1, 0] += before * z[at[q]]
            if width > 1:
                states[q, 0, 1, 1 + at[q]] = 0.5
                states[p, 1, 1, 1 + at[q]] = before
    return states


def add_state(rows, row, factor, series, beside, p, side, order):
    """Add a factor times a derivative at the begin (side 0) or end (1) of phase p to a row."""
    for i in range(rows.shape[1] if factor != 0 else 0):
        rows[row, i] += factor * (series[p + side, order, i] + beside[p, side, order, i])


def add_jump(rows, row, after, before, sign, series, beside, q, order):
    """Add `after` times a derivative after the begin of phase q, less `before` times before.

    The series is continuous: with equal factors it is left out, which avoids cancellation.
    """
    p, left = (q - 1, before) if q > 0 else (len(beside) - 1, sign * before)
    for i in range(rows.shape[1]):
        if after != before:
            rows[row, i] += (after - before) * series[q, order, i]
        rows[row, i] += after * beside[q, 0, order, i] - left * beside[p, 1, order, i]


def add_force_rate(case, z, at_w, ends, rows, row, factor, p, side, order):
    """Subtract a factor times a derivative by time of the force on phase p from a row."""
    _, numbers, setting, _, cell = case[:5]
    rates = rows.shape[1] > 1
    if order == 0:
        rows[row, 0] -= factor * numbers[p, F]
        for i in range(len(setting)):
            rows[row, 0] -= factor * numbers[p, MEMORY + i] * z[at_w + i]
            if rates:
                rows[row, 1 + at_w + i] -= factor * numbers[p, MEMORY + i]
    if numbers[p, G] != 0:
        angle = z[len(z) - 1] + cell[1] * ends[p + side]
        sine, cosine = sin(angle), cos(angle)
        for _ in range(order):
            sine, cosine = by_time(cell[1], sine, cosine)
        rows[row, 0] -= factor * numbers[p, G] * cosine
        if rates:
            change, at_s = factor * numbers[p, G] * sine, 1 + at_w + len(setting)
            add_angle(rows, row, change, cell[1], at_s, p + side)


def add_switches(case, z, at, ends, series, beside, rows):
    """Add the law of each jump of the velocity, and the differentiated equation of motion.

    The equation, differentiated ``order - 2`` times, holds on both sides of a switch: its jump
    determines that of derivative ``order``.
    """
    kinds, numbers, _, _, cell = case[:5]
    at_w = at[len(kinds)]
    for q in range(len(kinds)):
        p, sign = (q - 1, 1.0) if q > 0 else (len(kinds) - 1, cell[0])
        for i in range(unknowns_of_switch(kinds, q)):
            row, order = at[q] + i, kinds[q, CLASS] + 1 + i
            if order == 1:
                rows[row, 0] -= sign * numbers[p, JUMP]
                add_jump(rows, row, 1.0, numbers[p, RHO], cell[0], series, beside, q, 1)
                continue
            for step in range(3):  # of the acceleration, the velocity, the displacement
                after, before = numbers[q, step], numbers[p, step]
                add_jump(rows, row, after, before, cell[0], series, beside, q, order - step)
            add_force_rate(case, z, at_w, ends, rows, row, 1.0, q, 0, order - 2)
            add_force_rate(case, z, at_w, ends, rows, row, -sign, p, 1, order - 2)


def add_closure(case, z, at_w, ends, series, beside, rows):
    """Add the conditions of events, memories, and the duration of the cell."""
    kinds, numbers, setting, memory, cell = case[:5]
    count, memories, rates = len(kinds), len(setting), rows.shape[1] > 1
    at_s = at_w + memories
    for p in range(count):
        row = at_w + p
        rows[row, 0] += numbers[p, E_0]
        for order in range(2):
            add_state(rows, row, numbers[p, E_X + order], series, beside, p, 1, order)
        for i in range(memories):
            rows[row, 0] += numbers[p, MEMORY + memories + i] * z[at_w + i]
            if rates:
                rows[row, 1 + at_w + i] += numbers[p, MEMORY + memories + i]
        add_cosine(rows, row, numbers[p, E_COS], z, ends, cell[1], at_s, p + 1)
    for i in range(memories):
        row, p = at_w + count + i, setting[i]
        rows[row, 0] += z[at_w + i] - memory[i, 3]
        if rates:
            rows[row, 1 + at_w + i] += 1.0
        for order in range(2):
            add_state(rows, row, -memory[i, order], series, beside, p, 0, order)
        add_cosine(rows, row, -memory[i, 2], z, ends, cell[1], at_s, p)
    if cell[2] != 0:
        row = at_s + count
        rows[row, 0] -= cell[2] * pi / cell[1]
        for p in range(count):
            rows[row, 0] += z[at_s + p]
            if rates:
                rows[row, 1 + at_s + p] += 1.0


def add_cosine(rows, row, factor, z, ends, omega, at_s, q):
    """Add a factor times the cosine of the forcing at the begin of phase q to a row."""
    if factor != 0:
        angle = z[len(z) - 1] + omega * ends[q]
        rows[row, 0] += factor * cos(angle)
        if rows.shape[1] > 1:
            add_angle(rows, row, -factor * sin(angle), omega, 1 + at_s, q)


def add_beside(case, z, at, ends, motion, at_ends, series, rows):
    """Add the functions with a break, and the conditions of switches, to the rows.

    Return the states of these functions, as from `beside_series`.
    """
    kinds, sign, count, N = case[0], case[4][0], motion.shape[1], at[0] // 2
    states = beside_series(kinds, sign, z, at, at_ends.shape[1] - 1, rows.shape[1])
    if top(kinds) > 0:
        period = ends[len(kinds)] * (2 if odd(sign) else 1)
        tables = break_tables(kinds, sign, ends)
        moments = harmonic_moments(sign, ends, period, count, top(kinds) + 1)
        add_breaks(case, z, at, ends, moments, tables, at_ends, N, rows)
        add_break_states(case, z, at, ends, tables[1], states)
    add_switches(case, z, at, ends, series, states, rows)
    return states


def fill(case, z, rows):
    """Fill `rows`, which are zero, with the residuals of all conditions and derivatives."""
    kinds, numbers, setting, _, cell = case[:5]
    sign, phases, rates = cell[0], len(kinds), rows.shape[1] > 1
    N = (len(z) - unknowns_beside(case)) // 2
    at = places(case, N)
    at_s = at[phases] + len(setting)
    ends, period = times(z, at_s, sign, phases)
    motion = amplitudes(z, sign, N)
    count, highest = motion.shape[1], highest_derivative(kinds)
    last = highest_number(numbers, cell, number(sign, count - 1))
    integrals = harmonic_integrals(ends, period, last, rates)
    at_ends = waves(sign, ends, period, count, highest + 1)
    add_harmonics(numbers, sign, motion, ends, period, integrals, at_s, rows)
    add_forces(case, z, at[phases], ends, period, integrals, N, rows)
    add_impulses(case, z, at, ends, at_ends, N, rows)
    series = series_at_ends(sign, motion, ends, at_ends, at_s, N, rows.shape[1])
    beside = add_beside(case, z, at, ends, motion, at_ends, series, rows)
    add_closure(case, z, at[phases], ends, series, beside, rows)
    if rates and not odd(sign):
        rows[:, 1] /= 2


def residual(case, z, R):
    """Fill R with the residuals of all conditions."""
    R[:] = 0.0
    fill(case, z, R.reshape((len(R), 1)))


def jacobian(case, z, J):
    """Fill J with the derivatives of `residual` by all unknowns."""
    rows = np.zeros((len(z), 1 + len(z)))
    fill(case, z, rows)
    J[:, :] = rows[:, 1:]


def motion(case, z, p, u, derivative):
    """Return a derivative of the displacement on phase p at local times u in [0, 1]."""
    kinds, sign, count = case[0], case[4][0], len(case[0])
    if not 0 <= p < count:
        raise IndexError("p")
    N = (len(z) - unknowns_beside(case)) // 2
    at = places(case, N)
    ends, period = times(z, at[count] + len(case[2]), sign, count)
    (a, b), s = amplitudes(z, sign, N), ends[p + 1] - ends[p]
    numbers = np.arange(1, 2 * N, 2) if odd(sign) else np.arange(0, N + 1)
    q, turned = (p + 1, 1.0) if p + 1 < count else (0, sign)
    begins = z[at[p]] if jumps(kinds, p) else 0.0
    leaves = turned * z[at[q]] if jumps(kinds, q) else 0.0
    omega_0 = 2 * pi / period
    values = series_on_phase(a, b, numbers, omega_0, ends[p], s, begins, leaves, u, derivative)
    for factor, series in on_phase(case, z, at, ends, p):
        values = values + factor * legendre_on_phase(series, s, u, derivative)
    return values


def on_phase(case, z, at, ends, p):
    """Return coefficient and Legendre series of each function added to the harmonics."""
    kinds, sign = case[0], case[4][0]
    series = break_tables(kinds, sign, ends)[0]
    return [
        (z[at[q] + i], series[q, p, kinds[q, CLASS] + 2 + i])
        for q in range(len(kinds))
        for i in range(kinds[q, BESIDE])
    ]
