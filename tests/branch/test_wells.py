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


#: A force at which the mass goes through both wells, and touches no stop.
BOTH_WELLS = {
    "mass": 0.761, "damping": 0.131, "stiffness": 0.812, "negative": 0.504, "left": 1.72,
    "left_restitution": 0.5, "force": 0.284, "frequency": 0.664, "edge": 0.3249,
}  # fmt: skip


def test_a_symmetric_orbit_passes_a_branch_point_where_the_stops_are_unequal() -> None:
    """With equal ones the scene is odd: half of the orbit loses its symmetry there."""
    odd = ns.branches(WELLS(**BOTH_WELLS, right=1.72), "edge", 0.3, 0.35)
    points = [e.parameter for b in odd for e in b.events if e.kind == "branch-point"]
    expected = pytest.approx(points[0], abs=1e-10)  # no orbit is nearer than 1e-6
    assert points == [expected] * len(points)
    case = WELLS(**BOTH_WELLS, right=0.878)
    start = ns.solve(case, phases="mid,left,mid,right")
    branch = ns.branch(case, "edge", 0.32, 0.3262, start=start)
    assert branch.why_it_ended == ("the end of the range",) * 2
    assert [event.kind for event in branch.events] == ["fold", "branch-point"]
    event = branch.events[1]
    assert event.parameter == expected
    assert event.estimate < 1e-10
    at = [row.value for row in branch].index(event.parameter)
    assert branch[at].multipliers[0] == pytest.approx(1.0, abs=1e-6)
    assert [row.stable for row in (branch[at - 1], branch[at + 1])] == [True, False]
