"""What a cell of an orbit makes of small perturbations of its state, over arrays.

Neither Hill's determinant nor the Jacobian of an expansion gives it as well: the first
converges slowly or to a wrong limit where a derivative jumps, the second has the error of the
motion between the switches, which is larger than that of the times.

Plain Python, or compiled by numba with the exact equations.
"""

from math import cos, sin
from typing import Any

import numpy as np

from ..arrays import Integers, Matrix, Vector
from ..flow.exact_system import angles, ends, phase_numbers, places
from ..rows.joints import E_COS, E_X, FREE, MEMORY, RHO, F

#: Rounding of an acceleration, as a part of its terms, over `stability.ROUNDING` of products.
OF_SUMS = 1e-3

#: States of so many parts are looked at for what dies out; what is nothing beside 1.
MANY, DIED = 16, 1e-17


def end_rates(case: Any, z: Vector) -> Matrix:
    """Return velocity and acceleration where each phase ends by the flow, shape (P, 2)."""
    _, by = ends(case, z, angles(case, z, places(case)))
    found: Matrix = by[:, :, 0].copy()
    return found


def cell_map(
    case: Any, z: Vector, reached: Matrix, speed: float
) -> tuple[Matrix, Matrix, Vector]:
    """Return what a cell makes of perturbations of its state, before it is mirrored.

    The product over the phases of the flow's derivative and of the saltation at the switch that
    ends the phase, ``S = R + (F+ - R F- - R_t) n^T / (n F- + h_t)``, which SymPy derives in
    ``codegen/scene/saltation.py``.  The state is displacement, velocity and memory.

    Parameters
    ----------
    reached : ndarray, shape (P, 2)
        Velocity and acceleration where each phase ends.
    speed : float
        The largest velocity: the size of what the rate of an event is the sum of.

    Returns
    -------
    matrix : ndarray, shape (n, n)
    size : ndarray, shape (n, n)
        The same product of absolute values: rounding errors are parts of it.
    crossed : ndarray, shape (P,)
        The rate at which the event that ends each phase is crossed, as a part of that size.
    """
    kinds, numbers, setting, memory, cell = case[:5]
    at, count, more = places(case), len(kinds), len(setting)
    theta = angles(case, z, at)
    _, by = ends(case, z, theta)
    found, size, crossed = np.eye(2 + more), np.eye(2 + more), np.empty(count)
    for p in range(count):
        q = p + 1 if p + 1 < count else 0
        along, across = np.eye(2 + more), np.eye(2 + more)
        gradient, jump = np.zeros(2 + more), np.zeros(2 + more)
        before, behind = np.zeros(2 + more), np.zeros(2 + more)
        for j in range(2):
            along[j, 0] += by[p, j, 3]
            along[j, 1] += by[p, j, 4]
            before[j], gradient[j] = reached[p, j], numbers[p, E_X + j]
        across[1, 1] = numbers[p, RHO]
        sign, turned = cell[0] if q == 0 else 1.0, -cell[1] * sin(theta[p + 1])
        approach = numbers[p, E_COS] * turned
        m, c, k, f, g = phase_numbers(case, z, q)
        x, v = z[2 * q], z[2 * q + 1]
        behind[0] = sign * (v if kinds[q, FREE] != 0 else numbers[q, F])
        behind[1] = sign * (f + g * cos(theta[q]) - c * v - k * x) / m
        pull = (abs(f) + abs(g) + abs(c * v) + abs(k * x)) / m
        for i in range(more):
            own = cell[0] if p < setting[i] else 1.0
            for j in range(2):
                along[j, 2 + i] = own * by[p, j, 2] * numbers[p, MEMORY + i]
            gradient[2 + i] = own * numbers[p, MEMORY + more + i]
            if setting[i] == q:
                across[2 + i, 0], across[2 + i, 2 + i] = memory[i, 0], 0.0
                across[2 + i, 1] = memory[i, 1] * numbers[p, RHO]
                jump[2 + i] = -memory[i, 2] * turned
        approach += np.dot(gradient, before)
        m, c, k, f, g = phase_numbers(case, z, p)
        force = (abs(f) + abs(g) + abs(c) * speed + abs(k) * abs(z[2 * p])) / m
        scale = abs(gradient[0]) * speed + abs(gradient[1]) * force
        terms = np.zeros(2 + more)  # of which what is left may be little
        terms[1] = OF_SUMS * (abs(numbers[p, RHO]) * force + pull)
        scale += abs(numbers[p, E_COS]) * cell[1]
        crossed[p] = abs(approach) / scale if scale > 0 else 0.0
        jump += behind - np.dot(across, before)
        across += np.outer(jump, gradient) / approach
        found = np.dot(along, found)
        size = np.dot(np.abs(across), np.dot(np.abs(along), size))
        size += np.outer(terms, np.dot(np.abs(gradient), np.abs(found))) / abs(approach)
        size /= min(1.0, crossed[p])
        found = np.dot(across, found)
    return found, size, crossed


def lasting(own: Matrix) -> Integers:
    """Return of which parts of a state, of many, a perturbation lasts for a cell.

    What a part makes of itself, or through others, is otherwise nothing beside a multiplier
    that counts: those that are left have all others.
    """
    count, off = len(own), np.abs(own)
    lasts = np.ones(count)
    for j in range(count if count > MANY else 0):
        itself, off[j, j] = off[j, j], 0.0
        through = off[j].max() * off[:, j].max()
        lasts[j] = itself > DIED or through > DIED
    return np.flatnonzero(lasts)
