"""Linear forms in the state along a motion: demands, and the events that end phases."""

import numpy as np

from ..arrays import Vector
from ..scenes.cell import Form
from .motion import Motion

#: Distance of two forms, as a part of their size, that is rounding.
EQUAL = 1e-13


def value(orbit: Motion, p: int, form: Form, u: Vector) -> Vector:
    """Return a linear form in the state, at local times of a phase.

    The motion of one mass is looked at no more often than it has factors.
    """
    if orbit.case.scene.has_body:
        return np.asarray(np.array(form) @ orbit.signals(p, u))
    *factors, cos, constant = form
    found = constant + cos * np.cos(orbit.angle_at(p, u))
    for derivative, factor in enumerate(factors):
        if factor:
            found += factor * orbit.part(p, u, derivative)
    return np.asarray(found)


def value_at(orbit: Motion, p: int, form: Form, u: float) -> float:
    """Return a linear form in the state, at one local time of a phase."""
    return float(value(orbit, p, form, np.array([u]))[0])


def scale_of(orbit: Motion, p: int, form: Form) -> float:
    """Return the size of a form on a phase: of its terms, added without sign."""
    return float(np.abs(form) @ orbit.sizes[p])


def vanishes_by_event(orbit: Motion, p: int, form: Form) -> bool:
    """Whether a demand is the event that ends the phase, but for a factor."""
    event_form, sizes = orbit.cell.phases[p].event, orbit.sizes[p]
    demand, event = np.array(form) * sizes, np.array(event_form) * sizes
    if not event.any() or not demand.any():
        return False
    demand, event = demand / np.linalg.norm(demand), event / np.linalg.norm(event)
    apart = min(np.linalg.norm(demand - event), np.linalg.norm(demand + event))
    return bool(apart <= EQUAL)
