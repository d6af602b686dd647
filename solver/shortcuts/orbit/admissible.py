"""Whether a converged solution is the orbit: the conditions that the equations leave out.

The Galerkin equations have other real solutions: pure slip about ``x_s`` with ``t1 = 0``,
and for the C1 series a few more.  None of them satisfies what friction demands.
"""

import math

import numpy as np

from ...arrays import Vector
from .methods import Method
from .oscillator import StickSlip
from .samples import samples

#: Of the oscillator in slip, dimensionless.
NATURAL_PERIOD = 2 * math.pi

#: Times at which each phase is looked at, beside its ends, per unit of order.
SAMPLES = 4


#: What rounding may add to a velocity or a travel that is exact by construction.
ROUNDING = 1e-6


#: Mean velocity in stick, as a part of V, of what still is an orbit.  A Fourier series of
#: few harmonics shortens stick; nothing but a spurious root makes it much longer.
STICK_VELOCITY = (0.5, 3.0)


def tolerance(method: Method, order: int) -> float:
    """Return the part of the stick travel ``2 A`` by which stick may miss the static limit.

    A Fourier series meets the limit by the symmetry of its orbit, to rounding.  The C1
    series does not: at order N it resolves the end of stick to about one part in ``2 N``,
    and a solution that misses by more has another shape.  The velocity has no such
    allowance: at both ends of slip it is V for every method, and below V between them.
    """
    return 1 / (2 * order) if method.name == "c1" else ROUNDING


def _sampled(method: Method, order: int, alpha: float, z: Vector) -> tuple[Vector, Vector]:
    """Return displacements in stick, and velocities in slip, at many times."""
    t1, T = z[-2:]
    if method.c1_terms is not None:
        tau, displacement, velocity = samples(z, order, method.c1_terms)
        stick = tau < t1 / 2
        return displacement[stick], velocity[~stick]
    part = np.linspace(0.0, 1.0, SAMPLES * order + 64)
    return (
        method.evaluate(z, order, t1 * part, 0, alpha),
        method.evaluate(z, order, t1 + (T - t1) * part[1:-1], 1, alpha),
    )


def violations(method: Method, order: int, belt: StickSlip, z: Vector) -> tuple[str, ...]:
    """Return what the solution `z` violates, in words; empty if it is an orbit.

    Checked are ``0 < t1 < T``; in slip a velocity not above ``V``; in stick a spring force
    within the static limit, and at ``t1`` equal to it; and that stick, a travel of ``2 A``,
    has something like the belt's velocity.
    """
    t1, T = z[-2:]
    if not 0 < t1 < T:
        start, period = t1 * belt.time_unit, T * belt.time_unit
        return (f"t1 = {start:.6g} s is not between 0 and T = {period:.6g} s",)
    allowed = tolerance(method, order)
    found = []
    if T - t1 > NATURAL_PERIOD * (1 + allowed):
        found.append(
            f"slip lasts {(T - t1) / NATURAL_PERIOD:.4g} natural periods: within one, the "
            "velocity is back at V"
        )
    alpha = belt.alpha
    displacement, velocity = _sampled(method, order, alpha, z)
    at_end = float((method.evaluate(z, order, z[-2:-1], 0, alpha)[0] - alpha) / (2 * alpha))
    highest = float((displacement.max(initial=-alpha) - alpha) / (2 * alpha))
    if abs(at_end) > allowed:
        found.append(
            f"stick ends {abs(at_end):.3g} of its travel "
            f"{'beyond' if at_end > 0 else 'short of'} the static limit "
            f"(allowed at order {order}: {allowed:.3g})"
        )
    elif highest > allowed:
        found.append(
            f"the spring force in stick exceeds the static limit by {highest:.3g} of the "
            f"travel (allowed at order {order}: {allowed:.3g})"
        )
    overspeed = float(velocity.max(initial=1.0) - 1.0)
    if overspeed > ROUNDING:
        found.append(f"the velocity in slip exceeds V by {overspeed:.3g} of it")
    mean = 2 * alpha / t1
    if not STICK_VELOCITY[0] <= mean <= STICK_VELOCITY[1]:
        found.append(
            f"the mean velocity in stick is {mean:.3g} V: order {order} does not resolve the "
            f"phases, {t1 / T:.3g} and {1 - t1 / T:.3g} of the period"
        )
    return tuple(found)
