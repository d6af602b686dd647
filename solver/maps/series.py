"""The map of a phase by its expansion: its coefficients solved for, given states and times.

The rows of a phase are banded in the coefficients ``d_n`` of its acceleration.  Given the state
in which it begins, memory, times and its last coefficients, as many as there are conditions on
derivatives above the second, they determine the others.  Where there is a part of the residual
that no test sees, rows above the tests say what it is; with that put in, two columns of the
matrix ``B_low - Z B_top`` are full, and Z, of `tables`, depends on order and class alone.

Right sides and solutions stand in columns: the value; the derivatives by duration, angle of
the forcing, constant force, displacement and velocity at the begin; by the last coefficients.
"""

from typing import Any

import numpy as np

from ...generated.ck import (
    BESIDE,
    CLASS,
    FREE,
    MEMORY,
    C,
    F,
    G,
    K,
    M,
    derivative_at_end,
    derivative_at_end_by_s,
    displacement_gained,
    displacement_gained_by_s,
    fill_angles,
    legendre_moments,
    moment_by_kappa,
    of_moment,
    row,
    row_by_s,
    terms,
    tests,
    unseen,
)
from ..arrays import Matrix, Vector
from .band import (
    BLOCK,
    PAD,
    SIDE,
    add_full,
    eliminate,
    factorise_band,
    solve,
    solve_block,
    substitute,
)

#: Columns: of these, force, displacement and velocity stand in the first two rows alone.
VALUE, DURATION, ANGLE, FORCE, STATE, LAST = 0, 1, 2, 3, 4, 6


def places_kept(kinds: Any, N: int) -> Any:
    """Return where the unknowns of each phase begin that are solved for together."""
    at = np.zeros(len(kinds) + 1, dtype=np.int64)
    for p in range(len(kinds)):
        at[p + 1] = at[p] + 2 + terms(kinds, p, N) - tests(kinds, p, N)
    return at


def workplace(kinds: Any, at: Any, N: int) -> Any:
    """Return room: bands, columns, full columns, exchanges, moments; for which times; ends.

    The last three are as `joints` takes them: angles of the forcing, how phases end, and the
    derivatives.
    """
    count, rows, width, high = len(kinds), BLOCK, 2, 2
    for p in range(count):
        rows = max(rows, terms(kinds, p, N) + kinds[p, BESIDE])
        width = max(width, at[p + 1] - at[p])
        high = max(high, kinds[p, CLASS] + 1)
    length, columns = PAD + rows + SIDE, STATE + width
    return (
        np.zeros((count, length, PAD + SIDE + 1)),
        np.zeros((count, length, columns)),
        np.zeros((count, length, 2)),
        np.zeros((count, length), dtype=np.int64),
        np.zeros((count, 2, rows + 1)),
        np.full((count, 2), np.nan),
        np.zeros(count, dtype=np.bool_),
        np.zeros(count + 1),
        np.zeros((2, count, high)),
        np.zeros((2, count, high, columns - 1)),
    )


def solve_phases(case: Any, y: Vector, at: Any, N: int, work: Any) -> None:
    """Fill in how each phase begins and ends, from what is solved for together in `y`."""
    theta = work[7]
    fill_angles(case, y, at, theta)
    for p in range(len(case[0])):
        solve_phase(case, y, at, N, work, p, theta[p])


def solve_phase(case: Any, y: Vector, at: Any, N: int, work: Any, p: int, theta: float) -> None:
    """Fill it in for one phase, at the angle of the forcing where it begins."""
    kinds, _, setting = case[:3]
    bands, columns, fulls, exchanged, _, times, wide, _, ends, _ = work
    s = y[at[len(kinds)] + len(setting) + p]
    if not kinds[p, FREE]:
        ends[0, p, 0] = s * y[at[p] + 1]
        return
    D, B, full = bands[p], columns[p], fulls[p]
    number, rows = terms(kinds, p, N), tests(kinds, p, N)
    if times[p, 0] != s or times[p, 1] != theta:
        fill_band(case, N, work, p, s, theta)
        wide[p] = factorise_band(D, exchanged[p], rows)
        if kinds[p, BESIDE] > 0:
            solve(D, exchanged[p], wide[p], rows, full, 0, 2)
        times[p, 0], times[p, 1] = s, theta
    fill_value(case, y, at, N, work, p)
    for i in range(number - rows):
        B[PAD + rows + i, VALUE] = y[at[p] + 2 + i]
    solve(D, exchanged[p], wide[p], rows, B, VALUE, VALUE + 1)
    if kinds[p, BESIDE] > 0:
        add_full(full, rows, B, VALUE, VALUE + 1, rows)
    by = displacement_gained(s)
    d0, d1 = B[PAD, VALUE], B[PAD + 1, VALUE]
    ends[0, p, 0] = by[0] * y[at[p] + 1] + by[1] * d0 + by[2] * d1
    ends[0, p, 1] = s * d0
    for order in range(2, ends.shape[2]):
        end, begin = 0.0, 0.0
        for n in range(number):
            part = derivative_at_end(n, order - 2, s) * B[PAD + n, VALUE]
            end += part
            begin += part if (n + order) % 2 == 0 else -part
        ends[0, p, order], ends[1, p, order] = end, begin


def fill_band(case: Any, N: int, work: Any, p: int, s: float, theta: float) -> None:
    """Fill in the band of a phase, its full columns, and the moments of the forcing."""
    kinds, numbers, _, _, cell, tables = case
    D, full, moments = work[0][p], work[2][p], work[4][p]
    m, c, k, g = numbers[p, M], numbers[p, C], numbers[p, K], numbers[p, G]
    rows, left = tests(kinds, p, N), kinds[p, BESIDE]
    D[:PAD] = 0.0
    for l in range(rows):
        factors = row(l, m, c, k, s)
        D[PAD + l, 0], D[PAD + l, 1] = 0.0, 0.0
        for i in range(5):
            D[PAD + l, SIDE + i] = factors[2 + i] if l + i < rows + 2 else 0.0
    if left > 0:  # row R, above the tests, sees d_(R - 2) and d_(R - 1); the next d_(R - 1)
        first = row(rows, m, c, k, s)
        second = row(rows + 1, m, c, k, s)[2] if left > 1 else 0.0
        for low in range(rows):
            full[PAD + low, 0] = tables[p, low, 0] * first[2]
            full[PAD + low, 1] = tables[p, low, 0] * first[3]
            if left > 1:
                full[PAD + low, 1] += tables[p, low, 1] * second
    if g != 0:
        legendre_moments(cell[1] * s, theta, moments[:, : rows + left + 1])


def fill_value(case: Any, y: Vector, at: Any, N: int, work: Any, p: int) -> None:
    """Fill in the right side of a phase, in its first column."""
    kinds, numbers, setting = case[:3]
    B, moments = work[1][p], work[4][p]
    m, c, k, f, g = numbers[p, M], numbers[p, C], numbers[p, K], numbers[p, F], numbers[p, G]
    number, rows, left = terms(kinds, p, N), tests(kinds, p, N), kinds[p, BESIDE]
    at_w = at[len(kinds)]
    s = y[at_w + len(setting) + p]
    for i in range(len(setting)):
        f += numbers[p, MEMORY + i] * y[at_w + i]
    for l in range(rows + left):
        value = of_moment(l, g * moments[0, l]) if g != 0 else 0.0
        if l < 2 or l >= rows - 2:
            factors = row(l, m, c, k, s)
            value -= factors[0] * y[at[p]] + factors[1] * y[at[p] + 1]
            for i in range(max(0, rows + 2 - l), min(5, number + 2 - l)):
                value -= factors[2 + i] * y[at[p] + l + i - rows]
        B[PAD + l, VALUE] = value
    B[PAD, VALUE] += f
    take_unseen(case, N, p, B, VALUE, VALUE + 1)


def take_unseen(case: Any, N: int, p: int, B: Matrix, first: int, last: int) -> None:
    """Subtract from right sides what rows above the tests say of the part that no test sees."""
    kinds, tables = case[0], case[5]
    rows = tests(kinds, p, N)
    for i in range(kinds[p, BESIDE]):
        for low in range(rows):
            for column in range(first, last):
                B[PAD + low, column] -= tables[p, low, i] * B[PAD + rows + i, column]


def phase_rates(case: Any, y: Vector, at: Any, N: int, work: Any) -> None:
    """Fill in the derivatives of what `solve_phases` filled in, where it was called last."""
    for p in range(len(case[0])):
        phase_rate(case, y, at, N, work, p, work[1].shape[2])


def phase_rate(case: Any, y: Vector, at: Any, N: int, work: Any, p: int, most: int) -> None:
    """Fill them in for one phase: those of the columns below `most`."""
    kinds, numbers, setting = case[:3]
    bands, columns, fulls, exchanged, _, _, wide, _, ends, by = work
    s, after = y[at[len(kinds)] + len(setting) + p], p + 1 if p + 1 < len(kinds) else 0
    by[:, p] = 0.0
    if not kinds[p, FREE]:
        by[0, p, 0, STATE], by[0, p, 0, 0] = s, y[at[p] + 1]
        return
    D, B, last = bands[p], columns[p], min(most, STATE + at[p + 1] - at[p])
    number, rows = terms(kinds, p, N), tests(kinds, p, N)
    smooth = kinds[p, CLASS] > 1 or kinds[after, CLASS] > 1
    needed = rows if smooth else BLOCK
    fill_columns(case, y, at, N, work, p)
    full = kinds[p, BESIDE] > 0
    if wide[p]:
        eliminate(D, exchanged[p], rows, B, DURATION, last)
    else:
        forced = FORCE if numbers[p, G] != 0 else ANGLE
        eliminate(D, exchanged[p], rows, B, DURATION, min(last, forced))
        eliminate(D, exchanged[p], rows, B, LAST, last)
    solve_block(D, B, DURATION, last)
    substitute(D, wide[p], B, 0, rows if full else needed, DURATION, last)
    if full:
        add_full(fulls[p], rows, B, DURATION, last, needed)
    of_v, of_d0, of_d1 = displacement_gained(s)
    v_by_s, d0_by_s, d1_by_s = displacement_gained_by_s(s)
    for column in range(DURATION, last):
        by[0, p, 0, column - 1] = of_d0 * B[PAD, column] + of_d1 * B[PAD + 1, column]
        by[0, p, 1, column - 1] = s * B[PAD, column]
    d0, d1 = B[PAD, VALUE], B[PAD + 1, VALUE]
    by[0, p, 0, STATE] += of_v
    by[0, p, 0, 0] += v_by_s * y[at[p] + 1] + d0_by_s * d0 + d1_by_s * d1
    by[0, p, 1, 0] += d0
    for order in range(2, ends.shape[2] if smooth else 2):
        for n in range(number):
            weight = derivative_at_end(n, order - 2, s)
            sign = 1.0 if (n + order) % 2 == 0 else -1.0
            rate = derivative_at_end_by_s(n, order - 2, s) * B[PAD + n, VALUE]
            by[0, p, order, 0] += rate
            by[1, p, order, 0] += sign * rate
            for column in range(DURATION, last):
                if n < rows:
                    part = weight * B[PAD + n, column]
                else:
                    part = weight if column == LAST + n - rows else 0.0
                by[0, p, order, column - 1] += part
                by[1, p, order, column - 1] += sign * part


def fill_columns(case: Any, y: Vector, at: Any, N: int, work: Any, p: int) -> None:
    """Fill in the derivatives of the right side of a phase, less those of its band."""
    kinds, numbers, setting, _, cell = case[:5]
    m, c, k, g = numbers[p, M], numbers[p, C], numbers[p, K], numbers[p, G]
    number, rows, left = terms(kinds, p, N), tests(kinds, p, N), kinds[p, BESIDE]
    B, moments = work[1][p], work[4][p]
    s, v = y[at[len(kinds)] + len(setting) + p], y[at[p] + 1]
    B[PAD:, DURATION:] = 0.0
    for l in range(rows + left):
        changes, at_row = row_by_s(l, m, c, k, s), PAD + l
        slope = -changes[1] * v
        for i in range(max(0, 2 - l), min(5, number + 2 - l)):
            slope -= changes[2 + i] * B[at_row + i - 2, VALUE]
        if l < 2 or l >= rows - 2:
            factors = row(l, m, c, k, s)
            B[at_row, STATE], B[at_row, STATE + 1] = -factors[0], -factors[1]
            for i in range(max(0, rows + 2 - l), min(5, number + 2 - l)):
                B[at_row, LAST + l + i - 2 - rows] -= factors[2 + i]
        if g != 0:
            before, own, after = moment_by_kappa(l)
            change = own * moments[1, l] + after * moments[1, l + 1]
            change += before * moments[1, l - 1] if l > 0 else 0.0
            slope += of_moment(l, g * cell[1] * change)
            B[at_row, ANGLE] = of_moment(l, g * moments[1, l])
        B[at_row, DURATION] = slope
    B[PAD, FORCE] = 1.0
    take_unseen(case, N, p, B, DURATION, B.shape[1])


def unpack(case: Any, y: Vector, at: Any, N: int, work: Any, z: Vector) -> None:
    """Fill in all unknowns of the whole system, where the phases were solved last."""
    kinds, numbers, setting = case[:3]
    place, at_s = 0, at[len(kinds)] + len(setting)
    for p in range(len(kinds)):
        number, rows = terms(kinds, p, N), tests(kinds, p, N)
        z[place], z[place + 1] = y[at[p]], y[at[p] + 1]
        for i in range(number):
            z[place + 2 + i] = work[1][p, PAD + i, VALUE]
        place += 2 + number
        m, c, k, s = numbers[p, M], numbers[p, C], numbers[p, K], y[at_s + p]
        left = kinds[p, BESIDE]
        if left > 0:
            fill_value(case, y, at, N, work, p)  # the rows above the tests, not overwritten
        for i in range(left - 1, -1, -1):  # the highest first
            l = rows + i
            factors = row(l, m, c, k, s)
            value = -work[1][p, PAD + l, VALUE]
            for j in range(min(5, rows + 2 - l)):
                value += factors[2 + j] * z[place - number + l + j - 2]
            for j in range(i + 1, left):
                value -= m * unseen(rows + j, l, kinds[p, CLASS]) * z[place + j]
            z[place + i] = value / (m * unseen(l, l, kinds[p, CLASS]))
        place += left
    for i in range(len(y) - at[len(kinds)]):
        z[place + i] = y[at[len(kinds)] + i]
