"""How far an orbit of an expansion may violate a demand: by what its own residual explains.

What an expansion leaves of the equation of motion acts on its motion like a force.  The
velocity that this force would give, and the displacement, over each phase from the state that
keeps them smallest, are the size of the error of the motion; a demand that is violated by less
is not known to be violated.
The measure needs no exact orbit and knows no expansion: for functions that fit it falls faster
than any power of the order, for harmonics like their own overshoot, 1/N in the derivative
before the one that jumps.  It excuses sizes only, never the direction in which an event is
crossed nor a phase without duration, by which spurious roots are told.
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

#: Times the measured error, for the errors of the start of each phase and the growth since.
FACTOR = 2.0

#: Most that is excused, as a part of the demand's scale.
MOST = 0.25


def defect(orbit: Motion, p: int) -> tuple[float, float]:
    """Return the sizes of velocity and displacement that the residual on a phase would give.

    Both without units; on a held phase the residual is the acceleration.  Where a phase is
    held at one place, the errors of both are what they differ from rest there.
    """
    phase, s = orbit.cell.phases[p], float(orbit.cell_durations[p])
    place = orbit.cell.place(p)
    if place is not None:
        x, v = (orbit.part(p, LOOK, j) for j in (0, 1))
        return float(np.abs(v).max()), float(np.abs(x - place).max())

    def terms(u: Vector) -> Vector:
        if phase.held:
            return np.array([orbit.part(p, u, 2)])
        x, v, cosine, _ = orbit.signals(p, u)
        parts = phase.accelerations(x, v, cosine)
        return np.array([orbit.part(p, u, 2), *(-part for part in parts)])

    def residual(u: Vector) -> Vector:
        return np.asarray(terms(u).sum(axis=0))

    size = float(np.abs(terms(LOOK)).sum(axis=0).max())
    rate, travel = chebyshev.accumulated(chebyshev.pieces(residual, size))
    return s * rate, s * s * travel


def by_residual(orbit: Motion) -> Allowance:
    """Return what each demand of an orbit may fall below 0, as a part of its scale.

    The residual is looked at when the first demand asks.
    """

    @cache
    def errors() -> tuple[float, float]:
        found = [defect(orbit, p) for p in range(len(orbit.cell.phases))]
        velocity, displacement = map(max, zip(*found, strict=True))
        return velocity, displacement

    def error(p: int, form: Form) -> float:
        velocity, displacement = errors()
        return abs(form[0]) * displacement + abs(form[1]) * velocity

    return _by(orbit, error)


def by_neighbour(orbit: Motion, near: Motion | None) -> Allowance:
    """Return what demands of a body's orbit may fall below 0: twice what it differs by there.

    It is compared with the exact solution next to it, if there is one.
    """
    if near is None:
        return only_rounding

    @cache
    def apart(p: int) -> Vector:
        off: Vector = np.abs(orbit.signals(p, LOOK) - near.signals(p, LOOK)).max(axis=1)
        return off

    return _by(orbit, lambda p, form: float(np.abs(form) @ apart(p)))


def _by(orbit: Motion, error: Callable[[int, Form], float]) -> Allowance:
    """Return what is allowed by the error of each form on each phase."""

    def allowed(p: int, form: Form) -> float:
        scale = scale_of(orbit, p, form)
        excused = FACTOR * error(p, form) / scale if scale else 0.0
        return min(MOST, max(ROUNDING, excused))

    return allowed
