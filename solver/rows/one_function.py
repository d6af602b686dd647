"""A Fourier series and one function of class C^1: (12), (14).

For a scene of a held phase and a free one, without damping and forcing.  The functions here
replace those of the same name in `whole_period` for functions with a break.  The coefficient of
the function is the unknown of the switch that begins the held phase.
"""

from math import pi

import numpy as np

from ...generated.hb_c1 import (
    by_itself,
    force_by,
    on_phases,
    on_phases_by_s_free,
    on_phases_by_s_held,
)
from .fourier import cosine_place
from .harmonics import weighted_integrals
from .joints import F, K, M
from .moments import legendre_moments
from .orthogonality import add_force


def function_series(held, free, rates):
    """Return the function and its derivatives in shifted Legendre polynomials.

    Returns
    -------
    ndarray, shape (2, 3 or 1, 4, 4)
        For each phase the coefficients [n, l], with n = 3 for G, 2 for T G', 1 for T**2 G'';
        then, with `rates`, their derivatives by both durations.
    """
    series = np.zeros((2, 3 if rates else 1, 4, 4))
    for r in range(series.shape[1]):
        values = on_phases(held, free)
        if r > 0:
            values = (
                on_phases_by_s_held(held, free) if r == 1 else on_phases_by_s_free(held, free)
            )
        i = 0
        for p in range(2):
            for n in range(1, 4):
                for l in range(n + 1):
                    series[p, r, n, l] = values[i]
                    i += 1
    return series


def at_end(series):
    """Return the value of a series of shifted Legendre polynomials at u = 1."""
    value = 0.0
    for l in range(len(series)):
        value = value + series[l]
    return value


def function_integrals(series, numbers, ends, count):
    """Return the integrals over the period of ``m G'' + k G`` times harmonics.

    Moments of Legendre polynomials with harmonics are spherical Bessel functions.

    Returns
    -------
    ndarray, shape (2, 3 or 1, count)
        Times the cosine and times the sine: the integrals and, if `series` has derivatives,
        their derivatives by both durations.
    """
    rows, T = series.shape[1], ends[2]
    integrals, rho = np.zeros((2, rows, count)), np.zeros((rows, 4))
    waves, moments = np.zeros((2, 2, 5)), np.zeros((2, 5))
    for q in range(2):
        m, k = numbers[q, M], numbers[q, K]
        s, t = ends[q + 1] - ends[q], ends[q]
        for l in range(4):
            bent = series[q, 0, 1, l] * m / T**2
            rho[0, l] = k * series[q, 0, 3, l] + bent
            for r in range(1, rows):
                change = series[q, r, 1, l] * m / T**2 - 2 * bent / T
                rho[r, l] = k * series[q, r, 3, l] + change
        for column in range(count):
            w = column * (2 * pi / T)
            legendre_moments(w * s, w * t, moments)
            waves[0], waves[1, 0], waves[1, 1] = moments, -moments[1], moments[0]
            for wave in range(2):
                moment, turned = waves[wave, 0], waves[wave, 1]
                for l in range(4):
                    integrals[wave, 0, column] += s * rho[0, l] * moment[l]
                for l in range(4 if rows > 1 else 0):
                    near = (l + 1) * turned[l + 1] + (l * turned[l - 1] if l > 0 else 0.0)
                    stretch = (turned[l] + near / (2 * l + 1)) / 2
                    for r in range(2):
                        by_kappa = w * ((1.0 if r == q else 0.0) - s / T)
                        by_theta = w * ((1.0 if r < q else 0.0) - t / T)
                        slope = by_kappa * stretch + by_theta * turned[l]
                        change = rho[1 + r, l] * moment[l] + rho[0, l] * slope
                        longer = rho[0, l] * moment[l] if r == q else 0.0
                        integrals[wave, 1 + r, column] += s * change + longer
    return integrals


def add_function(case, z, motion, ends, series, rows):
    """Add the function's terms to the rows of harmonics, and the row tested with it."""
    numbers, N = case[1], motion.shape[1] - 1
    index, at_s = 2 * N + 1, 2 * N + 2
    c1 = z[index]
    integrals = function_integrals(series, numbers, ends, N + 1)
    for wave in range(2):
        for i in range(N + 1):
            row = cosine_place(1.0, N, i) if wave == 1 else i
            for r in range(integrals.shape[1]):
                value, column = integrals[1 - wave, r, i], at_s + r if r > 0 else 0
                rows[row, column] += c1 * value
                rows[index, column] += motion[wave, i] * value
            if rows.shape[1] > 1:
                rows[row, 1 + index] += integrals[1 - wave, 0, i]
                rows[index, 1 + row] += integrals[1 - wave, 0, i]
    left = by_itself(numbers[1, M], numbers[1, K], z[at_s], z[at_s + 1])
    right = force_by(numbers[1, F], z[at_s], z[at_s + 1])
    for r in range(integrals.shape[1]):
        rows[index, at_s + r if r > 0 else 0] += c1 * left[r] - right[r]
    if rows.shape[1] > 1:
        rows[index, 1 + index] += left[0]


def beside_series(z, ends, series, N, width):
    """Return displacement and velocity of the function, laid out as in `whole_period`.

    Returns
    -------
    ndarray, shape (2, 2, 2, width)
        At the end of each phase; values at its begin are not needed, and are 0.
    """
    index, at_s, T = 2 * N + 1, 2 * N + 2, ends[2]
    states = np.zeros((2, 2, 2, width))
    for p in range(2):
        for order in range(2):
            power = T if order == 1 else 1.0
            value = at_end(series[p, 0, 3 - order]) / power
            states[p, 1, order, 0] = z[index] * value
            if width > 1:
                states[p, 1, order, 1 + index] = value
            for r in range(1, series.shape[1]):
                change = at_end(series[p, r, 3 - order]) / power - order / T * value
                states[p, 1, order, at_s + r] = z[index] * change
    return states


def unknowns_of_switch(kinds, p):
    """Return the number of unknowns, and of conditions, of the switch that begins phase p."""
    return 1 if p == 0 else 0


def add_forces(case, z, at_w, ends, period, integrals, N, rows):
    """Subtract the integrals of the constant force times harmonics from their rows."""
    force = weighted_integrals(integrals, case[1][:, F], 0, ends, period)
    for r in range(force.shape[1]):
        add_force(force[0, r], force[1, r], 1.0, N, rows, at_w + r if r > 0 else 0)


def add_beside(case, z, at, ends, motion, at_ends, series, rows):
    """Add the function's terms to the rows; return its states, as from `beside_series`."""
    at_s = at[2]
    functions = function_series(z[at_s], z[at_s + 1], rows.shape[1] > 1)
    add_function(case, z, motion, ends, functions, rows)
    return beside_series(z, ends, functions, motion.shape[1] - 1, rows.shape[1])


def on_phase(case, z, at, ends, p):
    """Return coefficient and Legendre series of each function added to the harmonics."""
    at_s = at[2]
    return [(z[at[0]], function_series(z[at_s], z[at_s + 1], False)[p, 0, 3])]
