"""The other reading of (21): accelerations compared at equal times, not at equal parts of T.

The paper integrates from 0 to T and does not say whose T that is, nor how motions of different
periods are laid over each other.  Its figures have t/T, and so has the (22) of this program.
"""

import math
from collections.abc import Iterable

import numpy as np

from nonsmooth.solver.accuracy.quadrature import panels
from nonsmooth.solver.shortcuts.orbit import exact
from nonsmooth.solver.shortcuts.orbit.methods import METHODS

from .case import Case
from .words import listed, percent


def error_at_equal_times(case: Case, method: str, order: int) -> float:
    """Return (22) with both accelerations at the same t, from 0 to the exact T.

    Raises
    ------
    NoOrbit
        If the method has no orbit there.
    """
    z = case.orbit(method, order).unknowns
    t1, T = exact.times(case.alpha)
    jumps = [float(time) / T for time in (t1, *z[-2:]) if time < T]
    part, weights = panels(jumps, max(order, 2))
    reference = exact.evaluate(case.alpha, T * part, 2)
    found = METHODS[method].evaluate(z, order, np.mod(T * part, z[-1]), 2, case.alpha)
    return math.sqrt(float(weights @ (found - reference) ** 2) / float(weights @ reference**2))


def reading(case: Case, order: int, methods: Iterable[str] = ("hb",)) -> str:
    """Return how (22) is read here, and what the other reading gives at an order."""
    both = [
        f"{method} {percent(error_at_equal_times(case, method, order))} instead of "
        f"{percent(case.acceleration_error(method, order))}"
        for method in methods
        if case.has(method, order)
    ]
    other = f"; compared at equal times t it would be, at N = {order}, {listed(both)}"
    return f"(22) is over normalised time t/T, our reading of (21){other if both else ''}."
