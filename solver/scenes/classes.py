"""The class C^k at each switch for the parameters of a case, which may exceed the generic one.

As in ``codegen/scene/smoothness.py``, in numbers: a derivative jumps at a switch unless its
jump is a linear combination of the forms that vanish there.
"""

import numpy as np

from ..arrays import Matrix, Vector
from ..bodies.laws import lawful
from .bodies.cell import BodyCell
from .cell import Cell, Phase

#: Highest class that is told apart: a smoother switch counts as none.
HIGHEST = 8

#: Jumps below this, relative to the two sides, are rounding.
ROUNDING = 1e-10


def classes(cell: Cell) -> tuple[int, ...]:
    """Return the k of the class C^k at the switch that begins each phase of a cell."""
    if isinstance(cell, BodyCell) and cell.classes:
        return cell.classes
    return tuple(_class(cell, p) for p in range(len(cell.phases)))


def _class(cell: Cell, p: int) -> int:
    """Return the k of the class C^k at the switch that begins phase `p`."""
    previous, sign = (p - 1) % len(cell.phases), cell.sign if p == 0 else 1
    if any(jump != (1.0, 0.0) for jump in cell.phases[previous].jumps):
        return 0
    A, rows, signals = _side(cell, previous, sign)
    A_after, rows_after, signals_after = _side(cell, p, 1)
    vanishing = [np.array(cell.phases[previous].event) @ signals]
    for phase, of in ((cell.phases[previous], signals), (cell.phases[p], signals_after)):
        if phase.held:
            vanishing.append(of[1] - phase.speed * of[3])
    position = cell.place(previous)
    if position is not None:
        vanishing.append(signals[0] - position * signals[3])
    for memory, value in zip(cell.memory, signals_after[cell.phases[p].width :], strict=True):
        if memory.phase == p:
            vanishing.append(
                np.array(memory.value) @ signals_after[: len(memory.value)] - value
            )
    for order in range(1, HIGHEST):
        for before, after in zip(rows, rows_after, strict=True):
            size = np.abs(before).max() + np.abs(after).max()
            if _residual(after - before, np.array(vanishing)) > ROUNDING * max(size, 1e-300):
                return order
        rows, rows_after = rows @ A, rows_after @ A_after
    return HIGHEST


def _side(cell: Cell, q: int, sign: int) -> tuple[Matrix, Matrix, Matrix]:
    """Return the matrix A of ``Y' = A Y`` in phase `q`, and two sets of rows over Y.

    The first rows give the acceleration of one mass, or the contact forces on a body; the
    second give the signals of which forms are linear combinations.  Y is that of `generator`;
    of a body it is ``(y, cos, sin, 1, memory)``, with y of all modes.  All are for `sign` times
    the motion, and for the memory of the cell.
    """
    phase, memories = cell.phases[q], len(cell.memory)
    if not isinstance(cell, BodyCell):
        A = generator(cell, phase, sign)
        signals = np.delete(np.diag([sign, sign, 1.0, sign, 0.0, *[1.0] * memories]), 4, axis=0)
        return A, A[1:2], signals[[0, 1, 3, 2, *range(4, 4 + memories)]]
    system = lawful(cell, q)
    states = len(system.A)
    signs = [cell.sign if q < each.phase else 1 for each in cell.memory]
    column_signs = np.array([*[1] * (states + 2), sign, *(sign * s for s in signs)])
    A = np.zeros((len(column_signs), len(column_signs)))
    A[:states] = np.hstack([system.A, system.inputs])
    A[states, states + 1], A[states + 1, states] = -cell.omega, cell.omega
    signals = system.rows * column_signs
    signals[phase.width :, states + 3 :] = sign * np.eye(memories)
    return A * column_signs, system.force * column_signs, signals


def generator(cell: Cell, phase: Phase, sign: int) -> Matrix:
    """Return the matrix A of ``y' = A y`` with ``y = (x, x', 1, cos, sin, memory)``.

    The motion is `sign` times that of the phase.
    """
    count = 5 + len(cell.memory)
    A = np.zeros((count, count))
    A[0, 1] = 1.0
    factors = [-phase.k, -phase.c, sign * phase.f, phase.g, 0.0]
    A[1] = np.array([*factors, *(sign * h for h in phase.memory)]) / phase.m
    A[3, 4], A[4, 3] = -cell.omega, cell.omega
    return A


def _residual(row: Vector, basis: Matrix) -> float:
    """Return the maximum norm of a row less its best combination of the rows of a basis."""
    scaled = basis / np.abs(basis).max(axis=1, keepdims=True)
    weights = np.linalg.lstsq(scaled.T, row)[0]
    return float(np.abs(row - weights @ scaled).max())
