"""Galerkin conditions (5), (6), (7): the residual is orthogonal to the harmonics of the period.

Each of the `rows` has the residual of a condition in column 0 and, if there are more columns,
its derivatives by all unknowns after it.
"""

from math import cos, pi, sin

import numpy as np

from ...generated.hb import alone, by_time, of_forcing, products
from .fourier import cosine_place, jumps, number, odd, switch_rate
from .harmonics import weighted_integrals
from .joints import MEMORY, F, G, K, M


def is_same(numbers, column):
    """Return whether a coefficient is the same on all phases."""
    same = True
    for p in range(1, len(numbers)):
        same = same and numbers[p, column] == numbers[0, column]
    return same


def cycles_of(cell):
    """Return the number of periods of the forcing in the period."""
    cycles = 0
    while cycles * (1 if odd(cell[0]) else 2) < cell[2]:
        cycles += 1
    return cycles


def highest_number(numbers, cell, last):
    """Return the highest number of a harmonic to be integrated, in products or in the forcing.

    `last` is that of the motion.
    """
    same = True
    for order in range(3):
        same = same and is_same(numbers, K - order)
    return last + max(0 if same else last, cycles_of(cell))


def add_harmonics(numbers, sign, motion, ends, period, integrals, at_s, rows):
    """Add the integrals of ``m x'' + c x' + k x`` times harmonics, for x the harmonics.

    Harmonics over a period, and odd ones over half of it, are orthogonal: for a coefficient
    that is the same on all phases, only squares have an integral.
    """
    for order in range(3):
        weight = numbers[0, K - order]
        if not is_same(numbers, K - order):
            weights = numbers[:, K - order]
            table = weighted_integrals(integrals, weights, order, ends, period)
            for r in range(table.shape[1]):
                column = at_s + r if r > 0 else 0
                add_products(table[0, r], table[1, r], order, sign, motion, rows, column)
        elif weight != 0:
            whole = weight * (2 * pi / period) ** order * ends[len(ends) - 1]
            add_alone(whole, order, sign, motion, ends, at_s, rows)


def add_products(C, S, order, sign, motion, rows, column):
    """Add the integrals of a derivative of the motion times sines and cosines to a column.

    For column 0, their derivatives by the amplitudes are added as well, if rows have columns
    for them.
    """
    count, wide = motion.shape[1], column == 0 and rows.shape[1] > 1
    N = count if odd(sign) else count - 1
    for i in range(count):
        by_sine, by_cosine, j, row = 0.0, 0.0, number(sign, i), cosine_place(sign, N, i)
        for l in range(count):
            n = number(sign, l)
            aa, ab, ba, bb = products(j, n, C, S)
            for _ in range(order):
                aa, ab = by_time(n, aa, ab)
                ba, bb = by_time(n, ba, bb)
            by_sine = by_sine + (aa * motion[0, l] + ab * motion[1, l])
            by_cosine = by_cosine + (ba * motion[0, l] + bb * motion[1, l])
            if wide:
                index = 1 + cosine_place(sign, N, l)
                rows[i, 1 + l] += aa
                rows[i, index] += ab
                rows[row, 1 + l] += ba
                rows[row, index] += bb
        rows[i, column] += by_sine
        rows[row, column] += by_cosine


def add_alone(whole, order, sign, motion, ends, at_s, rows):
    """Add the same integrals for a coefficient that is the same on all phases.

    `whole` is the integral of the coefficient over the cell, times ``omega_0^order``.
    """
    count, phases = motion.shape[1], len(ends) - 1
    N = count if odd(sign) else count - 1
    for i in range(count):
        n, index = number(sign, i), cosine_place(sign, N, i)
        aa, ab, ba, bb = alone(whole if n == 0 else 0.0 * whole, whole)
        for _ in range(order):
            aa, ab = by_time(n, aa, ab)
            ba, bb = by_time(n, ba, bb)
        by_sine = aa * motion[0, i] + ab * motion[1, i]
        by_cosine = ba * motion[0, i] + bb * motion[1, i]
        rows[i, 0] += by_sine
        rows[index, 0] += by_cosine
        if rows.shape[1] > 1:
            rows[i, 1 + i] += aa
            rows[i, 1 + index] += ab
            rows[index, 1 + i] += ba
            rows[index, 1 + index] += bb
        for r in range(phases if rows.shape[1] > 1 else 0):
            rows[i, 1 + at_s + r] += (1 - order) / ends[phases] * by_sine
            rows[index, 1 + at_s + r] += (1 - order) / ends[phases] * by_cosine


def add_forces(case, z, at_w, ends, period, integrals, N, rows):
    """Subtract the integrals of constant force, memory and forcing times harmonics."""
    kinds, numbers, setting, _, cell = case[:5]
    memories, at_s = len(setting), at_w + len(setting)
    if memories > 0 or not is_same(numbers, F) or numbers[0, F] != 0:
        force = np.zeros((len(kinds), 1))
        for p in range(len(kinds)):
            force[p, 0] = numbers[p, F]
            for i in range(memories):
                force[p, 0] = force[p, 0] + numbers[p, MEMORY + i] * z[at_w + i]
        table = weighted_integrals(integrals, force[:, 0], 0, ends, period)
        for r in range(table.shape[1]):
            add_force(table[0, r], table[1, r], cell[0], N, rows, at_s + r if r > 0 else 0)
    for i in range(memories if rows.shape[1] > 1 else 0):
        table = weighted_integrals(integrals, numbers[:, MEMORY + i], 0, ends, period)
        add_force(table[0, 0], table[1, 0], cell[0], N, rows, 1 + at_w + i)
    if cell[2] != 0:
        cosine, sine = cos(z[len(z) - 1]), sin(z[len(z) - 1])
        table = weighted_integrals(integrals, numbers[:, G], 0, ends, period)
        for r in range(table.shape[1]):
            column = at_s + r if r > 0 else 0
            add_forcing(table[0, r], table[1, r], cosine, sine, cell, N, rows, column)
        if rows.shape[1] > 1:
            add_forcing(table[0, 0], table[1, 0], -sine, cosine, cell, N, rows, len(z))


def add_force(C, S, sign, N, rows, column):
    """Subtract the integrals C, S of a force times cosines and sines from their rows."""
    for i in range(N if odd(sign) else N + 1):
        rows[i, column] -= S[number(sign, i)]
        rows[cosine_place(sign, N, i), column] -= C[number(sign, i)]


def add_forcing(C, S, cosine, sine, cell, N, rows, column):
    """Subtract the integrals of the forcing, given its cosine and sine at the first switch."""
    sign, cycles = cell[0], cycles_of(cell)
    for i in range(N if odd(sign) else N + 1):
        by_sine, by_cosine = of_forcing(number(sign, i), cycles, cosine, sine, C, S)
        rows[i, column] -= by_sine
        rows[cosine_place(sign, N, i), column] -= by_cosine


def add_impulses(case, z, at, ends, at_ends, N, rows):
    """Subtract the impulses at jumps of the velocity, times the harmonics there."""
    kinds, numbers, setting, _, cell = case[:5]
    phases, at_s = len(kinds), at[len(kinds)] + len(setting)
    for p in range(phases):
        for i in range(at_ends.shape[3] if jumps(kinds, p) else 0):
            for wave in range(2):
                row = cosine_place(cell[0], N, i) if wave == 1 else i
                rows[row, 0] -= z[at[p]] * numbers[p, M] * at_ends[p, 0, wave, i]
                if rows.shape[1] > 1:
                    rows[row, 1 + at[p]] -= numbers[p, M] * at_ends[p, 0, wave, i]
                    rate = z[at[p]] * numbers[p, M] * at_ends[p, 1, wave, i]
                    for r in range(phases):
                        rows[row, 1 + at_s + r] -= rate * switch_rate(ends, r, p)
