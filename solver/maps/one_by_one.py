"""Durations solved for one after the other, without forcing.

If a phase begins in a known state, the event that ends it is a function of its duration alone:
one equation with one unknown, solved by `iteration.iterate_single`.
"""

from typing import Any

from ..arrays import Matrix, Vector
from ..iteration.iteration import SINGULAR
from ..iteration.single import iterate_single
from ..rows.joints import AFTER, AT_BEGIN, E_0, E_V, E_X, FREE, JUMP, OF_X, RHO
from .alone import is_alone
from .band import BLOCK
from .series import DURATION, factorise_phase, gained, solve_phase, unpack
from .series_rates import gained_by_duration, phase_rate


def known_begin(case: Any, at: Any, is_known: Any) -> int:
    """Return the first phase that begins in a known state; -1 without one, or if not apt.

    Not apt are cells with forcing, a memory, or an event at the begin of a phase.
    """
    kinds, _, setting, _, cell = case[:5]
    if cell[2] != 0 or len(setting) > 0:
        return -1
    first = -1
    for p in range(len(kinds)):
        if kinds[p, OF_X] == AT_BEGIN:
            return -1
        if first < 0 and is_known[at[p]] and is_known[at[p] + 1]:
            first = p
    return first


def event_residual(place: Any, s: float) -> float:
    """Return the event function at the end of an unforced phase of duration `s`."""
    case, at, N, room, marks, y, p, begin = place
    numbers = case[1]
    y[at[len(case[0])] + p] = s
    factorise_phase(case, N, room, marks, p, s)
    solve_phase(case, y, at, N, room, marks, room, p)
    x, v = gained(room, s, y[at[p] + 1])
    value: float = begin + (numbers[p, E_X] * x + numbers[p, E_V] * v)
    return value


def event_rate(place: Any, s: float) -> float:
    """Return the derivative of `event_residual`, at the duration of its last call."""
    case, at, N, room, marks, y, p, _ = place
    numbers = case[1]
    phase_rate(case, y, at, N, room, marks, room, p, BLOCK, DURATION + 1)
    x, v = gained_by_duration(room, s, y[at[p] + 1])
    rate: float = numbers[p, E_X] * x + numbers[p, E_V] * v
    return rate


def one_by_one(
    case: Any, z: Vector, N: int, limit: int, rooms: Any, lines: Matrix, marks: Any, first: int
) -> tuple[int, int, float, float]:
    """Solve for the durations one after the other, from phase `first`, whose begin is known.

    The event that ends the last phase also determines where the first begins: the displacement
    gained over the cell, `total`, must be zero or lead to the mirror image.
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
        else:  # a held phase moves by its speed times its duration
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
                if of == AFTER and is_alone(case, p, state):  # exactly the value of the event
                    y[at[q] + state] = -sign * numbers[p, E_0] / numbers[p, E_X + state]
    unpack(case, y, at, N, rooms, marks, rooms, z)
    return status, iterations, correction, norm
