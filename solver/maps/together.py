"""Newton's method on the condensed system: states, memories and times only.

Given these, the coefficients of each phase follow from its linear equations.  The conditions
that join the phases are a system whose size does not depend on the order; it is solved by
`iteration.iterate_within`.

Unknowns that single conditions determine are filled in before, exactly.  If a phase then begins
in a known state, and nothing forces, durations are solved for one by one: `one_by_one`.
"""

from typing import Any

import numpy as np

from ..arrays import Matrix, Vector
from ..iteration.iteration import iterate_within
from ..iteration.linear import least_squares
from ..iteration.single import POINTS
from ..rows.joints import joint_rates, joints
from ..rows.polynomials import order_of
from .alone import given_alone, given_last
from .one_by_one import known_begin, one_by_one
from .series import extent, fill_places, solve_phases, unpack, workplace
from .series_rates import phase_rates

#: Replaces `iteration.FAST`: here a new Jacobian costs little more than a residual.
FAST = 0.001

#: Replaces `iteration.AGAIN`: the last evaluation is made here.
AGAIN = np.inf


def times_of(place: Any) -> tuple[int, int]:
    """Return the number of unknown durations, and 1 if the case is forced, else 0."""
    case, whole, is_known = place[0], place[4], place[6]
    forced = 1 if case[4][2] != 0 else 0
    durations, last = 0, len(whole) - forced
    for i in range(last - len(case[0]), last):
        durations += 0 if is_known[i] else 1
    return durations, forced


def together_residual(place: Any, y: Vector, R: Vector) -> None:
    """Fill R with the unused conditions that join the phases, at the condensed unknowns y."""
    case, at, N, work, whole, conditions, is_known, is_used = place
    j = 0
    for i in range(len(whole)):
        if not is_known[i]:
            whole[i] = y[j]
            j += 1
    theta, ends = work[-3:-1]
    solve_phases(case, whole, at, N, work)
    joints(case, whole, at, theta, ends[0], ends[1], conditions[0], 0)
    j = 0
    for i in range(len(whole)):
        if not is_used[i]:
            R[j] = conditions[0, i]
            j += 1


def together_jacobian(place: Any, y: Vector, J: Matrix) -> None:
    """Fill J with the derivatives of `together_residual`, at its last call."""
    case, at, N, work, whole, conditions, is_known, is_used = place
    phase_rates(case, whole, at, N, work)
    conditions[:] = 0.0
    joint_rates(case, whole, at, work[-3], work[-1][0], work[-1][1], conditions, 0)
    row = 0
    for i in range(len(whole)):
        if is_used[i]:
            continue
        column = 0
        for j in range(len(whole)):
            if not is_known[j]:
                J[row, column] = conditions[i, j]
                column += 1
        row += 1


def fitted(place: Any, y: Vector, times: int, R: Vector, J: Matrix) -> None:
    """Fill in the states and memories that fit the last `times` entries of y best.

    The conditions are linear in them, and there are more conditions than states: least squares.
    Each is scaled to a largest coefficient of 1, those of the times included: a condition that
    hardly depends on states has little weight.
    """
    size, unknown = len(y), len(y) - times
    for i in range(unknown):
        y[i] = 0.0
    together_residual(place, y, R)
    together_jacobian(place, y, J)
    for i in range(size):
        largest = 0.0
        for j in range(size):
            largest = max(largest, abs(J[i, j]))
        factor = 1.0 / largest if largest > 0 else 1.0
        for j in range(unknown):
            J[i, j] *= factor
        J[i, unknown] = -factor * R[i]
    least_squares(J, unknown, y)


def all_at_once(
    place: Any, z: Vector, limit: int, J: Matrix, exchanged: Any, vectors: Matrix
) -> tuple[int, int, float, float]:
    """Solve for all condensed unknowns by Newton's method, from the times in `whole`.

    `J`, `exchanged` and `vectors` are workspace.
    """
    case, at, N, work, whole, _, is_known, is_used = place
    durations, forced = times_of(place)
    y, j = vectors[5, : len(J)], 0
    for i in range(len(whole)):
        if not is_known[i]:
            y[j] = whole[i]
            j += 1
    fitted(place, y, durations + forced, vectors[0, : len(J)], J)
    outcome = iterate_within(place, y, limit, J, exchanged, vectors)
    together_residual(place, y, vectors[0])
    given_last(case, whole, at, is_known, is_used)
    unpack(case, whole, at, N, work[0], work[1], work[2], z)
    return outcome


def begin(case: Any, z: Vector, N: int, whole: Vector, marks: Any) -> tuple[int, int]:
    """Fill in indices, times and the unknowns that single conditions determine.

    Return the result of `known_begin`, and the number of remaining unknowns.

    marks : ndarray, shape (3, n)
        Index of the first unknown of each phase; whether each unknown is known; whether each
        condition is used.
    """
    kinds, at, is_known, is_used = case[0], marks[0], marks[1], marks[2]
    fill_places(kinds, N, at)
    for i in range(len(kinds) + (1 if case[4][2] != 0 else 0)):
        whole[len(whole) - 1 - i] = z[len(z) - 1 - i]
    given_alone(case, whole, at, is_known, is_used)
    first, unknown = known_begin(case, at, is_known), len(whole)
    if first < 0:
        given_last(case, whole, at, is_known, is_used)
    for i in range(len(whole)):
        unknown -= 1 if is_known[i] else 0
    return first, unknown


def iterate_together(case: Any, z: Vector, limit: int) -> tuple[int, int, float, float]:
    """Solve ``residual(case, z) = 0`` from the times in `z`, which is overwritten.

    See `iteration.iterate_scene`; the norm returned is that of the conditions between phases.
    """
    count, N = len(case[0]), order_of(case, z)
    size, length, columns, _ = extent(case, N)
    rooms, lines = np.zeros((count, length, columns)), np.zeros((9, max(size, POINTS)))
    marks = np.zeros((count + 4, max(length, size)), dtype=np.int64)
    first, n = begin(case, z, N, lines[0, :size], marks[count:])
    if first >= 0:
        return one_by_one(case, z, N, limit, rooms, lines, marks, first)
    at, is_known, is_used = marks[count], marks[count + 1], marks[count + 2]
    work, conditions = workplace(case, N, rooms, marks), np.zeros((size, size))
    place = (case, at, N, work, lines[0, :size], conditions, is_known, is_used)
    return all_at_once(place, z, limit, np.empty((n, n)), marks[count + 3], lines[1:])
