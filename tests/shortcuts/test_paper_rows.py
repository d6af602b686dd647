"""The paper's own rows against S0 of the references."""

import pytest

import nonsmooth as ns

#: S0 of the references: method, order, end of stick, duration of slip.
PAPER = [
    ("hb", 5, 1.875462157353506912107, 4.777482415197889839387),
    ("hb", 9, 1.926406180724765044118, 4.750044560980750508907),
    ("hb-c1", 5, 2.003275341723989466195, 4.710778250731596045018),
    ("c1", 4, 1.825659942582271649211, 4.890257951267988441462),
    ("c1", 7, 2.000074538205047259564, 4.712309270499867232924),
]


@pytest.mark.parametrize(("method", "order", "stick", "slip"), PAPER)
def test_the_papers_own_rows_give_s0_of_the_references(method, order, stick, slip):
    belt = ns.StickSlip(mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0, normal_force=1)
    orbit = ns.solve(belt, method, order)
    assert (orbit.t1, orbit.period - orbit.t1) == pytest.approx((stick, slip), rel=1e-12)
