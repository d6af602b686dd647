"""The error of an orbit, estimated without the exact one: by the change to a better orbit.

The better orbit is that of the method whose times converge fastest, from the orbit's own times,
at an order where it has nearly always converged.  What it may be off by itself, the change to a
few orders more, is added, and so is the rounding that Newton's method left.
"""

import math

from ..case import registry
from ..case.methods import FIRST
from ..iteration.attempt import attempt
from ..orbit.orbit import SceneOrbit
from .errors import SceneErrors, difference

#: The order of the better orbit: so many more than the orbit's, and no less than that; nor more
#: than that, where the orbit is of a method whose errors are far larger at any order.
MORE, LEAST, MOST = 4, 20, 60

#: Rounding of the times, as a part of the period, beside the last corrections of Newton's
#: method; and of the derivative.
ROUNDING, CORRECTIONS, DERIVATIVE_ROUNDING = 2e-15, 4.0, 1e-14

NOTHING = SceneErrors(math.inf, math.inf, math.inf)


def estimate(orbit: SceneOrbit) -> SceneErrors:
    """Return the estimated errors of an orbit, without sign; infinite where none is known."""
    if FIRST not in registry.methods(orbit.case.scene):
        return NOTHING
    order = max(orbit.order + MORE, LEAST)
    if orbit.method != FIRST:
        order = min(order, MOST)
    better = _neighbour(orbit, order)
    beyond = better and _neighbour(better, order + MORE)
    if better is None or beyond is None:
        return NOTHING
    apart = difference(orbit, better, max(order, orbit.order))
    doubt = difference(better, beyond, order + MORE)
    rounding = ROUNDING + CORRECTIONS * orbit.outcome.correction
    return SceneErrors(
        period=abs(apart.period) + abs(doubt.period) + rounding,
        times=apart.times + doubt.times + rounding,
        discontinuous=apart.discontinuous
        + doubt.discontinuous
        + DERIVATIVE_ROUNDING
        + CORRECTIONS * orbit.outcome.correction,
    )


def _neighbour(orbit: SceneOrbit, order: int) -> SceneOrbit | None:
    """Return the orbit of the better method to which the times of an orbit lead.

    Where the conditions of that method are singular, by its functions of class C^1.
    """
    once = registry.class_one(orbit.case.scene, FIRST)
    for method in (FIRST, once) if orbit.method != once else (once,):
        if method is None:
            continue
        kernel = registry.quicker_kernel(orbit.case.scene, method, None, order)
        found = attempt(kernel, orbit.case, order, kernel.times(orbit.unknowns))
        if found.converged and found.admissible:
            return found
    return None
