"""The derivatives of the map of a phase, in the columns of its room after the value.

They are taken at the last call of `series.solve_phases`, by duration, angle of the forcing,
constant force, displacement and velocity at the begin, and the last coefficients.
"""

from typing import Any

from ...generated.ck import (
    derivative_at_end,
    derivative_at_end_by_s,
    displacement_gained,
    displacement_gained_by_s,
    moment_by_kappa,
    of_moment,
)
from ..arrays import Matrix, Vector
from ..rows.joints import BESIDE, CLASS, FREE, C, G, K, M
from ..rows.polynomials import row, row_by_s, terms, tests
from .band import BLOCK, PAD, add_full, eliminate, solve_block, substitute
from .series import (
    ANGLE,
    DURATION,
    FORCE,
    FULL,
    LAST,
    STATE,
    VALUE,
    WIDE,
    complete,
    take_unseen,
)


def phase_rates(case: Any, y: Vector, at: Any, N: int, work: Any) -> None:
    """Fill in the derivatives of the results of `solve_phases`, at its last call."""
    kinds, setting = case[0], case[2]
    rooms, marks, moments, _, _, ends, by = work
    by[:] = 0.0
    for p in range(len(kinds)):
        s, v = y[at[len(kinds)] + len(setting) + p], y[at[p] + 1]
        if not kinds[p, FREE]:
            by[0, p, 0, STATE + 1 - DURATION], by[0, p, 0, 0] = s, v
            continue
        after = p + 1 if p + 1 < len(kinds) else 0
        smooth = kinds[p, CLASS] > 1 or kinds[after, CLASS] > 1
        room, number, rows = rooms[p], terms(kinds, p, N), tests(kinds, p, N)
        last, needed = LAST + number - rows, rows if smooth else BLOCK
        phase_rate(case, y, at, N, room, marks[p], moments[p], p, needed, last)
        of_v, of_d0, of_d1 = displacement_gained(s)
        by[0, p, 0, 0], by[0, p, 1, 0] = gained_by_duration(room, s, v)
        for column in range(ANGLE, last):
            i = column - DURATION
            by[0, p, 0, i] = of_d0 * room[PAD, column] + of_d1 * room[PAD + 1, column]
            by[0, p, 1, i] = s * room[PAD, column]
        by[0, p, 0, STATE + 1 - DURATION] += of_v
        for order in range(2, ends.shape[2] if smooth else 2):
            for n in range(number):
                weight = derivative_at_end(n, order - 2, s)
                sign = 1.0 if (n + order) % 2 == 0 else -1.0
                rate = derivative_at_end_by_s(n, order - 2, s) * room[PAD + n, VALUE]
                by[0, p, order, 0] += rate
                by[1, p, order, 0] += sign * rate
                for column in range(DURATION, last):
                    if n < rows:
                        part = weight * room[PAD + n, column]
                    else:
                        part = weight if column == LAST + n - rows else 0.0
                    by[0, p, order, column - DURATION] += part
                    by[1, p, order, column - DURATION] += sign * part


def gained_by_duration(room: Matrix, s: float, v: float) -> tuple[float, float]:
    """Return the derivatives of `gained` by the duration."""
    by, by_s = displacement_gained(s), displacement_gained_by_s(s)
    d0, d0_by_s = room[PAD, VALUE], room[PAD, DURATION]
    d1, d1_by_s = room[PAD + 1, VALUE], room[PAD + 1, DURATION]
    x_by_s = by_s[0] * v + by_s[1] * d0 + by_s[2] * d1 + by[1] * d0_by_s + by[2] * d1_by_s
    return x_by_s, d0 + s * d0_by_s


def phase_rate(
    case: Any, y: Vector, at: Any, N: int, room: Matrix, marks: Any, moments: Matrix,
    p: int, needed: int, last: int,
) -> None:  # fmt: skip
    """Solve for the derivatives of a phase's value: `needed` rows, columns before `last`."""
    kinds, numbers = case[0], case[1]
    rows, full, wide = tests(kinds, p, N), kinds[p, BESIDE] > 0, marks[WIDE]
    complete(room, marks, rows)
    fill_columns(case, y, at, N, room, moments, p, last)
    if wide:
        eliminate(room, marks, rows, room, DURATION, last)
    else:
        forced = FORCE if numbers[p, G] != 0 else ANGLE
        eliminate(room, marks, rows, room, DURATION, min(last, forced))
        eliminate(room, marks, rows, room, LAST, last)
    solve_block(room, room, DURATION, last)
    substitute(room, wide, room, rows if full else needed, DURATION, last)
    if full:
        add_full(room, FULL, rows, room, DURATION, last, needed)


def fill_columns(
    case: Any, y: Vector, at: Any, N: int, room: Matrix, moments: Matrix, p: int, last: int
) -> None:
    """Fill in right sides for the derivatives of the value.

    Those of the phase's right side, less the derivative of the band times the value.
    """
    kinds, numbers, setting, _, cell = case[:5]
    m, c, k, g = numbers[p, M], numbers[p, C], numbers[p, K], numbers[p, G]
    number, rows, left = terms(kinds, p, N), tests(kinds, p, N), kinds[p, BESIDE]
    s, v = y[at[len(kinds)] + len(setting) + p], y[at[p] + 1]
    for l in range(rows + left):
        changes, at_row = row_by_s(l, m, c, k, s), PAD + l
        slope = -changes[1] * v
        for i in range(max(0, 2 - l), min(5, number + 2 - l)):
            slope -= changes[2 + i] * room[at_row + i - 2, VALUE]
        for column in range(ANGLE, last):
            room[at_row, column] = 0.0
        if (l < 2 or l >= rows - 2) and last > STATE:
            factors = row(l, m, c, k, s)
            room[at_row, STATE], room[at_row, STATE + 1] = -factors[0], -factors[1]
            for i in range(max(0, rows + 2 - l), min(5, number + 2 - l)):
                room[at_row, LAST + l + i - 2 - rows] -= factors[2 + i]
        if g != 0:
            below, middle, above = moment_by_kappa(l)
            change = middle * moments[1, l] + above * moments[1, l + 1]
            change += below * moments[1, l - 1] if l > 0 else 0.0
            slope += of_moment(l, g * cell[1] * change)
            room[at_row, ANGLE] = of_moment(l, g * moments[1, l])
        room[at_row, DURATION] = slope
    if last > FORCE:
        room[PAD, FORCE] = 1.0
    take_unseen(case, N, p, room, DURATION, last)
