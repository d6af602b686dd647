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
)
from ..arrays import Matrix, Vector
from ..iteration.iteration import SINGULAR, iterate_within
from ..iteration.linear import least_squares
from ..iteration.single import POINTS, iterate_single
from .band import BLOCK
from .series import (
    DURATION,
    extent,
    factorise_phase,
    fill_places,
    gained,
    gained_by_duration,
    phase_rate,
    phase_rates,
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
    case, whole, known = place[0], place[4], place[6]
    forced = 1 if case[4][2] != 0 else 0
    durations, last = 0, len(whole) - forced
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
    theta, ends = work[-3:-1]
    solve_phases(case, whole, at, N, work)
    joints(case, whole, at, theta, ends[0], ends[1], left[0], 0)
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


def event_residual(place: Any, s: float) -> float:
    """Return the event that ends a phase of duration `s`, where nothing forces."""
    case, at, N, room, marks, y, p, begin = place
    numbers = case[1]
    y[at[len(case[0])] + p] = s
    factorise_phase(case, N, room, marks, p, s)
    solve_phase(case, y, at, N, room, marks, room, p)
    x, v = gained(room, s, y[at[p] + 1])
    found: float = begin + (numbers[p, E_X] * x + numbers[p, E_V] * v)
    return found


def event_rate(place: Any, s: float) -> float:
    """Return its derivative, where the residual was evaluated last."""
    case, at, N, room, marks, y, p, _ = place
    numbers = case[1]
    phase_rate(case, y, at, N, room, marks, room, p, BLOCK, DURATION + 1)
    x, v = gained_by_duration(room, s, y[at[p] + 1])
    found: float = numbers[p, E_X] * x + numbers[p, E_V] * v
    return found


def one_by_one(
    case: Any, z: Vector, N: int, limit: int, rooms: Any, lines: Matrix, marks: Any, first: int
) -> tuple[int, int, float, float]:
    """Solve for the durations one after the other, from a phase whose begin is known.

    The event that ends the last of them is the one that gives where the first begins: what is
    gained on the way, `total`, is to be zero, or to bring the mass to the other side.
    """
    kinds, numbers, cell, y = case[0], case[1], case[4], lines[0]
    count, at = len(kinds), marks[len(kinds)]
    at_s, status, iterations, correction, norm = at[count], 0, 0, 0.0, 0.0
    total, turned = 0.0, 1.0
    for i in range(count):
        p = (first + i) % count
        x, v = y[at[p]], y[at[p] + 1]
        begin = numbers[p, E_X] * x + numbers[p, E_V] * v + numbers[p, E_0]
        if i == count - 1:
            begin = numbers[p, E_X] * turned * (total + (1.0 - cell[0]) * y[at[first]])
        if kinds[p, FREE]:
            place = (case, at, N, rooms[p], marks[p], y, p, begin)
            status, steps, last, event, s = iterate_single(
                place, y[at_s + p], limit, lines[1], lines[2]
            )
            iterations, correction = max(iterations, steps), max(correction, last)
            norm, (further, faster) = max(norm, event), gained(rooms[p], s, v)
        else:  # what a held phase gains is its speed times its duration
            slope = numbers[p, E_X] * v
            status, s = (0, -begin / slope) if slope != 0 else (SINGULAR, 0.0)
            further, faster = s * v, 0.0
        y[at_s + p] = s
        if status != 0:
            break
        if i < count - 1:
            q = (p + 1) % count
            sign = cell[0] if q == 0 else 1.0
            total += turned * further
            turned *= sign
            law = numbers[p, RHO] * v + numbers[p, JUMP]
            y[at[q]] = sign * (x + further)
            y[at[q] + 1] = sign * (law + numbers[p, RHO] * faster)
            for state in range(2):
                of = kinds[p, OF_X + state]
                if of == AFTER and is_alone(case, p, state):  # exactly as the event says
                    y[at[q] + state] = -sign * numbers[p, E_0] / numbers[p, E_X + state]
    unpack(case, y, at, N, rooms, marks, rooms, z)
    return status, iterations, correction, norm


def all_at_once(
    place: Any, z: Vector, limit: int, J: Matrix, exchanged: Any, vectors: Matrix
) -> tuple[int, int, float, float]:
    """Solve for what is not known, from the times in `whole`; the room is Newton's method's."""
    case, at, N, work, whole, _, known, used = place
    durations, forced = times_of(place)
    y, j = vectors[5, : len(J)], 0
    for i in range(len(whole)):
        if not known[i]:
            y[j] = whole[i]
            j += 1
    fitted(place, y, durations + forced, vectors[0, : len(J)], J)
    found = iterate_within(place, y, limit, J, exchanged, vectors)
    together_residual(place, y, vectors[0])
    given_last(case, whole, at, known, used)
    unpack(case, whole, at, N, work[0], work[1], work[2], z)
    return found


def begin(case: Any, z: Vector, N: int, whole: Vector, marks: Any) -> tuple[int, int]:
    """Fill in places, times and what single conditions give.

    Returned are what `known_begin` does, and how many unknowns are left.

    marks : ndarray, shape (3, n)
        Where the unknowns of each phase begin; of each unknown whether it is known; of each
        condition whether it is used.
    """
    kinds, at, known, used = case[0], marks[0], marks[1], marks[2]
    fill_places(kinds, N, at)
    for i in range(len(kinds) + (1 if case[4][2] != 0 else 0)):
        whole[len(whole) - 1 - i] = z[len(z) - 1 - i]
    given_alone(case, whole, at, known, used)
    first, unknown = known_begin(case, at, known), len(whole)
    if first < 0:
        given_last(case, whole, at, known, used)
    for i in range(len(whole)):
        unknown -= 1 if known[i] else 0
    return first, unknown


def iterate_together(case: Any, z: Vector, limit: int) -> tuple[int, int, float, float]:
    """Solve ``residual(case, z) = 0`` from the times in `z`, which is overwritten.

    See `iteration.iterate_scene`; the norm returned is that of what joins the phases.
    """
    count, N = len(case[0]), order_of(case, z)
    size, length, columns, _ = extent(case, N)
    rooms, lines = np.zeros((count, length, columns)), np.zeros((9, max(size, POINTS)))
    marks = np.zeros((count + 4, max(length, size)), dtype=np.int64)
    first, n = begin(case, z, N, lines[0, :size], marks[count:])
    if first >= 0:
        return one_by_one(case, z, N, limit, rooms, lines, marks, first)
    at, known, used = marks[count], marks[count + 1], marks[count + 2]
    work, left = workplace(case, N, rooms, marks), np.zeros((size, size))
    place = (case, at, N, work, lines[0, :size], left, known, used)
    return all_at_once(place, z, limit, np.empty((n, n)), marks[count + 3], lines[1:])
