"""Linear forms in the state along a motion: demands, and the events that end phases."""

import math

import numpy as np

from ..arrays import Vector
from ..scenes.cell import Form
from .motion import Motion

#: Largest distance of two normalised forms that are the same up to rounding.
EQUAL = 1e-13


def value(orbit: Motion, p: int, form: Form, u: Vector) -> Vector:
    """Return the values of a linear form in the state at local times of phase `p`.

    Of one mass, only derivatives with a factor other than 0 are evaluated.
    """
    if orbit.case.scene.has_body:
        return np.asarray(np.array(form) @ orbit.signals(p, u))
    *factors, cos, constant = form
    values = constant + cos * np.cos(orbit.angle_at(p, u))
    for derivative, factor in enumerate(factors):
        if factor:
            values += factor * orbit.part(p, u, derivative)
    return np.asarray(values)


def value_at(orbit: Motion, p: int, form: Form, u: float) -> float:
    """Return the value of a linear form in the state at one local time of phase `p`."""
    return float(value(orbit, p, form, np.array([u]))[0])


def scale_of(orbit: Motion, p: int, form: Form) -> float:
    """Return the scale of a form on phase `p`: the sum of the sizes of its terms."""
    return float(np.abs(form) @ orbit.sizes[p])


def vanishes_by_event(orbit: Motion, p: int, form: Form) -> bool:
    """Return whether a demand is a multiple of the event that ends phase `p`."""
    event_form, sizes = orbit.cell.phases[p].event, orbit.sizes[p]
    demand, event = np.array(form) * sizes, np.array(event_form) * sizes
    if not event.any() or not demand.any():
        return False
    demand, event = demand / math.hypot(*demand), event / math.hypot(*event)  # no squares
    distance = min(np.linalg.norm(demand - event), np.linalg.norm(demand + event))
    return bool(distance <= EQUAL)
