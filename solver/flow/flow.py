"""Closed-form motion of one linear phase from a given state, exact to rounding."""

import cmath

import numpy as np

from ..arrays import Vector
from ..scenes.cell import Phase
from . import responses
from .divided import of_three_at, of_two_at


def roots(phase: Phase) -> tuple[complex, complex]:
    """Return the roots of ``m r**2 + c r + k = 0``, the one of smaller modulus first."""
    return responses.roots(phase.m, phase.c, phase.k)


def motion(
    phase: Phase, start: Vector, angle: float, omega: float, t: Vector, derivative: int
) -> Vector:
    """Return a derivative of the displacement, 0 to 2, at times `t` after the start.

    Parameters
    ----------
    start : ndarray, shape (2,)
        Displacement and velocity at ``t = 0``.
    angle, omega : float
        The forcing is ``cos(omega t + angle)``.
    t : ndarray
        Times, not negative.
    """
    t = np.asarray(t, dtype=float)
    if phase.held:
        values = (start[0] + phase.speed * t, np.full(t.shape, phase.speed), np.zeros(t.shape))
        return np.asarray(values[derivative])
    with np.errstate(all="ignore"):  # a trial of Newton's method may grow beyond float64
        x, v = _states(phase, start, angle, omega, t.ravel())
        if derivative == 2:
            x = phase.acceleration(x, v, np.cos(omega * t.ravel() + angle))
    return np.asarray((x, v, x)[derivative]).reshape(t.shape)


def _states(
    phase: Phase, start: Vector, angle: float, omega: float, t: Vector
) -> tuple[Vector, Vector]:
    """Return displacement and velocity at times after the start of a free phase.

    Responses to forces that are zero are not evaluated.
    """
    small, large = roots(phase)
    impulse = of_two_at(small, large, t)
    of_x = np.exp(small * t) - small * impulse
    of_v = np.exp(large * t) + small * impulse
    x = of_x.real * start[0] + impulse.real * start[1]
    v = of_v.real * start[1] - phase.k / phase.m * impulse.real * start[0]
    if phase.f:
        x = x + phase.f / phase.m * of_three_at(small, large, 0j, t).real
        v = v + phase.f / phase.m * impulse.real
    if phase.g:
        wave = of_three_at(small, large, 1j * omega, t)
        turn = phase.g / phase.m * cmath.exp(1j * angle)
        x, v = x + (turn * wave).real, v + (turn * (1j * omega * wave + impulse)).real
    return x, v
