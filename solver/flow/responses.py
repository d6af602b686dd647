"""Responses of a linear phase to its initial state and to its forces, at one time.

They are plain Python, compiled by numba with the exact equations and with simulations.
"""

from math import copysign, cos, sin, sqrt
from typing import Any

import numpy as np

from .divided import exp, expm1, of_three, of_two

#: Nodes and weights on ``(-1, 1)`` of the Gauss rule with 8 points.
NODES, WEIGHTS = (tuple(part.tolist()) for part in np.polynomial.legendre.leggauss(8))


def roots(m: float, c: float, k: float) -> tuple[complex, complex]:
    """Return the roots of ``m r**2 + c r + k = 0``, the one of smaller modulus first."""
    gamma, square = c / (2 * m), k / m
    if square <= 0:
        inside = gamma * gamma - square
    else:  # a difference of squares, factored to avoid cancellation
        inside = (gamma - sqrt(square)) * (gamma + sqrt(square))
    if inside < 0:
        omega_d = sqrt(-inside)
        return complex(-gamma, omega_d), complex(-gamma, -omega_d)
    large = -(gamma + copysign(sqrt(inside), gamma))
    if large == 0:
        return complex(0.0, 0.0), complex(0.0, 0.0)
    return complex(square / large, 0.0), complex(large, 0.0)


def by_start(
    m: float, c: float, k: float, s: float
) -> tuple[float, float, float, float, float, float]:
    """Return the entries of the transition matrix ``exp(A s)`` of (x, v).

    These are xx, xv, vx, vv, then xx - 1 and vv - 1 without cancellation, for the change of the
    state may be small.
    """
    small, large = roots(m, c, k)
    impulse = of_two(small, large, s)
    # with the smaller root as factor of the impulse, none of the sums cancels
    xx, vv = exp(small * s) - small * impulse, exp(large * s) + small * impulse
    less_x = expm1(small * s) - small * impulse
    less_v = expm1(large * s) + small * impulse
    return xx.real, impulse.real, -k / m * impulse.real, vv.real, less_x.real, less_v.real


def by_force(m: float, c: float, k: float, s: float) -> tuple[float, float]:
    """Return displacement and velocity after a time `s` from rest under a constant force 1."""
    small, large = roots(m, c, k)
    zero = complex(0.0, 0.0)
    return of_three(small, large, zero, s).real / m, of_two(small, large, s).real / m


def by_forcing(
    m: float, c: float, k: float, omega: float, angle: float, s: float
) -> tuple[float, float, float, float]:
    """Return displacement and velocity after a time `s` from rest at 0, and derivatives.

    The force is ``cos(omega t + angle)``, the derivatives are by the angle.
    """
    small, large = roots(m, c, k)
    wave = of_three(small, large, complex(0.0, omega), s)
    turn = complex(cos(angle) / m, sin(angle) / m)
    x = turn * wave
    v = turn * (complex(0.0, omega) * wave + of_two(small, large, s))
    return x.real, v.real, -x.imag, -v.imag


def by_change(m: float, c: float, k: float, omega: float, angle: float, s: float) -> float:
    """Return the displacement after a time `s` from rest at 0.

    The force is ``cos(omega t + angle) - cos(angle)``.  The response is a third divided
    difference with a node 0: for small arguments, the integral of the second by time.
    """
    small, large = roots(m, c, k)
    wave, zero = complex(0.0, omega), complex(0.0, 0.0)
    if max(abs(small), abs(large), omega) * abs(s) > 1:
        third = of_three(small, large, wave, s) - of_three(small, large, zero, s)
    else:
        third = zero
        for i in range(len(NODES)):
            part = (1 + NODES[i]) / 2 * s
            third += wave * (WEIGHTS[i] / 2 * s) * of_three(small, large, wave, part)
    return (complex(cos(angle), sin(angle)) * third).real / m


def state_at(
    phase: Any, x: float, v: float, angle: float, omega: float, s: float
) -> tuple[float, float]:
    """Return displacement and velocity a time `s` after a phase starts at x and v."""
    if phase.held:
        return x + phase.speed * s, phase.speed
    m, c, k = phase.m, phase.c, phase.k
    xx, xv, vx, vv, _, _ = by_start(m, c, k, s)
    x, v = xx * x + xv * v, vx * x + vv * v
    if phase.f != 0:
        unit_x, unit_v = by_force(m, c, k, s)
        x, v = x + phase.f * unit_x, v + phase.f * unit_v
    if phase.g != 0:
        unit_x, unit_v, _, _ = by_forcing(m, c, k, omega, angle, s)
        x, v = x + phase.g * unit_x, v + phase.g * unit_v
    return x, v
