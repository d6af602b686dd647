"""Residual and Jacobian of a Fourier series and one function of class C^1: (12), (14).

For a held phase and a free one without damping, which nothing forces.  Unknowns are the
constant, which is twice the mean, sines, cosines, the coefficient of the function, and the two
durations.
"""

from math import cos, pi, sin

import numpy as np

from .fourier import (
    amplitudes,
    cosine_place,
    legendre_on_phase,
    series_at_ends,
    times,
    waves,
)
from .harmonics import harmonic_integrals, series_on_phase, weighted_integrals
from .joints import E_0, E_X, F, K, M
from .moments import spherical_bessel
from .orthogonality import add_force, add_harmonics
from .whole_period import add_state

#: Closed forms, which the generator writes.
on_phases = None  # T**2 G'', T G', G on both phases, as Legendre series one behind another
on_phases_by_s_held = None  # their derivatives by the duration of the held phase
on_phases_by_s_free = None  # those by the duration of the free phase
by_itself = None  # the integral of the left side for G with G, and its two derivatives
force_by = None  # that of the force with G, and its two derivatives


def function_series(held, free, rates):
    """Return the function and its derivatives in shifted Legendre polynomials.

    Returns
    -------
    ndarray, shape (2, 3 or 1, 4, 4)
        On each phase the coefficients [n, l] with n = 3 for G, 2 for T G', 1 for T**2 G'';
        behind them, if wanted, their derivatives by both durations.
    """
    found = np.zeros((2, 3 if rates else 1, 4, 4))
    for r in range(found.shape[1]):
        values = on_phases(held, free)
        if r > 0:
            values = (
                on_phases_by_s_held(held, free) if r == 1 else on_phases_by_s_free(held, free)
            )
        i = 0
        for p in range(2):
            for n in range(1, 4):
                for l in range(n + 1):
                    found[p, r, n, l] = values[i]
                    i += 1
    return found


def at_end(series):
    """Return a series of shifted Legendre polynomials where the phase ends."""
    found = 0.0
    for l in range(len(series)):
        found = found + series[l]
    return found


def function_integrals(series, numbers, ends, count):
    """Return the integrals over the period of ``m G'' + k G`` with harmonics.

    Integrals of Legendre polynomials are spherical Bessel functions.

    Returns
    -------
    ndarray, shape (2, 3 or 1, count)
        With the cosine and with the sine: the integrals, and if `series` has them their
        derivatives by both durations.
    """
    rows, T = series.shape[1], ends[2]
    omega = 2 * pi / T
    found, rho = np.zeros((2, rows, count)), np.zeros((rows, 4))
    even, odd, bessel = np.zeros(5), np.zeros(5), np.zeros(5)
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
            w = column * omega
            spherical_bessel(w * s / 2, bessel)
            for turned in range(2):  # the sine is the cosine, a quarter turn back
                middle = w * (t + s / 2) - turned * pi / 2
                co, si = cos(middle), sin(middle)
                for l in range(5):
                    turn = l % 4
                    value = co if turn == 0 else -si if turn == 1 else -co if turn == 2 else si
                    ahead = -si if turn == 0 else -co if turn == 1 else si if turn == 2 else co
                    even[l], odd[l] = value * bessel[l], ahead * bessel[l]
                for l in range(4):
                    found[turned, 0, column] += s * rho[0, l] * even[l]
                for l in range(4 if rows > 1 else 0):
                    near = (l + 1) * odd[l + 1] + (l * odd[l - 1] if l > 0 else 0.0)
                    stretch = (odd[l] + near / (2 * l + 1)) / 2
                    for r in range(2):
                        by_kappa = w * ((1.0 if r == q else 0.0) - s / T)
                        by_theta = w * ((1.0 if r < q else 0.0) - t / T)
                        slope = by_kappa * stretch + by_theta * odd[l]
                        change = rho[1 + r, l] * even[l] + rho[0, l] * slope
                        own = rho[0, l] * even[l] if r == q else 0.0
                        found[turned, 1 + r, column] += s * change + own
    return found


def size(case, N):
    """Return the number of unknowns."""
    return 2 * N + 4


def add_function(case, z, motion, ends, series, rows):
    """Add the function to the rows of harmonics, and the row that is orthogonal to it."""
    numbers, N = case[1], motion.shape[1] - 1
    own, at_s = 2 * N + 1, 2 * N + 2
    c1 = z[own]
    found = function_integrals(series, numbers, ends, N + 1)
    for wave in range(2):
        for i in range(N + 1):
            row = cosine_place(1.0, N, i) if wave == 1 else i
            for r in range(found.shape[1]):
                value, column = found[1 - wave, r, i], at_s + r if r > 0 else 0
                rows[row, column] += c1 * value
                rows[own, column] += motion[wave, i] * value
            if rows.shape[1] > 1:
                rows[row, 1 + own] += found[1 - wave, 0, i]
                rows[own, 1 + row] += found[1 - wave, 0, i]
    left = by_itself(numbers[1, M], numbers[1, K], z[at_s], z[at_s + 1])
    right = force_by(numbers[1, F], z[at_s], z[at_s + 1])
    for r in range(found.shape[1]):
        rows[own, at_s + r if r > 0 else 0] += c1 * left[r] - right[r]
    if rows.shape[1] > 1:
        rows[own, 1 + own] += left[0]


def beside_series(z, ends, series, N, width):
    """Return what displacement and velocity have beside the harmonics, as at `whole_period`.

    Returns
    -------
    ndarray, shape (2, 2, 2, width)
        Where each phase ends; no condition is on where it begins.
    """
    own, at_s, T = 2 * N + 1, 2 * N + 2, ends[2]
    found = np.zeros((2, 2, 2, width))
    for p in range(2):
        for order in range(2):
            power = T if order == 1 else 1.0
            value = at_end(series[p, 0, 3 - order]) / power
            found[p, 1, order, 0] = z[own] * value
            if width > 1:
                found[p, 1, order, 1 + own] = value
            for r in range(1, series.shape[1]):
                change = at_end(series[p, r, 3 - order]) / power - order / T * value
                found[p, 1, order, at_s + r] = z[own] * change
    return found


def add_constant_force(numbers, at_s, integrals, ends, N, rows):
    """Take the integrals of the force with harmonics from their rows."""
    force = weighted_integrals(integrals, numbers[:, F], 0, ends, ends[2])
    for r in range(force.shape[1]):
        column = at_s + r if r > 0 else 0
        add_force(force[0, r], force[1, r], 1.0, N, rows, column)


def add_events(numbers, at_s, harmonics, others, rows):
    """Add the events that end the phases."""
    for p in range(2):
        rows[at_s + p, 0] += numbers[p, E_0]
        for order in range(2):
            add_state(rows, at_s + p, numbers[p, E_X + order], harmonics, others, p, 1, order)


def fill(case, z, rows):
    """Fill rows, which are zero, with the left sides of the conditions and derivatives."""
    numbers, N, rates = case[1], (len(z) - 4) // 2, rows.shape[1] > 1
    at_s, width = 2 * N + 2, rows.shape[1]
    ends, T = times(z, at_s, 1.0, 2)
    motion = amplitudes(z, 1.0, N)
    integrals = harmonic_integrals(ends, T, 2 * N, rates)
    at_ends = waves(1.0, ends, T, N + 1, 2)
    add_harmonics(numbers, 1.0, motion, ends, T, integrals, at_s, rows)
    add_constant_force(numbers, at_s, integrals, ends, N, rows)
    series = function_series(z[at_s], z[at_s + 1], rates)
    add_function(case, z, motion, ends, series, rows)
    harmonics = series_at_ends(1.0, motion, ends, at_ends, at_s, N, width)
    others = beside_series(z, ends, series, N, width)
    add_events(numbers, at_s, harmonics, others, rows)
    if rates:
        rows[:, 1] /= 2


def residual(case, z, R):
    """Fill R with the left sides of the conditions."""
    R[:] = 0.0
    fill(case, z, R.reshape((len(R), 1)))


def jacobian(case, z, J):
    """Fill J with their derivatives."""
    rows = np.zeros((len(z), 1 + len(z)))
    fill(case, z, rows)
    J[:, :] = rows[:, 1:]


def motion(case, z, p, u, derivative):
    """Return a derivative of the displacement on phase p at local times u in [0, 1]."""
    if not 0 <= p < 2:
        raise IndexError("p")
    N = (len(z) - 4) // 2
    ends, T = times(z, 2 * N + 2, 1.0, 2)
    (a, b), s = amplitudes(z, 1.0, N), ends[p + 1] - ends[p]
    numbers, omega_0 = np.arange(0, N + 1), 2 * pi / T
    found = series_on_phase(0.0, a, b, numbers, omega_0, ends[p], s, 0.0, 0.0, u, derivative)
    series = function_series(z[2 * N + 2], z[2 * N + 3], False)[p, 0, 3]
    return found + z[2 * N + 1] * legendre_on_phase(series, s, u, derivative)
