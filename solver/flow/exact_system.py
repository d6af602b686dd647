"""The exact equations of a cell, by the flow of each phase, as a kernel.

Unknowns: displacement and velocity in which each phase begins, what its switches set (the
memory), durations, and the phase of the forcing.  Conditions: each phase begins where the one
before ends, with the jump of its velocity; each ends by its event; the memory is what it is set
to; and the cell is as long as the forcing makes it.  Like those of every expansion they are
linear in all but the times.
"""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from ..kernels.kernel import Kernel
from ..kernels.linking import linked
from ..scenes.cell import Cell
from . import flow

if TYPE_CHECKING:
    from ..orbit.motion import Motion


def exact_kernel(cell: Cell) -> Kernel:
    """Return the exact equations of a cell; the case of its functions is the cell."""
    count = len(cell.phases)
    return Kernel(
        method="exact",
        durations=count,
        forced=cell.forced,
        lowest=1,
        size=lambda order: 3 * count + len(cell.memory) + cell.forced,
        residual=residual,
        jacobian=jacobian,
        motion=motion,
        coefficients=lambda z: {"states": (z[: 2 * count], 0)},
        iterate=linked(residual, jacobian, count, cell.forced),
    )


def unknowns_of(motion: "Motion") -> Vector:
    """Return the unknowns of the exact equations of a cell, as a motion has them."""
    start, phases = np.zeros(1), range(len(motion.case.cell.phases))
    states = [float(motion.part(p, start, j)[0]) for p in phases for j in (0, 1)]
    turn = [motion.angle] if motion.case.cell.forced else []
    return np.array([*states, *motion.memory_values, *motion.cell_durations, *turn])


def _unpacked(cell: Cell, z: Vector) -> tuple[Cell, Matrix, Vector, Vector]:
    """Return the cell with numbers for its memory, states, durations, angles of the forcing.

    The angles are those where each phase begins.
    """
    count, more = len(cell.phases), len(cell.memory)
    states = z[: 2 * count].reshape(count, 2)
    memory, durations = z[2 * count : 2 * count + more], z[2 * count + more :][:count]
    angle = z[-1] if cell.forced else 0.0
    switches = np.concatenate([[0.0], np.cumsum(durations)[:-1]])
    return cell.remembering(memory.tolist()), states, durations, angle + cell.omega * switches


def residual(cell: Cell, z: Vector, R: Vector) -> None:
    """Fill R with the left sides of the conditions."""
    there, states, durations, angles = _unpacked(cell, z)
    count = len(cell.phases)
    for p, phase in enumerate(there.phases):
        s, angle, after = durations[p], angles[p], (p + 1) % count
        end = flow.end(phase, states[p], angle, cell.omega, s)
        (x, v), (dx, dv) = end.state, end.change
        sign = cell.sign if after == 0 else 1
        R[2 * p] = states[after, 0] - sign * x
        R[2 * p + 1] = states[after, 1] - sign * (phase.rho * v + phase.d)
        ex, ev, ec, e0 = phase.event
        # at the start of the phase, and its change: of a phase that begins at the event that
        # ends it the first is 0, and what is left keeps its digits
        at_start = ex * states[p, 0] + ev * states[p, 1] + ec * math.cos(angle) + e0
        half = cell.omega * s / 2
        turned = -2 * math.sin(angle + half) * math.sin(half)
        R[2 * count + p] = at_start + (ex * dx + ev * dv + ec * turned)
    for i, memory in enumerate(cell.memory):
        vx, vv, vc, v0 = memory.value
        x, v = states[memory.phase]
        value = vx * x + vv * v + vc * math.cos(angles[memory.phase]) + v0
        R[3 * count + i] = z[2 * count + i] - value
    if cell.forced:
        R[-1] = np.sum(durations) - cell.duration


def jacobian(cell: Cell, z: Vector, J: Matrix) -> None:
    """Fill J with their derivatives."""
    there, states, durations, angles = _unpacked(cell, z)
    count, omega = len(cell.phases), cell.omega
    first = 2 * count + len(cell.memory)  # column of the first duration
    J[:] = 0.0
    for p, phase in enumerate(there.phases):
        s, angle, after = durations[p], angles[p], (p + 1) % count
        end = flow.end(phase, states[p], angle, omega, s)
        sign = cell.sign if after == 0 else 1
        rows = slice(2 * p, 2 * p + 2)
        law = -sign * np.array([1.0, phase.rho])
        J[rows, 2 * after : 2 * after + 2] += np.eye(2)
        J[rows, rows] += law[:, None] * end.by_start
        J[rows, first + p] += law * end.by_duration
        ex, ev, ec, _ = phase.event
        row, form = 2 * count + p, np.array([ex, ev])
        sine = -ec * math.sin(angle + omega * s)
        J[row, rows] += form @ end.by_start
        J[row, first + p] += form @ end.by_duration + omega * sine
        if cell.memory and not phase.held:
            unit = flow.end(replace(phase, f=1.0, g=0.0), np.zeros(2), 0.0, omega, s).state
            for i, factor in enumerate(cell.phases[p].memory):
                J[rows, 2 * count + i] += law * unit * factor
                J[row, 2 * count + i] += form @ unit * factor
        for i, factor in enumerate(cell.phases[p].event[4:]):
            J[row, 2 * count + i] += factor
        if cell.forced:  # the angle moves with the phase of the forcing and earlier durations
            for column, rate in ((-1, 1.0), *((first + q, omega) for q in range(p))):
                J[rows, column] += rate * law * end.by_angle
                J[row, column] += rate * (form @ end.by_angle + sine)
    for i, memory in enumerate(cell.memory):
        vx, vv, vc, _ = memory.value
        p, row = memory.phase, 3 * count + i
        J[row, 2 * count + i] += 1.0
        J[row, 2 * p : 2 * p + 2] -= vx, vv
        if cell.forced:
            J[row, -1] += vc * math.sin(angles[p])
            J[row, first : first + p] += omega * vc * math.sin(angles[p])
    if cell.forced:
        J[-1, first : first + count] = 1.0


def motion(cell: Cell, z: Vector, p: int, u: Vector, derivative: int) -> Vector:
    """Return a derivative of the displacement on phase `p` at local times in [0, 1]."""
    there, states, durations, angles = _unpacked(cell, z)
    t = durations[p] * np.asarray(u, dtype=float)
    return flow.motion(there.phases[p], states[p], angles[p], cell.omega, t, derivative)
