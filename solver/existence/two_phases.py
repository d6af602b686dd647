"""All solutions of the exact equations of a forced cell of two phases.

The forcing fixes the duration of the cell, so the unknown duration s of the first phase gives
that of the second.  At given s the conditions are a square linear system for the states, the
memory, ``C = cos phi`` and ``S = sin phi``.  By Cramer's rule ``C = P/D`` and ``S = Q/D`` with
three determinants, smooth functions of s.  There remains one equation,

    D(s)^2 = P(s)^2 + Q(s)^2,     0 < s < duration of the cell.

Its roots need no starting values.  If all conditions are homogeneous but for the forcing, P
and Q vanish: the roots are those of D, and C and S are from the null vector of the system.

All roots are found if every phase lasts longer than `SHORTEST` of the cell, the determinants
are resolved by their interpolants, and any two roots of the same sign of D are further apart
than rounding errors; see `enclosure`.  These hypotheses are checked.
"""

import math
from dataclasses import dataclass
from functools import partial

import numpy as np

from ..arrays import Matrix, Vector
from ..flow import flow
from ..flow.divided import of_three_at, of_two_at
from ..scenes.cell import Cell, Phase
from . import enclosure

#: Shortest duration of a phase that is examined, relative to the cell; ratio of the lengths of
#: neighbouring pieces near an end.
SHORTEST, LONGER = 1e-10, 3.0

#: Most doubtful intervals from which Newton's method is tried; bisections of each.
DOUBTFUL, HALVINGS = 6, 40

#: Relative rounding error of the equation; absolute one of determinants that vanish.
ROUNDING, NOTHING = 1e-11, 1e-14


@dataclass(frozen=True)
class Solutions:
    """The durations and the phase of the forcing of each solution, without units.

    The `certain` ones have relative errors below 1e-9, and start Newton's method.  Near the
    `doubtful` times there may be a solution or none.  `complete`: there are no others.
    """

    certain: tuple[tuple[tuple[float, float], float], ...]
    doubtful: tuple[tuple[tuple[float, float], float], ...]
    complete: bool


def applies(cell: Cell) -> bool:
    """Whether a cell has two phases and a forcing."""
    return cell.forced and len(cell.phases) == 2


def solutions(cell: Cell) -> Solutions:
    """Return all solutions of the equations of a cell; see `applies`.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> cell = registry.load("elastic-plastic")().cell
    >>> all_of = solutions(cell)
    >>> [[f"{s:.6f}" for s in durations] for durations, _ in all_of.certain], all_of.complete
    ([['0.898473', '2.243120']], True)
    """
    with np.errstate(all="ignore"):
        try:
            roots = enclosure.roots(partial(_determinants, cell), cell.duration * _edges())
            complete = roots.complete and not _shorter(cell).any()
            likely = _starts(cell, roots.places, roots.signs)
            few = _most_likely(cell, roots.doubtful)[:DOUBTFUL]
            pairs = np.repeat(few, 2), np.tile([1.0, -1.0], len(few))
            doubtful = _starts(cell, *pairs)
        except (np.linalg.LinAlgError, FloatingPointError):
            return Solutions((), (), complete=False)
        return Solutions(likely, doubtful, complete)


def _most_likely(cell: Cell, intervals: Matrix) -> Vector:
    """Return one place in each interval: where ``|D| - R`` changes its sign, else the middle.

    The former come first, each group ordered by descending length of the phases.
    """

    def excess(s: Vector) -> Vector:
        D, P, Q = _determinants(cell, s[:, None])[:, :, 0]
        return np.asarray(np.abs(D) - np.hypot(P, Q))

    if not len(intervals):
        return np.empty(0)
    low, high = intervals.T
    changes, places = (excess(low) >= 0) != (excess(high) >= 0), intervals.mean(axis=1)
    if changes.any():
        ends = low[changes], high[changes]
        places[changes] = enclosure.changes_of_sign(excess, *ends, HALVINGS)
    shortest = np.minimum(places, cell.duration - places)
    return np.asarray(places[np.lexsort((-shortest, ~changes))])


def vanishing(cell: Cell) -> list[Phase]:
    """Return the phases that last no time in a limit that satisfies the equations to rounding.

    Those that are shorter than `SHORTEST` in a solution are included.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> case = registry.load("dry-friction")(force=0.3).of_motion("two-stops")
    >>> [phase.name for phase in vanishing(case.cell)]
    ['slide']
    """
    ends = cell.duration * np.array([[SHORTEST], [1 - SHORTEST]])
    with np.errstate(all="ignore"):
        try:
            D, P, Q = _determinants(cell, ends)[:, :, 0]
            near = np.abs(np.abs(D) - np.hypot(P, Q)) <= ROUNDING * np.abs(D)
            near |= _shorter(cell)
        except FloatingPointError:
            return []
    return [phase for phase, satisfied in zip(cell.phases, near, strict=True) if satisfied]


def _shorter(cell: Cell) -> Vector:
    """Return for each phase whether it is shorter than `SHORTEST` in a solution.

    There the residual of the equation changes sign between durations 0 and `SHORTEST`.
    """
    first = cell.duration * np.array([[0, SHORTEST], [1, 1 - SHORTEST]])
    with np.errstate(all="ignore"):
        D, P, Q = _determinants(cell, first)
    excess = np.abs(D) - np.hypot(P, Q)
    return np.asarray((excess[:, 0] * excess[:, 1] < 0) & (np.abs(excess[:, 0]) > NOTHING))


def _edges() -> Vector:
    """Return the edges of pieces on [0, 1], shorter towards both ends."""
    count = math.ceil(math.log(0.5 / SHORTEST, LONGER))
    half = np.geomspace(SHORTEST, 0.5, count + 1)
    return np.concatenate([half, 1 - half[-2::-1]])


def _determinants(cell: Cell, durations: Matrix) -> Matrix:
    """Return D, P and Q at durations of the first phase; shape (3, *durations.shape).

    Those of one row of durations are scaled by a common factor to moderate size.
    """
    A, b = (
        part.reshape(*durations.shape, *part.shape[1:])
        for part in rows(cell, _of_first(cell, durations.ravel()))
    )
    sizes = np.abs(A).max(axis=(1, 3), keepdims=True)
    sizes[~(sizes > 0)] = 1.0
    A, b = A / sizes, b / sizes[..., 0]
    replaced = np.stack([A, A, A])
    replaced[1, ..., -2], replaced[2, ..., -1] = b, b
    if not np.isfinite(replaced).all():
        raise FloatingPointError("the motion of a phase is beyond float64")
    return np.asarray(np.linalg.det(replaced))


def _of_first(cell: Cell, first: Vector) -> Matrix:
    """Return the durations of both phases from those of the first."""
    return np.column_stack([first, cell.duration - first])


def _starts(
    cell: Cell, places: Vector, signs: Vector
) -> tuple[tuple[tuple[float, float], float], ...]:
    """Return durations and the phase of the forcing at places where ``D = sign R``."""
    if not len(places):
        return ()
    _, P, Q = _determinants(cell, places[:, None])[:, :, 0]
    nothing = (P == 0) & (Q == 0)
    if nothing.any():
        A, _ = rows(cell, _of_first(cell, places[nothing]))
        free = np.linalg.svd(A / np.abs(A).max(axis=2, keepdims=True))[2][:, -1]
        P[nothing], Q[nothing] = free[:, -2], free[:, -1]
    rest = cell.duration - places
    return tuple(
        ((float(s), float(q)), math.atan2(sign * b, sign * a))
        for s, q, sign, a, b in zip(places, rest, signs, P, Q, strict=True)
    )


def rows(cell: Cell, durations: Matrix) -> tuple[Matrix, Matrix]:
    """Return A and b of the conditions of a cell at durations of its phases, shape (T, P).

    Unknowns: the states, the memory, C and S.  Rows: for each phase the two of its switch and
    its event, then the values of the memory.
    """
    memories, phases = len(cell.memory), len(cell.phases)
    states, behind = 2 * phases, 3 * phases
    count, by_memory = states + memories + 2, slice(states, states + memories)
    A = np.zeros((len(durations), behind + memories, count))
    b = np.zeros(A.shape[:2])
    starts = np.cumsum(np.insert(durations, 0, 0.0, axis=1), axis=1)
    for p, phase in enumerate(cell.phases):
        after, sign = (p + 1, 1) if p + 1 < phases else (0, cell.sign)
        moved, constant, unit, cosine, sine = _end(
            phase, cell.omega, starts[:, p], durations[:, p]
        )
        ends = np.zeros((len(A), 2, count))  # the state at the end, by the unknowns
        ends[:, :, 2 * p : 2 * p + 2], ends[:, :, -2], ends[:, :, -1] = moved, cosine, sine
        for i, factor in enumerate(phase.memory):
            ends[:, :, states + i] = factor * unit
        law = sign * np.array([1.0, phase.rho])
        joint = slice(3 * p, 3 * p + 2)
        A[:, joint] = -law[:, None] * ends
        A[:, joint, 2 * after : 2 * after + 2] += np.eye(2)
        b[:, joint] = law * constant + np.array([0.0, sign * phase.d])
        ex, ev, ec, e0, *factors = phase.event
        angle, row = cell.omega * starts[:, p + 1], 3 * p + 2
        A[:, row] = ex * ends[:, 0] + ev * ends[:, 1]
        A[:, row, -2] += ec * np.cos(angle)
        A[:, row, -1] -= ec * np.sin(angle)
        A[:, row, by_memory] += np.array(factors)
        b[:, row] = -(ex * constant[:, 0] + ev * constant[:, 1] + e0)
    for i, memory in enumerate(cell.memory):
        vx, vv, vc, v0 = memory.value
        angle, row = cell.omega * starts[:, memory.phase], behind + i
        A[:, row, states + i] = 1.0
        A[:, row, 2 * memory.phase], A[:, row, 2 * memory.phase + 1] = -vx, -vv
        A[:, row, -2], A[:, row, -1] = -vc * np.cos(angle), vc * np.sin(angle)
        b[:, row] = v0
    return A, b


def _end(phase: Phase, omega: float, begin: Vector, s: Vector) -> tuple[Matrix, ...]:
    """Return the final state of a phase: by initial state, constant, by unit force, C and S."""
    zero = np.zeros_like(s)
    if phase.held:
        ones, speed = np.ones_like(s), np.full_like(s, phase.speed)
        moved = np.moveaxis(np.array([[ones, zero], [zero, zero]]), 2, 0)
        constant, none = np.array([phase.speed * s, speed]).T, np.array([zero, zero]).T
        return moved, constant, none, none, none
    small, large = flow.roots(phase)
    impulse = of_two_at(small, large, s)
    of_x, of_v = np.exp(small * s) - small * impulse, np.exp(large * s) + small * impulse
    moved = np.array([[of_x, impulse], [-phase.k / phase.m * impulse, of_v]]).real
    unit = np.array([of_three_at(small, large, 0j, s), impulse]).real.T / phase.m
    wave = of_three_at(small, large, 1j * omega, s)
    turn = phase.g / phase.m * np.exp(1j * omega * begin)
    forced = turn * np.array([wave, 1j * omega * wave + impulse])
    return np.moveaxis(moved, 2, 0), phase.f * unit, unit, forced.real.T, -forced.imag.T
