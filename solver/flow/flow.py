"""Closed-form motion of one linear phase from a given state, exact to rounding."""

import cmath
import math
from dataclasses import dataclass

import numpy as np

from ..arrays import Matrix, Vector
from ..scenes.cell import Phase
from . import responses
from .divided import of_three_at, of_two_at


@dataclass(frozen=True)
class End:
    """The state in which a phase ends, and its derivatives.

    Parameters
    ----------
    state : ndarray, shape (2,)
        Displacement and velocity.
    change : ndarray, shape (2,)
        Their differences from the start, to their own digits: a phase may end where it began.
    by_duration, by_angle : ndarray, shape (2,)
        Derivatives by the duration, and by the angle of the forcing where the phase starts.
    by_start : ndarray, shape (2, 2)
        Derivatives by the displacement and velocity in which it starts.
    """

    state: Vector
    change: Vector
    by_duration: Vector
    by_angle: Vector
    by_start: Matrix


def roots(phase: Phase) -> tuple[complex, complex]:
    """Return the roots of ``m r**2 + c r + k = 0``, the one of smaller modulus first."""
    return responses.roots(phase.m, phase.c, phase.k)


def motion(
    phase: Phase, start: Vector, angle: float, omega: float, t: Vector, derivative: int
) -> Vector:
    """Return a derivative of the displacement, 0 to 2, at times `t` after the start.

    Parameters
    ----------
    phase : Phase
        Its equation of motion.
    start : ndarray, shape (2,)
        Displacement and velocity at ``t = 0``.
    angle, omega : float
        The forcing is ``cos(omega t + angle)``.
    t : ndarray
        Times, not negative.
    derivative : {0, 1, 2}
    """
    t = np.asarray(t, dtype=float)
    if phase.held:
        values = (start[0] + phase.speed * t, np.full(t.shape, phase.speed), np.zeros(t.shape))
        return np.asarray(values[derivative])
    with np.errstate(all="ignore"):  # a trial of Newton's method may grow beyond float64
        x, v = _states(phase, start, angle, omega, t.ravel())
        if derivative == 2:
            x = _acceleration(phase, x, v, np.cos(omega * t.ravel() + angle))
    return np.asarray((x, v, x)[derivative]).reshape(t.shape)


def end(phase: Phase, start: Vector, angle: float, omega: float, duration: float) -> End:
    """Return the state in which a phase ends, with all its derivatives; see `motion`."""
    x, v = map(float, start)
    if phase.held:
        state = np.array([x + phase.speed * duration, phase.speed])
        first = np.array([[1.0, 0.0], [0.0, 0.0]])
        change = np.array([phase.speed * duration, 0.0])
        return End(state, change, np.array([phase.speed, 0.0]), np.zeros(2), first)
    xx, xv, vx, vv, less_x, less_v = responses.by_start(phase.m, phase.c, phase.k, duration)
    forced, by_angle = _forced(phase, angle, omega, duration)
    state = np.array([xx * x + xv * v + forced[0], vx * x + vv * v + forced[1]])
    change = np.array([less_x * x + xv * v + forced[0], vx * x + less_v * v + forced[1]])
    cosine = math.cos(omega * duration + angle)
    force = phase.f + phase.g * cosine - phase.c * state[1] - phase.k * state[0]
    by_duration = np.array([state[1], force / phase.m])
    return End(state, change, by_duration, np.array(by_angle), np.array([[xx, xv], [vx, vv]]))


def state_at(
    phase: Phase, x: float, v: float, angle: float, omega: float, t: float
) -> tuple[float, float]:
    """Return displacement and velocity a time after a phase starts with them; see `motion`."""
    if phase.held:
        return x + phase.speed * t, phase.speed
    xx, xv, vx, vv, *_ = responses.by_start(phase.m, phase.c, phase.k, t)
    (moved, moving), _ = _forced(phase, angle, omega, t)
    return xx * x + xv * v + moved, vx * x + vv * v + moving


def _forced(
    phase: Phase, angle: float, omega: float, t: float
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return displacement and velocity by the forces alone, and their changes by the angle."""
    equation, x, v, by_angle = (phase.m, phase.c, phase.k), 0.0, 0.0, (0.0, 0.0)
    if phase.f:
        moved, moving = responses.by_force(*equation, t)
        x, v = phase.f * moved, phase.f * moving
    if phase.g:
        moved, moving, *turned = responses.by_forcing(*equation, omega, angle, t)
        x, v = x + phase.g * moved, v + phase.g * moving
        by_angle = phase.g * turned[0], phase.g * turned[1]
    return (x, v), by_angle


def _acceleration(phase: Phase, x: Vector, v: Vector, cosine: Vector) -> Vector:
    return (phase.f + phase.g * cosine - phase.c * v - phase.k * x) / phase.m


def _states(
    phase: Phase, start: Vector, angle: float, omega: float, t: Vector
) -> tuple[Vector, Vector]:
    """Return displacement and velocity at times after the start of a free phase.

    As `end`; of a force that is zero the response is not looked for.
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
