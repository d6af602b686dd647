"""The equations of a cell as arrays: the first argument of the kernels of any scene."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..arrays import Integers, Matrix, Vector
from ..rows import joints as of
from .cell import Cell, Phase


class Arrays(NamedTuple):
    """A cell as arrays; their columns are named in `rows.joints`.

    Parameters
    ----------
    kinds : ndarray of int, shape (P, 5)
        Of each phase: whether it is free, the class at its begin, the number of unknowns added
        to a series, and where x and x' of its event are taken.
    numbers : ndarray, shape (P, 11 + 2 M)
        Of each phase: equation (5), jump (2), event (4), then the factors of each memory in the
        equation and in the event.
    setting : ndarray of int, shape (M,)
        The phase whose begin sets each memory.
    memory : ndarray, shape (M, 4)
        The value it is set to, a linear form in x, x', the cosine of the forcing, and 1.
    cell : ndarray, shape (3,)
        Sign of the next cell; angular frequency; forcing angle of the cell over pi, 0 if free.
    """

    kinds: Integers
    numbers: Matrix
    setting: Integers
    memory: Matrix
    cell: Vector


def arrays_of(
    cell: Cell,
    classes: Sequence[int] = (),
    beside: Sequence[int] = (),
    after: bool = False,
    starts: bool = False,
) -> Arrays:
    """Return the arrays of a cell.

    Parameters
    ----------
    classes : sequence of int
        The k of the class C^k at the begin of each phase; 1 by default.
    beside : sequence of int
        The number of unknowns that each phase adds to a series; 0 by default.
    after : bool
        Whether events are evaluated after the switch, but for a velocity that jumps.
    starts : bool
        Whether the condition of the cell's start, if any, replaces the first event.
    """
    mass = next(phase.m for phase in cell.phases if not phase.held)
    rows = (_of_phase(phase, mass, after) for phase in cell.phases)
    kinds, numbers = zip(*rows, strict=True)
    arrays = Arrays(
        np.array(kinds, dtype=np.int64),
        np.array(numbers, dtype=float),
        np.array([each.phase for each in cell.memory], dtype=np.int64),
        np.array([each.value[:4] for each in cell.memory], dtype=float).reshape(-1, 4),
        np.array([cell.sign, cell.omega, 2 * cell.cycles / cell.cells if cell.forced else 0]),
    )
    arrays.kinds[:, of.CLASS] = classes or 1
    arrays.kinds[:, of.BESIDE] = beside or 0
    if starts and cell.start:
        arrays.kinds[0, of.OF_X : of.OF_V + 1] = of.AT_BEGIN
        arrays.numbers[0, of.E_X : of.E_0 + 1] = *cell.start[:2], 0.0, cell.start[2]
    return arrays


def _of_phase(phase: Phase, mass: float, after: bool) -> tuple[list[int], list[float]]:
    """Return the rows of a phase in `Arrays.kinds` and `Arrays.numbers`.

    The equation of a held phase is ``mass x'' = 0``: of the same size as those of the others.
    """
    jumps = (phase.rho, phase.d) != (1, 0)
    states = [of.AFTER if after else of.AT_END, of.AFTER if after and not jumps else of.AT_END]
    equation = [phase.m, phase.c, phase.k, phase.f, phase.g]
    memory = list(phase.memory)
    if phase.held:  # its velocity at the begin is the prescribed one
        equation, memory = [mass, 0.0, 0.0, 0.0, 0.0], [0.0] * len(memory)
    row = [*equation, phase.rho, phase.d, *phase.event[:4], *memory, *phase.event[4:]]
    return [not phase.held, 1, 0, *states], row
