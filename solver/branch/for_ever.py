"""The start of a branch at a motion without switches, the response to the forcing."""

import numpy as np

from ..arrays import Complex, Vector
from ..existence.bodies import steady
from ..scenes.bodies.cell import BodyCell
from ..scenes.cell import Cell
from ..simulation.lasting import response
from .course import Course
from .piece import NoStepError


def for_ever(course: Course, numbers: tuple[float, ...]) -> Vector:
    """Return the unknowns of a motion without switches, the response to the forcing.

    Its cell begins where the velocity, that of the first contact, vanishes: a sinusoid of the
    phase of the forcing there.

    Raises
    ------
    NoStepError
        If there is none.
    """
    cell = course.cell(numbers)
    states = steady(cell, 0) if isinstance(cell, BodyCell) else _steady(cell)
    if states is None:
        raise NoStepError
    mean, wave = states

    def begun(angle: float) -> Vector:
        state = mean + (wave * np.exp(1j * angle)).real
        return course.gathered(numbers, [state], np.array([cell.duration]), angle)

    equations = course.case_of(cell, [])
    first, second = (
        course.moving_at(equations, begun(angle), 0, 0.0)[1] for angle in (0.0, np.pi / 2)
    )
    return begun(float(np.arctan2(-first, second)))


def _steady(cell: Cell) -> tuple[Vector, Complex] | None:
    """Return mean and complex amplitude of displacement and velocity; None without them."""
    steady_response = response(cell.phases[0], cell.omega)
    if steady_response is None:
        return None
    mean, wave = steady_response
    return np.array([mean, 0.0]), wave * np.array([1.0, 1j * cell.omega])
