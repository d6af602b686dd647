"""The exact equations of a cell of a body: unknown are the durations and the forcing's phase.

At given times everything else is linear: the flow of each phase in its eigenbasis, the
switches, and periodicity, ``X(0) = sigma X(T)`` for the state with its memory.  What is left is
one equation an event, and the length of the cell.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from .flow import Flow, flow_of
from .laws import Lawful, lawful
from .switch import Switch, switch

if TYPE_CHECKING:
    from ..scenes.bodies.cell import BodyCell


@dataclass(frozen=True, eq=False)
class Part:
    """A phase of a cell: the body under its laws, its flow, the switch that ends it."""

    lawful: Lawful
    flow: Flow
    switch: Switch


@dataclass(frozen=True, eq=False)
class Evaluation:
    """What the times of a cell say.

    Parameters
    ----------
    residual : ndarray, shape (P + 1,) or (P,)
        The events, and the duration of the cell less that of the forcing.
    jacobian : ndarray
        By durations and phase.
    starts : ndarray, shape (P, n)
        ``X = (y, memory)`` where each phase begins.
    """

    residual: Vector
    jacobian: Matrix
    starts: Matrix


@lru_cache(maxsize=32)
def parts_of(cell: "BodyCell") -> tuple[Part, ...]:
    """Return the phases of a cell.

    Raises
    ------
    BodyError
        If a law does not fix its force, or a phase has no eigenbasis.
    """
    found = []
    for p in range(len(cell.phases)):
        own = lawful(cell, p)
        found.append(Part(own, flow_of(own, cell.omega), switch(cell, p, own.rows)))
    return tuple(found)


def wave(angle: float) -> Vector:
    """Return the cosine, the sine, and 1."""
    return np.array([np.cos(angle), np.sin(angle), 1.0])


def turned(angle: float) -> Vector:
    """Return the derivatives of `wave` by the angle."""
    return np.array([-np.sin(angle), np.cos(angle), 0.0])


def angles_of(cell: "BodyCell", times: Vector) -> Vector:
    """Return the angle of the forcing where each phase begins, and where the last ends."""
    durations = times[: len(cell.phases)]
    first = float(times[-1]) if cell.forced else 0.0
    return first + cell.omega * np.concatenate([[0.0], np.cumsum(durations)])


def phase_map(part: Part, s: float) -> tuple[Matrix, Matrix]:
    """Return the map of ``X = (y, memory)`` over a phase, and what cos, sin, 1 add to it."""
    states = part.lawful.A.shape[0]
    memory = part.switch.state.shape[0] - states
    driven = part.flow.driven(s)
    along = np.eye(states + memory)
    along[:states, :states], along[:states, states:] = part.flow.matrix(s), driven[:, 3:]
    return along, np.vstack([driven[:, :3], np.zeros((memory, 3))])


def rates(part: Part, X: Vector, angle: float) -> Vector:
    """Return the derivative of ``X = (y, memory)`` by time."""
    states = part.lawful.A.shape[0]
    inputs = np.concatenate([wave(angle), X[states:]])
    found = np.zeros(len(X))
    found[:states] = part.lawful.A @ X[:states] + part.lawful.inputs @ inputs
    return found


def later(angle: float) -> Matrix:
    """Return the matrix that turns `wave` on by an angle."""
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])


Maps = list[tuple[Matrix, Matrix]]


def _closed(cell: "BodyCell", maps: Maps, turns: Vector) -> tuple[Matrix, Matrix]:
    """Return the inverse that closes the cell, and where it begins by the first `wave`."""
    size = len(maps[0][0])
    closed, offset = np.eye(size), np.zeros((size, 3))
    for p, (part, (along, by_wave)) in enumerate(zip(parts_of(cell), maps, strict=True)):
        across = part.switch.state
        offset = along @ offset + by_wave @ later(turns[p])
        offset = across @ offset + part.switch.inputs @ later(turns[p + 1])
        closed = across @ (along @ closed)
    back = np.linalg.inv(np.eye(size) - cell.sign * closed) * float(cell.sign)
    return np.asarray(back, dtype=float), np.asarray(back @ offset, dtype=float)


def events_by_wave(cell: "BodyCell", durations: Vector) -> Matrix:
    """Return the events at given durations as ``A cos(phi) + B sin(phi) + C``; shape (P, 3)."""
    parts = parts_of(cell)
    turns = cell.omega * np.concatenate([[0.0], np.cumsum(durations)])
    maps = [phase_map(part, float(s)) for part, s in zip(parts, durations, strict=True)]
    _, X = _closed(cell, maps, turns)
    found = np.empty((len(parts), 3))
    for p, (part, (along, by_wave)) in enumerate(zip(parts, maps, strict=True)):
        states = part.lawful.A.shape[0]
        X = along @ X + by_wave @ later(turns[p])
        there, event = later(turns[p + 1]), part.switch.event
        found[p] = event[:states] @ X[:states] + event[states + 3 :] @ X[states:]
        found[p] += event[states : states + 3] @ there
        X = part.switch.state @ X + part.switch.inputs @ there
    return found


def _evaluated(cell: "BodyCell", times: Vector) -> Evaluation:
    parts, count = parts_of(cell), len(cell.phases)
    theta = angles_of(cell, times)
    maps = [phase_map(part, float(s)) for part, s in zip(parts, times, strict=False)]
    size = len(maps[0][0])
    back, begins = _closed(cell, maps, theta - theta[0])
    X = begins @ wave(theta[0])
    starts, residual = np.empty((count, size)), np.empty(count)
    turns = _turns(cell, count, len(times))
    moving, by_times = np.zeros((size, len(times))), []
    inward = np.eye(size)
    for p, (part, (along, by_wave)) in enumerate(zip(parts, maps, strict=True)):
        starts[p] = X
        X = along @ X + by_wave @ wave(theta[p])
        moving = along @ moving + np.outer(by_wave @ turned(theta[p]), turns[p])
        moving[:, p] += rates(part, X, theta[p + 1])
        inward = along @ inward
        states = part.lawful.A.shape[0]
        event = np.delete(part.switch.event, slice(states, states + 3))
        by_wave_there = part.switch.event[states : states + 3]
        residual[p] = event @ X + by_wave_there @ wave(theta[p + 1])
        there = by_wave_there @ turned(theta[p + 1]) * turns[p + 1]
        by_times.append((event, event @ moving + there, event @ inward))
        across, end = part.switch.state, part.switch.inputs
        X = across @ X + end @ wave(theta[p + 1])
        moving = across @ moving + np.outer(end @ turned(theta[p + 1]), turns[p + 1])
        inward = across @ inward
    first = back @ moving  # how the state at the beginning moves with the times
    jacobian = np.array([own + through @ first for _, own, through in by_times])
    return _with_length(cell, times, residual, jacobian, starts)


def _turns(cell: "BodyCell", count: int, width: int) -> Matrix:
    """Return how the angles where phases begin, and the last ends, move with the times."""
    found = np.zeros((count + 1, width))
    for p in range(count + 1):
        found[p, :p] = cell.omega
    if cell.forced:
        found[:, -1] = 1.0
    return found


def _with_length(
    cell: "BodyCell", times: Vector, residual: Vector, jacobian: Matrix, starts: Matrix
) -> Evaluation:
    """Return an evaluation with the duration of the cell, which a forcing makes known."""
    if cell.forced:
        count = len(cell.phases)
        residual = np.append(residual, times[:count].sum() - cell.duration)
        jacobian = np.vstack([jacobian, np.append(np.ones(count), 0.0)])
    return Evaluation(residual, jacobian, starts)


@lru_cache(maxsize=8)
def _kept(cell: "BodyCell", times: bytes) -> Evaluation:
    return _evaluated(cell, np.frombuffer(times))


def evaluated(cell: "BodyCell", times: Vector) -> Evaluation:
    """Return residual, Jacobian and states of the exact equations at given times.

    Parameters
    ----------
    cell : BodyCell
    times : ndarray
        Durations and, if something forces, the phase of the forcing.
    """
    return _kept(cell, np.ascontiguousarray(times, dtype=float).tobytes())


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
    part, found = parts_of(cell)[p], evaluated(cell, times)
    states = part.lawful.A.shape[0]
    start, theta = found.starts[p], float(angles_of(cell, times)[p])
    t = float(times[p]) * np.asarray(u, dtype=float)
    inputs = np.concatenate([wave(theta), start[states:]])
    there = theta + cell.omega * t
    waves, others = np.array([np.cos(there), np.sin(there)]), rows[:, states + 2 :] @ inputs[2:]
    free = part.flow.seen(rows[:, :states], start[:states], inputs, t)
    return np.asarray(free + rows[:, states : states + 2] @ waves + others[:, None])
