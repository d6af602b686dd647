"""The start of a branch at a motion without switches, the response to the forcing."""

import numpy as np

from ..arrays import Vector
from ..existence.reasons import steady
from .course import Course
from .place import NoStepError


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
    states = steady(cell, 0)
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
