"""The ends of a motion of the paper's oscillator: least and largest displacement, velocity."""

from collections.abc import Callable

import numpy as np
import scipy  # its parts are loaded where they are used

from ...arrays import Vector
from ...orbit import chebyshev
from .methods import Method
from .samples import samples

#: Harmonics up to which each phase is followed through all its critical points; beyond, the
#: ends are sought near the farthest of many samples.
MOST_FOLLOWED = 32


def extremes(
    method: Method, order: int, alpha: float, z: Vector, derivative: int
) -> tuple[float, float]:
    """Return the least and the largest value of a derivative over a period, dimensionless.

    Parameters
    ----------
    method, order, alpha : Method, int, float
        The expansion and the oscillator.
    z : ndarray
        The unknowns of an orbit.
    derivative : {0, 1}
    """

    def value(t: Vector) -> Vector:
        return method.evaluate(z, order, t, derivative, alpha)

    if method.c1_terms is not None and order > MOST_FOLLOWED:
        return _near_samples(z, order, method.c1_terms, derivative, value)
    t1, T = map(float, z[-2:])
    found = []
    for start, end in ((0.0, t1), (t1, T)):
        last = np.nextafter(end, 0.0)

        def part(u: Vector, start: float = start, last: float = last) -> Vector:
            return value(np.minimum(start + (last - start) * u, last))

        found.append(chebyshev.extremes(part))
    return min(low for low, _ in found), max(high for _, high in found)


def _near_samples(
    z: Vector, order: int, terms: int, derivative: int, value: Callable[[Vector], Vector]
) -> tuple[float, float]:
    """Return the ends of a series that is odd about mid-stick, near the farthest samples."""
    tau, *sampled = samples(z, order, terms)
    t1, T = z[-2:]
    values, step = sampled[derivative], tau[1] - tau[0]
    ends = []
    for sign in (1.0, -1.0) if derivative else (1.0,):
        near = t1 / 2 + tau[int(np.argmax(sign * values))]

        def beyond(t: float, sign: float = sign) -> float:
            return -sign * float(value(np.array([t % T]))[0])

        found = scipy.optimize.minimize_scalar(
            beyond, bounds=(near - step, near + step), options={"xatol": 1e-6 * step}
        )
        ends.append(-sign * float(found.fun))
    return (ends[1], ends[0]) if derivative else (-ends[0], ends[0])
