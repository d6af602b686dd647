"""The map of a phase by its expansion: coefficients from the state at its begin and times.

The rows of a phase are banded in the coefficients ``d_n`` of its acceleration.  Given the state
at its begin, memories, times and its last coefficients (one for each condition on a derivative
of order above 2), they determine the other coefficients.  If part of the residual is orthogonal
to all tests, the rows above the tests determine it.  Once it is eliminated, two columns of the
matrix ``B_low - Z B_top`` are full; Z, in `tables`, depends on order and class alone.

The workspace ("room") of a phase is one matrix.  After its band and two full columns, it has
columns of right sides and solutions: the value; its derivatives by duration, angle of the
forcing, constant force, displacement and velocity at the begin; by the last coefficients.
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

#: Columns; right sides by force, displacement and velocity have entries in two rows only.
FULL = PAD + SIDE + 1
VALUE = FULL + 2
DURATION, ANGLE, FORCE, STATE, LAST = VALUE + 1, VALUE + 2, VALUE + 3, VALUE + 4, VALUE + 6

#: Marks of a phase, in front of its pivot rows: whether rows were exchanged; whether its value
#: is solved for in all rows, or in the first two only.
WIDE, DONE = 0, 1


def fill_places(kinds: Any, N: int, at: Any) -> None:
    """Fill `at` with the index of the first condensed unknown of each phase, and after them.

    Those of a phase are its state at the begin and its last coefficients.
    """
    at[0] = 0
    for p in range(len(kinds)):
        at[p + 1] = at[p] + 2 + terms(kinds, p, N) - tests(kinds, p, N)


def extent(case: Any, N: int) -> tuple[int, int, int, int]:
    """Return the number of condensed unknowns, and the sizes of the workspace.

    These are rows and columns of the room of a phase, and the number of derivatives joined.
    """
    kinds = case[0]
    size, rows, last, high = len(case[2]) + (1 if case[4][2] != 0 else 0), BLOCK, 0, 2
    for p in range(len(kinds)):
        number = terms(kinds, p, N)
        last_p = number - tests(kinds, p, N)
        size += 3 + last_p
        rows, last = max(rows, number + kinds[p, BESIDE]), max(last, last_p)
        high = max(high, kinds[p, CLASS] + 1)
    return size, PAD + rows + SIDE, LAST + last, high


def workplace(case: Any, N: int, rooms: Any, marks: Any) -> Any:
    """Return the workspace of all phases: rooms, marks, and arrays that are made here.

    These are for moments of the forcing; for the times of the last factors; and, as `joints`
    takes them, for angles of the forcing, the ends of phases, and their derivatives.
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
    """Fill in the begins and ends of all phases, from the condensed unknowns `y`."""
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
    """Fill in the factors of the band of a phase, and the solutions for its full columns."""
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
    if left > 0:  # row R, above the tests, has d_(R - 2) and d_(R - 1); the next one d_(R - 1)
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
    """Solve for the value of a free phase, in all rows or in those that its end depends on.

    Its factors and the moments of the forcing must be there.
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
    """Solve for the remaining rows of the value, if any."""
    if not marks[DONE]:
        substitute(room, marks[WIDE], room, rows, VALUE, DURATION)
        marks[DONE] = True


def gained(room: Matrix, s: float, v: float) -> tuple[float, float]:
    """Return the changes of displacement and velocity over a free phase."""
    by, d0 = displacement_gained(s), room[PAD, VALUE]
    return by[0] * v + by[1] * d0 + by[2] * room[PAD + 1, VALUE], s * d0


def fill_value(
    case: Any, y: Vector, at: Any, N: int, room: Matrix, moments: Matrix, p: int
) -> None:
    """Fill the column of the value with the right side of a phase."""
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
    """Eliminate the part of the residual that is orthogonal to all tests from right sides."""
    kinds, tables = case[0], case[5]
    rows = tests(kinds, p, N)
    for i in range(kinds[p, BESIDE]):
        for low in range(rows):
            for column in range(first, last):
                B[PAD + low, column] -= tables[p, low, i] * B[PAD + rows + i, column]


def unpack(
    case: Any, y: Vector, at: Any, N: int, rooms: Any, marks: Any, moments: Any, z: Vector
) -> None:
    """Fill z with all unknowns of the expansion, from the last solution of the phases."""
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
