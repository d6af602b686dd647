"""Starting values: rough times, and the coefficients that fit them best.

All conditions are linear in the coefficients.  At given times they are a linear system with
more equations than unknowns, solved by least squares with scaled rows.

A cell of undamped phases is reversible: with ``x(t)`` also ``x(-t)`` solves it.  At an orbit
that is its own reflection, the Jacobian maps even changes to even conditions and odd ones to
odd ones.  If their numbers differ, it is singular, whatever the order: see ``docs/digits.md``.
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

#: Number of phases of the forcing among the rough times.
ANGLES = 12

#: Number of starts tried if exact orbits can be listed, but their times have led nowhere.
PATIENCE = 6

#: Coefficients of a condition that are smaller than this, relative to those of the times, tell
#: nothing about the coefficients.
ALONE = 1e-8

#: Singular values below this, relative to the largest, are rounding.
ROUNDING = 1e-12

#: Duration of one phase, relative to the others, if equal ones have led nowhere; and of how
#: many phases.  Of more, one makes no difference, and there are too many.
UNEQUAL, FEW_PHASES = ((1.5, "long"), (0.2, "short")), 12


@dataclass(frozen=True)
class RoughTimes:
    """Starting values of the times of a cell, without units, and their origin in words."""

    durations: tuple[float, ...]
    angle: float
    words: str


def rough_times(cell: Cell) -> Iterator[RoughTimes]:
    """Yield rough times: the scene's own guess, equal durations, then one long or short.

    Without forcing, an equal duration is ``pi``, half a period of the oscillator in its unit of
    time.  With forcing, durations add up to that of the cell, and `ANGLES` phases of the
    forcing are tried for each.
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
    """Yield rough durations, and their origin in words."""
    if cell.guess:
        yield cell.guess, "the scene's guess of the durations"
    count = len(cell.phases)
    equal = (math.pi,) * count
    yield equal, "equal durations"
    if count > FEW_PHASES or (count == 1 and cell.forced):
        return
    for part, word in UNEQUAL:
        for p, phase in enumerate(cell.phases):
            durations = (*equal[:p], part * math.pi, *equal[p + 1 :])
            yield durations, f"a {word} phase {phase.name}"


def with_coefficients(kernel: Kernel, case: Any, size: int, times: Vector) -> Vector:
    """Return the unknowns of a kernel: the coefficients of best fit, then the given times.

    `case` is the first argument of the kernel's functions.
    """
    count = size - len(times)
    z = np.concatenate([np.zeros(count), times])
    R, J = np.empty(size), np.empty((size, size))
    kernel.residual(case, z, R)
    kernel.jacobian(case, z, J)
    A = J[:, :count]
    rows = np.abs(A).max(axis=1)
    if np.isfinite(A).all() and np.isfinite(R).all():
        told = (rows > 0) & ~(rows <= ALONE * np.abs(J).max(axis=1))
        z[:count] = np.linalg.lstsq(A[told] / rows[told, None], -R[told] / rows[told])[0]
    return z


def solved(
    kernel: Kernel, arguments: Any, size: int, times: Vector, limit: int = ITERATION_LIMIT
) -> Outcome:
    """Return the outcome of Newton's method from rough times; see `with_coefficients`."""
    if kernel.condensed:
        z = np.concatenate([np.zeros(size - len(times)), times])
    else:
        z = with_coefficients(kernel, arguments, size, times)
    outcome = newton(kernel.iterate, arguments, z, limit)
    if not kernel.condensed or kernel.signals:  # of a body, times are the only unknowns
        return outcome
    R = np.empty(size)
    with np.errstate(all="ignore"):
        kernel.residual(arguments, outcome.unknowns, R)
    return replace(outcome, residual_norm=float(np.abs(R).max()))


def is_reversible(cell: Cell) -> bool:
    """Return whether each motion of a cell, reversed in time, is a motion as well."""
    return not cell.memory and all(
        phase.c == 0 and not phase.held and (phase.rho, phase.d) == (1, 0)
        for phase in cell.phases
    )


def is_singular(kernel: Kernel, case: Case, order: int, times: Vector) -> bool:
    """Return whether the Jacobian of a kernel is singular at times and best coefficients."""
    arguments = kernel.given(case, order)
    z = with_coefficients(kernel, arguments, kernel.size(order), times)
    J = np.empty((len(z), len(z)))
    kernel.jacobian(arguments, z, J)
    if not np.isfinite(J).all():
        return False
    values = np.linalg.svd(equilibrated(J), compute_uv=False)
    return bool(values[-1] <= ROUNDING * values[0])
