"""Closed-form motion of one linear phase from a given state, exact to rounding."""

import cmath
import math
from dataclasses import dataclass

import numpy as np

from ..arrays import Matrix, Vector
from ..scenes.cell import Phase
from .divided import Waves, of_three, of_two


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
    gamma, square = phase.c / (2 * phase.m), phase.k / phase.m
    root = cmath.sqrt(_difference_of_squares(gamma, square))
    if root.imag:
        return -gamma + root, -gamma - root
    large = -(gamma + math.copysign(root.real, gamma))
    return (complex(square / large), complex(large)) if large else (0j, 0j)


def _difference_of_squares(gamma: float, square: float) -> float:
    if square <= 0:
        return gamma * gamma - square
    return (gamma - math.sqrt(square)) * (gamma + math.sqrt(square))


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
        parts = _differences(phase, omega, t.ravel())
        x, v, *_ = _responses(phase, start, angle, omega, t.ravel(), parts)
        if derivative == 2:
            x = _acceleration(phase, x, v, np.cos(omega * t.ravel() + angle))
    return np.asarray((x, v, x)[derivative]).reshape(t.shape)


def end(phase: Phase, start: Vector, angle: float, omega: float, duration: float) -> End:
    """Return the state in which a phase ends, with all its derivatives; see `motion`."""
    if phase.held:
        x, speed = start[0] + phase.speed * duration, phase.speed
        first = np.array([[1.0, 0.0], [0.0, 0.0]])
        change = np.array([phase.speed * duration, 0.0])
        return End(np.array([x, speed]), change, np.array([speed, 0.0]), np.zeros(2), first)
    with np.errstate(all="ignore"):
        t = np.array([duration])
        parts = _differences(phase, omega, t)
        x, v, by_start, by_angle = _responses(phase, start, angle, omega, t, parts)
        a = _acceleration(phase, x, v, np.cos(omega * t + angle))
        change = _change(phase, start, angle, omega, t, parts)
    state, field = np.array([x[0], v[0]]), np.array([v[0], a[0]])
    return End(state, change, field, by_angle[:, 0], by_start[:, :, 0])


def _acceleration(phase: Phase, x: Vector, v: Vector, cosine: Vector) -> Vector:
    return (phase.f + phase.g * cosine - phase.c * v - phase.k * x) / phase.m


def _differences(phase: Phase, omega: float, t: Vector) -> tuple[Waves, Waves, Waves]:
    """Return the responses to an impulse, to a constant force 1, to a harmonic one.

    Of a force that is zero the response is not looked for.
    """
    small, large = roots(phase)
    nothing = np.zeros(len(t), dtype=complex)
    return (
        of_two(small, large, t),
        of_three(small, large, 0j, t) if phase.f else nothing,
        of_three(small, large, 1j * omega, t) if phase.g else nothing,
    )


def _change(
    phase: Phase,
    start: Vector,
    angle: float,
    omega: float,
    t: Vector,
    parts: tuple[Waves, Waves, Waves],
) -> Vector:
    """Return the differences of x and x' from the start, with no difference of large numbers.

    As `_responses`, with ``exp(z) - 1`` for each ``exp(z)`` that stands alone.
    """
    small, large = roots(phase)
    impulse, constant, wave = parts
    x = (np.expm1(small * t) - small * impulse).real * start[0] + impulse.real * start[1]
    v = (np.expm1(large * t) + small * impulse).real * start[1]
    v = v + (phase.f - phase.k * start[0]) / phase.m * impulse.real
    if phase.f:
        x = x + phase.f / phase.m * constant.real
    if phase.g:
        turn = phase.g / phase.m * cmath.exp(1j * angle)
        x, v = x + (turn * wave).real, v + (turn * (1j * omega * wave + impulse)).real
    return np.array([x[0], v[0]])


def _responses(
    phase: Phase,
    start: Vector,
    angle: float,
    omega: float,
    t: Vector,
    parts: tuple[Waves, Waves, Waves],
) -> tuple[Vector, Vector, Vector, Vector]:
    """Return x and x', and their derivatives by the start and by the angle of the forcing."""
    small, large = roots(phase)
    impulse, constant, wave = parts
    # each as the sum that does not cancel: the smaller root stands at the impulse
    of_x = np.exp(small * t) - small * impulse
    of_v = np.exp(large * t) + small * impulse
    by_start = np.array([[of_x, impulse], [-phase.k / phase.m * impulse, of_v]]).real
    x = by_start[0, 0] * start[0] + by_start[0, 1] * start[1]
    v = by_start[1, 0] * start[0] + by_start[1, 1] * start[1]
    if phase.f:
        x = x + phase.f / phase.m * constant.real
        v = v + phase.f / phase.m * impulse.real
    by_angle = np.zeros((2, len(t)))
    if phase.g:
        turn = phase.g / phase.m * cmath.exp(1j * angle)
        forced = turn * np.array([wave, 1j * omega * wave + impulse])
        x, v = x + forced[0].real, v + forced[1].real
        by_angle = -forced.imag
    return x, v, by_start, by_angle
