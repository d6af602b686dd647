"""All solutions of the exact equations where something forces and a cell is two phases.

The cell is as long as the forcing makes it, so one duration s says both.  At given durations
all conditions are linear in the states, in the memory and in ``C = cos phi`` and
``S = sin phi``, and there are as many of them: they say which C and S would be needed.  What is
left is one equation in one unknown,

    log(C(s)^2 + S(s)^2) = 0,     0 < s < duration of the cell,

whose roots are looked for on a grid of durations, finer where it comes near zero.  No guess of
a phase or duration is needed, and nothing depends on where an iteration leads.

Where an event is only touched, a phase lasts no time: the equation has a double root at an end,
and is within rounding of zero near it.  Signs tell nothing there, so that part is left out.
"""

import math
from functools import lru_cache

import numpy as np

from ..arrays import Matrix, Vector
from ..case.cell import Cell, Phase
from . import flow
from .divided import of_three, of_two

#: Durations on a grid: at least; for each half oscillation of a phase within the cell; at each
#: end, down to this part of the cell; and the most for which the equation is looked at.
EVEN, A_WAVE, AT_END, SHORTEST, MOST = 400, 24, 60, 1e-10, 20_000

#: Where a value on the grid is nearer to zero than its neighbours, by more than is left to
#: zero, there may be two roots between: the grid is made so many times as fine, that often.
FINER, TIMES = 32, 3

#: Halvings of an interval with a root.
HALVINGS = 30

#: What is rounding of the equation.
ROUNDING = 1e-11

#: Roots are at most this part of the durations on the first grid; more are rounding.
ROOTS = 1 / 8


def applies(cell: Cell) -> bool:
    """Whether a cell is two phases under a forcing."""
    return cell.forced and len(cell.phases) == 2


@lru_cache(maxsize=16)
def solutions(cell: Cell) -> tuple[tuple[tuple[float, float], float], ...] | None:
    """Return the durations and the phase of the forcing at each solution that is found.

    They are right to a part in 1e-9 and better, without units; Newton's method does the rest.

    Returns
    -------
    tuple or None
        None where the equations are singular for any duration, a phase oscillates too fast for
        the grid, or rounding hides the roots.

    Examples
    --------
    >>> from nonsmooth.solver.case import registry
    >>> cell = registry.load("elastic-plastic")().cell
    >>> [[f"{s:.6f}" for s in durations] for durations, _ in solutions(cell)]
    [['0.898473', '2.243120']]
    """
    grid = _grid(cell)
    if grid is None:
        return None
    with np.errstate(all="ignore"):
        try:
            return _solutions(cell, grid)
        except np.linalg.LinAlgError:
            return None


def vanishing(cell: Cell) -> list[Phase]:
    """Return the phases that last no time in a limit which satisfies the equations to rounding.

    Examples
    --------
    >>> from nonsmooth.solver.case import registry
    >>> case = registry.load("dry-friction")(force=0.3).of_motion("two-stops")
    >>> [phase.name for phase in vanishing(case.cell)]
    ['slide']
    """
    ends = cell.duration * np.array([SHORTEST, 1 - SHORTEST])
    with np.errstate(all="ignore"):
        try:
            near = np.abs(_size(cell, ends)) <= ROUNDING
        except np.linalg.LinAlgError:
            return []
    return [phase for phase, satisfied in zip(cell.phases, near, strict=True) if satisfied]


def _solutions(
    cell: Cell, grid: Vector
) -> tuple[tuple[tuple[float, float], float], ...] | None:
    values = _size(cell, grid)
    told = np.flatnonzero(~(np.abs(values) <= ROUNDING))
    if not len(told):
        return None
    inner = slice(told[0], told[-1] + 1)
    grid, values = grid[inner], values[inner]
    most = ROOTS * len(grid)
    for _ in range(TIMES):
        grid, values = _finer(cell, grid, values)
    crossed = np.flatnonzero(
        np.isfinite(values[:-1] + values[1:]) & (values[:-1] * values[1:] <= 0)
    )
    if len(crossed) > most:
        return None
    left, right, sign = grid[crossed], grid[crossed + 1], np.sign(values[crossed])
    for _ in range(HALVINGS if len(left) else 0):
        middle = (left + right) / 2
        same = np.sign(_size(cell, middle)) == sign
        left, right = np.where(same, middle, left), np.where(same, right, middle)
    C, S = _forcing(cell, left) if len(left) else (left, left)
    rest = cell.duration - left
    return tuple(
        ((float(s), float(q)), math.atan2(b, a))
        for s, q, a, b in zip(left, rest, C, S, strict=True)
    )


def _grid(cell: Cell) -> Vector | None:
    """Return durations of the first phase; None if it would take too many."""
    fastest = max(0.0 if q.held else abs(flow.roots(q)[1].imag) for q in cell.phases)
    count = EVEN + A_WAVE * math.ceil(max(fastest, cell.omega) * cell.duration / math.pi)
    if count > MOST:
        return None
    ends = np.geomspace(SHORTEST, 1 / count, AT_END)
    parts = np.concatenate([ends, np.linspace(0, 1, count + 1)[1:-1], 1 - ends])
    return np.asarray(cell.duration * np.unique(parts))


def _finer(cell: Cell, grid: Vector, values: Vector) -> tuple[Vector, Vector]:
    """Return a grid, and values, with more of both where it may have missed two roots."""
    size = np.abs(values)
    least = (size[1:-1] <= size[:-2]) & (size[1:-1] <= size[2:])
    change = np.maximum(size[:-2], size[2:]) - size[1:-1]
    places = np.flatnonzero(least & (size[1:-1] < change)) + 1
    if not len(places):
        return grid, values
    parts = np.arange(1, FINER) / FINER
    low = np.concatenate([grid[places - 1], grid[places]])
    high = np.concatenate([grid[places], grid[places + 1]])
    more = (low[:, None] + (high - low)[:, None] * parts).ravel()
    grid, values = np.concatenate([grid, more]), np.concatenate([values, _size(cell, more)])
    grid, first = np.unique(grid, return_index=True)
    return grid, values[first]


def _size(cell: Cell, durations: Vector) -> Vector:
    """Return ``log(C^2 + S^2)`` at durations of the first phase."""
    C, S = _forcing(cell, durations)
    return np.asarray(np.log(C * C + S * S))


def _forcing(cell: Cell, durations: Vector) -> tuple[Vector, Vector]:
    """Return the C and S that the conditions need at durations of the first phase."""
    A, b = _rows(cell, durations)
    sizes = np.abs(A).max(axis=2)
    sizes[sizes == 0] = 1.0
    found = np.linalg.solve(A / sizes[:, :, None], (b / sizes)[:, :, None])[:, :, 0]
    return found[:, -2], found[:, -1]


def _rows(cell: Cell, durations: Vector) -> tuple[Matrix, Matrix]:
    """Return A and b of the conditions at each duration.

    Unknowns: two states, the memory, C and S.  Rows: two of continuity and the event of each
    phase, and what the memory is set to.
    """
    more = len(cell.memory)
    count = 6 + more
    A, b = np.zeros((len(durations), count, count)), np.zeros((len(durations), count))
    lasts = (durations, cell.duration - durations)
    starts = (np.zeros_like(durations), durations)
    for p, phase in enumerate(cell.phases):
        s, own, after = lasts[p], slice(2 * p, 2 * p + 2), 1 - p
        moved, constant, unit, cosine, sine = _end(phase, cell.omega, starts[p], s)
        ends = np.zeros((len(s), 2, count))  # the state at the end, by the unknowns
        ends[:, :, own], ends[:, :, -2], ends[:, :, -1] = moved, cosine, sine
        for i, factor in enumerate(phase.memory):
            ends[:, :, 4 + i] = factor * unit
        law = (cell.sign if after == 0 else 1) * np.array([1.0, phase.rho])
        rows = slice(3 * p, 3 * p + 2)
        A[:, rows] = -law[:, None] * ends
        A[:, rows, 2 * after : 2 * after + 2] += np.eye(2)
        jump = (cell.sign if after == 0 else 1) * phase.d
        b[:, rows] = law * constant + np.array([0.0, jump])
        ex, ev, ec, e0, *factors = phase.event
        angle = cell.omega * (starts[p] + s)
        row = 3 * p + 2
        A[:, row] = ex * ends[:, 0] + ev * ends[:, 1]
        A[:, row, -2] += ec * np.cos(angle)
        A[:, row, -1] -= ec * np.sin(angle)
        A[:, row, 4 : 4 + more] += np.array(factors)
        b[:, row] = -(ex * constant[:, 0] + ev * constant[:, 1] + e0)
    for i, memory in enumerate(cell.memory):
        vx, vv, vc, v0 = memory.value
        angle = cell.omega * starts[memory.phase]
        A[:, 6 + i, 4 + i] = 1.0
        A[:, 6 + i, 2 * memory.phase], A[:, 6 + i, 2 * memory.phase + 1] = -vx, -vv
        A[:, 6 + i, -2], A[:, 6 + i, -1] = -vc * np.cos(angle), vc * np.sin(angle)
        b[:, 6 + i] = v0
    return A, b


def _end(phase: Phase, omega: float, begin: Vector, s: Vector) -> tuple[Matrix, ...]:
    """Return the end of a phase: by its start, constant, by a unit force, by C and by S."""
    zero = np.zeros_like(s)
    if phase.held:
        one, speed = np.ones_like(s), np.full_like(s, phase.speed)
        moved = np.moveaxis(np.array([[one, zero], [zero, zero]]), 2, 0)
        constant, none = np.array([phase.speed * s, speed]).T, np.array([zero, zero]).T
        return moved, constant, none, none, none
    small, large = flow.roots(phase)
    impulse = of_two(small, large, s)
    of_x, of_v = np.exp(small * s) - small * impulse, np.exp(large * s) + small * impulse
    moved = np.array([[of_x, impulse], [-phase.k / phase.m * impulse, of_v]]).real
    unit = np.array([of_three(small, large, 0j, s), impulse]).real.T / phase.m
    wave = of_three(small, large, 1j * omega, s)
    turn = phase.g / phase.m * np.exp(1j * omega * begin)
    forced = turn * np.array([wave, 1j * omega * wave + impulse])
    return np.moveaxis(moved, 2, 0), phase.f * unit, unit, forced.real.T, -forced.imag.T
