"""First iterates: rough times, and the coefficients that fit them best.

All conditions are linear in the coefficients, so at frozen times they are a linear system, with
more equations than unknowns; its rows are scaled and it is solved by least squares.  That never
needs a flow, and the square part of it may be singular.

A cell of undamped phases may be run through backwards: with ``x(t)`` also ``x(-t)`` solves it.
At an orbit that is its own reflection, the Jacobian maps even changes to even conditions and
odd ones to odd ones.  If there are not as many of either kind, it is singular, whatever the
order: see ``docs/digits.md``.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..arrays import Vector
from ..iteration.newton import ITERATION_LIMIT, Outcome, newton
from ..scaling import equilibrated
from ..scenes.case import Case
from ..scenes.cell import Cell
from .kernel import Kernel

#: Phases of the forcing from which a blind search starts.
ANGLES = 12

#: Starts that are tried where exact orbits can be listed, and their times have led nowhere.
PATIENCE = 6

#: The least singular value that is rounding, as a part of the largest.
ROUNDING = 1e-12

#: Duration of one phase, as a part of the others', where equal ones have led nowhere.
UNEQUAL = ((1.5, "long"), (0.2, "short"))


@dataclass(frozen=True)
class RoughTimes:
    """Times of a cell from which an iteration may start, and where they come from."""

    durations: tuple[float, ...]
    angle: float
    words: str


def rough_times(cell: Cell) -> Iterator[RoughTimes]:
    """Yield rough times: the scene's own guess, equal durations, then one long or short.

    Where nothing forces, an equal duration is ``pi``, half a period of the oscillator in its
    unit of time; where something does, the cell's is known, and the phase of the forcing is
    tried all around.
    """
    for durations, words in _splits(cell):
        if cell.forced:
            total = sum(durations)
            scaled = tuple(cell.duration / total * s for s in durations)
            for j in range(ANGLES):
                angle = 2 * math.pi * j / ANGLES
                yield RoughTimes(scaled, angle, f"{words}, forcing phase {angle:.3g} rad")
        else:
            yield RoughTimes(durations, 0.0, words)


def _splits(cell: Cell) -> Iterator[tuple[tuple[float, ...], str]]:
    if cell.guess:
        yield cell.guess, "the scene's guess of the durations"
    count = len(cell.phases)
    equal = (math.pi,) * count
    yield equal, "equal durations"
    for part, word in UNEQUAL if count > 1 or not cell.forced else ():
        for p, phase in enumerate(cell.phases):
            durations = (*equal[:p], part * math.pi, *equal[p + 1 :])
            yield durations, f"a {word} phase {phase.name}"


def with_coefficients(kernel: Kernel, case: Any, size: int, times: Vector) -> Vector:
    """Return the unknowns of a kernel: the coefficients of best fit, and the given times.

    Its conditions are linear in the coefficients; `case` is what its residual takes.
    """
    count = size - len(times)
    z = np.concatenate([np.zeros(count), times])
    R, J = np.empty(size), np.empty((size, size))
    kernel.residual(case, z, R)
    kernel.jacobian(case, z, J)
    A = J[:, :count]
    rows = np.abs(A).max(axis=1)
    rows[rows == 0] = 1.0
    if np.isfinite(A).all() and np.isfinite(R).all():
        z[:count] = np.linalg.lstsq(A / rows[:, None], -R / rows)[0]
    return z


def solved(
    kernel: Kernel, given: Any, size: int, times: Vector, limit: int = ITERATION_LIMIT
) -> Outcome:
    """Return where Newton's method leads from rough times: see `with_coefficients`."""
    if kernel.condensed:
        z = np.concatenate([np.zeros(size - len(times)), times])
    else:
        z = with_coefficients(kernel, given, size, times)
    found = newton(kernel.iterate, given, z, limit)
    if not kernel.condensed or kernel.signals:  # of a body, times are all it solves for
        return found
    R = np.empty(size)
    with np.errstate(all="ignore"):
        kernel.residual(given, found.unknowns, R)
    return replace(found, residual_norm=float(np.abs(R).max()))


def is_reversible(cell: Cell) -> bool:
    """Return whether a motion of a cell, run through backwards, is another one or itself."""
    return not cell.memory and all(
        phase.c == 0 and not phase.held and (phase.rho, phase.d) == (1, 0)
        for phase in cell.phases
    )


def is_singular(kernel: Kernel, case: Case, order: int, times: Vector) -> bool:
    """Return whether the Jacobian of a kernel is singular at given times; see `attempt`."""
    given = kernel.given(case, order)
    z = with_coefficients(kernel, given, kernel.size(order), times)
    J = np.empty((len(z), len(z)))
    kernel.jacobian(given, z, J)
    if not np.isfinite(J).all():
        return False
    values = np.linalg.svd(equilibrated(J), compute_uv=False)
    return bool(values[-1] <= ROUNDING * values[0])
