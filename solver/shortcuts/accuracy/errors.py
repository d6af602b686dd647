"""Errors against the exact orbit: period, end of stick, and the measure (22).

(22) compares accelerations over normalised time ``t/T``, as the paper's figures do.  Both
functions jump, at different places; the integral is taken between the jumps, by Gauss
rules with enough panels for the highest harmonic.
"""

import math
from dataclasses import dataclass

from ...accuracy.quadrature import panels
from ...arrays import Vector
from ..orbit import exact
from ..orbit.methods import Method
from ..series.spectral_errors import spectral_errors
from .quadrature import Shape, acceleration_difference

#: Harmonics above which sums over them replace quadrature, whose cost is their square.
MANY_HARMONICS = 200


@dataclass(frozen=True)
class Errors:
    """Errors of an orbit against the exact one.

    Parameters
    ----------
    period : float
        ``T/T_exact - 1``, signed.
    t1 : float
        ``t1/t1_exact - 1``, signed.
    acceleration : float
        (22), on normalised time.  A jump misplaced by ``dt`` contributes ``sqrt(dt)``:
        in float64 the measure cannot go below about 1e-8.  For a Fourier series of more than
        200 harmonics it is summed over them, and rounding is about 1e-7.
    acceleration_aligned : float
        The same with each phase mapped onto the exact one, so that the jumps coincide: it
        goes down to rounding, and says nothing of the times, which have errors of their own.
    """

    period: float
    t1: float
    acceleration: float
    acceleration_aligned: float


def acceleration_error(method: Method, order: int, alpha: float, z: Vector) -> float:
    """Return (22), the difference from the exact orbit."""
    found = Shape(float(z[-2]), float(z[-1]), lambda t: method.evaluate(z, order, t, 2, alpha))
    reference = Shape(*exact.times(alpha), lambda t: exact.evaluate(alpha, t, 2))
    return acceleration_difference(found, reference, order)


def aligned_acceleration_error(method: Method, order: int, alpha: float, z: Vector) -> float:
    """Return (22) with stick compared to stick and slip to slip, each over its own time."""
    t1, T = z[-2:]
    exact_t1, exact_T = exact.times(alpha)
    u, weights = panels([], max(order, 2))
    difference = size = 0.0
    for start, end, exact_start, exact_end in (
        (0.0, t1, 0.0, exact_t1),
        (t1, T, exact_t1, exact_T),
    ):
        there, here = start + (end - start) * u, exact_start + (exact_end - exact_start) * u
        reference = exact.evaluate(alpha, here, 2)
        found = method.evaluate(z, order, there, 2, alpha)
        duration = exact_end - exact_start
        difference += duration * float(weights @ (found - reference) ** 2)
        size += duration * float(weights @ reference**2)
    return math.sqrt(difference / size)


def errors(method: Method, order: int, alpha: float, z: Vector) -> Errors:
    """Return the errors of the dimensionless solution `z`."""
    t1, T = z[-2:]
    exact_t1, exact_T = exact.times(alpha)
    if method.c1_terms is not None and order > MANY_HARMONICS:
        acceleration, aligned = spectral_errors(z, order, alpha, method.c1_terms)
    else:
        acceleration = acceleration_error(method, order, alpha, z)
        aligned = aligned_acceleration_error(method, order, alpha, z)
    return Errors(
        period=float((T - exact_T) / exact_T),
        t1=float((t1 - exact_t1) / exact_t1),
        acceleration=acceleration,
        acceleration_aligned=aligned,
    )
