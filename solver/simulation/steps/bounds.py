"""A linear form along a phase: its derivatives, and a bound of the Taylor remainder.

Every derivative of the displacement obeys the equation of motion itself, forced by a derivative
of the forcing.  The norm ``sqrt(kappa y**2 + y'**2)`` of a solution grows at most at the rate
of the logarithmic norm of its matrix, and the forcing adds at most its amplitude: this bounds
all derivatives over a window by their values at its start.
"""

from math import cos, exp, inf, sin, sqrt
from typing import NamedTuple

from ...scenes.cell import Form, Phase

#: Number of Taylor coefficients; the remainder is bounded by the derivative of this order.
TERMS = 6


class Equation(NamedTuple):
    """A phase in numbers: ``m x'' + c x' + k x = f + g cos(omega t + phi)``, or ``x' = speed``.

    As `Phase`, with the memory evaluated into `f`, and with the frequency of the forcing.
    """

    m: float
    c: float
    k: float
    f: float
    g: float
    held: bool
    speed: float
    omega: float


class Local(NamedTuple):
    """A phase at one instant: derivatives of the displacement and of the cosine there.

    Parameters
    ----------
    phase : Equation
    derivatives : tuple of float
        Of the displacement, of orders 0 to `TERMS` + 1.
    sizes : tuple of float
        The sum of the moduli of the terms of each derivative: its rounding is a part of it.
    powers, waves : tuple of float
        Amplitudes and values of the derivatives of the cosine, of orders 0 to `TERMS` - 1.
    """

    phase: Equation
    derivatives: tuple[float, ...]
    sizes: tuple[float, ...]
    powers: tuple[float, ...]
    waves: tuple[float, ...]


def local(phase: Equation, x: float, v: float, angle: float, placed: bool) -> Local:
    """Return the derivatives at a state; `placed`: its displacement is exact to rounding."""
    p1 = phase.omega
    p2 = p1 * p1
    p3, p4, p5 = p2 * p1, p2 * p1 * p1, p2 * p1 * p1 * p1
    powers = (1.0, p1, p2, p3, p4, p5)
    cosine, sine = cos(angle), sin(angle)
    waves = (cosine, -p1 * sine, -p2 * cosine, p3 * sine, p4 * cosine, -p5 * sine)
    if phase.held:
        v = phase.speed
        sizes = (abs(x), abs(v), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
        return Local(phase, (x, v, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0), sizes, powers, waves)
    x2, of_2 = _derivative(phase, x, v, phase.f, 1.0, waves[0])
    x3, of_3 = _derivative(phase, v, x2, 0.0, p1, waves[1])
    x4, of_4 = _derivative(phase, x2, x3, 0.0, p2, waves[2])
    x5, of_5 = _derivative(phase, x3, x4, 0.0, p3, waves[3])
    x6, of_6 = _derivative(phase, x4, x5, 0.0, p4, waves[4])
    x7, of_7 = _derivative(phase, x5, x6, 0.0, p5, waves[5])
    # a displacement is known to the rounding of |x| + |v|, also where x is 0
    size_of_x = abs(x) + (0.0 if placed else abs(v))
    sizes = (size_of_x, abs(v), of_2, of_3, of_4, of_5, of_6, of_7)
    return Local(phase, (x, v, x2, x3, x4, x5, x6, x7), sizes, powers, waves)


def _derivative(
    phase: Equation, x: float, v: float, f: float, power: float, wave: float
) -> tuple[float, float]:
    """Return the acceleration of a solution x of the equation of motion, and its size."""
    m, c, k, g = phase.m, phase.c, phase.k, phase.g
    size = (abs(f) + abs(g) * power + abs(c * v) + abs(k * x)) / m
    return (f + g * wave - c * v - k * x) / m, size


def window(phase: Equation | Phase, omega: float) -> float:
    """Return a time over which `bound` is not far too large; it may be infinite."""
    rate = omega if phase.held or phase.g != 0 else 0.0
    if not phase.held:
        rate = max(rate, sqrt(abs(phase.k) / phase.m), -phase.c / phase.m)
    return 2.0 / rate if rate > 0 else inf


def taylor(at: Local, form: Form) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return the time derivatives of a form up to order `TERMS` - 1, and the size of each."""
    ex, ev, ec, constant = form
    x0, x1, x2, x3, x4, x5, x6, _ = at.derivatives
    w0, w1, w2, w3, w4, w5 = at.waves
    values = (
        ex * x0 + ev * x1 + ec * w0 + constant, ex * x1 + ev * x2 + ec * w1,
        ex * x2 + ev * x3 + ec * w2, ex * x3 + ev * x4 + ec * w3,
        ex * x4 + ev * x5 + ec * w4, ex * x5 + ev * x6 + ec * w5,
    )  # fmt: skip
    ex, ev, ec, constant = abs(ex), abs(ev), abs(ec), abs(constant)
    s0, s1, s2, s3, s4, s5, s6, _ = at.sizes
    p0, p1, p2, p3, p4, p5 = at.powers
    sizes = (
        ex * s0 + ev * s1 + ec * p0 + constant, ex * s1 + ev * s2 + ec * p1,
        ex * s2 + ev * s3 + ec * p2, ex * s3 + ev * s4 + ec * p3,
        ex * s4 + ev * s5 + ec * p4, ex * s5 + ev * s6 + ec * p5,
    )  # fmt: skip
    return values, sizes


def bound(at: Local, form: Form, s: float) -> float:
    """Return a bound of the derivative of order `TERMS` of a form within a time `s`."""
    ex, ev, ec, _ = form
    m, c, k, _, g, held, _, omega = at.phase
    power = at.powers[TERMS - 1] * omega
    wave = abs(ec) * power
    if held:
        return wave
    stiffness, damping, rate = k / m, c / m, 1 / window(at.phase, omega)
    kappa = max(abs(stiffness), rate * rate)
    kappa = kappa if kappa > 0 else 1.0
    root = sqrt(kappa)
    growth = (-damping + length(damping, (kappa - stiffness) / root)) / 2
    forced = abs(g) / m * power
    norm = length(root * at.derivatives[TERMS], at.derivatives[TERMS + 1])
    if norm == 0 and forced == 0:
        return wave
    largest = (norm + forced * s) * exp(min(growth * s, 700.0))
    return abs(ex) * largest / root + abs(ev) * largest + wave


def length(a: float, b: float) -> float:
    """Return ``hypot(a, b)``, with the same bits in Python and numba, unlike the built-in."""
    large = max(abs(a), abs(b))
    if not 0 < large < inf:
        return large
    a, b = a / large, b / large
    return large * sqrt(a * a + b * b)
