"""Solutions of all methods against the references: another program, 30 digits."""

import numpy as np
import pytest
from galerkin.derived import REFERENCES, module, solutions
from galerkin.oscillators import SCENES, case_of
from galerkin.solving import solve, times_of

#: The matrices have conditions below 1e5, so that this leaves them a digit.
TOLERANCE = 1e-12

#: Scenes whose phases are those of another one, with other numbers.
REPEATED = ("S3c", "S5b", "S5c")

#: Two functions a switch are tried on scenes of one phase, and here on one of two; functions
#: of class C^2 on one scene of two (the files of the others are compared in tests/scenes).
COSTLY = {
    *((name, "hb_ck_2") for name in ("S2a", "S2b", "S4a", "S4b", "S5a")),
    *((name, "ck") for name in ("S2a", "S2b", "S4b")),
    *((name, "hb_ck_1") for name in ("S2a", "S4b")),
}


@pytest.mark.parametrize(
    ("name", "method", "row"),
    [
        pytest.param(
            *q,
            id=f"{q[0]}-{q[1]}-{q[2]['order']}",
            marks=pytest.mark.long if q[0] in REPEATED or q[:2] in COSTLY else [],
        )
        for q in solutions("ck_tau", "ck", "hb", "hb_ck_1", "hb_ck_2")
    ],
)
def test_times_and_states_are_those_of_the_references(name, method, row):
    kernel, case = module(name, method), case_of(name)
    expected = np.array(row["times"], dtype=float)
    z = solve(kernel, case, row["order"], 1.01 * expected)
    classes = zip(SCENES[name][0].phases, REFERENCES[name]["classes"], strict=True)
    unseen = sum(k + 1 for phase, k in classes if method == "ck" and phase.held is None)
    assert len(z) == row["unknowns"] + unseen
    np.testing.assert_allclose(times_of(kernel, z), expected, rtol=0, atol=TOLERANCE)
    sign = SCENES[name][0].sign
    for p in range(kernel.DURATIONS):
        ends = np.array([0.0, 1.0])
        (x, after), (v, before) = (kernel.motion(case, z, p, ends, j) for j in (0, 1))
        following = (p + 1) % kernel.DURATIONS
        turned = sign if following == 0 else 1
        got = [x, v, turned * after, turned * before]
        wanted = (
            *(row["x"][p], row["v"][p]),
            *(row["x"][following], row["v_before"][following]),
        )
        # a series has its errors of the state at the switches: as large as its terms
        np.testing.assert_allclose(got, np.array(wanted, float), rtol=0, atol=10 * TOLERANCE)


@pytest.mark.parametrize("name", REFERENCES)
def test_the_lowest_order_of_each_kernel_can_be_solved(name):
    """At the next lower order a condition is void, or an unknown."""
    times = np.array(REFERENCES[name]["exact"], float)
    kernel = module(name, "ck_tau")
    z = solve(kernel, case_of(name), kernel.LOWEST + 1, times)
    assert np.abs(times_of(kernel, z) - times).max() < 0.5
