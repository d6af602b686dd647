"""States of a body in SI units, to continue from, even with another set of modes."""

import numpy as np

from ...arrays import Vector
from ...bodies.laws import scales
from ...scenes.case import Case
from .machine import BodyMachine
from .state import BodyState


def state_of(case: Case, machine: BodyMachine, values: Vector) -> BodyState:
    """Return the state with phase of the forcing 0, from numbers in SI units.

    If the body has another number of modes, these are cut or padded with zeros; then the state
    is the nearest with the given displacement and velocity of the contact.

    Parameters
    ----------
    values : ndarray
        Displacement and velocity of the first contact, the memory, the displacements of all
        modes, their velocities.
    """
    seen, count = 2 + len(machine.cell.memory), len(machine.cell.body.squares)
    modes, resized = values[seen:].reshape(2, -1), np.zeros((2, count))
    common = min(count, modes.shape[1])
    resized[:, :common] = modes[:, :common]
    numbers = np.append(values[:seen], resized) / units_of(case, machine)
    x, v = numbers[:2].tolist()
    return machine.put(BodyState(numbers[seen:], 0.0, memory=numbers[2:seen]), x, v)


def units_of(case: Case, machine: BodyMachine) -> Vector:
    """Return the SI units of the numbers that `strobe` keeps at a whole turn, as one vector."""
    units, w = case.units, scales(machine.cell.body, machine.cell.omega)
    root = units.mass**0.5
    memory = [units.of_motion(q.power) for q in machine.cell.memory]
    of_contact = [units.of_motion(0), units.of_motion(1)]
    velocities = np.full(len(w), root * units.of_motion(1))
    return np.array([*of_contact, *memory, *(root * units.of_motion(0) / w), *velocities])
