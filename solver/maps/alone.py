"""Unknowns that a single condition determines, eliminated before Newton's method."""

from math import pi
from typing import Any

from ..arrays import Vector
from ..rows.joints import (
    AFTER,
    AT_BEGIN,
    AT_END,
    E_0,
    E_COS,
    E_X,
    FREE,
    JUMP,
    MEMORY,
    OF_V,
    OF_X,
    RHO,
    highest,
)


def is_alone(case: Any, p: int, state: int) -> bool:
    """Return whether the event of phase p is of x (state 0) or of v (state 1) alone."""
    numbers, memories = case[1], len(case[2])
    for i in range(memories):
        if numbers[p, MEMORY + memories + i] != 0:
            return False
    mixed = numbers[p, E_X + 1 - state] != 0 or numbers[p, E_COS] != 0
    return bool(numbers[p, E_X + state] != 0 and not mixed)


def given_alone(case: Any, y: Vector, at: Any, is_known: Any, is_used: Any) -> None:
    """Fill in unknowns that single conditions determine; mark them `is_known`, these `is_used`.

    They are states that an event prescribes, velocities after a held phase or after a jump that
    does not depend on the velocity before, and the duration of a single forced phase.
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
            if is_known[i]:  # a second condition on it is left to Newton's method
                continue
            y[i] = -sign * numbers[p, E_0] / numbers[p, E_X + state]
            is_known[i], is_used[events + p] = True, True
    for _ in range(count):
        row = 0
        for q in range(count):
            p, sign = (q - 1, 1.0) if q > 0 else (count - 1, cell[0])
            determined = numbers[p, RHO] == 0 or (not kinds[p, FREE] and is_known[at[p] + 1])
            if determined and not is_known[at[q] + 1] and not is_used[row + 1]:
                law = numbers[p, RHO] * y[at[p] + 1] + numbers[p, JUMP]
                y[at[q] + 1] = sign * law
                is_known[at[q] + 1], is_used[row + 1] = True, True
            row += 1 + highest(kinds, q)
    if count == 1 and cell[2] != 0:
        i = len(y) - 2
        y[i] = cell[2] * pi / cell[1]
        is_known[i], is_used[len(y) - 1] = True, True


def given_last(case: Any, y: Vector, at: Any, is_known: Any, is_used: Any) -> None:
    """Fill in durations that only the continuity of the displacement contains; mark both.

    They are those of held phases without forcing whose event does not depend on their end.
    """
    kinds, _, setting, _, cell = case[:5]
    count, row = len(kinds), 0
    for q in range(count if cell[2] == 0 else 0):
        p, sign = (q - 1, 1.0) if q > 0 else (count - 1, cell[0])
        of_end = kinds[p, OF_X] == AT_END or kinds[p, OF_V] == AT_END
        if not (kinds[p, FREE] or of_end) and is_known[at[p] + 1] and y[at[p] + 1] != 0:
            i = at[count] + len(setting) + p
            y[i] = (sign * y[at[q]] - y[at[p]]) / y[at[p] + 1]
            is_known[i], is_used[row] = True, True
        row += 1 + highest(kinds, q)
