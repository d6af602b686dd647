"""Linear forms in the state along a motion: demands, and the events that end phases."""

import numpy as np

from ..arrays import Vector
from ..scenes.cell import Form
from .motion import Motion


def terms(orbit: Motion, p: int, form: Form, u: Vector) -> Vector:
    """Return the terms of a linear form in the state, at local times of a phase."""
    cell, durations = orbit.cell, orbit.cell_durations
    if orbit.case.scene.has_body:
        return np.asarray(np.array(form)[:, None] * orbit.signals(p, u))
    angle = orbit.angle + cell.omega * float(np.sum(durations[:p]))
    cosine = np.cos(angle + cell.omega * durations[p] * u)
    x, v, cos, constant = form
    zero = np.zeros(len(u))
    return np.array(
        [
            x * orbit.part(p, u, 0) if x else zero,
            v * orbit.part(p, u, 1) if v else zero,
            cos * cosine,
            np.full(len(u), constant),
        ]
    )


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
    return bool(1 - abs(demand @ event) <= 1e-12)
