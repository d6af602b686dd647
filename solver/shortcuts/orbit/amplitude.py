"""How far a motion goes: half of the way between its two ends, dimensionless."""

from collections.abc import Callable

import numpy as np
import scipy  # its parts are loaded where they are used

from ...arrays import Vector
from ..search.kernels import functions_for
from .methods import Method
from .samples import samples

#: Times at which the first half of slip is looked at, beside those of the whole period.
SLIP_SAMPLES = 65


def amplitude(method: Method, order: int, alpha: float, z: Vector) -> float:
    """Return half of the way between the two ends of a motion.

    A C1 series turns once after each end of slip.  A Fourier series is odd about mid-stick;
    where it turns last is sought near the farthest of many samples.

    Parameters
    ----------
    method, order, alpha : Method, int, float
        The expansion and the oscillator.
    z : ndarray
        The unknowns of an orbit.
    """
    if method.c1_terms is None:
        return _of_c1(alpha, z)
    tau, displacement, velocity = samples(z, order, method.c1_terms)
    t1, T = z[-2:]
    start_of_slip = t1 / 2 + (T - t1) / 2 * np.linspace(0.0, 1.0, SLIP_SAMPLES)

    def motion(since: Vector, derivative: int) -> Vector:
        return method.evaluate(z, order, since + t1 / 2, derivative, alpha)

    return max(
        _farthest(motion, tau, displacement, velocity),
        _farthest(motion, start_of_slip, motion(start_of_slip, 0), motion(start_of_slip, 1)),
    )


def _farthest(
    motion: Callable[[Vector, int], Vector], tau: Vector, displacement: Vector, velocity: Vector
) -> float:
    """Return the largest of these displacements, or what lies beyond it up to the turn."""
    i = int(np.argmax(displacement))
    farthest = float(displacement[i])
    before, after = max(i - 1, 0), min(i + 1, len(tau) - 1)
    if not velocity[before] > 0 > velocity[after]:
        return farthest
    turn = scipy.optimize.brentq(
        lambda since: motion(np.array([since]), 1)[0], tau[before], tau[after]
    )
    return max(farthest, float(motion(np.array([turn]), 0)[0]))


def _of_c1(alpha: float, z: Vector) -> float:
    """Return half of the way between the ends of a C1 series."""
    forward, (t1, T) = z[:-2], z[-2:]
    order = len(forward) - 1
    functions = functions_for("c1", order)
    _, _, parts, _ = functions["band_tables"](order)
    twice = np.empty(len(forward) + 2)
    backward = forward.copy()
    backward[::2] *= -1
    above, below = (
        functions["overshoot"](alpha, p, parts, T - t1, twice) for p in (forward, backward)
    )
    return float(t1 + above + below) / 2
