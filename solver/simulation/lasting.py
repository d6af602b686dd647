"""Proof that a phase lasts for ever, by the energy of its transient.

The difference h of a motion from the steady response to the forcing obeys the equation of the
phase without force, so ``m h'^2 + k h^2`` does not grow.  Nothing is sampled: each demand of
the phase is checked at a lower bound, from the response and the bound of the transient.
"""

import cmath
import math

from ..scenes.cell import Form, Phase

#: Rounding of a form, relative to the size of its terms: a form below zero by no more only
#: touches zero, which is no event.
ROUNDING = 2e-15


def lasts(phase: Phase, x: float, v: float, omega: float, angle: float) -> bool:
    """Return whether a phase is proven to last for ever from a state on.

    The memory of the phase is in numbers; the forcing is ``cos(omega s + angle)``, with s = 0
    at the state; all without units.  False if the phase ends, or if the bounds do not decide.
    """
    steady = _steady(phase, x, v, omega, angle)
    if steady is None:
        return False
    mean, wave, far, fast = steady

    def positive(form: Form, sign: int = 1) -> bool:
        ex, ev, ec, e0 = form
        turning = abs(ex * wave + ev * 1j * omega * wave + ec)  # the amplitude about its mean
        least = sign * (ex * mean + e0) - turning - abs(ex) * far - abs(ev) * fast
        return least >= -ROUNDING * (abs(ex * mean) + abs(e0) + turning)

    holds = all(positive(form) for _, form in phase.demands)
    return holds and (positive(phase.event) or positive(phase.event, -1))


def _steady(
    phase: Phase, x: float, v: float, omega: float, angle: float
) -> tuple[float, complex, float, float] | None:
    """Return mean and complex amplitude of the steady response, and bounds of h and h'.

    None if there is no such response, or the transient may grow.
    """
    if phase.held:
        return None if phase.speed else (x, 0j, 0.0, 0.0)
    m, c, k, steady = phase.m, phase.c, phase.k, response(phase, omega)
    if steady is None or c < 0 or k < 0 or c == k == 0:
        return None
    mean, wave = steady
    wave_now = wave * cmath.exp(1j * angle)
    h, rate = x - mean - wave_now.real, v - (1j * omega * wave_now).real
    if k > 0:
        fast = math.hypot(math.sqrt(k / m) * h, rate)
        return mean, wave, math.sqrt(m / k) * fast, fast
    far = m / c * rate  # the way left: h' decays exponentially, h tends to h + far
    return h + far, wave, abs(far), abs(rate)


def response(phase: Phase, omega: float) -> tuple[float, complex] | None:
    """Return mean and complex amplitude of the steady response; None if there is none."""
    m, c, k = phase.m, phase.c, phase.k
    stiffness = complex(k - m * omega**2, c * omega)
    if (phase.g and not stiffness) or (k == 0 and phase.f):
        return None
    return phase.f / k if k else 0.0, phase.g / stiffness if phase.g else 0j
