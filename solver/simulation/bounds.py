"""A linear form along a phase: Taylor coefficients, and a bound for what they leave out.

Every derivative of the displacement obeys the equation of motion itself, forced by a derivative
of the forcing.  The norm ``sqrt(kappa y**2 + y'**2)`` of a solution grows no faster than at the
logarithmic norm of its matrix, and the forcing adds at most its amplitude: that bounds all
derivatives over a window, from their values at its start alone.
"""

import math
from dataclasses import dataclass

from ..scenes.cell import Form, Phase

#: Taylor coefficients that are used; the bound is for the derivative of this order.
TERMS = 6


@dataclass(frozen=True)
class Local:
    """A phase at one instant: derivatives of the displacement and of the cosine there.

    Parameters
    ----------
    phase : Phase
    omega, angle : float
        The forcing is ``cos(omega s + angle)``, `s` from this instant.
    derivatives : tuple of float
        Of the displacement, from order 0 to `TERMS` and one more.
    sizes : tuple of float
        Of what each is the sum of, added without sign.
    """

    phase: Phase
    omega: float
    angle: float
    derivatives: tuple[float, ...]
    sizes: tuple[float, ...]


def local(
    phase: Phase, x: float, v: float, omega: float, angle: float, placed: bool = False
) -> Local:
    """Return a phase at a state; `placed` if the displacement is exact to its own rounding."""
    if phase.held:
        still = (x, phase.speed, *(0.0,) * TERMS)
        return Local(phase, omega, angle, still, tuple(map(abs, still)))
    # displacements are known to the rounding of the way in a unit of time, also where x is 0
    values, sizes = [x, v], [abs(x) + (0.0 if placed else abs(v)), abs(v)]
    m, power = phase.m, 1.0
    for j in range(TERMS):
        force = phase.g * power * math.cos(angle + j * math.pi / 2)
        constant = phase.f if j == 0 else 0.0
        values.append((constant + force - phase.c * values[-1] - phase.k * values[-2]) / m)
        own = abs(phase.c * values[-2]) + abs(phase.k * values[-3])
        sizes.append((abs(constant) + abs(phase.g) * power + own) / m)
        power *= omega
    return Local(phase, omega, angle, tuple(values), tuple(sizes))


def window(phase: Phase, omega: float) -> float:
    """Return a time over which the bound is not far too large; it may be infinite."""
    if phase.held:
        rate = omega
    else:
        rate = max(math.sqrt(abs(phase.k) / phase.m), omega if phase.g else 0.0)
        rate = max(rate, -phase.c / phase.m)
    return 2.0 / rate if rate else math.inf


def taylor(at: Local, form: Form) -> tuple[list[float], list[float]]:
    """Return the derivatives of a form by time up to `TERMS` - 1, and the size of each."""
    ex, ev, ec, constant = form
    values, sizes, power = [], [], 1.0
    for j in range(TERMS):
        wave = ec * power * math.cos(at.angle + j * math.pi / 2)
        rest = constant if j == 0 else 0.0
        values.append(ex * at.derivatives[j] + ev * at.derivatives[j + 1] + wave + rest)
        own = abs(ex) * at.sizes[j] + abs(ev) * at.sizes[j + 1]
        sizes.append(own + abs(ec) * power + abs(rest))
        power *= at.omega
    return values, sizes


def bound(at: Local, form: Form, s: float) -> float:
    """Return what the derivative of order `TERMS` of a form never exceeds within a time `s`."""
    ex, ev, ec, _ = form
    power = math.prod((at.omega,) * TERMS)
    wave = abs(ec) * power
    if at.phase.held:
        return wave
    phase = at.phase
    stiffness, damping = phase.k / phase.m, phase.c / phase.m
    rate = 1 / window(phase, at.omega)
    kappa = max(abs(stiffness), rate * rate) or 1.0
    growth = (-damping + math.hypot(damping, (kappa - stiffness) / math.sqrt(kappa))) / 2
    forced = abs(phase.g) / phase.m * power
    norm = math.hypot(math.sqrt(kappa) * at.derivatives[TERMS], at.derivatives[TERMS + 1])
    if not norm and not forced:
        return wave
    largest = (norm + forced * s) * math.exp(min(growth * s, 700.0))
    return abs(ex) * largest / math.sqrt(kappa) + abs(ev) * largest + wave
