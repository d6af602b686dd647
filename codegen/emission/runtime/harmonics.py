"""Integrals of harmonics over phases, and the motion as a Fourier series."""

from math import cos, pi, sin

import numpy as np


def harmonic_integrals(weights, power, ends, period, highest):
    """Return the integrals of a weight times harmonics, over a cell.

    These are the cosine and the sine of ``k omega_0 t``.  The integrals are multiplied by a
    power of ``omega_0``, as derivatives of harmonics are.

    Parameters
    ----------
    weights : tuple of float, length P
        The weight on each phase.
    power : int
        Of ``omega_0``.
    ends : tuple of float, length P + 1
        Where the phases begin, and where the last one ends.
    period : float
        ``omega_0 = 2 pi/period``; a multiple of the cell.
    highest : int
        Largest k.

    Returns
    -------
    cosines, sines : ndarray, shape (P + 1, 2 highest + 1)
        Row 0 the integrals, row 1 + q their derivatives by the duration of phase q.  Entry -k
        is that of -k, as Python counts from the end.
    """
    phases, length, cell = len(weights), 2 * highest + 1, ends[len(ends) - 1]
    scale = (2 * pi / period) ** power
    cosines, sines = np.zeros((phases + 1, length)), np.zeros((phases + 1, length))
    for k in range(highest + 1):
        omega = 2 * pi * k / period
        begin_c, begin_s = cos(omega * ends[0]), sin(omega * ends[0])
        for p in range(phases):
            t, end, weight = ends[p], ends[p + 1], weights[p] * scale
            end_c, end_s = cos(omega * end), sin(omega * end)
            half = omega * (end - t) / 2
            size = (end - t) * (sin(half) / half if half != 0.0 else 1.0)
            middle = omega * (t + end) / 2
            over_c, over_s = size * cos(middle), size * sin(middle)
            cosines[0, k] += weight * over_c
            sines[0, k] += weight * over_s
            for q in range(phases):
                later = (1.0 if p >= q else 0.0) - end / cell
                now = (1.0 if p > q else 0.0) - t / cell
                change_c = end_c * later - begin_c * now + (1 - power) * over_c / cell
                change_s = end_s * later - begin_s * now + (1 - power) * over_s / cell
                cosines[1 + q, k] += weight * change_c
                sines[1 + q, k] += weight * change_s
            begin_c, begin_s = end_c, end_s
        if k > 0:
            for row in range(phases + 1):
                cosines[row, length - k] = cosines[row, k]
                sines[row, length - k] = -sines[row, k]
    return cosines, sines


def harmonic_motion(mean, a, b, numbers, omega_0, t, derivative):
    """Return ``mean + sum a_n sin(n omega_0 t) + b_n cos(n omega_0 t)``, or a derivative."""
    t = np.asarray(t)
    angle = np.multiply.outer(t, numbers * omega_0)
    factor = (numbers * omega_0) ** derivative
    sine, cosine = np.sin(angle + derivative * pi / 2), np.cos(angle + derivative * pi / 2)
    constant = mean if derivative == 0 else 0.0
    return constant + sine @ (factor * a) + cosine @ (factor * b)


def series_on_phase(mean, a, b, numbers, omega_0, start, s, begins, ends, u, derivative):
    """Return the motion on a phase from its Fourier series, at local times u from 0 to 1.

    Where the velocity jumps by `begins` or `ends`, the series has the mean of both sides; at
    the very ends of the phase the velocity returned is that of this side.
    """
    u = np.asarray(u, dtype=float)
    motion = harmonic_motion(mean, a, b, numbers, omega_0, start + s * u, derivative)
    if derivative == 1:
        motion = motion + begins / 2 * (u == 0) - ends / 2 * (u == 1)
    return motion
