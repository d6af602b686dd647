"""Closed-form motion of one linear phase from a given state, exact to rounding."""

import cmath
import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..arrays import Matrix, Vector
from ..scenes.cell import Phase
from .divided import exp, expm1, of_three, of_three_at, of_two, of_two_at


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
    found = _parts(phase, angle, omega, duration)
    state = np.array(found.state(x, v))
    a = (
        phase.f + phase.g * math.cos(omega * duration + angle)
        - phase.c * state[1] - phase.k * state[0]
    ) / phase.m  # fmt: skip
    return End(
        state,
        np.array(found.change(x, v)),
        np.array([state[1], a]),
        np.array(found.by_angle),
        np.array(found.by_start),
    )


def state_at(
    phase: Phase, x: float, v: float, angle: float, omega: float, t: float
) -> tuple[float, float]:
    """Return displacement and velocity a time after a phase starts with them; see `motion`."""
    if phase.held:
        return x + phase.speed * t, phase.speed
    return _parts(phase, angle, omega, t).state(x, v)


class _Parts(NamedTuple):
    """What a phase makes of its start, and of its forces, in a time.

    Parameters
    ----------
    forced : (float, float)
        Displacement and velocity by the forces alone.
    by_angle : (float, float)
        Their derivatives by the angle of the forcing.
    by_start : 2 x 2 float
        Derivatives of the state by the start.
    less : (float, float)
        Those of x by x and of v by v, less 1, to their own digits.
    """

    forced: tuple[float, float]
    by_angle: tuple[float, float]
    by_start: tuple[tuple[float, float], tuple[float, float]]
    less: tuple[float, float]

    def state(self, x: float, v: float) -> tuple[float, float]:
        """Return the state that a start comes to."""
        (xx, xv), (vx, vv) = self.by_start
        return xx * x + xv * v + self.forced[0], vx * x + vv * v + self.forced[1]

    def change(self, x: float, v: float) -> tuple[float, float]:
        """Return its difference from the start, with no difference of large numbers."""
        (_, xv), (vx, _) = self.by_start
        return (
            self.less[0] * x + xv * v + self.forced[0],
            self.less[1] * v + vx * x + self.forced[1],
        )


def _parts(phase: Phase, angle: float, omega: float, t: float) -> _Parts:
    small, large = roots(phase)
    impulse = of_two(small, large, t)
    # each as the sum that does not cancel: the smaller root stands at the impulse
    of_x = exp(small * t) - small * impulse
    of_v = exp(large * t) + small * impulse
    less = expm1(small * t) - small * impulse, expm1(large * t) + small * impulse
    x, v, by_angle = 0.0, 0.0, (0.0, 0.0)
    if phase.f:
        x = phase.f / phase.m * of_three(small, large, 0j, t).real
        v = phase.f / phase.m * impulse.real
    if phase.g:
        wave = of_three(small, large, 1j * omega, t)
        turn = phase.g / phase.m * cmath.exp(1j * angle)
        moved, moving = turn * wave, turn * (1j * omega * wave + impulse)
        x, v, by_angle = x + moved.real, v + moving.real, (-moved.imag, -moving.imag)
    by_start = (of_x.real, impulse.real), (-phase.k / phase.m * impulse.real, of_v.real)
    return _Parts((x, v), by_angle, by_start, (less[0].real, less[1].real))


def _acceleration(phase: Phase, x: Vector, v: Vector, cosine: Vector) -> Vector:
    return (phase.f + phase.g * cosine - phase.c * v - phase.k * x) / phase.m


def _states(
    phase: Phase, start: Vector, angle: float, omega: float, t: Vector
) -> tuple[Vector, Vector]:
    """Return displacement and velocity at times after the start of a free phase.

    As `_parts`; of a force that is zero the response is not looked for.
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
