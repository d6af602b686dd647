"""A phase that is shown to last for ever, by the energy of its transient.

The difference h of a motion from the steady response to the forcing obeys the equation of the
phase without any force, so that ``m h'^2 + k h^2`` does not grow.  Nothing is sampled: what the
phase demands is held against the least value that response and transient leave.
"""

import cmath
import math

from ..scenes.cell import Form, Phase

#: Rounding, as a part of the size of the terms of a form: what is below zero by that only
#: touches it, and is not an event.
ROUNDING = 2e-15


def lasts(phase: Phase, x: float, v: float, omega: float, angle: float) -> bool:
    """Return whether it is shown that a phase lasts for ever from a state on.

    The phase has numbers for the memory, and the forcing is ``cos(omega s + angle)``, `s` from
    that state; all without units.  False where it ends, and where that is not shown.
    """
    steady = _steady(phase, x, v, omega, angle)
    if steady is None:
        return False
    mean, wave, far, fast = steady

    def positive(form: Form, sign: int = 1) -> bool:
        ex, ev, ec, e0 = form
        turning = abs(ex * wave + ev * 1j * omega * wave + ec)
        least = sign * (ex * mean + e0) - turning - abs(ex) * far - abs(ev) * fast
        return least >= -ROUNDING * (abs(ex * mean) + abs(e0) + turning)

    kept = all(positive(form) for _, form in phase.demands)
    return kept and (positive(phase.event) or positive(phase.event, -1))


def _steady(
    phase: Phase, x: float, v: float, omega: float, angle: float
) -> tuple[float, complex, float, float] | None:
    """Return mean and wave of the steady response, and the most of the transient's h and h'.

    None where there is no such response, or the transient may grow.
    """
    if phase.held:
        return None if phase.speed else (x, 0j, 0.0, 0.0)
    m, c, k = phase.m, phase.c, phase.k
    stiffness = complex(k - m * omega**2, c * omega)
    if c < 0 or k < 0 or (phase.g and not stiffness):
        return None
    wave = phase.g / stiffness if phase.g else 0j
    now = wave * cmath.exp(1j * angle)
    h, rate = x - now.real, v - (1j * omega * now).real
    if k > 0:
        h -= phase.f / k
        fast = math.hypot(math.sqrt(k / m) * h, rate)
        return phase.f / k, wave, math.sqrt(m / k) * fast, fast
    if c == 0 or phase.f:
        return None
    far = m / c * rate  # what is left of the way: h' decays, and h with it
    return h + far, wave, abs(far), abs(rate)
