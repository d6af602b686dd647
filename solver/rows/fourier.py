"""Fourier series (3) of a motion of any phases: layout of unknowns, times, values at switches.

A case is arrays, as in `joints`.  Harmonics are counted by i: their numbers are 0, 1, ..., N,
or the N odd ones if the motion repeats with the opposite sign after a cell.
"""

from math import pi

import numpy as np
from numpy.polynomial import legendre

from ...generated.hb import by_time
from .harmonics import multiples
from .joints import BESIDE, CLASS


def legendre_on_phase(series, duration, u, derivative):
    """Return values of a series of shifted Legendre polynomials, or of a derivative by time.

    `u` are local times in [0, 1] of a phase.
    """
    w = 2 * np.asarray(u, dtype=float) - 1
    slope = legendre.legder(series, derivative, scl=2)
    return legendre.legval(w, slope) / duration**derivative


def odd(sign):
    """Return whether the cell is half a period: then only odd harmonics occur."""
    return sign < 0


def number(sign, i):
    """Return the number of harmonic i."""
    return 2 * i + 1 if odd(sign) else i


def cosine_place(sign, N, i):
    """Return the index of the unknown, and of the row, of cosine i; those of sine i are i.

    The cosine of number 0 is the constant; the sine of number 0 is zero and shares its index.
    """
    return 0 if i == 0 and not odd(sign) else N + i


def jumps(kinds, p):
    """Return whether the velocity jumps where phase p begins, and no function has that jump."""
    return kinds[p, CLASS] == 0 and kinds[p, BESIDE] == 0


def unknowns_of_switch(kinds, p):
    """Return the number of unknowns, and of conditions, of the switch that begins phase p."""
    return 1 if jumps(kinds, p) else kinds[p, BESIDE]


def unknowns_beside(case):
    """Return the number of unknowns besides the 2 N of harmonics of numbers above 0."""
    kinds, _, setting, _, cell = case[:5]
    return places(case, 0)[len(kinds)] + len(setting) + len(kinds) + (1 if cell[2] != 0 else 0)


def places(case, N):
    """Return the index of the first unknown of each switch, and of the first after them."""
    kinds, sign = case[0], case[4][0]
    at = np.zeros(len(kinds) + 1, dtype=np.int64)
    at[0] = 2 * N if odd(sign) else 2 * N + 1
    for p in range(len(kinds)):
        at[p + 1] = at[p] + unknowns_of_switch(kinds, p)
    return at


def times(z, at_s, sign, phases):
    """Return the times of the switches of a cell, from 0 to its end, and the period."""
    ends = np.zeros(phases + 1)
    for p in range(phases):
        ends[p + 1] = ends[p] + z[at_s + p]
    return ends, ends[phases] * (2 if odd(sign) else 1)


def switch_rate(ends, r, q):
    """Return ``T d(t_q/T)/ds_r``: t_q is the begin of phase q, s_r the duration of phase r."""
    return (1.0 if r < q else 0.0) - ends[q] / ends[len(ends) - 1]


def amplitudes(z, sign, N):
    """Return the amplitudes of sines and cosines, shape (2, count); [1, 0] is the mean."""
    count = N if odd(sign) else N + 1
    amplitude = np.zeros((2, count))
    for i in range(count):
        amplitude[0, i], amplitude[1, i] = z[i], z[cosine_place(sign, N, i)]
    if not odd(sign):
        amplitude[0, 0], amplitude[1, 0] = 0.0, z[0] / 2
    return amplitude


def waves(sign, ends, period, count, highest):
    """Return the derivatives of sines and cosines at the switches and at the end of the cell.

    Returns
    -------
    ndarray, shape (P + 1, highest + 1, 2, count)
        By switch, order of the derivative, sine or cosine, and i.
    """
    phases, omega_0 = len(ends) - 1, 2 * pi / period
    derivatives = np.zeros((phases + 1, highest + 1, 2, count))
    for q in range(phases + 1):
        if 0 < q < phases:
            cosines, sines = multiples(omega_0 * ends[q], number(sign, count - 1))
        for i in range(count):
            j, sine, cosine = number(sign, i), 0.0, sign if q == phases else 1.0
            if 0 < q < phases:
                sine, cosine = sines[j], cosines[j]
            for order in range(highest + 1):
                derivatives[q, order, 0, i], derivatives[q, order, 1, i] = sine, cosine
                sine, cosine = by_time(j * omega_0, sine, cosine)
    return derivatives


def series_at_ends(sign, motion, ends, at_ends, at_s, N, width):
    """Return the derivatives of the series at the switches and at the end of the cell.

    Returns
    -------
    ndarray, shape (P + 1, derivatives, width)
        The value and, if `width` is above 1, its derivatives by all unknowns after it; the one
        by the constant is by half of it.
    """
    phases, highest, T = len(ends) - 1, at_ends.shape[1] - 1, ends[len(ends) - 1]
    series = np.zeros((phases + 1, highest + 1, width))
    for q in range(phases + 1):
        for order in range(highest + 1):
            value = 0.0
            for i in range(motion.shape[1]):
                sine, cosine = at_ends[q, order, 0, i], at_ends[q, order, 1, i]
                value = value + (sine * motion[0, i] + cosine * motion[1, i])
                if width > 1:
                    series[q, order, 1 + i] += sine
                    series[q, order, 1 + cosine_place(sign, N, i)] += cosine
            series[q, order, 0] = value
        for order in range(highest if width > 1 else 0):
            for r in range(phases):
                change = series[q, order + 1, 0] * switch_rate(ends, r, q)
                series[q, order, 1 + at_s + r] = change - order / T * series[q, order, 0]
    return series
