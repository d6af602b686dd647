"""How much an orbit itself answers to its parameters, whatever computes it."""

import numpy as np

from ..exact import ExactOrbit
from ..flow.exact_system import exact_kernel

#: Relative change of a parameter: the error of the central difference is its square.
STEP = 2.0**-17


def condition(orbit: ExactOrbit) -> float:
    """Return the condition number of the times of an orbit as functions of its parameters.

    The sum over the parameters of ``|p dt/dp|``, for the time t that answers most, as a part
    of the period: a parameter rounded by a part e moves some time by up to that times e, in
    exact arithmetic too.  Times are durations, and the phase of the forcing over its angular
    frequency.  By the implicit function theorem on the exact equations, with differences for
    the derivatives by the parameters.
    """
    case, kernel = orbit.case, exact_kernel(orbit.case.cell)
    z, numbers = orbit.outcome.unknowns, case.numbers
    J = np.empty((len(z), len(z)))
    kernel.jacobian(case.cell, z, J)
    changes = []
    for i, value in enumerate(numbers):
        ends = []
        for side in (1, -1):
            moved = (*numbers[:i], value * (1 + side * STEP), *numbers[i + 1 :])
            R = np.empty(len(z))
            kernel.residual(case.scene.cell(moved, case.cycles, case.units), z, R)
            ends.append(R)
        changes.append((ends[0] - ends[1]) / (2 * STEP))
    rows = np.abs(J).max(axis=1)
    by_parameters = np.linalg.solve(J / rows[:, None], np.array(changes).T / rows[:, None])
    moved_by = np.abs(kernel.times(by_parameters)).sum(axis=1)
    if case.cell.forced:
        moved_by[-1] /= case.cell.omega
    period = float(np.sum(orbit.cell_durations)) * case.cell.cells
    return float(moved_by.max()) / period
