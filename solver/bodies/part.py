"""The phases of a cell of a body: laws, flow, switch and map of each."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, lru_cache, partial, wraps
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from ..arrays import Matrix, Vector
from .flow import Flow, flow_of
from .laws import HELD, Lawful, lawful
from .switch import Switch, fixed, switch

if TYPE_CHECKING:
    from ..scenes.bodies.cell import BodyCell

#: Relative change of a state over a cell below which periodicity does not determine its size.
RETURNING = 1e-7


@dataclass(frozen=True, eq=False)
class Part:
    """A phase of a cell: the body under its laws, its flow, the switch that ends it.

    `closing` is the same switch on an orbit, and determines displacements that nothing else
    does: see `switch.fixed`; and without a forcing where on the orbit the cell begins.
    `flowing` makes the flow at its first call; phases under the same laws share it.
    """

    lawful: Lawful
    switch: Switch
    closing: Switch
    flowing: Callable[[], Flow]

    @property
    def flow(self) -> Flow:
        """The flow of the body in the phase.

        Raises
        ------
        BodyError
            If there is no eigenbasis.
        """
        return self.flowing()


@lru_cache(maxsize=32)
def parts_of(cell: "BodyCell") -> tuple[Part, ...]:
    """Return the phases of a cell.

    Without a forcing a motion may be shifted in time.  Where the force of a contact does not
    jump, periodicity at given durations does not determine by how much; where only impulses
    act, it does not determine how fast the motion is.  Its equations are then singular on the
    orbit.  So each switch shifts the state to the surface of its event; see `onto_event`.

    Raises
    ------
    BodyError
        If a law does not fix its force.
    """
    phases = [cell.carrying(p) for p in range(len(cell.phases))]
    keys = [(phase.laws, phase.held, phase.speed) for phase in phases]
    under = {key: _under(cell, keys.index(key)) for key in dict.fromkeys(keys)}
    laws, flows = zip(*(under[key] for key in keys), strict=True)
    switches = [switch(cell, p, law.rows) for p, law in enumerate(laws)]
    closing = fixed(switches, *shifts(cell))
    if not cell.forced:
        closing = [q.fixing(*onto_event(q)) for q in closing]
    return tuple(map(Part, laws, switches, closing, flows))


def _under(cell: "BodyCell", p: int) -> tuple[Lawful, Callable[[], Flow]]:
    """Return the body under the laws of a phase, and what makes its flow once."""
    law = lawful(cell, p)
    return law, cache(partial(flow_of, law, cell.omega))


def onto_event(each: Switch) -> tuple[Matrix, Matrix]:
    """Return the directions of a shift of the state that any motion without a forcing needs.

    By column, before a switch and behind it, for `Switch.fixing`: the gradient of the event;
    and that with places and velocities exchanged added to it, as either may be left open.
    """
    event, states = each.gradient, each.states
    exchanged = np.append(np.roll(event[:states], states // 2), event[states:])
    return event[:, None], (event + exchanged)[:, None]


@lru_cache(maxsize=32)
def shifts(cell: "BodyCell") -> tuple[Matrix, Matrix]:
    """Return the directions of ``X = (y, memory)`` that periodicity does not determine.

    By column, at the end of a phase and behind its switch, for `switch.fixed`.  For one forced
    phase they are the states that return.  For others they are rigid-body displacements that
    no phase and no switch sees.
    """
    if cell.forced and len(cell.phases) == 1:
        return _returning(cell)
    count = 2 * len(cell.body.squares)
    is_free = cell.sign > 0 and bool((cell.body.squares == 0).any())
    basis = np.empty((count + len(cell.memory), 0))
    for p in range(len(cell.phases) if is_free else 0):
        law = lawful(cell, p)
        if p == 0:
            basis = np.vstack([law.still, np.zeros((len(cell.memory), law.still.shape[1]))])
        outside = basis[:count] - law.still @ np.linalg.pinv(law.still) @ basis[:count]
        conditions = np.vstack([outside, switch(cell, p, law.rows).state @ basis - basis])
        _, values, Vh = np.linalg.svd(conditions)
        basis = basis @ Vh[(values > HELD * np.abs(basis).max(initial=1.0)).sum() :].T
    return basis, basis


def _returning(cell: "BodyCell") -> tuple[Matrix, Matrix]:
    """Return the states that one phase of known duration and its switch map to themselves.

    First at the end of the phase; second, behind it, the left null space of ``1 - map``.
    If all modes are damped there are none.
    """
    body = cell.body
    by_mode = (
        np.diag(body.damping) if body.is_proportional else np.linalg.eigvalsh(body.damping)
    )
    if by_mode.min() * cell.duration > RETURNING:
        return (np.empty((2 * len(body.squares) + len(cell.memory), 0)),) * 2
    law, flowing = _under(cell, 0)
    across = switch(cell, 0, law.rows)
    flow, _ = phase_map(Part(law, across, across, flowing), cell.duration)
    left, values, Vh = np.linalg.svd(np.eye(len(flow)) - cell.sign * across.state @ flow)
    last = int((values > RETURNING).sum())
    return flow @ Vh[last:].T, left[:, last:]


# A function whose last argument are times.
AtTimes = TypeVar("AtTimes", bound=Callable[..., Any])


def kept_by_times(count: int) -> Callable[[AtTimes], AtTimes]:
    """Return a decorator that caches the last `count` results of a function of times."""

    def keeping(function: AtTimes) -> AtTimes:
        @lru_cache(maxsize=count)
        def kept(*arguments: Any) -> Any:
            return function(*arguments[:-1], np.frombuffer(arguments[-1]))

        @wraps(function)
        def at(*arguments: Any) -> Any:
            times = np.ascontiguousarray(arguments[-1], dtype=float)
            return kept(*arguments[:-1], times.tobytes())

        return at  # type: ignore[return-value]

    return keeping


def wave(angle: float) -> Vector:
    """Return ``(cos, sin, 1)`` of an angle."""
    return np.array([np.cos(angle), np.sin(angle), 1.0])


def turned(angle: float) -> Vector:
    """Return the derivatives of `wave` by the angle."""
    return np.array([-np.sin(angle), np.cos(angle), 0.0])


def angles_of(cell: "BodyCell", times: Vector) -> Vector:
    """Return the angle of the forcing where each phase begins, and where the last ends."""
    count = len(cell.phases)
    angles = np.zeros((*times.shape[:-1], count + 1))
    angles[..., 1:] = cell.omega * np.cumsum(times[..., :count], axis=-1)
    return angles + times[..., -1:] if cell.forced else angles


def phase_map(part: Part, s: float | Vector) -> tuple[Matrix, Matrix]:
    """Return the affine map over a phase: the matrices of ``X = (y, memory)`` and of `wave`.

    Shapes (..., n, n) and (..., n, 3), stacked for several durations.
    """
    states, size = part.lawful.A.shape[0], part.switch.state.shape[0]
    driven = part.flow.driven(s)
    flow, by_wave = np.zeros((*np.shape(s), size, size)), np.zeros((*np.shape(s), size, 3))
    flow[..., :, :] = np.eye(size)
    flow[..., :states, :states] = part.flow.matrix(s)
    flow[..., :states, states:], by_wave[..., :states, :] = driven[..., 3:], driven[..., :3]
    return flow, by_wave


def rates(part: Part, X: Vector, waving: Vector) -> Vector:
    """Return the derivative of ``X = (y, memory)`` by time, for a `wave`; or of several."""
    states = part.lawful.A.shape[0]
    inputs = np.concatenate([waving, X[..., states:]], axis=-1)
    derivative = np.zeros(X.shape)
    derivative[..., :states] = X[..., :states] @ part.lawful.A.T + inputs @ part.lawful.inputs.T
    return derivative


def later(angle: float | Vector) -> Matrix:
    """Return the matrix that rotates `wave` by an angle; a stack for several."""
    rotation = np.zeros((*np.shape(angle), 3, 3))
    rotation[..., 0, 0] = rotation[..., 1, 1] = np.cos(angle)
    rotation[..., 1, 0] = np.sin(angle)
    rotation[..., 0, 1], rotation[..., 2, 2] = -rotation[..., 1, 0], 1.0
    return rotation


def generator_of(part: Part, omega: float) -> Matrix:
    """Return the matrix G of ``Y' = G Y`` on a phase, Y = (y, cos, sin, 1, memory)."""
    A, inputs = part.lawful.A, part.lawful.inputs
    generator = np.zeros((len(A) + inputs.shape[1],) * 2)
    generator[: len(A)] = np.hstack([A, inputs])
    generator[len(A), len(A) + 1], generator[len(A) + 1, len(A)] = -omega, omega
    return generator
