"""The estimated error against the true one: calibration, rounding, nothing known."""

import json
import math
import os
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.solver.shortcuts.accuracy import estimate
from nonsmooth.solver.shortcuts.accuracy.estimate import Estimate, _sines
from nonsmooth.solver.shortcuts.orbit import exact
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
from nonsmooth.solver.shortcuts.search import kernels
from nonsmooth.solver.shortcuts.search.newton import newton
from nonsmooth.solver.shortcuts.search.start import rough_times, with_coefficients

EXAMPLES = int(os.environ.get("EXAMPLES", "1200")) // 20


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


@pytest.mark.parametrize("method", METHODS)
def test_the_estimate_is_at_least_half_and_at_most_20_times_the_error(method: str) -> None:
    """Measured on 1034 orbits: 1.0 to 1.6 (period), 0.97 to 1.3 (t1), 1.0 to 1.1 (22)."""
    seen = []

    @settings(max_examples=EXAMPLES // 3)
    @given(st.floats(-3, 3), orders[method])
    def run(exponent: float, order: int) -> None:
        try:
            orbit = ns.solve(belt_at(10**exponent), method, order, many=True)
        except ns.NoOrbit:
            return
        seen.append(order)
        floor = rounding(orbit)
        for name in ("period", "t1", "acceleration"):
            error, estimated = abs(getattr(orbit.errors, name)), getattr(orbit.estimate, name)
            assert estimated >= 0.5 * error
            if error > getattr(floor, name):
                assert estimated <= 20 * error
            else:
                assert estimated <= 20 * getattr(floor, name)

    run()
    assert len(seen) >= 0.5 * (EXAMPLES // 3)


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
def test_what_the_better_orbit_may_be_off_by_is_added(monkeypatch, method: str) -> None:
    """As if the series had converged at order 5: it is off by 5.46e-5 there."""
    monkeypatch.setattr(estimate, "CONVERGED_ORDER", 1)
    orbit = ns.solve(DEFAULT, method, 40)
    near, beyond = (ns.solve(DEFAULT, "c1", order) for order in (5, 9))
    change = np.abs(orbit.unknowns[-2:] - near.unknowns[-2:])
    doubt = np.abs(beyond.unknowns[-2:] - near.unknowns[-2:])
    t1, T = near.unknowns[-2:]
    assert orbit.estimate.t1 == pytest.approx((change + doubt)[0] / t1, rel=1e-9)
    assert orbit.estimate.period == pytest.approx((change + doubt)[1] / T, rel=1e-9)


def test_an_error_like_that_of_the_better_orbit_is_seen(monkeypatch) -> None:
    """Both are off to the same side, by 9.3e-5 and 5.5e-5: their difference says too little."""
    monkeypatch.setattr(estimate, "CONVERGED_ORDER", 1)
    orbit = ns.solve(DEFAULT, "hb-c1", 8)
    assert orbit.errors.period == pytest.approx(9.3e-5, rel=0.01)
    assert 0.99 * orbit.errors.period <= orbit.estimate.period <= 1.1 * orbit.errors.period


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
def test_the_estimate_holds_for_very_many_harmonics(method: str) -> None:
    orbit = ns.solve(DEFAULT, method, 5000)
    for name in ("period", "t1", "acceleration"):
        error, estimated = abs(getattr(orbit.errors, name)), getattr(orbit.estimate, name)
        assert 0.9 * error <= estimated <= 1.2 * error + 1e-14


@pytest.mark.parametrize(("method", "order"), [("hb", 9), ("hb-c1", 9), ("c1", 9)])
def test_what_newton_left_and_rounding_are_added(method: str, order: int) -> None:
    """The last correction says how large the rounding errors are; four of them count."""
    outcome = ns.solve(DEFAULT, method, order).outcome
    least = []
    for correction in (0.0, 1e-6):
        left = replace(outcome, correction=correction)
        least.append(estimate.estimate(METHODS[method], order, 1.0, left))
    assert least[1].period - least[0].period == pytest.approx(4e-6, rel=0.01)
    T, t1 = exact.times(1.0)[1], 2.0
    assert least[1].t1 - least[0].t1 == pytest.approx(4e-6 * T / t1, rel=0.01)


@pytest.mark.parametrize(("order", "alpha"), [(1, 1e-3), (2, 1e-3), (6, 1e-3), (10, 1e-3)])
def test_a_spurious_solution_is_no_better_orbit(order: int, alpha: float) -> None:
    """The rough start leads to one whose stick is much too long or too short."""
    kernel = kernels.compiled("c1")
    start = with_coefficients(kernel, alpha, order, *rough_times(alpha))
    found = newton(kernel.iterate, alpha, start)
    assert found.converged
    assert abs(found.unknowns[-2] / (2 * alpha) - 1) > 1 / (2 * order)
    assert estimate._c1_orbit(alpha, order) is None


def test_a_second_turn_is_no_better_orbit(monkeypatch) -> None:
    """Its stick is right, and its slip lasts 2 pi longer."""

    def later(alpha: float) -> tuple[float, float]:
        t1, T = rough_times(alpha)
        return t1, T + 2 * math.pi

    alpha, kernel = 1.0009765625, kernels.compiled("c1")
    found = newton(kernel.iterate, alpha, with_coefficients(kernel, alpha, 30, *later(alpha)))
    t1, T = exact.times(alpha)
    assert found.converged
    assert found.unknowns[-2:] == pytest.approx([t1, T + 2 * math.pi], rel=1e-9)
    estimate._c1_orbit.cache_clear()
    monkeypatch.setattr(estimate, "rough_times", later)
    assert estimate._c1_orbit(alpha, 30) is None
    estimate._c1_orbit.cache_clear()


@pytest.mark.parametrize(("method", "order"), [("hb", 5), ("hb-c1", 5), ("c1", 9)])
def test_where_no_better_orbit_is_found_nothing_is_claimed(
    monkeypatch, run, method: str, order: int
) -> None:
    monkeypatch.setattr(estimate, "_c1_orbit", lambda alpha, order: None)
    assert ns.solve(DEFAULT, method, order).estimate.period == math.inf
    _, out, _ = run("solve", "--method", method, "--order", order, "--json")
    document = json.loads(out)
    assert document["admissible"] is True
    assert set(document["estimate"].values()) == {None}
    assert {"period", "t1", "acceleration", "times"} <= set(document["estimate"])


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
