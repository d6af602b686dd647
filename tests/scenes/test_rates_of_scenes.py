"""How fast the methods converge, class by class, against the theory.

With r the derivative in the decisive event and ``q = k + K + 2 - r`` the times of hb-ck fall
like ``N^-(2 ceil(q/2) - 1)``, since odd tails cancel at their own jump, and ``x^(k+1)`` in the
mean like ``N^-(K + 1/2)``; hb is K = 0.  Fitted over odd orders, since the series of half a
period have odd harmonics only.
"""

import math

import numpy as np
import pytest

from nonsmooth.solver.kernels import registry
from nonsmooth.solver.solve import solve_case

#: A scene of each class: its k, r of the decisive event, the orders of the fit.
CLASSES = {
    "impact-two-sided": (0, 1),
    "impact-inelastic": (0, 1),
    "dry-friction": (1, 1),
    "backlash": (2, 0),
}
ORDERS = (9, 13, 17, 23, 31)

#: Where the terms of next order are small only later.
LATER = {"backlash": (23, 29, 35, 41, 47)}


def errors_of(name, method, functions=None, orders=ORDERS):
    case = registry.load(name)()
    found = [solve_case(case, method, order, functions).errors for order in orders]
    return np.array([(q.times, q.discontinuous) for q in found])


def slopes(name, *method):
    orders = LATER.get(name, ORDERS)
    return -np.polyfit(np.log(orders), np.log(errors_of(name, *method, orders=orders)), 1)[0]


@pytest.mark.parametrize("functions", [0, 1, 2, 3])
@pytest.mark.parametrize(
    "name",
    [
        "dry-friction",
        *(pytest.param(q, marks=pytest.mark.long) for q in CLASSES if q[0] != "d"),
    ],
)
def test_rates_of_harmonics(name, functions):
    """As near as the terms of next order leave it.

    With the phase of the forcing, the derivative is off by as much as the times.
    """
    k, r = CLASSES[name]
    method = ("hb-ck", functions) if functions else ("hb",)
    times, derivative = slopes(name, *method)
    power = 2 * math.ceil((k + functions + 2 - r) / 2) - 1
    assert times == pytest.approx(power, abs=0.6)
    assert derivative == pytest.approx(min(functions + 0.5, power), abs=0.4)


@pytest.mark.parametrize("name", [*CLASSES, "elastic-plastic", "clearance"])
def test_polynomials_converge_faster_than_any_power(name):
    """Each two orders more divide the error by more than the two before, or by a hundred."""
    found = errors_of(name, "ck-tau", orders=(3, 5, 7, 9))[:, 0]
    above = found[found > 1e-13]
    ratios = above[:-1] / above[1:]
    assert (ratios > 20).all()
    assert found[-1] < 1e-8
