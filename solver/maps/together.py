"""Newton's method on what joins the phases: states, memory and times only.

Given these, each phase is solved for by itself, by its expansion.  What joins the phases is a
system of as many equations, whatever the order, which `iteration.iterate_within` solves.

What single conditions give is filled in before, exactly.  Where nothing forces and a phase
begins in a state that is known then, durations are single unknowns: `one_by_one`.
"""

from math import pi
from typing import Any

import numpy as np

from ...generated.ck import (
    AFTER,
    AT_BEGIN,
    AT_END,
    E_0,
    E_COS,
    E_V,
    E_X,
    FREE,
    JUMP,
    MEMORY,
    OF_V,
    OF_X,
    RHO,
    highest,
    joint_rates,
    joints,
    order_of,
    residual,
)
from ..arrays import Matrix, Vector
from ..iteration.iteration import SINGULAR, iterate_within
from ..iteration.linear import least_squares
from ..iteration.single import POINTS, ROOM, iterate_single
from .series import (
    phase_rate,
    phase_rates,
    places_kept,
    solve_phase,
    solve_phases,
    unpack,
    workplace,
)

#: In the place of `iteration.FAST`: here a new Jacobian costs little more than a residual.
FAST = 0.001

#: In the place of `iteration.AGAIN`: what is returned is evaluated here.
AGAIN = np.inf


def times_of(place: Any) -> tuple[int, int]:
    """Return how many durations are unknown, and 1 if the phase of the forcing is, else 0."""
    case, known = place[0], place[6]
    forced = 1 if case[4][2] != 0 else 0
    durations, last = 0, len(known) - forced
    for i in range(last - len(case[0]), last):
        durations += 0 if known[i] else 1
    return durations, forced


def is_alone(case: Any, p: int, state: int) -> bool:
    """Whether the event that ends a phase says displacement (0) or velocity (1) alone."""
    numbers, more = case[1], len(case[2])
    for i in range(more):
        if numbers[p, MEMORY + more + i] != 0:
            return False
    others = numbers[p, E_X + 1 - state] != 0 or numbers[p, E_COS] != 0
    return bool(numbers[p, E_X + state] != 0 and not others)


def given_alone(case: Any, y: Vector, at: Any, known: Any, used: Any) -> None:
    """Fill in the unknowns that conditions give one by one, and mark both.

    They are states that an event gives, velocities that a held phase keeps or a jump does
    not depend on, and the only duration of a cell that the forcing makes so long.
    """
    kinds, numbers, _, _, cell = case[:5]
    count, events = len(kinds), 0
    for q in range(count):
        events += 1 + highest(kinds, q)
    for p in range(count):
        q = p + 1 if p + 1 < count else 0
        for state in range(2):
            of = kinds[p, OF_X + state]
            if of == AT_END or not is_alone(case, p, state):
                continue
            i, sign = (at[p] + state, 1.0) if of == AT_BEGIN else (at[q] + state, 1.0)
            if of == AFTER and q == 0:
                sign = cell[0]
            if known[i]:  # what a second condition says of it is left to Newton's method
                continue
            y[i] = -sign * numbers[p, E_0] / numbers[p, E_X + state]
            known[i], used[events + p] = True, True
    for _ in range(count):
        row = 0
        for q in range(count):
            p, sign = (q - 1, 1.0) if q > 0 else (count - 1, cell[0])
            kept = numbers[p, RHO] == 0 or (not kinds[p, FREE] and known[at[p] + 1])
            if kept and not known[at[q] + 1] and not used[row + 1]:
                law = numbers[p, RHO] * y[at[p] + 1] + numbers[p, JUMP]
                y[at[q] + 1] = sign * law
                known[at[q] + 1], used[row + 1] = True, True
            row += 1 + highest(kinds, q)
    if count == 1 and cell[2] != 0:
        i = len(y) - 2
        y[i] = cell[2] * pi / cell[1]
        known[i], used[len(y) - 1] = True, True


def given_last(case: Any, y: Vector, at: Any, known: Any, used: Any) -> None:
    """Fill in durations that one condition alone sees, where the next phase begins; mark both.

    They are those of held phases where nothing forces, whose event is not of their end.
    """
    kinds, _, setting, _, cell = case[:5]
    count, row = len(kinds), 0
    for q in range(count if cell[2] == 0 else 0):
        p, sign = (q - 1, 1.0) if q > 0 else (count - 1, cell[0])
        of_end = kinds[p, OF_X] == AT_END or kinds[p, OF_V] == AT_END
        if not (kinds[p, FREE] or of_end) and known[at[p] + 1] and y[at[p] + 1] != 0:
            i = at[count] + len(setting) + p
            y[i] = (sign * y[at[q]] - y[at[p]]) / y[at[p] + 1]
            known[i], used[row] = True, True
        row += 1 + highest(kinds, q)


def together_residual(place: Any, y: Vector, R: Vector) -> None:
    """Fill R with what joins the phases, at what is not known of their unknowns."""
    case, at, N, work, whole, left, known, used = place
    j = 0
    for i in range(len(whole)):
        if not known[i]:
            whole[i] = y[j]
            j += 1
    solve_phases(case, whole, at, N, work)
    joints(case, whole, at, work[-3], work[-2][0], work[-2][1], left[0], 0)
    j = 0
    for i in range(len(whole)):
        if not used[i]:
            R[j] = left[0, i]
            j += 1


def together_jacobian(place: Any, y: Vector, J: Matrix) -> None:
    """Fill J with the derivatives, where the residual was evaluated last."""
    case, at, N, work, whole, left, known, used = place
    phase_rates(case, whole, at, N, work)
    left[:] = 0.0
    joint_rates(case, whole, at, work[-3], work[-1][0], work[-1][1], left, 0)
    row = 0
    for i in range(len(whole)):
        if used[i]:
            continue
        column = 0
        for j in range(len(whole)):
            if not known[j]:
                J[row, column] = left[i, j]
                column += 1
        row += 1


def fitted(place: Any, y: Vector, times: int, R: Vector, J: Matrix) -> None:
    """Fill in the states and memory that fit the times in `y` best: least squares.

    What joins the phases is linear in them, and there are more equations; each is scaled to a
    largest coefficient of 1, those of the times included: one that hardly answers to a state
    says little of it.
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


def known_begin(case: Any, at: Any, known: Any) -> int:
    """Return a phase that begins in a known state where nothing forces; -1 if there is none."""
    kinds, _, setting, _, cell = case[:5]
    if cell[2] != 0 or len(setting) > 0:
        return -1
    found = -1
    for p in range(len(kinds)):
        if kinds[p, OF_X] == AT_BEGIN:
            return -1
        if found < 0 and known[at[p]] and known[at[p] + 1]:
            found = p
    return found


def event_residual(place: Any, s: Vector, R: Vector) -> None:
    """Fill R with the event that ends a phase of duration ``s[0]``."""
    case, at, N, work, y, p, begin = place
    numbers, ends = case[1], work[-2]
    y[at[len(case[0])] + p] = s[0]
    solve_phase(case, y, at, N, work, p, 0.0)
    R[0] = begin + (numbers[p, E_X] * ends[0, p, 0] + numbers[p, E_V] * ends[0, p, 1])


def event_rate(place: Any, s: Vector, J: Matrix) -> None:
    """Fill J with its derivative, where the residual was evaluated last."""
    case, at, N, work, y, p, _ = place
    numbers, by = case[1], work[-1]
    phase_rate(case, y, at, N, work, p, 2)
    J[0, 0] = numbers[p, E_X] * by[0, p, 0, 0] + numbers[p, E_V] * by[0, p, 1, 0]


def one_by_one(
    case: Any, y: Vector, at: Any, N: int, work: Any, first: int, limit: int, room: Matrix
) -> tuple[int, int, float]:
    """Solve for the durations one after the other, from a phase whose begin is known.

    The event that ends the last of them is the one that gives where the first begins: what is
    gained on the way, `total`, is to be zero, or to bring the mass to the other side.  The room
    is that of `iterate_single`, and a row more.
    """
    kinds, numbers, cell = case[0], case[1], case[4]
    count, ends = len(kinds), work[-2]
    s, at_s = room[ROOM, :1], at[count]
    iterations, correction, total, turned = 0, 0.0, 0.0, 1.0
    for i in range(count):
        p = (first + i) % count
        s[0] = y[at_s + p]
        begin = numbers[p, E_X] * y[at[p]] + numbers[p, E_V] * y[at[p] + 1] + numbers[p, E_0]
        if i == count - 1:
            begin = numbers[p, E_X] * turned * (total + (1.0 - cell[0]) * y[at[first]])
        place = (case, at, N, work, y, p, begin)
        if kinds[p, FREE]:
            status, steps, last, _ = iterate_single(place, s, limit, room[:ROOM])
        else:  # what a held phase gains is its speed times its duration
            slope = numbers[p, E_X] * y[at[p] + 1]
            if slope == 0:
                return SINGULAR, iterations, correction
            status, steps, last = 0, 0, 0.0
            s[0] = -begin / slope
            event_residual(place, s, room[0])
        iterations, correction = max(iterations, steps), max(correction, last)
        if status != 0:
            return status, iterations, correction
        if i < count - 1:
            q = (p + 1) % count
            sign = cell[0] if q == 0 else 1.0
            total += turned * ends[0, p, 0]
            turned *= sign
            law = numbers[p, RHO] * y[at[p] + 1] + numbers[p, JUMP]
            y[at[q]] = sign * (y[at[p]] + ends[0, p, 0])
            y[at[q] + 1] = sign * (law + numbers[p, RHO] * ends[0, p, 1])
            for state in range(2):
                of = kinds[p, OF_X + state]
                if of == AFTER and is_alone(case, p, state):  # exactly as the event says
                    y[at[q] + state] = -sign * numbers[p, E_0] / numbers[p, E_X + state]
    return 0, iterations, correction


def all_at_once(
    case: Any, at: Any, N: int, work: Any, whole: Vector, left: Matrix, known: Any, used: Any,
    limit: int, J: Matrix, rows: Any, vectors: Matrix,
) -> tuple[int, int, float]:  # fmt: skip
    """Solve for what is not known, from the times in `whole`; the room is Newton's method's."""
    place = (case, at, N, work, whole, left, known, used)
    durations, forced = times_of(place)
    y, j = vectors[5], 0
    for i in range(len(whole)):
        if not known[i]:
            y[j] = whole[i]
            j += 1
    fitted(place, y, durations + forced, vectors[0], J)
    status, iterations, correction, _ = iterate_within(place, y, limit, J, rows, vectors)
    together_residual(place, y, vectors[0])
    given_last(case, whole, at, known, used)
    return status, iterations, correction


def iterate_together(case: Any, z: Vector, limit: int) -> tuple[int, int, float, float]:
    """Solve ``residual(case, z) = 0`` from the times in `z`, which is overwritten.

    See `iteration.iterate_scene`; the norm returned is that of the whole residual.
    """
    kinds, _, setting, _, cell = case[:5]
    N = order_of(case, z)
    at = places_kept(kinds, N)
    work = workplace(kinds, at, N)
    times = len(kinds) + (1 if cell[2] != 0 else 0)
    size = at[len(kinds)] + len(setting) + times
    whole, left = np.zeros(size), np.zeros((size, size))
    known, used = np.zeros(size, dtype=np.bool_), np.zeros(size, dtype=np.bool_)
    for i in range(times):
        whole[size - times + i] = z[len(z) - times + i]
    given_alone(case, whole, at, known, used)
    first = known_begin(case, at, known)
    if first >= 0:
        room = np.empty((ROOM + 1, POINTS))
        status, iterations, correction = one_by_one(
            case, whole, at, N, work, first, limit, room
        )
    else:
        given_last(case, whole, at, known, used)
        n = size
        for i in range(size):
            n -= 1 if known[i] else 0
        J, rows, vectors = np.empty((n, n)), np.empty(n, dtype=np.int64), np.empty((6, n))
        status, iterations, correction = all_at_once(
            case, at, N, work, whole, left, known, used, limit, J, rows, vectors
        )
    unpack(case, whole, at, N, work, z)
    R = np.empty(len(z))
    residual(case, z, R)
    norm = 0.0
    for value in R:
        if abs(value) > norm or np.isnan(value):
            norm = abs(value)
    return status, iterations, correction, norm
