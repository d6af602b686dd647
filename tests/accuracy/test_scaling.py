"""Laws of the oscillator as properties: one number, alpha, shapes the orbit."""

import numpy as np
import pytest
from computed import belt_of
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.kim_perkins import StickSlipOrbit
from nonsmooth.report.case import DEFAULT

scale = st.floats(-12, 12).map(lambda exponent: 10.0**exponent)
METHODS = st.sampled_from([("hb", 4), ("hb-c1", 4), ("c1", 7)])


def in_other_units(belt: ns.StickSlip, kg: float, m: float, s: float) -> ns.StickSlip:
    """Return the same oscillator with mass, length and time measured in other units."""
    return ns.StickSlip(
        mu_s=belt.mu_s,
        mu_k=belt.mu_k,
        mass=belt.mass * kg,
        stiffness=belt.stiffness * kg / s / s,
        belt_speed=belt.belt_speed * m / s,
        normal_force=belt.normal_force * kg * m / s / s,
    )


@settings(max_examples=30)
@given(METHODS, scale, scale, scale)
def test_change_of_units_changes_nothing_but_units(
    method: tuple[str, int], kg: float, m: float, s: float
) -> None:
    # alpha itself is rounded a few times on the way, by parts in 1e16.
    other = in_other_units(DEFAULT, kg, m, s)
    assert other.alpha == pytest.approx(DEFAULT.alpha, rel=1e-14)
    first, second = ns.solve(DEFAULT, *method), ns.solve(other, *method)
    assert second.t1 / second.period == pytest.approx(first.t1 / first.period, rel=1e-13)
    assert second.period == pytest.approx(first.period * s, rel=1e-13)
    assert second.errors.period == pytest.approx(first.errors.period, abs=1e-13)
    assert second.errors.acceleration == pytest.approx(first.errors.acceleration, rel=1e-9)
    size = belt_length(first) * m
    there, here = (
        second.displacement(0.3 * second.period),
        first.displacement(0.3 * first.period),
    )
    assert float(there) == pytest.approx(float(here) * m, abs=1e-12 * size)


def belt_length(orbit: StickSlipOrbit) -> float:
    return float(np.abs(orbit.displacement(np.linspace(0, orbit.period, 50))).max())


@settings(max_examples=20)
@given(METHODS, st.floats(0, 0.9), st.floats(0.1, 2))
def test_only_the_drop_of_friction_matters_beside_a_shift(
    method: tuple[str, int], mu_k: float, drop: float
) -> None:
    force = 0.25 * DEFAULT.normal_force / drop
    changed = {"mu_k": mu_k, "mu_s": mu_k + drop, "normal_force": force}
    belt = ns.StickSlip(**{**DEFAULT.values, **changed})
    first, second = ns.solve(DEFAULT, *method), ns.solve(belt, *method)
    assert second.period == pytest.approx(first.period, rel=1e-12)
    shift = (mu_k * force - 0.25 * DEFAULT.normal_force) / DEFAULT.stiffness
    t = np.linspace(0, first.period, 17)[:-1]
    moved = first.displacement(t) + shift
    size = np.abs(moved).max()
    np.testing.assert_allclose(second.displacement(t), moved, atol=1e-11 * size)


@pytest.mark.parametrize(
    ("method", "order"), [("hb", 5), ("hb-c1", 5), ("hb", 12), ("hb-c1", 12)]
)
def test_fourier_orbits_are_odd_about_the_middle_of_stick(method: str, order: int) -> None:
    orbit = ns.solve(DEFAULT, method, order)
    centre = DEFAULT.mu_k * DEFAULT.normal_force / DEFAULT.stiffness
    t = np.linspace(0, orbit.period, 41)
    ahead = orbit.displacement(orbit.t1 / 2 + t) - centre
    behind = orbit.displacement(orbit.t1 / 2 - t) - centre
    np.testing.assert_allclose(ahead, -behind, atol=1e-13)


@settings(max_examples=30)
@given(st.floats(-3, 3).map(lambda exponent: 10.0**exponent))
def test_c1_of_order_20_is_exact_to_rounding_over_six_decades(alpha: float) -> None:
    orbit = ns.solve(belt_of(alpha), "c1", 20)
    assert abs(orbit.errors.period) < 1e-13
    assert orbit.outcome.iterations <= 4  # from a coarse orbit
