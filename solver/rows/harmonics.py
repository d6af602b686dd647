"""Integrals of harmonics over phases, and the motion as a Fourier series."""

from math import cos, pi, sin

import numpy as np


def multiples(angle, highest):
    """Return ``cos(k angle)`` and ``sin(k angle)`` for k up to `highest`.

    By addition theorems from multiples of 16 and the 16 least k: one cosine and one sine for 16
    values, and a few roundings.
    """
    cosines, sines = np.zeros(highest + 1), np.zeros(highest + 1)
    for k in range(min(16, highest + 1)):
        cosines[k], sines[k] = cos(k * angle), sin(k * angle)
    for begin in range(16, highest + 1, 16):
        c, s = cos(begin * angle), sin(begin * angle)
        for k in range(begin, min(begin + 16, highest + 1)):
            near_c, near_s = cosines[k - begin], sines[k - begin]
            cosines[k], sines[k] = c * near_c - s * near_s, s * near_c + c * near_s
    return cosines, sines


def harmonic_integrals(ends, period, highest, rates):
    """Return the integrals of the cosine and the sine of ``k omega_0 t`` over each phase.

    Parameters
    ----------
    ends : tuple of float, length P + 1
        Times of the switches and of the end of the cell.
    period : float
        ``omega_0 = 2 pi/period``; a multiple of the cell.
    highest : int
        Largest k.
    rates : bool
        Whether derivatives are computed as well.

    Returns
    -------
    ndarray, shape (P, 2, 1 + P or 1, highest + 1)
        For each phase, of the cosine and of the sine: row 0 the integrals, row 1 + q their
        derivatives by the duration of phase q.
    """
    phases, cell = len(ends) - 1, ends[len(ends) - 1]
    integrals = np.zeros((phases, 2, 1 + phases if rates else 1, highest + 1))
    begin_c, begin_s = np.ones(highest + 1), np.zeros(highest + 1)
    for p in range(phases):
        t, end = ends[p], ends[p + 1]
        half_c, half_s = multiples(pi * (end - t) / period, highest)
        for k in range(highest + 1):
            h_c, h_s, b_c, b_s = half_c[k], half_s[k], begin_c[k], begin_s[k]
            half = pi * k * (end - t) / period
            size = (end - t) * (h_s / half if half != 0.0 else 1.0)
            middle_c, middle_s = b_c * h_c - b_s * h_s, b_s * h_c + b_c * h_s
            end_c, end_s = middle_c * h_c - middle_s * h_s, middle_s * h_c + middle_c * h_s
            over_c, over_s = size * middle_c, size * middle_s
            integrals[p, 0, 0, k], integrals[p, 1, 0, k] = over_c, over_s
            if rates:
                change_c = (over_c - end * end_c + t * b_c) / cell
                change_s = (over_s - end * end_s + t * b_s) / cell
                for q in range(phases):
                    at_end, at_begin = (1.0 if p >= q else 0.0), (1.0 if p > q else 0.0)
                    integrals[p, 0, 1 + q, k] = change_c + at_end * end_c - at_begin * b_c
                    integrals[p, 1, 1 + q, k] = change_s + at_end * end_s - at_begin * b_s
            begin_c[k], begin_s[k] = end_c, end_s
    return integrals


def weighted_integrals(integrals, weights, power, ends, period):
    """Return ``omega_0^power`` times the integrals over a cell of a weight times harmonics.

    Parameters
    ----------
    integrals : ndarray
        From `harmonic_integrals`.
    weights : tuple of float, length P
        The weight on each phase.
    power : int
        Order of the derivative of the harmonics.
    ends, period
        Those of `integrals`.

    Returns
    -------
    ndarray, shape (2, 1 + P or 1, 2 highest + 1)
        Of the cosine and of the sine, rows as in `integrals`.  Entry -k, as Python counts from
        the end, is for harmonic -k.
    """
    phases, _, rows, length = integrals.shape
    scale, cell = (2 * pi / period) ** power, ends[phases]
    sums = np.zeros((2, rows, 2 * length - 1))
    for p in range(phases):
        weight = weights[p] * scale
        if weight != 0.0:
            for wave in range(2):
                for row in range(rows):
                    for k in range(length):
                        sums[wave, row, k] += weight * integrals[p, wave, row, k]
    for wave in range(2):
        for row in range(1, rows):
            for k in range(length):
                sums[wave, row, k] -= power / cell * sums[wave, 0, k]
        for row in range(rows):
            for k in range(1, length):
                value = sums[wave, row, k]
                sums[wave, row, 2 * length - 1 - k] = value if wave == 0 else -value
    return sums


def series_on_phase(a, b, numbers, omega_0, start, s, begins, ends, u, derivative):
    """Return ``sum a_n sin(n omega_0 t) + b_n cos(n omega_0 t)`` on a phase, or a derivative.

    At local times u from 0 to 1.  Where the velocity jumps, by `begins` or `ends`, the series
    has the mean of both sides; the velocity returned at u = 0 and u = 1 is the limit from
    within the phase.
    """
    u, omega = np.asarray(u, dtype=float), numbers * omega_0
    angle = np.multiply.outer(start + s * u, omega) + derivative * pi / 2
    factor = omega**derivative
    motion = np.sin(angle) @ (factor * a) + np.cos(angle) @ (factor * b)
    if derivative == 1:
        motion = motion + begins / 2 * (u == 0) - ends / 2 * (u == 1)
    return motion
