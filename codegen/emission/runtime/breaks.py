"""A function of the whole cell on its phases: its ends, its integrals with harmonics."""

from math import cos, pi, sin

import numpy as np
from numpy.polynomial import legendre

from .moments import spherical_bessel


def function_series(*durations_and_rates):
    """Stand for the closed forms of one function: `breaks_on_phases` of T**3 G''' to G."""
    raise NotImplementedError


def break_ends(series):
    """Return each function where the phases begin and end, from `breaks_on_phases`.

    Returns
    -------
    ndarray, shape (1 + P or 1, n, P, 2)
        The values, and their derivatives by each duration, at the begin and at the end.
    """
    phases, rates, size, _ = series.shape
    found = np.zeros((rates, size, phases, 2))
    for q in range(phases):
        for r in range(rates):
            for n in range(size):
                for l in range(size):
                    found[r, n, q, 0] += series[q, r, n, l] * (1 - 2 * (l % 2))
                    found[r, n, q, 1] += series[q, r, n, l]
    return found


def break_integrals(n, series, weights, ends, period, numbers):
    """Return the integrals over a cell of the residual of ``beta_n`` times harmonics.

    Parameters
    ----------
    n : int
        The function.
    series : ndarray
        From `breaks_on_phases`, with or without derivatives.
    weights : tuple of (m, c, k) on each phase
    ends : tuple of float, length P + 1
    period : float
        ``omega_0 = 2 pi/period``; a multiple of the cell.
    numbers : ndarray
        The harmonics; the first is that of the constant.

    Returns
    -------
    ndarray, shape (2, 1 + P or 1, len(numbers))
        With the cosine and with the sine: the integrals, their derivatives by each duration.
    """
    phases, rows, cell = len(ends) - 1, series.shape[1], ends[len(ends) - 1]
    omega = 2 * pi / period
    found = np.zeros((2, rows, len(numbers)))
    rho = np.zeros((rows, n + 1))
    even, odd = np.zeros(n + 2), np.zeros(n + 2)
    for q in range(phases):
        m, c, k = weights[q]
        s, t = ends[q + 1] - ends[q], ends[q]
        rho[:, :] = 0.0
        for l in range(n + 1):
            rate, twice = (
                series[q, 0, n - 1, l] * c / cell,
                series[q, 0, n - 2, l] * m / cell**2,
            )
            rho[0, l] = k * series[q, 0, n, l] + rate + twice
            for r in range(1, rows):
                rho[r, l] = k * series[q, r, n, l] + series[q, r, n - 1, l] * c / cell
                rho[r, l] += series[q, r, n - 2, l] * m / cell**2 - (rate + 2 * twice) / cell
        for column in range(len(numbers)):
            w = numbers[column] * omega
            bessel = spherical_bessel(n + 2, w * s / 2)
            for turned in range(2):  # the sine is the cosine, a quarter turn back
                middle = w * (t + s / 2) - turned * pi / 2
                co, si = cos(middle), sin(middle)
                for l in range(n + 2):
                    turn = l % 4
                    value = co if turn == 0 else -si if turn == 1 else -co if turn == 2 else si
                    ahead = -si if turn == 0 else -co if turn == 1 else si if turn == 2 else co
                    even[l], odd[l] = value * bessel[l], ahead * bessel[l]
                for l in range(n + 1):
                    found[turned, 0, column] += s * rho[0, l] * even[l]
                for l in range(n + 1 if rows > 1 else 0):
                    near = (l + 1) * odd[l + 1] + (l * odd[l - 1] if l > 0 else 0.0)
                    stretch = (odd[l] + near / (2 * l + 1)) / 2
                    for r in range(phases):
                        by_kappa = w * ((1.0 if r == q else 0.0) - s / cell)
                        by_theta = w * ((1.0 if r < q else 0.0) - t / cell)
                        slope = by_kappa * stretch + by_theta * odd[l]
                        change = rho[1 + r, l] * even[l] + rho[0, l] * slope
                        own = rho[0, l] * even[l] if r == q else 0.0
                        found[turned, 1 + r, column] += s * change + own
    return found


def legendre_on_phase(series, duration, u, derivative):
    """Return a series of shifted Legendre polynomials on a phase, or a derivative by time."""
    w = 2 * np.asarray(u, dtype=float) - 1
    slope = legendre.legder(series, derivative, scl=2)
    return legendre.legval(w, slope) / duration**derivative
