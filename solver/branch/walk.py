"""Steps along a branch until an event: the inner loop of continuation.

Plain Python, or compiled by numba with the exact equations.
"""

from math import isnan
from typing import Any

import numpy as np

from ..arrays import Matrix, Vector
from ..flow import divided, exact_system, responses
from ..iteration import iteration, linear
from ..kernels import linking
from ..kernels.family import Family
from ..rows import joints as joining
from ..stability import cell_map as cell_maps
from ..stability.cell_map import cell_map, end_rates
from . import extended, watch
from .extended import case_at, corrected, tangent
from .watch import watched

#: Shortest and longest step, in scaled coordinates; the factor by which steps grow.
LEAST_STEP, MOST_STEP, GROWTH = 1e-9, 0.1, 1.3

#: Least cosine of the angle between tangents of a step; most of the ratio of corrections.
TURN, FIRST_FALL = 0.95, 0.1

#: Size of a scaled unknown, meant to be about 1, at which the scales are chosen anew.
OUTGROWN = 8.0

#: Part of a step, next to an orbit that is known, in which no double root is looked for.
DIP = 1e-3

#: Distance of multipliers from a bifurcation that is rounding, as without damping.
NEUTRAL = 1e-9

#: Size of a watched form, without units, that is rounding.
LOST = 1e-12

# Why a walk ends: the arrays are full; an event happens in the last step, or the parameter
# leaves its interval; the step cannot get smaller; an unknown has outgrown its scale.
FULL, EVENT, STUCK, GROWN = 0, 1, 2, 3

#: What may be asked for: see `asked`.
CORRECTED, PLACED, WALKED = range(3)

#: The last monitors are of the whole orbit: the tangent's component of the parameter;
#: ``det(M + 1)``; the least pivot of the bordered Jacobian with the sign of its determinant,
#: zero where branches meet; the number of multipliers outside the unit circle; the product of
#: ``lambda_i lambda_j - 1``.  For the multipliers of a body see `bodies.equations`.
OWN = 5
FOLD, FLIP, MEETS, OUTSIDE, PAIRS = range(OWN)


def stepped(along: Any, y: Vector, direction: Vector, length: float) -> tuple[bool, float, Any]:
    """Predict along the tangent and correct: whether that converges, its `fall`, the orbit."""
    orbit = y + length * direction / along[4]
    converged, fall = corrected(along, orbit, direction)
    return converged, fall, orbit


def multiplier_monitors(matrix: Matrix) -> tuple[float, float, float]:
    """Return ``det(M + 1)``, the number of multipliers outside the unit circle, and a product.

    The product is that of ``lambda_i lambda_j - 1``: zero where a pair has modulus 1.
    """
    minus = float(np.linalg.det(matrix + np.eye(len(matrix))))
    values, product = np.linalg.eigvals(matrix.astype(np.complex128)), complex(1.0, 0.0)
    if len(matrix) == 2:
        area = matrix[0, 0] * matrix[1, 1] - matrix[0, 1] * matrix[1, 0]
        return minus, outside(values), float(area - 1)
    for i in range(len(values)):
        for j in range(i):
            product *= values[i] * values[j] - 1
    return minus, outside(values), product.real


def outside(values: Any) -> float:
    """Return the number of multipliers outside the unit circle by more than rounding."""
    return float(np.sum(np.abs(values) > 1 + NEUTRAL))


def tangent_and_monitors(
    along: Any, table: Any, y: Vector, border: Vector, extremes: Matrix, maps: Any
) -> tuple[Vector, Vector]:
    """Return the tangent and the monitors at an orbit; fill in its extremes and maps.

    extremes : ndarray, shape (2, 2)
        See `watch.watched`.
    maps : ndarray, shape (2, n, n) or (2, 0, 0)
        The derivative of the map over the cell, and its size; see `cell_map`.
    """
    n, count = len(y) - 1, len(along[0])
    direction, meets = tangent(along, y, border)
    case, values = case_at(along, y[n]), np.empty((len(table), 3))
    watched(case, table, y[:n], values, extremes)
    speed = max(abs(extremes[1, 0]), abs(extremes[1, 1]))
    through, size, _ = cell_map(case, y[:n], end_rates(case, y[:n]), speed)
    if maps.size > 0:
        maps[0], maps[1] = through, size
    monitors = np.empty(values.size + count + OWN)
    monitors[: values.size] = values.ravel()
    monitors[values.size : values.size + count] = y[along[5] :][:count]
    orbit = monitors[values.size + count :]
    orbit[:] = np.nan
    orbit[FOLD], orbit[MEETS] = direction[n], meets
    if np.isfinite(through).all():  # where an event is touched, perturbations are not mapped
        orbit[FLIP], orbit[OUTSIDE], orbit[PAIRS] = multiplier_monitors(along[6] * through)
    return direction, monitors


def happens(before: float, after: float, i: int) -> bool:
    """Whether monitor `i` shows an event in a step; `i` is counted from the first of `OWN`.

    Forms and durations (negative `i`) do where they fall below zero, but for one that is zero
    all along: of contacts that switch together.
    """
    if i < 0:
        is_lost = abs(before) <= LOST and abs(after) <= LOST  # not if one is none
        return after < 0 and not before < 0 and not is_lost
    if i == OUTSIDE:
        return abs(after - before) > 0
    return i != PAIRS and before * after < 0 and min(abs(before), abs(after)) > NEUTRAL


def dips(before: Vector, between: Vector, after: Vector, back: float, ahead: float) -> float:
    """Return where in two steps a monitor may have two roots, from the orbit between; else 0.

    A monitor has the same sign at the three orbits, but the parabola through its values, or
    through their squares, changes it.  (Squares, as the least factor of a complex pair is not
    smooth.)  A minimum next to one of the orbits does not count.
    """
    orbit, nearest = len(between) - OWN, 0.0
    for i in range(len(between)):
        least = min(abs(before[i]), abs(between[i]), abs(after[i]))
        alike = before[i] * between[i] > 0 and between[i] * after[i] > 0
        if not alike or i == orbit + OUTSIDE or (i >= orbit and least <= NEUTRAL):
            continue
        for power in range(1, 3):
            left, middle, right = abs(before[i]), abs(between[i]), abs(after[i])
            left, middle, right = left**power, middle**power, right**power
            fell, rose = (middle - left) / back, (right - middle) / ahead
            bend = (rose - fell) / (back + ahead)
            slope = fell + bend * back
            at = -slope / (2 * bend) if bend > 0 else 0.0
            inside = min(at + back, abs(at), ahead - at) > DIP
            if inside and middle + slope * at / 2 < 0:
                nearest = min(nearest, at) if nearest != 0 else at
    return nearest


def walk(
    along: Any, table: Any, length: float, most: float, Y: Matrix, D: Matrix, V: Matrix,
    E: Any, T: Any, S: Vector,
) -> tuple[int, int, float]:  # fmt: skip
    """Step along a branch, from the orbit in the first row of the arrays.

    Parameters
    ----------
    along, table
        See `extended` and `watch`.
    length : float
        The first step to try.
    most : float
        The most that a step changes the coordinate of the parameter.
    Y, D : ndarray, shape (room, unknowns + 1)
        Unknowns and tangents of the orbits.
    V, E, T : ndarray
        Monitors, extremes and maps of each; see `tangent_and_monitors`.
    S : ndarray, shape (room,)
        The length of the step to each.

    Returns
    -------
    last : int
        The row of the last orbit.
    why : int
        Why the walk ends.
    length : float
        The next step to try.
    """
    last, n = 0, Y.shape[1] - 1
    while last + 1 < len(Y):
        rate = abs(D[last, n])
        length = min(length, MOST_STEP if rate == 0 else min(MOST_STEP, most / rate))
        converged, fall, y = stepped(along, Y[last], D[last], length)
        accepted = converged and fall <= FIRST_FALL
        if accepted:
            direction, monitors = tangent_and_monitors(
                along, table, y, D[last], E[last + 1], T[last + 1]
            )
            accepted = np.dot(direction, D[last]) >= TURN
        if not accepted:
            length /= 2
            if length < LEAST_STEP:
                return last, STUCK, length
            continue
        if last > 0:
            at = dips(V[last - 1], V[last], monitors, S[last], length)
            if at != 0:  # there next
                last, length = (last - 1, S[last] + at) if at < 0 else (last, at)
                continue
        last += 1
        Y[last], D[last], V[last], S[last] = y, direction, monitors, length
        event = abs(y[n]) > 1
        for i in range(len(monitors)):
            event = event or happens(V[last - 1, i], V[last, i], i - (len(monitors) - OWN))
        if event:
            return last, EVENT, length
        length *= GROWTH
        for j in range(along[5] + len(along[0])):  # but for the phase of the forcing
            if abs(y[j] * along[4][j]) > OUTGROWN or isnan(y[j]):
                return last, GROWN, length
    return last, FULL, length


def asked(
    task: int, along: Any, table: Any, length: float, most: float, Y: Matrix, D: Matrix,
    V: Matrix, E: Any, T: Any, S: Vector,
) -> tuple[int, int, float]:  # fmt: skip
    """Correct the first orbit, or fill in its tangent and monitors, or walk on from it.

    All is asked for by one function: each that Python calls is compiled with all that it calls.

    Parameters
    ----------
    task : int
        `CORRECTED`: orthogonally to the first row of D; it is `STUCK` without an orbit.
        `PLACED`: on the side of that row.  `WALKED`: see `walk`.
    along, table, length, most, Y, D, V, E, T, S
        See `walk`, and there for what is returned.
    """
    if task == CORRECTED:
        converged, _, y = stepped(along, Y[0], D[0], 0.0)
        Y[0] = y
        return 0, FULL if converged else STUCK, length
    if task == PLACED:
        direction, monitors = tangent_and_monitors(along, table, Y[0], D[0], E[0], T[0])
        D[0], V[0] = direction, monitors
        return 0, FULL, length
    return walk(along, table, length, most, Y, D, V, E, T, S)


def linked(equations: Any, make: linking.Make) -> dict[str, Any]:
    """Return the functions of a branch, plain or compiled."""
    return linking.made((*MODULES, equations), {}, make)


#: What they are made of, and the functions.
NUMBERS = joining, divided, responses, iteration, linear
MODULES = (*NUMBERS, exact_system, cell_maps, watch, extended)
FAMILY = Family(linked, MODULES)
