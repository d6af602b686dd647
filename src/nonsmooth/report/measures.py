"""Measures of an orbit: errors against the exact one, and the overshoot beside a jump."""

import math
from collections.abc import Callable
from functools import partial

import numpy as np

from nonsmooth.kim_perkins import ExactStickSlipOrbit, StickSlipOrbit
from nonsmooth.solver.arrays import Vector
from nonsmooth.solver.orbit.errors import acceleration_error, derivative
from nonsmooth.solver.orbit.quadrature import panels

#: Samples of each phase for a largest value.
SAMPLES = 2000


def peak(orbit: StickSlipOrbit) -> tuple[float, float]:
    """Return time and value of the largest acceleration in the second half of stick."""
    times = np.linspace(orbit.t1 / 2, orbit.t1, SAMPLES, endpoint=False)
    values = orbit.acceleration(times)
    best = int(np.argmax(values))
    return float(times[best]), float(values[best])


def overshoot(orbit: StickSlipOrbit, exact: ExactStickSlipOrbit) -> float:
    """Return the overshoot of the acceleration before its jump, relative to the jump.

    The exact acceleration is 0 in stick and falls at its end.  Positive values in the second
    half of stick are Gibbs' phenomenon.
    """
    return peak(orbit)[1] / exact.case.largest_jump


def differences(orbit: StickSlipOrbit, exact: ExactStickSlipOrbit, quantity: str) -> Vector:
    """Return the errors of a quantity, with stick and slip each mapped onto the exact phase.

    That of the acceleration is relative to the jump; those of displacement, velocity and jerk
    to the exact amplitude of the quantity.
    """
    omega = exact.case.omega_n
    sizes = {
        "displacement": exact.case.amplitude,
        "velocity": exact.case.amplitude * omega,
        "acceleration": exact.case.largest_jump,
        "jerk": exact.case.amplitude * omega**3,
    }
    u, order = (np.arange(SAMPLES) + 0.5) / SAMPLES, list(sizes).index(quantity)
    errors = [derivative(orbit, p, u, order) - derivative(exact, p, u, order) for p in (0, 1)]
    return np.abs(errors) * (exact.case.units.of_motion(order) / sizes[quantity])


def largest(quantity: str, orbit: StickSlipOrbit, exact: ExactStickSlipOrbit) -> float:
    """Return the largest of the `differences` of a quantity."""
    return float(differences(orbit, exact, quantity).max())


def inside(orbit: StickSlipOrbit, exact: ExactStickSlipOrbit) -> float:
    """Return the largest error of the acceleration in the middle half of each phase."""
    quarter = SAMPLES // 4
    return float(differences(orbit, exact, "acceleration")[:, quarter:-quarter].max())


def error_at_equal_times(orbit: StickSlipOrbit, exact: ExactStickSlipOrbit) -> float:
    """Return (22) with both accelerations at the same t, from 0 to the exact T.

    This is the other reading of (21): the paper integrates from 0 to T, and does not say which
    period T is, nor how motions of different periods are compared.
    """
    T = exact.period
    jumps = [time / T for time in (exact.t1, orbit.t1, orbit.period) if time < T]
    part, weights = panels(jumps, max(orbit.order, 2))
    reference = exact.acceleration(T * part)
    difference = orbit.acceleration(T * part) - reference
    return math.sqrt(float(weights @ difference**2) / float(weights @ reference**2))


#: The measures by the names that the checks of the claims use.
MEASURES: dict[str, Callable[[StickSlipOrbit, ExactStickSlipOrbit], float]] = {
    "period": lambda orbit, exact: orbit.period / exact.period - 1,
    "acceleration": lambda orbit, exact: acceleration_error(orbit, exact, orbit.order),
    "acceleration at equal times": error_at_equal_times,
    "largest displacement": partial(largest, "displacement"),
    "largest velocity": partial(largest, "velocity"),
    "largest acceleration": partial(largest, "acceleration"),
    "largest jerk": partial(largest, "jerk"),
    "inside": inside,
    "overshoot": overshoot,
}
