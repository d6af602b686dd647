"""The estimated error against the true one: calibration, rounding, nothing known."""

import json
import math
import os

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.solver import estimate
from nonsmooth.solver.belt import DEFAULT
from nonsmooth.solver.estimate import Estimate, _sines
from nonsmooth.solver.methods import METHODS

EXAMPLES = int(os.environ.get("EXAMPLES", "1200")) // 8


def belt_at(alpha: float) -> ns.StickSlip:
    return ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )


def rounding(orbit: ns.Orbit) -> Estimate:
    """Return errors below which rounding decides, not the method."""
    t1, T = orbit.unknowns[-2:]
    return Estimate(1e-14, 1e-14 * T / t1, 2e-7 * math.sqrt(T / (T - t1)))


orders = {
    "hb": st.one_of(st.integers(1, 60), st.integers(61, 600)),
    "hb-c1": st.one_of(st.integers(1, 60), st.integers(61, 600)),
    "c1": st.integers(1, 40),
}


@settings(max_examples=EXAMPLES)
@given(st.sampled_from(list(METHODS)), st.floats(-3, 3), st.data())
def test_the_estimate_is_at_least_half_and_at_most_20_times_the_error(
    method: str, exponent: float, data: st.DataObject
) -> None:
    """Measured on 1034 orbits: 1.0 to 1.6 (period), 0.97 to 1.3 (t1), 1.0 to 1.1 (22)."""
    order = data.draw(orders[method])
    try:
        orbit = ns.solve(belt_at(10**exponent), method, order, many=True)
    except ns.NoOrbit:
        return
    floor = rounding(orbit)
    for name in ("period", "t1", "acceleration"):
        error, estimated = abs(getattr(orbit.errors, name)), getattr(orbit.estimate, name)
        assert estimated >= 0.5 * error
        if error > getattr(floor, name):
            assert estimated <= 20 * error
        else:
            assert estimated <= 20 * getattr(floor, name)


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
def test_the_estimate_holds_for_very_many_harmonics(method: str) -> None:
    orbit = ns.solve(DEFAULT, method, 5000)
    for name in ("period", "t1", "acceleration"):
        error, estimated = abs(getattr(orbit.errors, name)), getattr(orbit.estimate, name)
        assert 0.9 * error <= estimated <= 1.2 * error + 1e-14


@pytest.mark.parametrize(("method", "order"), [("hb", 5), ("hb-c1", 5), ("c1", 9)])
def test_where_no_better_orbit_is_found_nothing_is_claimed(
    monkeypatch, run, method: str, order: int
) -> None:
    monkeypatch.setattr(estimate, "_c1_orbit", lambda alpha, order: None)
    assert ns.solve(DEFAULT, method, order).estimate.period == math.inf
    _, out, _ = run("solve", "--method", method, "--order", order, "--json")
    document = json.loads(out)
    assert document["admissible"] is True
    assert document["estimate"] == {"period": None, "t1": None, "acceleration": None}


@pytest.mark.parametrize("order", [399, 400])
def test_the_highest_order_has_an_estimate(order: int) -> None:
    assert ns.solve(DEFAULT, "c1", order, many=True).estimate.period < 1e-14


def test_sines_of_a_c1_series_are_its_harmonics() -> None:
    orbit = ns.solve(DEFAULT, "c1", 24)
    z, (t1, T) = orbit.unknowns, orbit.unknowns[-2:]
    tau = T * np.arange(4096) / 4096
    t = np.mod(tau + t1 / 2, T)
    acceleration = METHODS["c1"].evaluate(z, 24, t, 2, 1.0)
    expected = -np.fft.rfft(acceleration)[1:6].imag / 2048
    np.testing.assert_allclose(_sines(z, 5), expected, atol=1e-3)  # it jumps: 1/4096


def test_rows_and_csv_have_the_estimate(run, tmp_path) -> None:
    target = tmp_path / "rows.csv"
    status, out, _ = run("sweep", "--methods", "c1", "--orders", "5,9", "-o", target, "--json")
    assert status == 0
    row = json.loads(out)["rows"][0]
    assert row["estimate"]["period"] == pytest.approx(5.46e-5, rel=0.1)
    header, first, _ = target.read_text().splitlines()
    values = dict(zip(header.split(","), first.split(","), strict=True))
    assert float(values["estimate_period"]) == row["estimate"]["period"]
