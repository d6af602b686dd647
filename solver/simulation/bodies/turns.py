"""A motion of a body at each whole turn of the forcing, and its states in SI units."""

import numpy as np

from ...arrays import Matrix, Vector
from ...bodies.laws import scales
from ...scenes.case import Case
from ..simulate import cycle
from ..walk import Place, walk
from .along import state_at
from .machine import BodyMachine
from .record import BodySegment
from .rules import BodyState


def turns(
    case: Case, machine: BodyMachine, start: BodyState, cycles: int
) -> tuple[Matrix, BodyState | None]:
    """Return a motion from a state on, where the phase of the forcing is that of the start.

    Returns
    -------
    states : ndarray, shape (n, 2 + M)
        Displacement and velocity of the first contact, and the memory, without units; fewer
        than ``cycles + 1`` rows where the motion ends.
    last : BodyState or None
        The state in the last of them; None where the motion ends before.
    """
    T = cycle(machine.cell)
    segments, _, ended = walk(case, machine, Place.first(machine, start), cycles * T)
    own = [q for q in segments if isinstance(q, BodySegment)]
    found: list[list[float]] = []
    for q in own:
        is_last = q is own[-1] and not ended
        while len(found) <= cycles and (is_last or len(found) * T < float(q.t) + q.s):
            s = np.array([len(found) * T - float(q.t)])
            x, v = (float(q.seen(row, s)[0]) for row in q.regime.contacts[:2, 0])
            found.append([x, v, *q.Y[q.regime.states + 3 :]])
    states = np.array(found).reshape(len(found), 2 + len(machine.cell.memory))
    if ended:
        return states, None
    y = state_at(own[-1].regime, own[-1].Y, cycles * T - float(own[-1].t))
    memory = tuple(map(float, own[-1].Y[own[-1].regime.states + 3 :]))
    return states, BodyState(tuple(map(float, y)), start.angle, memory=memory)


def in_si(case: Case, machine: BodyMachine, state: BodyState) -> Vector:
    """Return a state as ``(x, x', eta, eta', memory)``: of contact and modes, in SI units."""
    seen = machine.regimes[0].contacts[:2, 0] @ state.full
    return np.array([*seen, *state.y, *state.memory]) * _units(case, machine)


def from_si(case: Case, machine: BodyMachine, values: Vector) -> BodyState:
    """Return the state where the phase of the forcing is 0; see `in_si`.

    Of a body whose modes are others, the nearest to theirs with the contact at its place.
    """
    more, count = len(machine.cell.memory), len(machine.cell.body.squares)
    own, other = values[2 : len(values) - more].reshape(2, -1), np.zeros((2, count))
    common = min(count, own.shape[1])
    other[:, :common] = own[:, :common]
    given = np.array([*values[:2], *other.ravel(), *values[len(values) - more :]])
    x, v, *rest = (given / _units(case, machine)).tolist()
    y, memory = tuple(rest[: 2 * count]), tuple(rest[2 * count :])
    return machine.put(BodyState(y, 0.0, memory=memory), x, v)


def _units(case: Case, machine: BodyMachine) -> Vector:
    units, w = case.units, scales(machine.cell.body, machine.cell.omega)
    root = units.mass**0.5
    places = root * units.of_motion(0) / w
    memory = [units.of_motion(q.power) for q in machine.cell.memory]
    seen = [units.of_motion(0), units.of_motion(1)]
    return np.array([*seen, *places, *np.full(len(w), root * units.of_motion(1)), *memory])
