"""Branches of two wells: their orbits may be symmetric where the oscillator is not."""

import pytest
from branch.wells import WELLS
from scipy.optimize import brentq

import nonsmooth as ns

#: Unequal stops, and a force at which the mass may stay in one well.
ONE_WELL = {
    "mass": 1.14, "damping": 0.107, "stiffness": 1.49, "negative": 0.84, "edge": 0.467,
    "left": 1.72, "right": 1.58, "force": 0.553, "frequency": 1.72,
}  # fmt: skip


def test_a_motion_that_never_ends_touches_the_edge_of_its_well() -> None:
    """The middle has a mirror image in the scene, the well has none: half an orbit is none."""
    case = WELLS(**ONE_WELL)
    start = ns.solve(case, phases="mid,right")
    branch = ns.branch(case, "frequency", 1.71, 1.86, start=start)
    assert branch.why_it_ended == ("the end of the range",) * 2
    (event,) = branch.events
    m, c, k, K, edge = (case.values[name] for name in list(ONE_WELL)[:5])

    def beyond(w: float) -> float:
        return case.values["force"] / abs(complex(k - m * w * w, c * w)) - K * edge / k

    assert event.parameter == pytest.approx(brentq(beyond, 1.6, 1.86, xtol=1e-15), rel=1e-12)
    assert {row.motion for row in branch} == {"mid_by_2,right", "only right"}
