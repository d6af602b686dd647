"""The exact equations of a cell, by the closed-form flow of each phase, as a kernel.

The unknowns are displacement and velocity at the begin of each phase, the memories, the
durations, and the phase of the forcing.  The conditions are those that join the phases of every
expansion, `rows.joints`: continuity with jumps, events, memory, the duration of the cell.  They
are linear in all unknowns but the times.

A cell is given as arrays.  The functions from `places` to `jacobian` and Newton's method are
plain Python, or compiled by numba for all scenes once that pays.
"""

from functools import lru_cache
from math import cos
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import Matrix, Vector
from ..kernels import bodies
from ..kernels.family import solved_by_newton
from ..kernels.kernel import Kernel
from ..rows import joints as joining
from ..rows.joints import FREE, MEMORY, C, F, G, K, M, fill_angles, joint_rates, joints
from ..scenes.arrays import Arrays, arrays_of
from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Cell
from . import divided, flow, responses
from .responses import by_force, by_forcing, by_start

if TYPE_CHECKING:
    from ..orbit.motion import Motion


def places(case: Any) -> Any:
    """Return the index of the first unknown of each phase, and of the first after them."""
    return 2 * np.arange(len(case[0]) + 1)


def angles(case: Any, z: Vector, at: Any) -> Vector:
    """Return the angles of the forcing at the switches and at the end of the cell."""
    theta: Vector = np.empty(len(case[0]) + 1)
    fill_angles(case, z, at, theta)
    return theta


def ends(case: Any, z: Vector, theta: Vector) -> tuple[Any, Any]:
    """Return the changes of the state over each phase, and their derivatives.

    They are `gained` and `gained_by` of `joints`.
    """
    kinds, numbers, setting, _, cell = case[:5]
    count, memories = len(kinds), len(setting)
    gained, gained_by = np.zeros((count, 2)), np.zeros((count, 2, 5))
    for p in range(count):
        # as Python's floats: NumPy's are slow, and round complex quotients differently
        m, c, k = float(numbers[p, M]), float(numbers[p, C]), float(numbers[p, K])
        x, v, s = float(z[2 * p]), float(z[2 * p + 1]), float(z[2 * count + memories + p])
        force = float(numbers[p, F])
        if kinds[p, FREE] == 0:  # the velocity at which it is held; see `arrays`
            gained[p, 0], gained[p, 1] = s * force, force - v
            gained_by[p, 0, 0], gained_by[p, 1, 4] = force, -1.0
            continue
        for i in range(memories):
            force = force + float(numbers[p, MEMORY + i] * z[2 * count + i])
        xx, xv, vx, vv, less_x, less_v = by_start(m, c, k, s)
        push, forced_x, forced_v = force, 0.0, 0.0
        if force != 0 or memories > 0:
            unit_x, unit_v = by_force(m, c, k, s)
            forced_x, forced_v = force * unit_x, force * unit_v
            gained_by[p, 0, 2], gained_by[p, 1, 2] = unit_x, unit_v
        g = float(numbers[p, G])
        if g != 0:
            omega, angle = float(cell[1]), float(theta[p])
            wave_x, wave_v, x_by_angle, v_by_angle = by_forcing(m, c, k, omega, angle, s)
            forced_x, forced_v = forced_x + g * wave_x, forced_v + g * wave_v
            gained_by[p, 0, 1], gained_by[p, 1, 1] = g * x_by_angle, g * v_by_angle
            push = push + g * cos(theta[p + 1])
        gained[p, 0] = less_x * x + xv * v + forced_x
        gained[p, 1] = vx * x + less_v * v + forced_v
        gained_by[p, 0, 3], gained_by[p, 0, 4] = less_x, xv
        gained_by[p, 1, 3], gained_by[p, 1, 4] = vx, less_v
        # the state at the end, not as start plus change: it may be far smaller than both
        x, v = xx * x + xv * v + forced_x, vx * x + vv * v + forced_v
        gained_by[p, 0, 0], gained_by[p, 1, 0] = v, (push - c * v - k * x) / m
    return gained, gained_by


def phase_numbers(case: Any, z: Vector, p: int) -> Vector:
    """Return m, c, k, the constant force and g of phase `p`; of a held one only m is not 0."""
    kinds, numbers, setting = case[0], case[1], case[2]
    equation = np.zeros(5)
    equation[0] = numbers[p, M]
    if kinds[p, FREE] != 0:
        equation[1], equation[2], equation[4] = numbers[p, C], numbers[p, K], numbers[p, G]
        equation[3] = numbers[p, F]
        for i in range(len(setting)):
            equation[3] += numbers[p, MEMORY + i] * z[2 * len(kinds) + i]
    return equation


def residual(case: Any, z: Vector, R: Vector) -> None:
    """Fill R with the residuals of all conditions."""
    at = places(case)
    theta = angles(case, z, at)
    gained, _ = ends(case, z, theta)
    joints(case, z, at, theta, gained, gained, R, 0)


def jacobian(case: Any, z: Vector, J: Matrix) -> None:
    """Fill J with the derivatives of `residual` by all unknowns."""
    at = places(case)
    theta = angles(case, z, at)
    _, gained_by = ends(case, z, theta)
    J[:, :] = 0.0
    joint_rates(case, z, at, theta, gained_by, gained_by, J, 0)


#: These functions, linked as plain Python or compiled, with accounts of the time they take.
FAMILY = solved_by_newton(joining, divided, responses)


@lru_cache(maxsize=256)
def arrays(cell: Cell) -> Arrays:
    """Return the arrays of a cell; the force of a held phase is replaced by its velocity."""
    arrays_ = arrays_of(cell)
    for p, phase in enumerate(cell.phases):
        if phase.held:
            arrays_.numbers[p, F] = phase.speed
    return arrays_


def exact_kernel(cell: Cell) -> Kernel:
    """Return the kernel of the exact equations; its functions take a cell as case."""
    if isinstance(cell, BodyCell):
        return bodies.exact_kernel(cell)
    count, account = len(cell.phases), FAMILY.account_of(__name__)
    of = FAMILY.quicker(__name__, count)
    return Kernel(
        method="exact",
        durations=count,
        forced=cell.forced,
        lowest=1,
        size=lambda order: 3 * count + len(cell.memory) + cell.forced,
        residual=lambda case, z, R: of["residual"](arrays(case), z, R),
        jacobian=lambda case, z, J: of["jacobian"](arrays(case), z, J),
        motion=motion,
        coefficients=lambda z: {
            q.name: (z[2 * count + i], q.power) for i, q in enumerate(cell.memory)
        },
        iterate=lambda case, z, limit: of["iterate"](arrays(case), z, limit),
        account=None if account.is_compiled else account,
    )


def unknowns_of(motion: "Motion") -> Vector:
    """Return the unknowns of the exact equations that a motion, exact or not, has."""
    start, phases = np.zeros(1), range(len(motion.case.cell.phases))
    states = [float(motion.part(p, start, j)[0]) for p in phases for j in (0, 1)]
    return np.array([*states, *motion.memory_values, *motion.times])


def motion(cell: Cell, z: Vector, p: int, u: Vector, derivative: int) -> Vector:
    """Return a derivative of the displacement on phase `p` at local times in [0, 1]."""
    count, memories = len(cell.phases), len(cell.memory)
    durations = z[2 * count + memories :][:count]
    phase = cell.phases[p].remembering(z[2 * count : 2 * count + memories].tolist())
    angle = (float(z[-1]) if cell.forced else 0.0) + cell.omega * float(durations[:p].sum())
    t = durations[p] * np.asarray(u, dtype=float)
    return flow.motion(phase, z[2 * p : 2 * p + 2], angle, cell.omega, t, derivative)
