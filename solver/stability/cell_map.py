"""The monodromy matrix of a cell of one mass, over arrays, from flows and saltation matrices.

Neither Hill's determinant nor the Jacobian of an expansion gives it as accurately.  The first
converges slowly or to a wrong limit where a derivative jumps; the second has the error of the
motion between switches, which is larger than that of the times.
"""

from math import cos, sin
from typing import Any

import numpy as np

from ..arrays import Integers, Matrix, Vector
from ..flow.exact_system import angles, ends, phase_numbers, places
from ..iteration.linear import product
from ..rows.joints import E_COS, E_X, FREE, MEMORY, RHO, F

#: Relative rounding error of an acceleration, in units of `stability.ROUNDING`.
OF_SUMS = 1e-3

#: Size of a state above which components that decay within a cell are left out; how much.
MANY, DIED = 16, 1e-17


def end_rates(case: Any, z: Vector) -> Matrix:
    """Return velocity and acceleration at the end of each phase by its flow, shape (P, 2)."""
    _, by = ends(case, z, angles(case, z, places(case)))
    rates: Matrix = by[:, :, 0].copy()
    return rates


def cell_map(
    case: Any, z: Vector, reached: Matrix, speed: float
) -> tuple[Matrix, Matrix, Vector]:
    """Return the monodromy matrix of a cell, before a mirrored cell is turned back.

    It is the product over the phases of the transition matrix of the flow and the saltation
    matrix of the switch that ends the phase, ``S = R + (F+ - R F- - R_t) n^T / (n F- + h_t)``,
    which SymPy derives in ``codegen/scene/saltation.py``.  The state is (x, x', memory).

    Parameters
    ----------
    reached : ndarray, shape (P, 2)
        Velocity and acceleration at the end of each phase.
    speed : float
        The largest velocity, the scale of the rate of an event.

    Returns
    -------
    matrix : ndarray, shape (n, n)
    size : ndarray, shape (n, n)
        Scale of the rounding errors of `matrix`; see `linear.product`.
    crossed : ndarray, shape (P,)
        The rate ``n F- + h_t`` at the event that ends each phase, relative to its terms.
    """
    kinds, numbers, setting, memory, cell = case[:5]
    at, count, memories = places(case), len(kinds), len(setting)
    theta = angles(case, z, at)
    _, by = ends(case, z, theta)
    shape = count, 2 + memories, 2 + memories
    steps, sizes, crossed = np.empty(shape), np.empty(shape), np.empty(count)
    for p in range(count):
        q = p + 1 if p + 1 < count else 0
        transition, saltation = np.eye(2 + memories), np.eye(2 + memories)
        gradient, jump = np.zeros(2 + memories), np.zeros(2 + memories)
        before, after = np.zeros(2 + memories), np.zeros(2 + memories)
        for j in range(2):
            transition[j, 0] += by[p, j, 3]
            transition[j, 1] += by[p, j, 4]
            before[j], gradient[j] = reached[p, j], numbers[p, E_X + j]
        saltation[1, 1] = numbers[p, RHO]
        sign, cosine_rate = cell[0] if q == 0 else 1.0, -cell[1] * sin(theta[p + 1])
        approach = numbers[p, E_COS] * cosine_rate
        m, c, k, f, g = phase_numbers(case, z, q)
        x, v = z[2 * q], z[2 * q + 1]
        after[0] = sign * (v if kinds[q, FREE] != 0 else numbers[q, F])
        after[1] = sign * (f + g * cos(theta[q]) - c * v - k * x) / m
        pull = (abs(f) + abs(g) + abs(c * v) + abs(k * x)) / m
        for i in range(memories):
            memory_sign = cell[0] if p < setting[i] else 1.0
            for j in range(2):
                transition[j, 2 + i] = memory_sign * by[p, j, 2] * numbers[p, MEMORY + i]
            gradient[2 + i] = memory_sign * numbers[p, MEMORY + memories + i]
            if setting[i] == q:
                saltation[2 + i, 0], saltation[2 + i, 2 + i] = memory[i, 0], 0.0
                saltation[2 + i, 1] = memory[i, 1] * numbers[p, RHO]
                jump[2 + i] = -memory[i, 2] * cosine_rate
        approach += np.dot(gradient, before)
        m, c, k, f, g = phase_numbers(case, z, p)
        force = (abs(f) + abs(g) + abs(c) * speed + abs(k) * abs(z[2 * p])) / m
        scale = abs(gradient[0]) * speed + abs(gradient[1]) * force
        terms = np.zeros(2 + memories)  # sizes of the sums in F+ - R F-, which may cancel
        terms[1] = OF_SUMS * (abs(numbers[p, RHO]) * force + pull)
        scale += abs(numbers[p, E_COS]) * cell[1]
        crossed[p] = abs(approach) / scale if scale > 0 else 0.0
        jump += after - np.dot(saltation, before)
        saltation += np.outer(jump, gradient) / approach
        steps[p] = np.dot(saltation, transition)
        size = np.dot(np.abs(saltation), np.abs(transition))
        cancelled = np.dot(np.abs(gradient), np.abs(transition))
        size += np.outer(terms, cancelled) / abs(approach)
        sizes[p] = size / min(1.0, crossed[p])
    matrix, size = product(steps, sizes)
    return matrix, size, crossed


def lasting(matrix: Matrix) -> Integers:
    """Return the indices of a state's components whose perturbation survives one cell.

    Components of a large state with negligible entries in the monodromy matrix, on the diagonal
    and in products of row and column, do not affect multipliers of a size that counts.
    """
    count, off_diagonal = len(matrix), np.abs(matrix)
    lasts = np.ones(count)
    for j in range(count if count > MANY else 0):
        itself, off_diagonal[j, j] = off_diagonal[j, j], 0.0
        through = off_diagonal[j].max() * off_diagonal[:, j].max()
        lasts[j] = itself > DIED or through > DIED
    return np.flatnonzero(lasts)
