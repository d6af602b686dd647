"""A phase of a body in modal coordinates, where its eigenbasis is known, over arrays.

The poles are then uncoupled: a step in time costs O(m) for m poles, that of the state O(m^2).
Where no eigenbasis is known, the coordinates are the state Y itself.

A *way* is the tuple of the generator of Y, the poles, their inputs, the frequency of the
forcing, the matrix from coordinates to Y, and its inverse.

Plain Python, or compiled by numba.
"""

from math import ceil, log2
from typing import Any

import numpy as np

from ...arrays import Matrix, Vector
from .exponential import (
    SHORT,
    answers,
    by_basis,
    doubled,
    drives_of,
    exp_less_one,
    norm,
    scales_of,
)

#: Parts of a phase for each 1 of ``|G| s``; fewest and most parts.
CLOSE, FEWEST, MOST = 2.0, 32, 1024

#: Most parts where an eigenbasis is known: those that matter are halved, see `watched`.
MOST_BY_BASIS = 128

#: Terms of a Taylor series within such a part.
EXPANDED = 14


def way_of(case: Any, p: int) -> Any:
    """Return the way of a phase; see `equations.case_at`."""
    generator, (poles, basis, inverse) = case[1][p], case[7]
    width = len(generator)
    omega = generator[width - 2, width - 3]
    if len(poles) == 0 or not np.abs(poles[p]).max() < np.inf:
        unit = np.eye(width)
        return generator, np.empty(0, np.complex128), np.empty((0, 0)), omega, unit, unit
    n, m = len(basis[p]), 2 * len(poles[p])
    scales = scales_of(generator, n)
    forth, back = np.zeros((width, m + width - n)), np.zeros((m + width - n, width))
    forth[:n, :m], back[:m, :n] = scales * basis[p], inverse[p] / scales.reshape(1, n)
    for i in range(width - n):
        forth[n + i, m + i] = back[m + i, n + i] = 1.0
    drives = drives_of(generator, inverse[p], n)
    return generator, poles[p].copy(), drives, omega, forth, back


def gained(case: Any, p: int, t: float, Y: Matrix) -> Matrix:
    """Return the change ``(exp(G t) - 1) Y`` of states, columns of shape (W, k), in a phase.

    By the eigenbasis if it is known, but not for a short time.
    """
    poles = case[7][0]
    if len(poles) > 0 and np.abs(poles[p]).max() * abs(t) > SHORT:
        way = way_of(case, p)
        change: Matrix = way[4] @ added(way, t, way[5] @ Y)
        return change
    return exp_less_one(case[1][p], t) @ Y


def added(way: Any, t: float, y: Matrix) -> Matrix:
    """Return the change of coordinates in a time, by column."""
    generator, poles, drives, omega, _, _ = way
    if len(poles) == 0:
        return exp_less_one(generator, t) @ y
    return by_basis(poles, drives, omega, answers(poles, omega, t), t, y)


def ahead(way: Any, t: float, y: Vector) -> Vector:
    """Return the coordinates after a time."""
    return y + added(way, t, y.reshape(-1, 1))[:, 0]


def along(way: Any, s: float, Y: Vector) -> Matrix:
    """Return the coordinates at equidistant times that resolve a phase, by column."""
    generator, poles, drives, omega, _, back = way
    states, has_basis = len(Y) - 3, len(poles) > 0
    size = norm(generator[:states, :states]) * abs(s)
    count = int(min(max(ceil(CLOSE * size), FEWEST), MOST_BY_BASIS if has_basis else MOST))
    coordinates, filled = np.empty((len(back), count + 1)), 1
    coordinates[:, 0] = back @ Y
    step = np.empty((0, 0)) if has_basis else exp_less_one(generator, s / count)
    responses = answers(poles, omega, s / count)
    while filled <= count:
        columns, t = min(filled, count + 1 - filled), filled * s / count
        block = coordinates[:, :columns].copy()
        if has_basis:
            block += by_basis(poles, drives, omega, responses, t, block)
            responses = doubled(responses, poles, omega, t)
        else:
            block += step @ block
            step = 2 * step + step @ step
        coordinates[:, filled : filled + columns] = block
        filled += columns
    return coordinates


def halves(way: Any, h: float) -> tuple[Any, Any]:
    """Return the propagators over 1/2, 1/4, ... of a step, down to a short one.

    Of poles their `answers`; without an eigenbasis ``exp(G t) - 1``.
    """
    generator, poles, _, omega, _, _ = way
    width = len(generator)
    size = norm(generator[: width - 3, : width - 3]) * abs(h) * CLOSE
    count = ceil(log2(size)) if size > 1 else 0
    if len(poles) > 0:
        responses = np.empty((count, 3, len(poles)), np.complex128)
        if count > 0:
            responses[count - 1] = answers(poles, omega, h / 2.0**count)
        for j in range(count - 2, -1, -1):
            responses[j] = doubled(responses[j + 1], poles, omega, h / 2.0 ** (j + 2))
        return np.empty((0, 0, 0)), responses
    exponentials = np.empty((count, width, width))
    if count > 0:
        exponentials[count - 1] = exp_less_one(generator, h / 2.0**count)
    for j in range(count - 2, -1, -1):
        exponentials[j] = exponentials[j + 1] @ exponentials[j + 1] + 2 * exponentials[j + 1]
    return exponentials, np.empty((0, 3, 0), np.complex128)


def over(way: Any, finer: tuple[Any, Any], j: int, t: float, y: Vector) -> Vector:
    """Return the coordinates after propagator j of `halves`, over its time t."""
    _, poles, drives, omega, _, _ = way
    if len(poles) == 0:
        coordinates: Vector = y + finer[0][j] @ y
        return coordinates
    return y + by_basis(poles, drives, omega, finer[1][j], t, y.reshape(-1, 1))[:, 0]


def moves_of(way: Any, h: float, y: Matrix) -> Matrix:
    """Return how far each pole may move in a time h from coordinates, by column; shape (m, k).

    A pole s at z, driven by d, moves by ``h (|s z| + |d|)`` at most.  One that is faster than
    the forcing moves with its steady answer, and circles about it.
    """
    _, poles, drives, omega, _, _ = way
    m, r, speeds = len(poles), len(y) - 2 * len(poles), np.abs(poles)
    inputs, driven = np.ascontiguousarray(y[2 * m :]), drives[:m] + 1j * drives[m:]
    is_fast, s = speeds > 2 * omega, poles.reshape(m, 1)
    steady = -driven / np.where(is_fast.reshape(m, 1), s, np.inf)
    square = np.where(is_fast, poles * poles + omega * omega, np.inf)
    cosine, sine = driven[:, r - 3], driven[:, r - 2]
    steady[:, r - 3] = -(poles * cosine + omega * sine) / square
    steady[:, r - 2] = -(poles * sine - omega * cosine) / square
    real = y[:m] - np.ascontiguousarray(steady.real) @ inputs
    imaginary = y[m : 2 * m] - np.ascontiguousarray(steady.imag) @ inputs
    wave = np.hypot(inputs[r - 3, 0], inputs[r - 2, 0])
    drift = omega * wave * (np.abs(steady[:, r - 3]) + np.abs(steady[:, r - 2]))
    for i in range(r):
        size = wave if r - 3 <= i < r - 1 else abs(inputs[i, 0])
        drift += np.where(is_fast, 0.0, size * np.abs(driven[:, i]))
    turns = np.where(is_fast, np.minimum(h * speeds, 2.0), h * speeds)
    circled = turns.reshape(m, 1) * np.sqrt(real * real + imaginary * imaginary)
    growth = np.exp(h * max(poles.real.max(), 0.0))
    moves: Matrix = growth * (circled + h * drift.reshape(m, 1))
    return moves


def may_change(way: Any, h: float, y: Vector, moves: Matrix, form: Vector) -> Vector:
    """Return how far a form may go in a time h, by its poles' `moves_of`, from any time."""
    m, omega, width = len(way[1]), way[3], len(y)
    sizes = np.sqrt(form[:m] * form[:m] + form[m : 2 * m] * form[m : 2 * m])
    forced = np.hypot(form[width - 3], form[width - 2]) * np.hypot(y[width - 3], y[width - 2])
    changes: Vector = sizes @ moves + h * omega * forced
    return changes


def expanded(way: Any, form: Vector) -> Matrix:
    """Return the Taylor coefficients in time of a form of Y, as forms of the coordinates.

    Shape (EXPANDED, len(coordinates)).
    """
    generator, poles, drives, omega, forth, _ = way
    m, width = len(poles), forth.shape[1]
    coefficients = np.empty((EXPANDED, width))
    coefficients[0] = form @ forth
    for j in range(1, EXPANDED):
        previous = coefficients[j - 1]
        if m == 0:
            coefficients[j] = previous @ generator / j
            continue
        real, imaginary = previous[:m], previous[m : 2 * m]
        coefficients[j, :m] = poles.real * real + poles.imag * imaginary
        coefficients[j, m : 2 * m] = poles.real * imaginary - poles.imag * real
        coefficients[j, 2 * m :] = previous[: 2 * m] @ drives
        coefficients[j, width - 3] += omega * previous[width - 2]
        coefficients[j, width - 2] -= omega * previous[width - 3]
        coefficients[j] /= j
    return coefficients
