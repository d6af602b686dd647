"""The exact equations of a cell, by the flow of each phase, as a kernel.

Unknowns: displacement and velocity in which each phase begins, durations, and the phase of the
forcing.  Conditions: each phase begins where the one before ends, with the jump of its
velocity; each ends by its event; and the cell is as long as the forcing makes it.  Like those
of every expansion they are linear in all but the times.
"""

import math

import numpy as np

from ..arrays import Matrix, Vector
from ..case.cell import Cell
from ..case.kernel import SceneKernel, linked
from . import flow


def exact_kernel(cell: Cell) -> SceneKernel:
    """Return the exact equations of a cell; the case of its functions is the cell."""
    count = len(cell.phases)
    return SceneKernel(
        method="exact",
        durations=count,
        forced=cell.forced,
        lowest=1,
        size=lambda order: 3 * count + cell.forced,
        residual=residual,
        jacobian=jacobian,
        motion=motion,
        coefficients=lambda z: {"states": (z[: 2 * count], 0)},
        iterate=linked(residual, jacobian, count, cell.forced),
    )


def _unpacked(cell: Cell, z: Vector) -> tuple[Matrix, Vector, Vector]:
    """Return states, durations, and the angle of the forcing where each phase begins."""
    count = len(cell.phases)
    states, durations = z[: 2 * count].reshape(count, 2), z[2 * count : 3 * count]
    angle = z[-1] if cell.forced else 0.0
    switches = np.concatenate([[0.0], np.cumsum(durations)[:-1]])
    return states, durations, angle + cell.omega * switches


def residual(cell: Cell, z: Vector, R: Vector) -> None:
    """Fill R with the left sides of the conditions."""
    states, durations, angles = _unpacked(cell, z)
    count = len(cell.phases)
    for p, phase in enumerate(cell.phases):
        s, angle, after = durations[p], angles[p], (p + 1) % count
        x, v = flow.end(phase, states[p], angle, cell.omega, s).state
        sign = cell.sign if after == 0 else 1
        R[2 * p] = states[after, 0] - sign * x
        R[2 * p + 1] = states[after, 1] - sign * (phase.rho * v + phase.d)
        ex, ev, ec, e0 = phase.event
        R[2 * count + p] = ex * x + ev * v + ec * math.cos(angle + cell.omega * s) + e0
    if cell.forced:
        R[-1] = np.sum(durations) - cell.duration


def jacobian(cell: Cell, z: Vector, J: Matrix) -> None:
    """Fill J with their derivatives."""
    states, durations, angles = _unpacked(cell, z)
    count, omega = len(cell.phases), cell.omega
    J[:] = 0.0
    for p, phase in enumerate(cell.phases):
        s, angle, after = durations[p], angles[p], (p + 1) % count
        end = flow.end(phase, states[p], angle, omega, s)
        sign = cell.sign if after == 0 else 1
        rows = slice(2 * p, 2 * p + 2)
        law = -sign * np.array([1.0, phase.rho])
        J[rows, 2 * after : 2 * after + 2] += np.eye(2)
        J[rows, rows] += law[:, None] * end.by_start
        J[rows, 2 * count + p] += law * end.by_duration
        ex, ev, ec, _ = phase.event
        row, form = 2 * count + p, np.array([ex, ev])
        sine = -ec * math.sin(angle + omega * s)
        J[row, rows] += form @ end.by_start
        J[row, 2 * count + p] += form @ end.by_duration + omega * sine
        if cell.forced:  # the angle moves with the phase of the forcing and earlier durations
            for column, rate in ((-1, 1.0), *((2 * count + q, omega) for q in range(p))):
                J[rows, column] += rate * law * end.by_angle
                J[row, column] += rate * (form @ end.by_angle + sine)
    if cell.forced:
        J[-1, 2 * count : 3 * count] = 1.0


def motion(cell: Cell, z: Vector, p: int, u: Vector, derivative: int) -> Vector:
    """Return a derivative of the displacement on phase `p` at local times in [0, 1]."""
    states, durations, angles = _unpacked(cell, z)
    t = durations[p] * np.asarray(u, dtype=float)
    return flow.motion(cell.phases[p], states[p], angles[p], cell.omega, t, derivative)
