"""How far an orbit of an expansion may violate a demand: as far as its own residual explains.

The residual of the equation of motion acts on an expansion like a force.  Its first and second
integral over each phase, with the constants that keep them smallest, estimate the errors of
velocity and displacement; a demand that is violated by less is not known to be violated.
The estimate needs no exact orbit and knows no expansion.  For functions that fit the motion it
falls faster than any power of the order N; for harmonics it falls like their overshoot, 1/N in
the derivative before the one that jumps.  It excuses small violations only, never an event
crossed in the wrong direction or a phase without duration: these are the marks of spurious
roots.
"""

from collections.abc import Callable
from functools import cache

import numpy as np

from ..arrays import Vector
from ..scenes.cell import Form
from . import chebyshev
from .admissible import ROUNDING, Allowance, only_rounding
from .forms import scale_of
from .motion import LOOK, Motion
from .transients import cuts

#: Safety factor of the estimate, for errors at the start of each phase and their growth.
FACTOR = 2.0

#: Largest violation that is excused, relative to the demand's scale.
MOST = 0.25


def defect(orbit: Motion, p: int) -> tuple[float, float]:
    """Return the errors of velocity and displacement that the residual on a phase explains.

    Both are without units.  On a held phase the residual is the acceleration.  On a phase that
    rests at a known place, they are the differences from rest there.
    """
    phase, s = orbit.cell.phases[p], float(orbit.cell_durations[p])
    position = orbit.cell.place(p)
    if position is not None:
        x, v = (orbit.part(p, LOOK, j) for j in (0, 1))
        return float(np.abs(v).max()), float(np.abs(x - position).max())

    def terms(u: Vector) -> Vector:
        if phase.held:
            return np.array([orbit.part(p, u, 2)])
        x, v, cosine, _ = orbit.signals(p, u)
        parts = phase.accelerations(x, v, cosine)
        return np.array([orbit.part(p, u, 2), *(-part for part in parts)])

    def residual(u: Vector) -> Vector:
        return np.asarray(terms(u).sum(axis=0))

    size = float(np.abs(terms(LOOK)).sum(axis=0).max())
    rate, travel = chebyshev.accumulated(chebyshev.pieces(residual, size, cuts(orbit, p)))
    return s * rate, s * s * travel


def by_residual(orbit: Motion) -> Allowance:
    """Return the allowance of an orbit by its residual, which the first call computes."""

    @cache
    def errors() -> tuple[float, float]:
        defects = [defect(orbit, p) for p in range(len(orbit.cell.phases))]
        velocity, displacement = map(max, zip(*defects, strict=True))
        return velocity, displacement

    def error(p: int, form: Form) -> float:
        velocity, displacement = errors()
        return abs(form[0]) * displacement + abs(form[1]) * velocity

    return _by(orbit, error)


def by_neighbour(orbit: Motion, near: Motion | None) -> Allowance:
    """Return the allowance of a body's orbit by its distance from the exact solution `near`.

    Without one, only rounding is allowed.
    """
    if near is None:
        return only_rounding

    @cache
    def errors(p: int) -> Vector:
        largest: Vector = np.abs(orbit.signals(p, LOOK) - near.signals(p, LOOK)).max(axis=1)
        return largest

    return _by(orbit, lambda p, form: float(np.abs(form) @ errors(p)))


def _by(orbit: Motion, error: Callable[[int, Form], float]) -> Allowance:
    """Return the allowance for a given error of each form on each phase."""

    def allowed(p: int, form: Form) -> float:
        scale = scale_of(orbit, p, form)
        excused = FACTOR * error(p, form) / scale if scale else 0.0
        return min(MOST, max(ROUNDING, excused))

    return allowed
