"""The exact equations of a body along a parameter, over arrays, as steps of a branch take them.

A state is ``Y = (X, cos, sin, 1)``: X is that of the modes and the memory, the rest the angle
of the forcing.  In phase p it moves by ``Y' = G_p Y``, and the switch behind it is ``S_p``:

    Y_(p+1) = S_p exp(G_p s_p) Y_p,    e_p exp(G_p s_p) Y_p = 0,    X_0 = sigma X_P.

Unknown are ``X_0``, the durations ``s_p`` and, if something forces, its angle at the beginning.
With the times alone nothing can be solved for at a fold, where the cell that is closed has a
multiplier of 1.

The functions stand for those of the same names in `extended`, `cell_map` and `walk`.  Plain
Python, or compiled by numba.
"""

from math import ceil, copysign, cos, log2, sin
from typing import Any

import numpy as np

from ...arrays import Matrix, Vector
from ..extended import series_at

#: Size of a matrix whose exponential is a Taylor series of twelve terms, to rounding.
SHORT = 0.25

#: 1 over the factorials.
INVERSE_FACTORIALS = tuple(1 / float(np.prod(np.arange(1.0, k + 1))) for k in range(13))


def case_at(along: Any, q: float) -> Any:
    """Return the arrays of the cell at a value of the parameter.

    The numbers of its kinds; generators and switches, shape (P, W, W); events, (P, W);
    displacement and velocity of the first contact, (P, 2, W); sigma, the angular frequency and
    the duration of the cell; forms that are watched, (R, W).
    """
    values = series_at(along[2], q)
    count, width = len(along[0]), along[1][0]
    square, line = count * width * width, count * width
    rest = values[2 * square :]
    return (
        along[0],
        values[:square].reshape(count, width, width),
        values[square : 2 * square].reshape(count, width, width),
        rest[:line].reshape(count, width),
        rest[line : 3 * line].reshape(count, 2, width),
        rest[3 * line : 3 * line + 3],
        rest[3 * line + 3 :].reshape(-1, width),
    )


def less_one(matrix: Matrix, t: float) -> Matrix:
    """Return ``exp(matrix t) - 1``, also where that is small: a Taylor series, doubled."""
    size, doublings, f = norm(matrix) * abs(t), 0, INVERSE_FACTORIALS
    if size > SHORT:
        doublings = ceil(log2(size / SHORT))
    A = matrix * (t / 2.0**doublings)
    A2 = A @ A
    A3, A4 = A2 @ A, A2 @ A2
    high = f[9] * A + f[10] * A2 + f[11] * A3 + f[12] * A4
    high = f[5] * A + f[6] * A2 + f[7] * A3 + f[8] * A4 + A4 @ high
    found: Matrix = A + f[2] * A2 + f[3] * A3 + f[4] * A4 + A4 @ high
    for _ in range(doublings):
        found = found @ found + 2 * found
    return found


def norm(matrix: Matrix) -> float:
    """Return the largest sum of sizes in a row."""
    largest = 0.0
    for i in range(len(matrix)):
        largest = max(largest, np.abs(matrix[i]).sum())
    return largest


def begun(case: Any, z: Vector) -> Vector:
    """Return the state Y in which the cell begins."""
    states = case[1].shape[1] - 3
    found = np.ones(states + 3)
    found[:states] = z[:states]
    angle = z[len(z) - 1] if len(z) > states + len(case[0]) else 0.0
    found[states], found[states + 1] = cos(angle), sin(angle)
    return found


def starts(case: Any, z: Vector) -> Matrix:
    """Return the state Y in which each phase begins, shape (P, W)."""
    generators, switches = case[1], case[2]
    states = generators.shape[1] - 3
    found = np.empty((len(generators), states + 3))
    found[0] = begun(case, z)
    for p in range(len(generators) - 1):
        end = found[p] + less_one(generators[p], z[states + p]) @ found[p]
        found[p + 1] = switches[p] @ end
    return found


def state_at(case: Any, z: Vector, p: int, t: float) -> Vector:
    """Return the state Y at a time from the beginning of a phase."""
    begin = starts(case, z)[p]
    found: Vector = begin + less_one(case[1][p], t) @ begin
    return found


def left_sides(along: Any, z: Vector, q: float, R: Vector) -> None:
    """Fill R with the left sides of the equations at a value of the parameter."""
    equations(case_at(along, q), along[3], z, R, np.empty((len(z), len(z))))


def equations(case: Any, divided: Any, z: Vector, R: Vector, J: Matrix) -> None:
    """Fill R with the left sides of the equations of a cell, J with their derivatives by z."""
    generators, switches, events = case[1], case[2], case[3]
    sign, duration = case[5][0], case[5][2]
    count, states, last = len(generators), generators.shape[1] - 3, len(z) - 1
    Y, by = begun(case, z), np.zeros((states + 3, len(z)))
    for i in range(states):
        by[i, i] = 1.0
    if last == states + count:
        by[states, last], by[states + 1, last] = -Y[states + 1], Y[states]
    for p in range(count):
        row, s = states + p, z[states + p]
        grown = less_one(generators[p], s)
        gain, gain_by = grown @ Y, grown @ by
        Y, by = Y + gain, by + gain_by
        rate = generators[p] @ Y
        by[:, row] += rate
        R[row], J[row] = np.dot(events[p], Y), events[p] @ by
        if divided[p] != 0:
            R[row], J[row] = np.dot(events[p], gain) / s, events[p] @ gain_by / s
            J[row, row] += (np.dot(events[p], rate) - R[row]) / s
        Y, by = switches[p] @ Y, switches[p] @ by
    R[:states] = z[:states] - sign * Y[:states]
    J[:states] = -sign * by[:states]
    for i in range(states):
        J[i, i] += 1.0
    if last == states + count:
        R[last] = z[states:last].sum() - duration
        J[last] = 0.0
        J[last, states:last] = 1.0


def factorise(A: Matrix, rows: Any) -> bool:
    """Factorise as `linear.factorise` does, by whole rows: of many modes that is quicker."""
    n = len(A)
    for k in range(n):
        pivot = k + int(np.argmax(np.abs(A[k:, k])))
        rows[k] = pivot
        if A[pivot, k] == 0 or not np.isfinite(A[pivot, k]):
            return False
        if pivot != k:
            row = A[k].copy()
            A[k], A[pivot] = A[pivot], row
        A[k + 1 :, k] /= A[k, k]
        A[k + 1 :, k + 1 :] -= A[k + 1 :, k : k + 1] * A[k, k + 1 :]
    return True


def end_rates(case: Any, z: Vector) -> Matrix:
    """Return nothing: perturbations of a body are mapped from its own states."""
    return np.empty((0, 2))


def cell_map(
    case: Any, z: Vector, reached: Matrix, speed: float
) -> tuple[Matrix, Matrix, Vector]:
    """Return what a cell makes of perturbations of X; see `stability.cell_map`."""
    generators, switches, events, omega = case[1], case[2], case[3], case[5][1]
    count, states = len(generators), generators.shape[1] - 3
    found, size, crossed = np.eye(states), np.eye(states), np.empty(count)
    first = begun(case, z)
    Y = first
    for p in range(count):
        grown = less_one(generators[p], z[states + p])
        Y = Y + grown @ Y
        before = generators[p] @ Y
        Y = switches[p] @ Y
        behind = generators[p + 1] @ Y if p + 1 < count else case[5][0] * generators[0] @ first
        gradient, waves = events[p, :states], events[p, states : states + 2]
        scale = np.dot(np.abs(gradient), np.abs(before[:states])) + omega * np.abs(waves).sum()
        rate = np.dot(events[p], before)
        crossed[p] = abs(rate) / scale if scale > 0 else 0.0
        jump = (behind - switches[p] @ before)[:states]
        across = switches[p, :states, :states] + np.outer(jump, gradient) / rate
        through = np.eye(states) + grown[:states, :states]
        found = across @ (through @ found)
        size = np.abs(across) @ (np.abs(through) @ size) / min(1.0, crossed[p])
    return found, size, crossed


def beside_minus_one(own: Matrix) -> float:
    """Return what has the sign of the product of all multipliers plus 1: the least of these."""
    return least_factor(np.linalg.eigvals(own.astype(np.complex128)) + 1)


def beyond_one(own: Matrix) -> float:
    """Return the same of what the multipliers are in pairs, together, beyond 1."""
    values, found = np.linalg.eigvals(own.astype(np.complex128)), []
    for i in range(len(values)):
        for j in range(i):
            found.append(values[i] * values[j] - 1)
    return least_factor(np.array(found))


def least_factor(factors: Any) -> float:
    """Return the least size of factors, which are real or in pairs, with their joint sign."""
    least, turned = np.inf, 1.0 + 0.0j
    for factor in factors:
        size = abs(factor)
        least = min(least, size)
        turned *= factor / size if size > 0 else 1.0
    return copysign(least, turned.real)
