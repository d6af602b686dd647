"""States of a body in SI units, to go on from also where its modes are others."""

import numpy as np

from ...arrays import Vector
from ...bodies.laws import scales
from ...scenes.case import Case
from .machine import BodyMachine
from .state import BodyState


def state_of(case: Case, machine: BodyMachine, values: Vector) -> BodyState:
    """Return the state where the phase of the forcing is 0, from numbers in SI units.

    Of a body whose modes are others, the nearest to theirs with the contact at its place.

    Parameters
    ----------
    values : ndarray
        Displacement and velocity of the first contact, the memory, and of each mode its
        displacement, then of each its velocity.
    """
    seen, count = 2 + len(machine.cell.memory), len(machine.cell.body.squares)
    modes, other = values[seen:].reshape(2, -1), np.zeros((2, count))
    common = min(count, modes.shape[1])
    other[:, :common] = modes[:, :common]
    given = np.append(values[:seen], other) / units_of(case, machine)
    x, v = given[:2].tolist()
    return machine.put(BodyState(given[seen:], 0.0, memory=given[2:seen]), x, v)


def units_of(case: Case, machine: BodyMachine) -> Vector:
    """Return the units of the numbers in `state_of`, from those at a whole turn of a motion."""
    units, w = case.units, scales(machine.cell.body, machine.cell.omega)
    root = units.mass**0.5
    memory = [units.of_motion(q.power) for q in machine.cell.memory]
    seen = [units.of_motion(0), units.of_motion(1)]
    velocities = np.full(len(w), root * units.of_motion(1))
    return np.array([*seen, *memory, *(root * units.of_motion(0) / w), *velocities])
