"""Orbits of generated scenes against 22-digit solutions of the same equations."""

import json
import math

import numpy as np
import pytest
from made_scenes import Given, made

from nonsmooth.solver import exact, search
from nonsmooth.solver.accuracy import estimate as estimates
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.existence.known import Known
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.orbit.errors import difference
from nonsmooth.solver.solve import solve_case

IMPACT, BACKLASH = registry.load("impact"), registry.load("backlash")
DAMPED = registry.load("stick-slip-damped")
UNIT = {"mass": 1, "stiffness": 1, "belt_speed": 1, "normal_force": 1, "damping": 0.1}
S1 = IMPACT()
S5B = DAMPED(**UNIT, mu_s=2, mu_k=1, weakening=0.2)
S5C = DAMPED(**UNIT, mu_s=2.1, mu_k=2.1, weakening=0.5)


@pytest.mark.parametrize("case", [S1, S5B], ids=["S1", "S5b"])
def test_errors_fall_faster_than_any_power_and_are_estimated(case) -> None:
    before = math.inf
    for order in (4, 6, 8, 10, 14):
        orbit = solve_case(case, "ck-tau", order)
        times = orbit.errors.times
        assert times < max(before / 20, 1e-15)
        before = times
        # the estimate holds, and is no more than rounding above
        assert times <= orbit.estimate.times <= 1.01 * times + 1e-14
        assert orbit.errors.discontinuous <= orbit.estimate.discontinuous
        assert orbit.estimate.discontinuous <= 1.01 * orbit.errors.discontinuous + 1e-12
        assert orbit.errors.switches <= orbit.estimate.switches
        assert orbit.estimate.switches <= 1.01 * orbit.errors.switches + 1e-14
        assert abs(orbit.errors.period) <= orbit.estimate.period


@pytest.mark.parametrize("case", [S1, S5C], ids=["S1", "S5c"])
def test_estimates_of_slow_methods_hold(case) -> None:
    orbit = solve_case(case, "hb", 8)
    assert orbit.errors.times == pytest.approx(orbit.estimate.times, rel=0.01)
    assert orbit.errors.discontinuous == pytest.approx(orbit.estimate.discontinuous, rel=0.01)
    assert 1e-4 < orbit.errors.times < 0.1


@pytest.mark.parametrize("method", ["hb", "ck-tau"])
def test_a_far_better_solution_has_to_be_an_orbit(monkeypatch, method: str) -> None:
    """It is looked at unless it is next to the orbit: then it is the same root."""
    orbit = solve_case(S1, method, 8)
    assert orbit.admissible
    attempt, looked_at = estimates.attempt, []

    def refused(kernel, case, order, times):
        found = attempt(kernel, case, order, times)
        looked_at.append(order)
        found.__dict__["violations"] = ("not an orbit",)
        return found

    monkeypatch.setattr(estimates, "attempt", refused)
    known = estimates.estimate(orbit)
    assert len(looked_at) == (2 if method == "ck-tau" else 1)
    far = orbit.errors.times  # of hb: no better orbit is left to compare it with
    assert (known.times == far) == (method == "hb")


def test_errors_are_what_their_names_say() -> None:
    orbit = solve_case(S5B, "ck-tau", 4)
    exact = exact_orbit(S5B)
    off = np.subtract(orbit.durations, exact.durations)
    assert orbit.errors.period == pytest.approx(orbit.period / exact.period - 1, rel=1e-9)
    assert orbit.errors.times == pytest.approx(np.abs(off).max() / exact.period, rel=1e-9)
    # the measure of the acceleration by a plain sum, phases aligned
    apart = size = start = exact_start = 0.0
    u = (np.arange(2000) + 0.5) / 2000
    for s, exact_s in zip(orbit.durations, exact.durations, strict=True):
        reference = exact.acceleration(exact_start + exact_s * u)
        apart += exact_s * np.mean((orbit.acceleration(start + s * u) - reference) ** 2)
        size += exact_s * np.mean(reference**2)
        start, exact_start = start + s, exact_start + exact_s
    assert orbit.errors.discontinuous == pytest.approx(math.sqrt(apart / size), rel=1e-4)


def test_the_phase_of_the_forcing_counts_as_a_time() -> None:
    orbit, exact = solve_case(S1, "ck-tau", 4), exact_orbit(S1)
    off = abs(orbit.forcing_phase - exact.forcing_phase) / 1.8
    assert orbit.errors.times == pytest.approx(off / orbit.period, rel=1e-9)
    assert abs(orbit.errors.period) < 1e-15


@pytest.mark.parametrize("case", [S1, S5B], ids=["S1", "S5b"])
def test_motion_at_any_time(case) -> None:
    orbit, exact = solve_case(case, "ck-tau", 20), exact_orbit(case)
    t = np.linspace(-2, 3, 41).reshape(1, 41) * orbit.period + 0.01
    for name in ("displacement", "velocity", "acceleration"):
        found, expected = getattr(orbit, name)(t), getattr(exact, name)(t)
        assert found.shape == t.shape
        np.testing.assert_allclose(found, expected, atol=1e-12)
    assert orbit.displacement(-1e-300) == orbit.displacement(0.0)
    assert orbit.displacement(0.0) == pytest.approx(orbit.phases[0].displacement)
    assert orbit.velocity(orbit.period) == pytest.approx(orbit.phases[0].velocity)
    assert orbit.extremes["displacement"] == pytest.approx(exact.extremes["displacement"])
    assert orbit.extremes["velocity"] == pytest.approx(exact.extremes["velocity"])
    with pytest.raises(ValueError, match="finite times"):
        orbit.displacement(math.nan)


def test_a_period_starts_after_the_switch() -> None:
    orbit = solve_case(S1, "ck-tau", 12)
    assert orbit.velocity(0.0) == pytest.approx(-1.46040485873650923802, rel=1e-13)
    assert orbit.velocity(-1e-9) == pytest.approx(2.4340080978941820634, rel=1e-8)


def test_the_first_derivative_that_jumps_sets_the_class() -> None:
    assert solve_case(S1, "ck-tau", 6).smoothness == "C0"
    assert solve_case(S5B, "ck-tau", 6).smoothness == "C1"


def test_coefficients_are_in_si_units() -> None:
    orbit = solve_case(IMPACT(mass=2, damping=0.1, frequency=3, force=2), "ck-tau", 6)
    found = orbit.coefficients
    assert found["x_flight"] == pytest.approx(0.1, rel=1e-13)
    assert found["v_flight"] == pytest.approx(orbit.phases[0].velocity, rel=1e-13)
    mean = np.mean(orbit.acceleration((np.arange(4000) + 0.5) / 4000 * orbit.period))
    assert found["d_flight"][0] == pytest.approx(mean, abs=1e-7)


def test_errors_of_the_forcing_phase_go_the_short_way_round() -> None:
    case = made([(1, 0, 1, 0, 1)], [(1, 0, 0, 0)], omega=0.4)()
    wave = np.polynomial.Polynomial([0, 1, -1])
    one, two = (
        Given(case, (5 * math.pi,), wave, angle) for angle in (0.01, 2 * math.pi - 0.01)
    )
    assert difference(one, two, 2).times == pytest.approx(0.02 / 0.4 / (5 * math.pi))
    assert difference(one, one, 2).times == 0


def test_without_a_better_orbit_the_exact_one_tells_the_error(monkeypatch) -> None:
    monkeypatch.setattr("nonsmooth.solver.accuracy.estimate._neighbour", lambda *of: None)
    orbit = solve_case(S1, "hb", 5)
    assert orbit.estimate.times == orbit.errors.times  # none is better but the exact
    orbit.__dict__["_exact_solution"] = None
    for kept in ("errors", "estimate"):
        orbit.__dict__.pop(kept, None)
    assert orbit.estimate.times == math.inf
    assert json.loads(json.dumps(orbit.as_dict(), allow_nan=False))["estimate"]["times"] is None


def test_an_order_without_an_orbit_is_refused() -> None:
    with pytest.raises(NoOrbit, match="ck-tau, N = 2"):
        solve_case(S1, "ck-tau", 2)


def test_no_orbit_is_raised_with_every_start(monkeypatch) -> None:
    for module in (exact, search):  # it would be shown sooner
        monkeypatch.setattr(module, "known", lambda case: Known())
    monkeypatch.setattr(search, "shown_to_be_none", lambda *found: None)
    with pytest.raises(NoOrbit) as caught:
        solve_case(BACKLASH(force=0.05), "hb", 7)
    assert "hb, N = 7" in caught.value.reason
    *starts, simulated = caught.value.tried
    assert len(starts) == 120
    assert all(line.startswith("from ") for line in starts)
    assert simulated == "a simulation comes to a motion without switches"
    assert caught.value.iterations > 24


def test_a_resting_mass_is_no_orbit() -> None:
    # damping beyond what weakening friction feeds: no oscillation is left
    with pytest.raises(NoOrbit):
        solve_case(DAMPED(**(UNIT | {"damping": 5.0}), mu_s=1.0, mu_k=1.0), "ck-tau", 8)


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ((IMPACT,), TypeError, "expected a case, such as"),
        ((S1, "ck-tau", 1), ValueError, "a whole number from 2 to 400"),
        ((S1, "ck-tau", True), ValueError, "whole number"),
        ((S1, "ck-tau", 5.0), ValueError, "whole number"),
        ((S1, "none"), ValueError, "expected one of"),
        ((S1, "ck-tau", 5, 2), ValueError, "functions: got 2"),
    ],
)
def test_bad_arguments_are_named(arguments, error, message) -> None:
    with pytest.raises(error, match=message):
        solve_case(*arguments)
