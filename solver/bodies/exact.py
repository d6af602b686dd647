"""The exact equations of a cell of a body, for the durations and the phase of the forcing.

At given times everything else is linear: the flow of each phase in its eigenbasis, the
switches, and periodicity, ``X(0) = sigma X(T)`` for the state with its memory.  There remain
one equation for each event, and the length of the cell.
"""

from dataclasses import dataclass
from functools import reduce
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from .part import angles_of, kept_by_times, later, parts_of, phase_map, rates, wave

if TYPE_CHECKING:
    from ..scenes.bodies.cell import BodyCell


#: The rounding error in an eigenbasis is at most this part of its condition, in units of eps.
LOST = 1 / 32

#: Largest ratio of a periodic state to the inhomogeneity of the map over a cell.  Beyond, it is
#: a quotient of rounding errors, in a direction that periodicity does not determine.
UNBOUNDED = 1e12


@dataclass(frozen=True, eq=False)
class Evaluation:
    """The exact equations at given times.

    Parameters
    ----------
    residual : ndarray
        The events, and the duration of the cell less that of the forcing, if something
        forces.
    jacobian : ndarray
        By durations and phase.
    starts : ndarray, shape (P, n)
        ``X = (y, memory)`` where each phase begins.
    """

    residual: Vector
    jacobian: Matrix
    starts: Matrix


Maps = list[tuple[Matrix, Matrix]]


def _through(cell: "BodyCell", maps: Maps, turns: Vector) -> tuple[Matrix, Matrix]:
    """Return the affine map over a cell: of the state at its start, and of the first `wave`."""
    passed, offset = [], np.zeros_like(maps[0][1])
    for p, (part, (flow, by_wave)) in enumerate(zip(parts_of(cell), maps, strict=True)):
        closing = part.closing
        offset = flow @ offset + by_wave @ later(turns[..., p])
        offset = closing.state @ offset + closing.inputs @ later(turns[..., p + 1])
        passed += [flow] if closing.keeps else [flow, closing.state]
    closed = reduce(lambda before, each: each @ before, passed)
    return cell.sign * closed, cell.sign * offset


def _closed(closed: Matrix, offset: Matrix) -> Matrix:
    """Return the periodic state, from the matrix and the inhomogeneity of the map over a cell.

    NaN where periodicity does not determine it, as of a body that moves freely.
    """
    try:
        state = np.linalg.solve(np.eye(closed.shape[-1]) - closed, offset)
    except np.linalg.LinAlgError:
        if closed.ndim > 2:
            return np.array([_closed(*each) for each in zip(closed, offset, strict=True)])
        return np.full(offset.shape, np.nan)
    sizes, added = (np.abs(q).max(axis=(-2, -1), keepdims=True) for q in (state, offset))
    return np.where(sizes > UNBOUNDED * added, np.nan, state)


def events_by_wave(cell: "BodyCell", durations: Vector) -> Matrix:
    """Return the events at given durations as ``A cos(phi) + B sin(phi) + C``.

    Parameters
    ----------
    cell : BodyCell
    durations : ndarray, shape (..., P)

    Returns
    -------
    ndarray, shape (..., P, 3)
    """
    parts = parts_of(cell)
    angles = np.zeros((*durations.shape[:-1], len(parts) + 1))
    angles[..., 1:] = cell.omega * np.cumsum(durations, axis=-1)
    maps = [phase_map(part, durations[..., p]) for p, part in enumerate(parts)]
    X = _closed(*_through(cell, maps, angles))
    coefficients = np.empty((*durations.shape, 3))
    for p, (part, (flow, by_wave)) in enumerate(zip(parts, maps, strict=True)):
        X = flow @ X + by_wave @ later(angles[..., p])
        rotation, closing = later(angles[..., p + 1]), part.closing
        coefficients[..., p, :] = closing.gradient @ X + closing.waves @ rotation
        X = closing.state @ X + closing.inputs @ rotation
    return coefficients


def _waves(cell: "BodyCell", times: Vector) -> Matrix:
    """Return `wave` where phases begin and the last ends, and its derivatives by the times.

    Shape (..., P + 1, 3, 1 + times).
    """
    angles, count = angles_of(cell, times), len(cell.phases)
    waves = np.zeros((*angles.shape, 3, 1 + times.shape[-1]))
    waves[..., 0, 0], waves[..., 1, 0], waves[..., 2, 0] = np.cos(angles), np.sin(angles), 1.0
    angles_by = cell.omega * np.tri(count + 1, times.shape[-1], -1)
    if cell.forced:
        angles_by[:, -1] = 1.0
    waves[..., 0, 1:] = -waves[..., 1, :1] * angles_by
    waves[..., 1, 1:] = waves[..., 0, :1] * angles_by
    return waves


def _passed(cell: "BodyCell", maps: Maps, waves: Matrix, X: Matrix) -> tuple[Matrix, ...]:
    """Follow a state through a cell, with its derivatives by the times.

    Parameters
    ----------
    waves : ndarray, shape (..., P + 1, 3, 1 + times)
        See `_waves`.
    X : ndarray, shape (..., n, 1 + times)

    Returns
    -------
    events : ndarray, shape (..., P, 1 + times)
    starts : ndarray, shape (..., P, n)
        Where each phase begins.
    end : ndarray, shape (..., n, 1 + times)
        The end of the cell, mirrored if cells are.
    """
    events, starts = [], []
    for p, (part, (flow, by_wave)) in enumerate(zip(parts_of(cell), maps, strict=True)):
        starts.append(X[..., 0])
        begins, ends, closing = waves[..., p, :, :], waves[..., p + 1, :, :], part.closing
        X = flow @ X + by_wave @ begins
        X[..., 1 + p] += rates(part, X[..., 0], ends[..., 0])
        events.append(closing.gradient @ X + (closing.waves @ ends))
        X = closing.state @ X + closing.inputs @ ends
    return np.stack(events, axis=-2), np.stack(starts, axis=-2), cell.sign * X


def at_times(cell: "BodyCell", times: Vector) -> Evaluation:
    """Return residual, Jacobian and states of the exact equations at given times.

    Parameters
    ----------
    cell : BodyCell
    times : ndarray, shape (..., times)
        Durations and, if something forces, the phase of the forcing.  Of several a stack.
    """
    parts, waves, angles = parts_of(cell), _waves(cell, times), angles_of(cell, times)
    maps = [phase_map(part, times[..., p]) for p, part in enumerate(parts)]
    closed, offset = _through(cell, maps, angles - angles[..., :1])
    X = np.zeros((*offset.shape[:-1], waves.shape[-1]))
    X[..., :1] = _closed(closed, offset) @ waves[..., 0, :, :1]
    *_, moved = _passed(cell, maps, waves, X)
    X[..., 1:] = _closed(closed, moved[..., 1:])
    events, starts, _ = _passed(cell, maps, waves, X)
    residual, jacobian = events[..., 0], events[..., 1:]
    if cell.forced:
        excess = times[..., :-1].sum(axis=-1, keepdims=True) - cell.duration
        ones = np.broadcast_to(np.append(np.ones(len(parts)), 0.0), jacobian[..., :1, :].shape)
        residual = np.concatenate([residual, excess], axis=-1)
        jacobian = np.concatenate([jacobian, ones], axis=-2)
    return Evaluation(residual, jacobian, starts)


evaluated = kept_by_times(8)(at_times)


def left_open(cell: "BodyCell", times: Vector) -> float:
    """Return by how much the state at given times is not periodic, relative to its size.

    The switches of `parts_of` shift directions that periodicity does not determine.  Where the
    shift is more than rounding, there is no orbit.
    """
    starts, part = evaluated(cell, times).starts, parts_of(cell)[-1]
    theta, s = angles_of(cell, times), float(times[len(cell.phases) - 1])
    flow, by_wave = phase_map(part, s)
    X = flow @ starts[-1] + by_wave @ wave(theta[-2])
    X = part.switch.state @ X + part.switch.inputs @ wave(theta[-1])
    return float(np.abs(cell.sign * X - starts[0]).max() / (np.abs(starts).max() or 1.0))


def seen(cell: "BodyCell", times: Vector, p: int, u: Vector, rows: Matrix) -> Matrix:
    """Return linear forms of ``(y, cos, sin, 1, memory)`` on phase `p`, at local times.

    Parameters
    ----------
    u : ndarray
        Local times in [0, 1].
    rows : ndarray
        The forms, a row each.

    Returns
    -------
    ndarray, shape (len(rows), len(u))
    """
    part = parts_of(cell)[p]
    states = part.lawful.A.shape[0]
    start, theta = evaluated(cell, times).starts[p], float(angles_of(cell, times)[p])
    t = float(times[p]) * np.asarray(u, dtype=float)
    inputs = np.concatenate([wave(theta), start[states:]])
    angle = theta + cell.omega * t
    waves, steady = np.array([np.cos(angle), np.sin(angle)]), rows[:, states + 2 :] @ inputs[2:]
    free = part.flow.seen(rows[:, :states], start[:states], inputs, t)
    return np.asarray(free + rows[:, states : states + 2] @ waves + steady[:, None])


def magnitudes(cell: "BodyCell", times: Vector, p: int) -> Vector:
    """Return the sums of the moduli of the terms of forms at the start of a phase.

    The terms are those by modes and inputs.  Where two poles nearly coincide, they are those by
    poles, times the digits that the condition of the eigenbasis costs.
    """
    part, at_times = parts_of(cell)[p], evaluated(cell, times)
    rows, states = part.lawful.rows, part.lawful.A.shape[0]
    start, theta = at_times.starts[p], float(angles_of(cell, times)[p])
    Y = np.concatenate([start[:states], wave(theta), start[states:]])
    rows, half = rows[: len(rows) - len(cell.memory)], part.flow.upper
    by_poles = np.abs(rows[:, :states] @ half.basis) @ np.abs(half.inverse @ start[:states])
    by_mode = np.abs(rows) @ np.abs(Y)
    return np.asarray(np.maximum(by_mode, by_poles * part.flow.condition * LOST))


def event_sizes(cell: "BodyCell", times: Vector) -> Vector:
    """Return the sum of the moduli of the terms of the event at the end of each phase."""
    theta, starts = angles_of(cell, times), evaluated(cell, times).starts
    sizes = np.empty(len(starts))
    for p, (part, s) in enumerate(zip(parts_of(cell), times, strict=False)):
        flow, by_wave = phase_map(part, float(s))
        end = flow @ starts[p] + by_wave @ wave(theta[p])
        event, waves = part.switch.gradient, part.switch.waves
        sizes[p] = np.abs(event) @ np.abs(end) + np.abs(waves) @ np.abs(wave(theta[p + 1]))
    return sizes
