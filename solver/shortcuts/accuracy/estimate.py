"""The error of an orbit, estimated without the exact one: by the change to a better orbit.

The C1 series converges faster than any power of its order, so four orders more are an orbit
next to which the error of the first is seen whole.  For a Fourier series that better orbit is
the C1 series at an order where it has long converged: more harmonics, or more C1 functions
beside them, would show a part of the error only, and where stick is too short for the
harmonics to resolve, nothing of it.  What the better orbit itself may be off by, and the
rounding that Newton's method left, are added.
"""

import math
from contextlib import nullcontext
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ...arrays import Vector
from ...compiling import PLAIN_ORDER
from ..orbit.methods import METHODS, Method
from ..search import kernels
from ..search.newton import Outcome, newton
from ..search.start import rough_times, with_coefficients
from ..series.spectral_errors import harmonics, normalised_error
from .errors import MANY_HARMONICS
from .quadrature import Shape, acceleration_difference

#: Order at which the C1 series has converged, and orders to more of it; at the highest there
#: is, to less.
CONVERGED_ORDER = 24
STEPS = (4, 3, 5, 6, -4)

#: Rounding of the times, as a part of ``T``, beside the last corrections of Newton's method;
#: of (22), where a jump misplaced by rounding counts by its square root.
ROUNDING, CORRECTIONS, ACCELERATION_ROUNDING = 2e-15, 4.0, 3e-8


@dataclass(frozen=True)
class Estimate:
    """Estimated errors of an orbit, without sign; infinite where nothing can be said.

    Parameters
    ----------
    period, t1 : float
        Of ``T`` and ``t1``, relative.
    acceleration : float
        Of (22).
    """

    period: float
    t1: float
    acceleration: float


NOTHING = Estimate(math.inf, math.inf, math.inf)


@lru_cache(maxsize=256)
def _c1_orbit(alpha: float, order: int) -> Vector | None:
    """Return the unknowns of the C1 series from the rough start, if they are an orbit's."""
    if order > METHODS["c1"].highest_order:
        return None
    load = kernels.quicker if order <= PLAIN_ORDER else kernels.compiled
    kernel = load("c1")
    with nullcontext() if kernel.account is None else kernel.account.spending():
        start = with_coefficients(kernel, alpha, order, *rough_times(alpha))
        outcome = newton(kernel.iterate, alpha, start)
    t1, T = outcome.unknowns[-2:]
    sound = outcome.converged and abs(t1 / (2 * alpha) - 1) <= 1 / (2 * order)
    return outcome.unknowns if sound and T - t1 <= 2 * math.pi * (1 + 1 / order) else None


def _better(alpha: float, order: int) -> tuple[int, Vector] | None:
    """Return an orbit of the C1 series of a few orders more than `order`."""
    for step in STEPS:
        found = _c1_orbit(alpha, order + step)
        if found is not None:
            return order + step, found
    return None


def estimate(method: Method, order: int, alpha: float, outcome: Outcome) -> Estimate:
    """Return the estimated errors of an orbit.

    Parameters
    ----------
    method, order, alpha : Method, int, float
        The expansion and the oscillator.
    outcome : Outcome
        The orbit, dimensionless.
    """
    z = outcome.unknowns
    near = _better(alpha, order if method.name == "c1" else CONVERGED_ORDER)
    if near is None:
        return NOTHING
    doubt = np.zeros(2)
    if method.name != "c1":
        beyond = _better(alpha, near[0])
        if beyond is None:
            return NOTHING
        doubt = np.abs(beyond[1][-2:] - near[1][-2:])
    t1, T = near[1][-2:]
    rounding = (ROUNDING + CORRECTIONS * outcome.correction) * T
    errors = np.abs(z[-2:] - near[1][-2:]) + doubt + rounding
    better = _shape(METHODS["c1"], near[0], alpha, near[1])
    if method.c1_terms is not None and order > MANY_HARMONICS:
        found = harmonics(z, order, method.c1_terms)
        acceleration = normalised_error(found, better, _sines(near[1], order))
    else:
        found_shape = _shape(method, order, alpha, z)
        acceleration = acceleration_difference(found_shape, better, order)
    jumps = ACCELERATION_ROUNDING * math.sqrt(T / (T - t1))
    return Estimate(
        period=float(errors[1] / T),
        t1=float(errors[0] / t1),
        acceleration=acceleration + jumps,
    )


def _shape(method: Method, order: int, alpha: float, z: Vector) -> Shape:
    def acceleration(t: Vector) -> Vector:
        return method.evaluate(z, order, t, 2, alpha)

    return Shape(float(z[-2]), float(z[-1]), acceleration)


def _sines(z: Vector, order: int) -> Vector:
    """Return the sine coefficients, about mid-stick, of the acceleration of a C1 series.

    Of its Legendre parts those of odd degree; the others vanish as it converges.
    """
    parts, (t1, T) = z[1:-2:2], z[-2:]
    functions = kernels.compiled("hb-symmetric").functions
    moments = functions["slip_moments"](len(parts), order, t1, T)[:, :, 0]
    return np.asarray(2 / T * parts @ moments)
