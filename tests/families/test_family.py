"""Families of orbits along a parameter: each point is what `solve` gives for its oscillator."""

import math
from dataclasses import asdict, replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.generated.shortcuts import c1 as kernel
from nonsmooth.solver.shortcuts.orbit.oscillator import (
    DEFAULT,
    PARAMETERS,
    alpha_of,
    time_unit_of,
)

#: Ranges of each parameter that keep alpha between 1e-3 and 1e3, in any units.
RANGES = {
    "mass": (1e-4, 1e4),
    "stiffness": (1e-2, 1e6),
    "belt_speed": (1e-3, 1e2),
    "mu_s": (0.26, 30.0),
    "mu_k": (0.0, 0.49),
    "normal_force": (1.0, 1e5),
}


def values_of(parameter: str, count: int) -> np.ndarray:
    return np.linspace(*RANGES[parameter], count)


def exact_times(alpha: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return t1 and T of Section 2, dimensionless."""
    return 2 * alpha, 2 * alpha + math.pi + 2 * np.arctan2(1, alpha)


@pytest.mark.parametrize("parameter", PARAMETERS)
def test_scales_of_many_are_those_of_one(parameter: str) -> None:
    values = values_of(parameter, 50)
    given_ = asdict(DEFAULT) | {parameter: values}
    belts = [replace(DEFAULT, **{parameter: value}) for value in values.tolist()]
    alpha = np.broadcast_to(alpha_of(given_, np.sqrt), values.shape)
    unit = np.broadcast_to(time_unit_of(given_, np.sqrt), values.shape)
    assert alpha.tolist() == [belt.alpha for belt in belts]
    assert unit.tolist() == [belt.time_unit for belt in belts]


#: Of five oscillators along each parameter, those that have an orbit at a low order.
LOW_ORDERS = {
    ("c1", 4): dict(zip(PARAMETERS, (1, 1, 1, 4, 3, 4), strict=True)),
    ("hb", 12): dict(zip(PARAMETERS, (4, 4, 4, 1, 5, 1), strict=True)),
}


@pytest.mark.parametrize("parameter", PARAMETERS)
@pytest.mark.parametrize(
    ("method", "order"), [("c1", 24), ("c1", 4), ("c1", 200), ("hb", 12), ("hb-c1", 12)]
)
def test_a_point_is_what_solve_gives(parameter: str, method: str, order: int) -> None:
    compared = 0
    family = ns.family(DEFAULT, parameter, values_of(parameter, 5), method, order)
    for point in family.points:
        belt = replace(DEFAULT, **{parameter: float(point["value"])})
        assert point["alpha"] == belt.alpha
        try:
            orbit = ns.solve(belt, method, order, many=True)
        except ns.NoOrbit as failure:
            status, orbit = failure.status, None
        else:
            status = "ok"
        assert ("ok", "no-orbit", "not-converged")[point["status"]] == status
        if orbit is None:
            assert np.isnan(point["period"])
            continue
        compared += 1
        rounding = 1e-14 * orbit.period
        assert point["period"] == pytest.approx(orbit.period, abs=rounding)
        assert point["t1"] == pytest.approx(orbit.t1, abs=rounding)
        assert point["amplitude"] == pytest.approx(orbit.amplitude, rel=1e-13)
        assert point["stick_fraction"] == point["t1"] / point["period"]
        judged = orbit.estimate
        assert point["estimate_period"] == pytest.approx(judged.period, rel=0.2, abs=1e-14)
    assert compared == LOW_ORDERS.get((method, order), {}).get(parameter, 5)


@pytest.mark.parametrize(
    ("method", "order"), [("c1", n) for n in (3, 5, 8, 13, 24)] + [("hb", 30), ("hb-c1", 30)]
)
def test_estimates_bound_the_errors(method: str, order: int) -> None:
    family = ns.family(DEFAULT, "belt_speed", np.geomspace(1e-3, 1e3, 150), method, order)
    found = family.points[family["status"] == 0]
    assert len(found) > 50
    t1, T = exact_times(found["alpha"])
    for name, true in (("t1", t1), ("period", T)):
        error = np.abs(found[name] / (true * DEFAULT.time_unit) - 1)
        assert (found[f"estimate_{name}"] >= error / 2).all()
        large = error > 1e-12
        assert (found[f"estimate_{name}"] <= 20 * error)[large].all()


def test_the_default_order_is_exact_to_rounding() -> None:
    family = ns.family(DEFAULT, "belt_speed", np.geomspace(1e-6, 1e3, 3000))
    t1, T = exact_times(family["alpha"])
    unit = DEFAULT.time_unit
    np.testing.assert_allclose(family["period"], T * unit, rtol=2e-15)
    np.testing.assert_allclose(family["t1"], t1 * unit, atol=4e-15 * unit, rtol=1e-14)
    speed = family["value"]
    np.testing.assert_allclose(
        family["amplitude"], speed * unit * np.hypot(1, family["alpha"]), rtol=3e-15
    )


def test_a_very_fast_belt_is_left_to_solve() -> None:
    family = ns.family(DEFAULT, "belt_speed", [1e6, 1e7])
    assert (family["status"] == 0).all()
    np.testing.assert_allclose(family["period"], 2 * math.pi * 0.1, rtol=1e-6)
    assert (family["estimate_period"] < 1e-13).all()


def check_amplitude(belt: ns.StickSlip, method: str, order: int) -> bool:
    """Compare the amplitude with samples of the motion; whether there was an orbit."""
    try:
        orbit = ns.solve(belt, method, order)
    except ns.NoOrbit:
        return False
    slip = orbit.period - orbit.t1
    times = np.concatenate(
        [np.linspace(0, orbit.period, 4001), orbit.t1 + np.linspace(0, slip, 4001)]
    )
    motion = orbit.displacement(times)
    sampled = (motion.max() - motion.min()) / 2
    # Between samples h apart the motion goes on by no more than max|a| h**2 / 8.
    beyond = np.abs(orbit.acceleration(times)).max() * (slip / 4000) ** 2 / 8
    rounding = 1e-12 * sampled
    assert sampled - rounding <= orbit.amplitude <= sampled + beyond + rounding
    return True


def test_amplitude_is_where_the_motion_turns() -> None:
    compared: list[bool] = []

    @settings(max_examples=40)
    @given(
        st.floats(-2.5, 2.5).map(lambda power: 10**power),
        st.sampled_from([("c1", 9), ("c1", 24), ("hb", 10), ("hb", 60), ("hb-c1", 25)]),
    )
    def run(alpha: float, case: tuple[str, int]) -> None:
        compared.append(check_amplitude(replace(DEFAULT, belt_speed=1 / alpha), *case))

    run()
    assert sum(compared) >= 36


def test_the_amplitude_of_the_exact_orbit() -> None:
    orbit = ns.exact(DEFAULT)
    motion = orbit.displacement(np.linspace(0, orbit.period, 20001))
    assert orbit.amplitude == pytest.approx((motion.max() - motion.min()) / 2, rel=1e-7)


def test_slip_velocity_is_the_integral_of_its_acceleration() -> None:
    p = np.random.default_rng(1).normal(size=8)
    s, u, h = 3.7, 0.37, 1e-30
    velocity, acceleration = kernel.slip_velocity(p, s, u + 1j * h)
    assert velocity.imag / h == pytest.approx(s * acceleration.real, rel=1e-13)
    assert kernel.slip_velocity(p, s, 0.0)[0] == pytest.approx(1, abs=1e-13)


@pytest.mark.parametrize("count", [1, 4, 5, 8, 9, 11])
def test_every_chunk_is_in_the_family(count: int, monkeypatch) -> None:
    values = values_of("belt_speed", 11)[:count]
    whole = ns.family(DEFAULT, "belt_speed", values, "c1", 8)
    monkeypatch.setattr("nonsmooth.solver.shortcuts.search.family.CHUNK", 4)
    found = ns.family(DEFAULT, "belt_speed", values, "c1", 8)
    assert found["value"].tolist() == values.tolist()
    assert found.points.tobytes() == whole.points.tobytes()


def test_a_parameter_that_there_is_not() -> None:
    with pytest.raises(ValueError, match=r"parameter: got 'speed', expected one of mass,"):
        ns.family(DEFAULT, "speed", [1.0])


@pytest.mark.parametrize("value", [-1.0, 0.0, math.nan, math.inf])
def test_a_value_that_makes_no_oscillator(value: float) -> None:
    with pytest.raises(ns.ParameterError, match="belt_speed: got"):
        ns.family(DEFAULT, "belt_speed", [1.0, value, 2.0])


def test_no_values() -> None:
    with pytest.raises(ValueError, match="values: got none"):
        ns.family(DEFAULT, "mass", [])


def test_a_family_prints_itself() -> None:
    lines = str(ns.family(DEFAULT, "belt_speed", [0.5, 1.0], "hb", 30)).splitlines()
    assert len(lines) == 3
    assert lines[0].split()[:2] == ["belt_speed", "alpha"]
    assert "not-converged" in str(ns.family(DEFAULT, "belt_speed", [1e-4], "hb", 3))


@pytest.mark.parametrize("order", [24, 40, 60, 104])
def test_a_short_stick_is_what_solve_gives(order: int) -> None:
    alpha = np.random.default_rng(order).uniform(-7, -2, 12)
    belt = ns.StickSlip(mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0, normal_force=1)
    family = ns.family(belt, "normal_force", 10**alpha, "c1", order)
    assert (family["status"] == 0).all()
    for point in family.points:
        orbit = ns.solve(replace(belt, normal_force=float(point["value"])), "c1", order)
        # both are solutions to rounding, which is a part of T: the estimates say so
        assert abs(point["t1"] / orbit.t1 - 1) < point["estimate_t1"]
        assert point["estimate_t1"] == pytest.approx(orbit.estimate.t1, rel=0.6)
