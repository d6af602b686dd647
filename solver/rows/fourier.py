"""Harmonics over the period of a motion of any phases: where unknowns are, times, (3) at ends.

And what stands beside (3), on a phase.

A scene is arrays, as in `joints`.  Harmonics are counted by i: their numbers are 0, 1, ..., N,
or the N odd ones where the motion repeats with the opposite sign after a cell.
"""

from math import pi

import numpy as np
from numpy.polynomial import legendre

from ...generated.hb import by_time
from .harmonics import multiples
from .joints import BESIDE, CLASS


def legendre_on_phase(series, duration, u, derivative):
    """Return a series of shifted Legendre polynomials on a phase, or a derivative by time."""
    w = 2 * np.asarray(u, dtype=float) - 1
    slope = legendre.legder(series, derivative, scl=2)
    return legendre.legval(w, slope) / duration**derivative


def odd(sign):
    """Return whether the cell is half a period: then only odd harmonics are there."""
    return sign < 0


def number(sign, i):
    """Return the number of harmonic i."""
    return 2 * i + 1 if odd(sign) else i


def cosine_place(sign, N, i):
    """Return where the unknown of cosine i stands, and its row; those of sine i stand at i.

    The cosine of number 0 is the constant; the sine is zero, and adds zeros to its place.
    """
    return 0 if i == 0 and not odd(sign) else N + i


def jumps(kinds, p):
    """Return whether the velocity jumps where phase p begins, with no function for it."""
    return kinds[p, CLASS] == 0 and kinds[p, BESIDE] == 0


def own(kinds, p):
    """Return how many unknowns, and conditions, the switch that begins phase p has."""
    return 1 if jumps(kinds, p) else kinds[p, BESIDE]


def beside(case):
    """Return how many unknowns there are beside the harmonics of numbers 1 and beyond."""
    kinds, _, setting, _, cell = case[:5]
    found = len(setting) + len(kinds) + (1 if cell[2] != 0 else 0)
    for p in range(len(kinds)):
        found += own(kinds, p)
    return found if odd(cell[0]) else found + 1


def places(case, N):
    """Return where the unknowns of each switch begin, and those behind all of them."""
    kinds, sign = case[0], case[4][0]
    at = np.zeros(len(kinds) + 1, dtype=np.int64)
    at[0] = 2 * N if odd(sign) else 2 * N + 1
    for p in range(len(kinds)):
        at[p + 1] = at[p] + own(kinds, p)
    return at


def times(z, at_s, sign, phases):
    """Return when phases begin and the last one ends, and the period."""
    ends = np.zeros(phases + 1)
    for p in range(phases):
        ends[p + 1] = ends[p] + z[at_s + p]
    return ends, ends[phases] * (2 if odd(sign) else 1)


def moved(ends, r, q):
    """Return the derivative of ``t_q/T`` by duration r, times T."""
    return (1.0 if r < q else 0.0) - ends[q] / ends[len(ends) - 1]


def amplitudes(z, sign, N):
    """Return what sines and cosines are multiplied by; the mean is half the constant."""
    count = N if odd(sign) else N + 1
    found = np.zeros((2, count))
    for i in range(count):
        found[0, i], found[1, i] = z[i], z[cosine_place(sign, N, i)]
    if not odd(sign):
        found[0, 0], found[1, 0] = 0.0, z[0] / 2
    return found


def waves(sign, ends, period, count, highest):
    """Return sines, cosines and their derivatives where phases begin, and the last one ends.

    Returns
    -------
    ndarray, shape (P + 1, highest + 1, 2, count)
    """
    phases, omega_0 = len(ends) - 1, 2 * pi / period
    found = np.zeros((phases + 1, highest + 1, 2, count))
    for q in range(phases + 1):
        if 0 < q < phases:
            cosines, sines = multiples(omega_0 * ends[q], number(sign, count - 1))
        for i in range(count):
            j, sine, cosine = number(sign, i), 0.0, sign if q == phases else 1.0
            if 0 < q < phases:
                sine, cosine = sines[j], cosines[j]
            for order in range(highest + 1):
                found[q, order, 0, i], found[q, order, 1, i] = sine, cosine
                sine, cosine = by_time(j * omega_0, sine, cosine)
    return found


def series_at_ends(sign, motion, ends, at_ends, at_s, N, width):
    """Return derivatives of the series where phases begin and the last one ends.

    Returns
    -------
    ndarray, shape (P + 1, derivatives, width)
        The value and, if `width` has room for them, behind it its derivatives by all unknowns,
        by half the constant for the constant.
    """
    phases, highest, T = len(ends) - 1, at_ends.shape[1] - 1, ends[len(ends) - 1]
    found = np.zeros((phases + 1, highest + 1, width))
    for q in range(phases + 1):
        for order in range(highest + 1):
            value = 0.0
            for i in range(motion.shape[1]):
                sine, cosine = at_ends[q, order, 0, i], at_ends[q, order, 1, i]
                value = value + (sine * motion[0, i] + cosine * motion[1, i])
                if width > 1:
                    found[q, order, 1 + i] += sine
                    found[q, order, 1 + cosine_place(sign, N, i)] += cosine
            found[q, order, 0] = value
        for order in range(highest if width > 1 else 0):
            for r in range(phases):
                change = found[q, order + 1, 0] * moved(ends, r, q)
                found[q, order, 1 + at_s + r] = change - order / T * found[q, order, 0]
    return found
