"""The exact equations of a body along a parameter, over arrays, for the steps of a branch.

The state is ``Y = (X, cos, sin, 1)``: X has the modes and the memory, cos and sin are of the
phase of the forcing.  In phase p ``Y' = G_p Y``, and ``S_p`` is the switch at its end:

    Y_(p+1) = S_p exp(G_p s_p) Y_p,    e_p exp(G_p s_p) Y_p = 0,    X_0 = sigma X_P.

Unknowns are ``X_0``, the durations ``s_p`` and, with a forcing, its phase at the start.
``X_0`` could be eliminated by periodicity, but not at a fold, where a multiplier is 1.

The functions stand for those of the same names in `extended`, `cell_map` and `walk`.  Plain
Python, or compiled by numba.
"""

from math import copysign, cos, sin
from typing import Any

import numpy as np

from ...arrays import Complex, Matrix, Vector
from ...iteration.linear import product
from ...stability.cell_map import lasting
from ..extended import A_MOMENT, AN_INSTANT, DIFFERENCE, series_at
from ..walk import outside
from .exponential import SHORT, exp_less_three_terms, exp_less_two_terms, norm
from .ways import gained

#: Modulus of a factor below which it counts beside the least one.
NEXT = 0.1


def case_at(along: Any, q: float) -> Any:
    """Return the arrays of the cell at a value of the parameter.

    In order: the kinds of phases; generators and switches, shape (P, W, W); events, (P, W);
    displacement and velocity of the first contact, (P, 2, W); sigma, angular frequency and
    duration of the cell; watched forms, (R, W); known eigenbases, see `arrays.Known`.
    """
    count, width = len(along[0]), along[1][0]
    poles, basis, inverse, constant, varying = along[7]
    values = constant.copy()
    values[varying] = series_at(along[2], q)
    square, line = count * width * width, count * width
    remaining = values[2 * square :]
    return (
        along[0],
        values[:square].reshape(count, width, width),
        values[square : 2 * square].reshape(count, width, width),
        remaining[:line].reshape(count, width),
        remaining[line : 3 * line].reshape(count, 2, width),
        remaining[3 * line : 3 * line + 3],
        remaining[3 * line + 3 :].reshape(-1, width),
        (poles, basis, inverse),
    )


def initial_state(case: Any, z: Vector) -> Vector:
    """Return the state Y in which the cell begins."""
    states = case[1].shape[1] - 3
    state = np.ones(states + 3)
    state[:states] = z[:states]
    angle = z[len(z) - 1] if len(z) > states + len(case[0]) else 0.0
    state[states], state[states + 1] = cos(angle), sin(angle)
    return state


def initial_states(case: Any, z: Vector) -> Matrix:
    """Return the state Y in which each phase begins, shape (P, W)."""
    generators, switches = case[1], case[2]
    states = generators.shape[1] - 3
    starts = np.empty((len(generators), states + 3))
    starts[0] = initial_state(case, z)
    for p in range(len(generators) - 1):
        starts[p + 1] = switches[p] @ state_after(case, p, z[states + p], starts[p])
    return starts


def state_after(case: Any, p: int, t: float, Y: Vector) -> Vector:
    """Return a state a time later in a phase."""
    return Y + gained(case, p, t, Y.reshape(-1, 1))[:, 0]


def state_at(case: Any, z: Vector, p: int, t: float) -> Vector:
    """Return the state Y at a time from the beginning of a phase."""
    return state_after(case, p, t, initial_states(case, z)[p])


def residual_along(along: Any, z: Vector, q: float, R: Vector) -> None:
    """Fill R with the residual of the equations at a value of the parameter."""
    residual_and_jacobian(case_at(along, q), along[3], z, R, np.empty((len(z), 0)))


def residual_and_jacobian(case: Any, divided: Any, z: Vector, R: Vector, J: Matrix) -> None:
    """Fill R with the residual of the equations of a cell, J with its derivatives by z.

    A J without columns is not filled.
    """
    generators, switches, events = case[1], case[2], case[3]
    sign, duration, by = case[5][0], case[5][2], J.shape[1] > 0
    count, states, last = len(generators), generators.shape[1] - 3, len(z) - 1
    Y = np.zeros((states + 3, 1 + J.shape[1]))  # the state, and its derivatives
    Y[:, 0] = initial_state(case, z)
    if by:
        for i in range(states):
            Y[i, 1 + i] = 1.0
    if by and last == states + count:
        Y[states, 1 + last], Y[states + 1, 1 + last] = -Y[states + 1, 0], Y[states, 0]
    for p in range(count):
        row, start = states + p, Y
        s = z[row] if z[row] != 0 else AN_INSTANT
        gain = gained(case, p, s, Y)
        Y = Y + gain
        rate = generators[p] @ Y[:, 0].copy()
        if by:
            Y[:, 1 + row] += rate
        event_row = events[p] @ (Y if divided[p] == 0 else gain / s)
        if divided[p] > 1:
            event_row = divided_gain(case, divided[p], p, s, start)
        if divided[p] == 3:  # where it ends: on the surface, which its gain does not say
            gradient = events[p, :states]
            Y[:states] -= np.outer(gradient, events[p] @ Y) / np.dot(gradient, gradient)
        R[row], J[row] = event_row[0], event_row[1:]
        if by and divided[p] != 0:
            J[row, row] += divided_slope(
                case, divided[p], p, s, start[:, :1].copy(), rate, R[row]
            )
        Y = switches[p] @ Y
    R[:states] = z[:states] - sign * Y[:states, 0]
    J[:states] = -sign * Y[:states, 1:]
    if last == states + count:
        R[last], J[last] = z[states:last].sum() - duration, 0.0
    if by:
        for i in range(states):
            J[i, i] += 1.0
        if last == states + count:
            J[last, states:last] = 1.0


def divided_slope(
    case: Any, times: int, p: int, s: float, Y: Matrix, rate: Vector, value: float
) -> float:
    """Return the derivative of a divided event by the duration; Y is the state at the start.

    Where terms would cancel, by its limit or by differences.
    """
    if times > 1:
        h = DIFFERENCE / norm(case[1][p])
        ahead, back = (
            divided_gain(case, times, p, s + h, Y),
            divided_gain(case, times, p, s - h, Y),
        )
        return float((ahead[0] - back[0]) / (2 * h))
    if abs(s) < A_MOMENT:
        return float(np.dot(case[3][p], case[1][p] @ rate) / 2)
    return float((np.dot(case[3][p], rate) - value) / s)


def divided_gain(case: Any, times: int, p: int, s: float, Y: Matrix) -> Vector:
    """Return the change of an event over its phase, divided by the duration 2 or 3 times.

    The phase begins where the event and its first derivative vanish; of 3 times, the second as
    well.  Their terms of the exponential are left out; of a long phase not the last one.
    """
    short = times == 3 and norm(case[1][p]) * abs(s) <= SHORT
    tail = exp_less_three_terms(case[1][p], s) if short else exp_less_two_terms(case[1][p], s)
    change: Vector = case[3][p] @ (tail @ Y) / s**times
    return change


def end_rates(case: Any, z: Vector) -> Matrix:
    """Return no rates: `cell_map` of a body computes its own."""
    return np.empty((0, 2))


def cell_map(
    case: Any, z: Vector, reached: Matrix, speed: float
) -> tuple[Matrix, Matrix, Vector]:
    """Return the derivative of the map of X over a cell; see `stability.cell_map`."""
    generators, switches, events, omega = case[1], case[2], case[3], case[5][1]
    count, states = len(generators), generators.shape[1] - 3
    shape = count, states, states
    steps, sizes, crossed = np.empty(shape), np.empty(shape), np.empty(count)
    start = initial_state(case, z)
    Y = start
    for p in range(count):
        grown = gained(case, p, z[states + p], np.eye(states + 3))
        Y = Y + grown @ Y
        before = generators[p] @ Y
        Y = switches[p] @ Y
        behind = generators[p + 1] @ Y if p + 1 < count else case[5][0] * generators[0] @ start
        gradient, waves = events[p, :states], events[p, states : states + 2]
        scale = np.dot(np.abs(gradient), np.abs(before[:states])) + omega * np.abs(waves).sum()
        rate = np.dot(events[p], before)
        crossed[p] = abs(rate) / scale if scale > 0 else 0.0
        jump = (behind - switches[p] @ before)[:states]
        across = switches[p, :states, :states] + np.outer(jump, gradient) / rate
        through = np.eye(states) + grown[:states, :states]
        steps[p] = across @ through
        sizes[p] = np.abs(across) @ np.abs(through) / min(1.0, crossed[p])
    matrix, size = product(steps, sizes)
    return matrix, size, crossed


def multiplier_monitors(matrix: Matrix) -> tuple[float, float, float]:
    """Return the monitors of multipliers, as `walk.multiplier_monitors` does.

    In place of products, which overflow for many multipliers, their least factors with the sign
    of the product: of ``lambda_i + 1``, and of ``1 - lambda_i lambda_j``.
    """
    lasts = lasting(matrix)
    matrix = matrix[lasts][:, lasts]
    values = np.linalg.eigvals(matrix.astype(np.complex128)).astype(np.complex128)
    beneath = np.tril(np.ones(matrix.shape), -1).ravel() > 0
    pairs = np.outer(values, values).ravel()[beneath]
    return least_factors(values + 1), outside(values), least_factors(1 - pairs)


def least_factors(factors: Complex) -> float:
    """Return the least modulus of factors, with the sign of their (real) product.

    Times that of the next over `NEXT`, if less than 1: where both vanish at once, each is a
    square root of a smooth function, and their product is smooth.
    """
    if len(factors) == 0:
        return 1.0
    sizes = np.abs(factors)
    turned = np.prod(factors / np.where(sizes > 0, sizes, 1.0))
    least = np.sort(sizes)
    beside = min(least[1] / NEXT, 1.0) if len(least) > 1 else 1.0
    return float(copysign(least[0] * beside, turned.real))
