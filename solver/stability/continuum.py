"""Whether an orbit is one of a continuum: others of its period lie beside it."""

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from ..flow.exact_system import exact_kernel, unknowns_of
from ..scenes.cell import Cell, Form, Memory, Phase

if TYPE_CHECKING:
    from ..orbit.motion import Motion

#: How far beside an orbit another is looked for, as a part of its largest unknown; what is
#: rounding of their equations; the singular value, as a part of the largest, that is none.
BESIDE, ROUNDING, SINGULAR = 1e-3, 1e-11, 1e-7

#: Steps towards an orbit beside it.
STEPS = 12


def is_one_of_a_continuum(motion: "Motion") -> bool:
    """Return whether the exact equations of a whole period have another solution close by.

    Where they are singular, a step is made along what they do not fix, and from there the
    nearest solution is looked for: if it stays away, the orbit is one of many.

    Parameters
    ----------
    motion : Motion
        An orbit: exact, or near an exact one.
    """
    cell = whole_period(motion.case.cell)
    if cell is None:
        return False
    found = _nearest(cell, _unknowns(motion))
    if found is None:
        return False
    _, singular, directions = np.linalg.svd(_jacobian(cell, found))
    if singular[-1] > SINGULAR * singular[0]:
        return False
    away = BESIDE * float(np.abs(found).max()) * directions[-1]
    other = _nearest(cell, found + away)
    return other is not None and bool(np.abs(other - found).max() > np.abs(away).max() / 2)


def whole_period(cell: Cell) -> Cell | None:
    """Return a cell of a whole period, the mirror image spelled out; None if it cannot be.

    It cannot where a memory is set within the half period.
    """
    if cell.sign > 0:
        return cell
    if any(memory.phase for memory in cell.memory):
        return None
    count, zeros = len(cell.phases), (0.0,) * len(cell.memory)

    def first(phase: Phase) -> Phase:
        memory = (*phase.memory, *zeros) if zeros else ()
        return replace(phase, event=(*phase.event, *zeros), memory=memory)

    def second(phase: Phase) -> Phase:
        x, v, cos, constant, *factors = phase.event
        event: Form = (-x, -v, -cos, constant, *zeros, *(-q for q in factors))
        memory = (*zeros, *phase.memory) if zeros else ()
        return replace(
            phase, f=-phase.f, speed=-phase.speed, d=-phase.d, event=event, memory=memory
        )

    def later(memory: Memory) -> Memory:
        return replace(
            memory, phase=memory.phase + count, value=(*memory.value[:3], -memory.value[3])
        )

    phases = (*map(first, cell.phases), *map(second, cell.phases))
    memory = (*cell.memory, *map(later, cell.memory))
    return replace(cell, phases=phases, sign=1, guess=(), memory=memory)


def _unknowns(motion: "Motion") -> Vector:
    """Return the unknowns of the exact equations of a whole period, as a motion has them."""
    cell, z = motion.case.cell, unknowns_of(motion)
    if cell.sign > 0:
        return z
    count, more = len(cell.phases), len(cell.memory)
    states, memory, times = np.split(z, [2 * count, 2 * count + more])
    durations, turn = times[:count], times[count:]
    parts = (states, -states, memory, -memory, durations, durations, turn)
    return np.concatenate(parts)


def _jacobian(cell: Cell, z: Vector) -> Matrix:
    J = np.empty((len(z), len(z)))
    exact_kernel(cell).jacobian(cell, z, J)
    return J


def _nearest(cell: Cell, z: Vector) -> Vector | None:
    """Return the solution that the shortest steps of Newton's method lead to, if to one."""
    z, R = z.copy(), np.empty(len(z))
    for _ in range(STEPS):
        exact_kernel(cell).residual(cell, z, R)
        if np.abs(R).max() <= ROUNDING * max(1.0, float(np.abs(z).max())):
            return z
        z -= np.linalg.pinv(_jacobian(cell, z), rcond=SINGULAR) @ R
    return None
