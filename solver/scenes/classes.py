"""The class at each switch for the parameters of a case: higher than in general, for some.

As in ``codegen/scene/smoothness.py``, with numbers put in: a derivative jumps at a switch
unless its jump is a combination of the forms known to vanish there.
"""

import numpy as np

from ..arrays import Matrix, Vector
from ..bodies.laws import lawful
from .bodies.cell import BodyCell
from .cell import Cell, Phase

#: Derivatives that are looked at: one that is smoother is not told from one without switch.
HIGHEST = 8

#: What is rounding, as a part of what is subtracted.
ROUNDING = 1e-10


def classes(cell: Cell) -> tuple[int, ...]:
    """Return the k of the class C^k at the switch that begins each phase of a cell."""
    if isinstance(cell, BodyCell) and cell.classes:
        return cell.classes
    return tuple(_class(cell, p) for p in range(len(cell.phases)))


def _class(cell: Cell, p: int) -> int:
    """Return the k at the switch that begins phase `p`, in the frame behind it."""
    left, sign = (p - 1) % len(cell.phases), cell.sign if p == 0 else 1
    if any(jump != (1.0, 0.0) for jump in cell.phases[left].jumps):
        return 0
    A, row, seen = _side(cell, left, sign)
    A_after, row_after, seen_after = _side(cell, p, 1)
    known = [np.array(cell.phases[left].event) @ seen]
    for phase, of in ((cell.phases[left], seen), (cell.phases[p], seen_after)):
        if phase.held:
            known.append(of[1] - phase.speed * of[3])
    place = cell.place(left)
    if place is not None:
        known.append(seen[0] - place * seen[3])
    for memory, value in zip(cell.memory, seen_after[cell.phases[p].width :], strict=True):
        if memory.phase == p:
            known.append(np.array(memory.value) @ seen_after[: len(memory.value)] - value)
    for order in range(1, HIGHEST):
        for one, other in zip(row, row_after, strict=True):
            size = np.abs(one).max() + np.abs(other).max()
            if _left_over(other - one, np.array(known)) > ROUNDING * max(size, 1e-300):
                return order
        row, row_after = row @ A, row_after @ A_after
    return HIGHEST


def _side(cell: Cell, q: int, sign: int) -> tuple[Matrix, Matrix, Matrix]:
    """Return ``A`` of ``Y' = A Y`` in a phase, and rows over Y; the motion times `sign`.

    Rows are of the acceleration of one mass, or of the contact forces on a body, and of what
    forms are of.  Y is that of `generator`; of a body it is ``(y, cos, sin, 1, memory)``, with
    y of all modes.  The memory is that of the cell.
    """
    phase, more = cell.phases[q], len(cell.memory)
    if not isinstance(cell, BodyCell):
        A = generator(cell, phase, sign)
        seen = np.delete(np.diag([sign, sign, 1.0, sign, 0.0, *[1.0] * more]), 4, axis=0)
        return A, A[1:2], seen[[0, 1, 3, 2, *range(4, 4 + more)]]
    own = lawful(cell, q)
    states = len(own.A)
    signs = [cell.sign if q < each.phase else 1 for each in cell.memory]
    put = np.array([*[1] * (states + 2), sign, *(sign * q for q in signs)])
    A = np.zeros((len(put), len(put)))
    A[:states] = np.hstack([own.A, own.inputs])
    A[states, states + 1], A[states + 1, states] = -cell.omega, cell.omega
    seen = own.rows * put
    seen[phase.width :, states + 3 :] = sign * np.eye(more)
    return A * put, own.force * put, seen


def generator(cell: Cell, phase: Phase, sign: int) -> Matrix:
    """Return ``A`` of ``y' = A y`` with ``y = (x, x', 1, cos, sin, memory)``."""
    count = 5 + len(cell.memory)
    found = np.zeros((count, count))
    found[0, 1] = 1.0
    factors = [-phase.k, -phase.c, sign * phase.f, phase.g, 0.0]
    found[1] = np.array([*factors, *(sign * h for h in phase.memory)]) / phase.m
    found[3, 4], found[4, 3] = -cell.omega, cell.omega
    return found


def _left_over(row: Vector, known: Matrix) -> float:
    """Return the size of what no combination of the known rows accounts for."""
    scaled = known / np.abs(known).max(axis=1, keepdims=True)
    weights = np.linalg.lstsq(scaled.T, row)[0]
    return float(np.abs(row - weights @ scaled).max())
