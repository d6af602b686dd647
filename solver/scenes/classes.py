"""The class at each switch for the parameters of a case: higher than in general, for some.

As in ``codegen/scene/smoothness.py``, with numbers put in: a derivative jumps at a switch
unless its jump is a combination of the forms known to vanish there.
"""

from collections.abc import Sequence
from typing import Any

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
    if isinstance(cell, BodyCell):
        return cell.classes or tuple(_of_body(cell, p) for p in range(len(cell.phases)))
    return tuple(_class(cell, p) for p in range(len(cell.phases)))


def _class(cell: Cell, p: int) -> int:
    left, right, sign = cell.phases[p - 1], cell.phases[p], cell.sign if p == 0 else 1
    if left.rho != 1 or left.d != 0:
        return 0
    before, after = generator(cell, left, sign), generator(cell, right, 1)
    known = _known(cell, p, left, sign)
    return _continuous(before[1:2], after[1:2], before, after, known)


def _of_body(cell: BodyCell, p: int) -> int:
    """Return the k at the switch of a body that begins phase `p`: by its contact forces.

    As `_class`, with ``Y = (y, cos, sin, 1, memory)`` of all modes, in the frame behind it.
    """
    left, sign = (p - 1) % len(cell.phases), cell.sign if p == 0 else 1
    if any(jump != (1.0, 0.0) for jump in cell.phases[left].jumps):
        return 0
    (A, force, rows), (A_after, force_after, rows_after) = (
        _of_phase(cell, left, sign), _of_phase(cell, p, 1)
    )  # fmt: skip
    states = len(rows[0]) - 3 - len(cell.memory)
    known = [np.array(cell.carrying(left).event) @ rows]
    for q, side in ((left, sign), (p, 1)):
        if cell.phases[q].held:
            known.append(rows_after[1].copy())
            known[-1][states + 2] -= side * cell.phases[q].speed
    for i, each in enumerate(cell.memory):
        if each.phase == p:
            known.append(np.array(each.value) @ rows_after[: len(each.value)])
            known[-1][states + 3 + i] -= 1.0
    return _continuous(force, force_after, A, A_after, known)


def _of_phase(cell: BodyCell, q: int, sign: int) -> tuple[Matrix, Matrix, Matrix]:
    """Return ``A`` of ``Y' = A Y`` in a phase, its contact forces, and what forms are of.

    `sign` is what the motion is multiplied by; the memory is that of the cell.
    """
    own = lawful(cell, q)
    states = len(own.A)
    signs = [cell.sign if q < each.phase else 1 for each in cell.memory]
    put = np.array([*[1] * (states + 2), sign, *(sign * q for q in signs)])
    A = np.zeros((len(put), len(put)))
    A[:states] = np.hstack([own.A, own.inputs])
    A[states, states + 1], A[states + 1, states] = -cell.omega, cell.omega
    return A * put, own.force * put, own.rows * put


def generator(cell: Cell, phase: Phase, sign: int) -> Matrix:
    """Return ``A`` of ``y' = A y`` with ``y = (x, x', 1, cos, sin, memory)``."""
    count = 5 + len(cell.memory)
    found = np.zeros((count, count))
    found[0, 1] = 1.0
    factors = [-phase.k, -phase.c, sign * phase.f, phase.g, 0.0]
    found[1] = np.array([*factors, *(sign * h for h in phase.memory)]) / phase.m
    found[3, 4], found[4, 3] = -cell.omega, cell.omega
    return found


def _known(cell: Cell, p: int, left: Phase, sign: int) -> list[list[float]]:
    """Return the forms in y that vanish at the switch that begins phase `p`."""
    x, v, cos, constant, *memory = left.event
    rows = [[sign * x, sign * v, constant, sign * cos, 0.0, *memory]]
    nothing = [0.0] * len(cell.memory)
    if left.held:
        rows.append([0.0, float(sign), -left.speed, 0.0, 0.0, *nothing])
    place = cell.place((p - 1) % len(cell.phases))
    if place is not None:
        rows.append([float(sign), 0.0, -place, 0.0, 0.0, *nothing])
    for i, q in enumerate(cell.memory):
        if q.phase == p:
            x, v, cos, constant = q.value
            rows.append([x, v, constant, cos, 0.0, *nothing])
            rows[-1][5 + i] = -1.0
    return rows


def _continuous(
    rows: Matrix, rows_after: Matrix, A: Matrix, A_after: Matrix, known: Sequence[Any]
) -> int:
    """Return the order of the last derivative that does not jump at a switch.

    Rows of what jumps with the second, over the states before and behind it, whose rates are
    by ``A``; `known` are forms that vanish there.
    """
    for order in range(1, HIGHEST):
        for row, row_after in zip(rows, rows_after, strict=True):
            size = np.abs(row).max() + np.abs(row_after).max()
            if _left_over(row_after - row, np.array(known)) > ROUNDING * max(size, 1e-300):
                return order
        rows, rows_after = rows @ A, rows_after @ A_after
    return HIGHEST


def _left_over(row: Vector, known: Matrix) -> float:
    """Return the size of what no combination of the known rows accounts for."""
    scaled = known / np.abs(known).max(axis=1, keepdims=True)
    weights = np.linalg.lstsq(scaled.T, row)[0]
    return float(np.abs(row - weights @ scaled).max())
