"""Functions with a break at a switch: their values at switches, and their terms in the rows.

The function ``beta_n`` of the switch that begins phase p depends on ``u = (t - t_p)/T`` in the
cell that begins there, and ``d beta_n/du = beta_(n-1)``.
"""

from math import pi

import numpy as np

from ...generated.hb import in_the_middle, in_the_middle_mirrored, integral
from .fourier import cosine_place, number, switch_rate
from .joints import BESIDE, CLASS, C, K, M
from .moments import legendre_moments


def top(kinds):
    """Return the highest n of the functions; 0 if there are none."""
    highest = 0
    for p in range(len(kinds)):
        if kinds[p, BESIDE] > 0:
            highest = max(highest, kinds[p, CLASS] + 1 + kinds[p, BESIDE])
    return highest


def break_value(n, u, sign):
    """Return ``beta_n(u)`` by its Taylor series about u = 1/2."""
    middle = in_the_middle() if sign > 0 else in_the_middle_mirrored()
    value = 0.0 * u
    for i in range(n, -1, -1):
        value = value * (u - 1 / 2) / (i + 1) + middle[n - i]
    return value


def break_series(highest, begin, length, sign):
    """Return the coefficients [n, l] of ``beta_n(begin + length w) = sum_l [n, l] P_l*(w)``."""
    series = np.zeros((highest + 1, highest + 1))
    for n in range(highest + 1):
        for l in range(n + 1 if n > 0 else 0):
            below, above = integral(l)
            before = series[n - 1, l - 1] if l > 0 else -series[n - 1, 0]
            after = series[n - 1, l + 1] if l < n else 0.0
            series[n, l] = length * (below * before + above * after)
        series[n, 0] = series[n, 0] + break_value(n, begin, sign)
    return series


def break_tables(kinds, sign, ends):
    """Return the functions of each switch on each phase: Legendre series, and end values.

    Returns
    -------
    ndarray, shape (P, P, n, n)
        For a switch and a phase, the coefficients [n, l] of `break_series`.
    ndarray, shape (P, P, 2, n)
        The values of ``beta_n`` at the begin and the end of the phase.
    """
    phases, highest, T = len(kinds), top(kinds), ends[len(kinds)]
    series = np.zeros((phases, phases, highest + 1, highest + 1))
    values = np.zeros((phases, phases, 2, highest + 1))
    for p in range(phases):
        for q in range(phases if kinds[p, BESIDE] > 0 else 0):
            begin, length = (ends[q] - ends[p]) / T, (ends[q + 1] - ends[q]) / T
            if q < p:  # in the cell that began before
                begin = begin + 1
            factor = sign if q < p else 1.0
            beta = break_series(highest, begin, length, sign)
            for n in range(highest + 1):
                for l in range(n + 1):
                    series[p, q, n, l] = factor * beta[n, l]
                    values[p, q, 0, n] += factor * beta[n, l] * (1 - 2 * (l % 2))
                    values[p, q, 1, n] += factor * beta[n, l]
    return series, values


def add_break_states(case, z, at, ends, values, states):
    """Add the functions to the derivatives at ends of phases, laid out as `beside_series`."""
    kinds, setting = case[0], case[2]
    phases, T, at_s = len(kinds), ends[len(kinds)], at[len(kinds)] + len(setting)
    for p in range(phases):
        for i in range(kinds[p, BESIDE]):
            index, n = at[p] + i, kinds[p, CLASS] + 2 + i
            for q in range(phases):
                for side in range(2):
                    power = 1.0
                    for order in range(min(n + 1, states.shape[2])):
                        value = values[p, q, side, n - order] / power
                        power = power * T
                        states[q, side, order, 0] += z[index] * value
                        if states.shape[3] == 1:
                            continue
                        states[q, side, order, 1 + index] += value
                        slope = values[p, q, side, n - order - 1] / power if order < n else 0.0
                        for r in range(phases):
                            rate = switch_rate(ends, r, q + side) - switch_rate(ends, r, p)
                            change = z[index] * (rate * slope - order / T * value)
                            states[q, side, order, 1 + at_s + r] += change


def harmonic_moments(sign, ends, period, count, degrees):
    """Return the integrals over each phase of shifted Legendre polynomials times harmonics.

    Returns
    -------
    ndarray, shape (P, degrees, 2, count)
        Times the sine and times the cosine.
    """
    phases = len(ends) - 1
    table, moments = np.zeros((phases, degrees, 2, count)), np.empty((2, degrees))
    for q in range(phases):
        s = ends[q + 1] - ends[q]
        for i in range(count):
            omega = number(sign, i) * (2 * pi / period)
            legendre_moments(omega * s, omega * ends[q], moments)
            for l in range(degrees):
                table[q, l, 0, i], table[q, l, 1, i] = -s * moments[1, l], s * moments[0, l]
    return table


def break_residual(numbers, q, beta, n, T):
    """Return ``m x'' + c x' + k x`` for ``x = beta_n`` in phase q, from the values `beta`."""
    residual = numbers[q, K] * beta[n] + numbers[q, C] * beta[n - 1] / T
    return residual + numbers[q, M] * beta[n - 2] / T**2 if n > 1 else residual


def integrals_of_break(numbers, n, T, series, moments):
    """Return the integrals of ``m x'' + c x' + k x`` for ``x = beta_n`` times the harmonics.

    Returns
    -------
    ndarray, shape (2, 2, count)
        Times the sine and the cosine; then T times their derivatives by T, with the harmonics
        and u fixed.
    """
    integrals = np.zeros((2, 2, moments.shape[3]))
    for q in range(len(numbers)):
        for l in range(n + 1):
            spring = numbers[q, K] * series[q, n, l]
            damper = numbers[q, C] * series[q, n - 1, l] / T
            mass = numbers[q, M] * series[q, n - 2, l] / T**2 if n > 1 else 0.0 * damper
            for wave in range(2):
                for i in range(moments.shape[3]):
                    integrals[0, wave, i] += (spring + damper + mass) * moments[q, l, wave, i]
                    integrals[1, wave, i] += (spring - mass) * moments[q, l, wave, i]
    return integrals


def add_breaks(case, z, at, ends, moments, tables, at_ends, N, rows):
    """Add the terms of the functions to the rows of the harmonics, (5), (6), (7)."""
    kinds, (series, values) = case[0], tables
    rates = rows.shape[1] > 1
    for p in range(len(kinds)):
        first = kinds[p, CLASS] + 2
        before = np.zeros((2, 2, moments.shape[3]))
        begin = first - 1 if rates else first
        for n in range(begin, first + kinds[p, BESIDE] if kinds[p, BESIDE] > 0 else begin):
            integrals = integrals_of_break(case[1], n, ends[len(kinds)], series[p], moments)
            if n >= first:
                add_break(case, z, at, ends, p, n, integrals, before, N, rows)
                if rates:
                    add_moved_ends(case, z, at, ends, p, n, values[p], at_ends, N, rows)
            before = integrals


def add_break(case, z, at, ends, p, n, integrals, before, N, rows):
    """Add the terms of one function to the rows of the harmonics.

    Their derivatives are for fixed limits of integration; see `add_moved_ends`.
    """
    kinds, setting, sign = case[0], case[2], case[4][0]
    index, T = at[p] + n - kinds[p, CLASS] - 2, ends[len(kinds)]
    at_s = at[len(kinds)] + len(setting)
    for wave in range(2):
        for i in range(integrals.shape[2]):
            row = cosine_place(sign, N, i) if wave == 1 else i
            rows[row, 0] += z[index] * integrals[0, wave, i]
            if rows.shape[1] > 1:
                rows[row, 1 + index] += integrals[0, wave, i]
                for r in range(len(kinds)):
                    change = (
                        integrals[1, wave, i] - switch_rate(ends, r, p) * before[0, wave, i]
                    )
                    rows[row, 1 + at_s + r] += z[index] * change / T


def add_moved_ends(case, z, at, ends, p, n, values, at_ends, N, rows):
    """Add the derivatives of a function's terms by the limits of the integrals over phases."""
    kinds, numbers, setting, sign = case[0], case[1], case[2], case[4][0]
    phases, at_s = len(kinds), at[len(kinds)] + len(setting)
    c = z[at[p] + n - kinds[p, CLASS] - 2]
    for q in range(phases):
        for side in range(2):
            residual = break_residual(numbers, q, values[q, side], n, ends[phases])
            residual = c * residual if side == 1 else -c * residual
            for wave in range(2):
                for i in range(at_ends.shape[3]):
                    row = cosine_place(sign, N, i) if wave == 1 else i
                    term = residual * at_ends[q + side, 0, wave, i]
                    for r in range(phases):
                        rows[row, 1 + at_s + r] += term * switch_rate(ends, r, q + side)
