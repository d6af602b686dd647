"""What a linear phase makes of its start and of its forces in a time, in plain numbers.

As Python, and compiled by numba with the exact equations and with simulations.
"""

from math import copysign, cos, sin, sqrt
from typing import Any

import numpy as np

from .divided import exp, expm1, of_three, of_two

#: Nodes and weights on ``(-1, 1)`` of the rule of Gauss of 8 points.
NODES, WEIGHTS = (tuple(part.tolist()) for part in np.polynomial.legendre.leggauss(8))


def roots(m: float, c: float, k: float) -> tuple[complex, complex]:
    """Return the roots of ``m r**2 + c r + k = 0``, the one of smaller modulus first."""
    gamma, square = c / (2 * m), k / m
    if square <= 0:
        inside = gamma * gamma - square
    else:  # the difference of two squares, without their rounding
        inside = (gamma - sqrt(square)) * (gamma + sqrt(square))
    if inside < 0:
        turning = sqrt(-inside)
        return complex(-gamma, turning), complex(-gamma, -turning)
    large = -(gamma + copysign(sqrt(inside), gamma))
    if large == 0:
        return complex(0.0, 0.0), complex(0.0, 0.0)
    return complex(square / large, 0.0), complex(large, 0.0)


def by_start(
    m: float, c: float, k: float, s: float
) -> tuple[float, float, float, float, float, float]:
    """Return the derivatives of the state after a time `s` by that before.

    Those of x by x, of x by v, of v by x, of v by v; then the first and the last less 1, to
    their own digits: a phase may end where it began.
    """
    small, large = roots(m, c, k)
    impulse = of_two(small, large, s)
    # each as the sum that does not cancel: the smaller root stands at the impulse
    xx, vv = exp(small * s) - small * impulse, exp(large * s) + small * impulse
    less_x = expm1(small * s) - small * impulse
    less_v = expm1(large * s) + small * impulse
    return xx.real, impulse.real, -k / m * impulse.real, vv.real, less_x.real, less_v.real


def by_force(m: float, c: float, k: float, s: float) -> tuple[float, float]:
    """Return displacement and velocity after a time `s` of a constant force 1."""
    small, large = roots(m, c, k)
    zero = complex(0.0, 0.0)
    return of_three(small, large, zero, s).real / m, of_two(small, large, s).real / m


def by_forcing(
    m: float, c: float, k: float, omega: float, angle: float, s: float
) -> tuple[float, float, float, float]:
    """Return displacement and velocity after a time `s` of a force ``cos(omega t + angle)``.

    Then their derivatives by the angle.
    """
    small, large = roots(m, c, k)
    wave = of_three(small, large, complex(0.0, omega), s)
    turn = complex(cos(angle) / m, sin(angle) / m)
    moved = turn * wave
    moving = turn * (complex(0.0, omega) * wave + of_two(small, large, s))
    return moved.real, moving.real, -moved.imag, -moving.imag


def by_change(m: float, c: float, k: float, omega: float, angle: float, s: float) -> float:
    """Return displacement after a time `s` of a force ``cos(omega t + angle) - cos(angle)``.

    It is a third divided difference, one of its nodes 0: the integral of the second by time.
    """
    small, large = roots(m, c, k)
    wave, zero = complex(0.0, omega), complex(0.0, 0.0)
    if max(abs(small), abs(large), omega) * abs(s) > 1:
        found = of_three(small, large, wave, s) - of_three(small, large, zero, s)
    else:
        found = zero
        for i in range(len(NODES)):
            part = (1 + NODES[i]) / 2 * s
            found += wave * (WEIGHTS[i] / 2 * s) * of_three(small, large, wave, part)
    return (complex(cos(angle), sin(angle)) * found).real / m


def state_at(
    phase: Any, x: float, v: float, angle: float, omega: float, s: float
) -> tuple[float, float]:
    """Return displacement and velocity a time `s` after a phase starts with them."""
    if phase.held:
        return x + phase.speed * s, phase.speed
    m, c, k = phase.m, phase.c, phase.k
    xx, xv, vx, vv, _, _ = by_start(m, c, k, s)
    there, rate = xx * x + xv * v, vx * x + vv * v
    if phase.f != 0:
        moved, moving = by_force(m, c, k, s)
        there, rate = there + phase.f * moved, rate + phase.f * moving
    if phase.g != 0:
        moved, moving, _, _ = by_forcing(m, c, k, omega, angle, s)
        there, rate = there + phase.g * moved, rate + phase.g * moving
    return there, rate
