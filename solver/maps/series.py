"""The map of a phase by its expansion: its coefficients solved for, given states and times.

The rows of a phase are banded in the coefficients ``d_n`` of its acceleration.  Given the state
in which it begins, memory, times and its last coefficients, as many as there are conditions on
derivatives above the second, they determine the others.  Where there is a part of the residual
that no test sees, rows above the tests say what it is; with that put in, two columns of the
matrix ``B_low - Z B_top`` are full, and Z, of `tables`, depends on order and class alone.

The room of a phase is one matrix.  Behind its band, and two full columns, right sides and
solutions stand in columns: the value; the derivatives by duration, angle of the forcing,
constant force, displacement and velocity at the begin; by the last coefficients.
"""

from typing import Any

import numpy as np

from ...generated.ck import derivative_at_end, displacement_gained, of_moment, unseen
from ..arrays import Matrix, Vector
from ..rows.joints import BESIDE, CLASS, FREE, MEMORY, C, F, G, K, M, fill_angles
from ..rows.moments import legendre_moments
from ..rows.polynomials import row, terms, tests
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

#: Columns: of these, those by force, displacement and velocity stand in two rows alone.
FULL = PAD + SIDE + 1
VALUE = FULL + 2
DURATION, ANGLE, FORCE, STATE, LAST = VALUE + 1, VALUE + 2, VALUE + 3, VALUE + 4, VALUE + 6

#: Marks of a phase, in front of its exchanges: whether there are any; whether its value is the
#: solution in all rows, or in the first two alone.
WIDE, DONE = 0, 1


def fill_places(kinds: Any, N: int, at: Any) -> None:
    """Fill in where the unknowns of each phase begin that are solved for together."""
    at[0] = 0
    for p in range(len(kinds)):
        at[p + 1] = at[p] + 2 + terms(kinds, p, N) - tests(kinds, p, N)


def extent(case: Any, N: int) -> tuple[int, int, int, int]:
    """Return how many unknowns are solved for together, and what room they need.

    It is rows and columns of the room of a phase, and how many derivatives are joined.
    """
    kinds = case[0]
    size, rows, last, high = len(case[2]) + (1 if case[4][2] != 0 else 0), BLOCK, 0, 2
    for p in range(len(kinds)):
        number = terms(kinds, p, N)
        own = number - tests(kinds, p, N)
        size += 3 + own
        rows, last = max(rows, number + kinds[p, BESIDE]), max(last, own)
        high = max(high, kinds[p, CLASS] + 1)
    return size, PAD + rows + SIDE, LAST + last, high


def workplace(case: Any, N: int, rooms: Any, marks: Any) -> Any:
    """Return where phases are solved: their rooms, their marks, and what has room here.

    It is for the moments of the forcing; for which times there are bands; and, as `joints`
    takes them, for angles of the forcing, how phases end, and the derivatives.
    """
    count, (_, length, columns, high) = len(case[0]), extent(case, N)
    return (
        rooms,
        marks,
        np.empty((count, 2, length)),
        np.full((count, 2), np.nan),
        np.zeros(count + 1),
        np.zeros((2, count, high)),
        np.zeros((2, count, high, columns - DURATION)),
    )


def solve_phases(case: Any, y: Vector, at: Any, N: int, work: Any) -> None:
    """Fill in how each phase begins and ends, from what is solved for together in `y`."""
    kinds, numbers, setting, _, cell = case[:5]
    rooms, marks, moments, times, theta, ends, _ = work
    fill_angles(case, y, at, theta)
    for p in range(len(kinds)):
        s, v = y[at[len(kinds)] + len(setting) + p], y[at[p] + 1]
        if not kinds[p, FREE]:
            ends[0, p, 0] = s * v
            continue
        room, number = rooms[p], terms(kinds, p, N)
        if times[p, 0] != s or times[p, 1] != theta[p]:
            factorise_phase(case, N, room, marks[p], p, s)
            if numbers[p, G] != 0:
                count = number + kinds[p, BESIDE] + 1
                legendre_moments(cell[1] * s, theta[p], moments[p, :, :count])
            times[p, 0], times[p, 1] = s, theta[p]
        solve_phase(case, y, at, N, room, marks[p], moments[p], p)
        ends[0, p, 0], ends[0, p, 1] = gained(room, s, v)
        if ends.shape[2] > 2:
            complete(room, marks[p], tests(kinds, p, N))
        for order in range(2, ends.shape[2]):
            end, begin = 0.0, 0.0
            for n in range(number):
                part = derivative_at_end(n, order - 2, s) * room[PAD + n, VALUE]
                end += part
                begin += part if (n + order) % 2 == 0 else -part
            ends[0, p, order], ends[1, p, order] = end, begin


def factorise_phase(case: Any, N: int, room: Matrix, marks: Any, p: int, s: float) -> None:
    """Fill in the factors of the band of a phase, and its full columns."""
    kinds, numbers, tables = case[0], case[1], case[5]
    m, c, k = numbers[p, M], numbers[p, C], numbers[p, K]
    rows, left = tests(kinds, p, N), kinds[p, BESIDE]
    for l in range(rows):
        factors, at_row = row(l, m, c, k, s), PAD + l
        room[at_row, 0], room[at_row, 1] = 0.0, 0.0
        for i in range(5):
            room[at_row, SIDE + i] = factors[2 + i]
    wide = factorise_band(room, marks, rows)
    marks[WIDE] = wide
    if left > 0:  # row R, above the tests, sees d_(R - 2) and d_(R - 1); the next d_(R - 1)
        first = row(rows, m, c, k, s)
        second = row(rows + 1, m, c, k, s)[2] if left > 1 else 0.0
        for low in range(rows):
            room[PAD + low, FULL] = tables[p, low, 0] * first[2]
            room[PAD + low, FULL + 1] = tables[p, low, 0] * first[3]
            if left > 1:
                room[PAD + low, FULL + 1] += tables[p, low, 1] * second
        solve(room, marks, wide, rows, room, FULL, VALUE)


def solve_phase(
    case: Any, y: Vector, at: Any, N: int, room: Matrix, marks: Any, moments: Matrix, p: int
) -> None:
    """Fill in the value of a phase that is free, all of it or as much as its end is seen by.

    Its band and the moments of the forcing are there.
    """
    kinds, numbers = case[0], case[1]
    number, rows, left = terms(kinds, p, N), tests(kinds, p, N), kinds[p, BESIDE]
    fill_value(case, y, at, N, room, moments, p)
    for i in range(number - rows):
        room[PAD + rows + i, VALUE] = y[at[p] + 2 + i]
    if numbers[p, G] != 0 or number > rows or left > 0 or marks[WIDE]:
        eliminate(room, marks, rows, room, VALUE, DURATION)
    solve_block(room, room, VALUE, DURATION)
    marks[DONE] = False
    if left > 0:
        complete(room, marks, rows)
        add_full(room, FULL, rows, room, VALUE, DURATION, rows)


def complete(room: Matrix, marks: Any, rows: int) -> None:
    """Solve for all rows of the value."""
    if not marks[DONE]:
        substitute(room, marks[WIDE], room, 0, rows, VALUE, DURATION)
        marks[DONE] = True


def gained(room: Matrix, s: float, v: float) -> tuple[float, float]:
    """Return what displacement and velocity gain in a phase that is free."""
    by, d0 = displacement_gained(s), room[PAD, VALUE]
    return by[0] * v + by[1] * d0 + by[2] * room[PAD + 1, VALUE], s * d0


def fill_value(
    case: Any, y: Vector, at: Any, N: int, room: Matrix, moments: Matrix, p: int
) -> None:
    """Fill in the right side of a phase, in the column of its value."""
    kinds, numbers, setting = case[:3]
    m, c, k, f, g = numbers[p, M], numbers[p, C], numbers[p, K], numbers[p, F], numbers[p, G]
    number, rows, left = terms(kinds, p, N), tests(kinds, p, N), kinds[p, BESIDE]
    at_w = at[len(kinds)]
    s = y[at_w + len(setting) + p]
    for i in range(len(setting)):
        f += numbers[p, MEMORY + i] * y[at_w + i]
    for l in range(rows + left):
        value = of_moment(l, g * moments[0, l]) if g != 0 else 0.0
        if l < 2 or (l >= rows - 2 and number > rows):
            factors = row(l, m, c, k, s)
            value -= factors[0] * y[at[p]] + factors[1] * y[at[p] + 1]
            for i in range(max(0, rows + 2 - l), min(5, number + 2 - l)):
                value -= factors[2 + i] * y[at[p] + l + i - rows]
        room[PAD + l, VALUE] = value
    room[PAD, VALUE] += f
    take_unseen(case, N, p, room, VALUE, DURATION)


def take_unseen(case: Any, N: int, p: int, B: Matrix, first: int, last: int) -> None:
    """Subtract from right sides what rows above the tests say of the part that no test sees."""
    kinds, tables = case[0], case[5]
    rows = tests(kinds, p, N)
    for i in range(kinds[p, BESIDE]):
        for low in range(rows):
            for column in range(first, last):
                B[PAD + low, column] -= tables[p, low, i] * B[PAD + rows + i, column]


def unpack(
    case: Any, y: Vector, at: Any, N: int, rooms: Any, marks: Any, moments: Any, z: Vector
) -> None:
    """Fill in all unknowns of the whole system, where the phases were solved last."""
    kinds, numbers, setting = case[:3]
    place, at_s = 0, at[len(kinds)] + len(setting)
    for p in range(len(kinds)):
        number, rows, room = terms(kinds, p, N), tests(kinds, p, N), rooms[p]
        z[place], z[place + 1] = y[at[p]], y[at[p] + 1]
        if number > 0:
            complete(room, marks[p], rows)
        for i in range(number):
            z[place + 2 + i] = room[PAD + i, VALUE]
        place += 2 + number
        m, c, k, s = numbers[p, M], numbers[p, C], numbers[p, K], y[at_s + p]
        left = kinds[p, BESIDE]
        if left > 0:
            # the rows above the tests, not overwritten
            fill_value(case, y, at, N, room, moments[p], p)
        for i in range(left - 1, -1, -1):  # the highest first
            l = rows + i
            factors = row(l, m, c, k, s)
            value = -room[PAD + l, VALUE]
            for j in range(min(5, rows + 2 - l)):
                value += factors[2 + j] * z[place - number + l + j - 2]
            for j in range(i + 1, left):
                value -= m * unseen(rows + j, l, kinds[p, CLASS]) * z[place + j]
            z[place + i] = value / (m * unseen(l, l, kinds[p, CLASS]))
        place += left
    for i in range(len(z) - place):
        z[place + i] = y[at[len(kinds)] + i]
