"""The belt under the paper's symbols: its formulas and conditions, evaluated by `paper`."""

import itertools
import pickle

import numpy as np
import pytest
from computed import Exact
from paper import METHODS, Problem, cosine, one, sine

import nonsmooth as ns
from nonsmooth.kim_perkins import SECTION_4, ExactStickSlipOrbit, StickSlipOrbit, as_in_paper

BELT = ns.StickSlip(
    mass=0.7, stiffness=30.0, belt_speed=0.4, mu_s=0.6, mu_k=0.2, normal_force=5.0
)
EXACT = Exact(BELT)
CASES = [*itertools.product(METHODS, (3, 7)), ("hb", 20), ("hb-c1", 20)]


def problem(orbit: StickSlipOrbit) -> Problem:
    return Problem(orbit.t1, orbit.period, EXACT.omega, EXACT.centre)


def from_coefficients(method: str, orbit: StickSlipOrbit):
    """Return x(t) and its acceleration: (3), (11) with (12), or (15) and (16)."""
    p, found = problem(orbit), orbit.coefficients
    if method == "c1":
        x_0 = (2 * BELT.mu_k - BELT.mu_s) * BELT.normal_force / BELT.stiffness
        return p.polynomial(np.array(found["d"]), BELT.belt_speed, x_0)
    x, acceleration = p.series(found["a0"], np.array(found["a"]), np.array(found["b"]))
    c1 = found.get("c1", 0.0)
    return (
        lambda t: x(t) + c1 * p.g1(t),
        lambda t: acceleration(t) + c1 * p.g1_acceleration(t),
    )


@pytest.mark.parametrize(("method", "order"), CASES)
def test_coefficients_are_the_papers_and_meet_its_conditions(method: str, order: int) -> None:
    orbit = ns.solve(BELT, method, order)
    p, (x, acceleration) = problem(orbit), from_coefficients(method, orbit)
    inside = np.linspace(0.02, 0.98, 23)
    t = np.concatenate([orbit.t1 * inside, orbit.t1 + (orbit.period - orbit.t1) * inside])
    size = np.abs(orbit.displacement(t)).max()
    # c1 as printed cancels between g1 and its own harmonics: N**2.5 digits' worth.
    np.testing.assert_allclose(x(t), orbit.displacement(t), atol=1e-12 * size)
    size = np.abs(orbit.acceleration(t)).max()
    np.testing.assert_allclose(acceleration(t), orbit.acceleration(t), atol=1e-10 * size)
    tests = {
        "hb": [one, *(f(j * p.omega_0) for j in range(1, order + 1) for f in (sine, cosine))],
        "c1": [
            lambda t, k=k: np.maximum(t - p.t1, 0) ** (k + 2) / ((k + 1) * (k + 2))
            for k in range(order + 1)
        ],
    }
    tests["hb-c1"] = [*tests["hb"], p.g1]
    for test in tests[method]:  # (5) to (7), (14), (18)
        largest = size * p.inner(one, one, lambda t, test=test: abs(test(t)))
        assert abs(p.inner(*p.residual(x, acceleration), test)) < 1e-11 * largest


@pytest.mark.parametrize(("method", "order"), CASES)
def test_errors_are_those_against_the_closed_form(method: str, order: int) -> None:
    orbit = ns.solve(BELT, method, order)
    assert orbit.errors.period == pytest.approx(orbit.period / EXACT.period - 1, abs=1e-14)
    assert orbit.errors.t1 == pytest.approx(orbit.t1 / EXACT.t1 - 1, abs=1e-14)
    edges = np.unique([0, EXACT.t1 / EXACT.period, orbit.t1 / orbit.period, 1])
    nodes, weights = np.polynomial.legendre.leggauss(200)
    apart = size = 0.0
    for left, right in itertools.pairwise(edges):
        theta = (left + right) / 2 + (right - left) / 2 * nodes
        exact = EXACT.motion(theta, 2)
        off = orbit.acceleration(theta * orbit.period) - exact
        apart += (right - left) * weights @ off**2
        size += (right - left) * weights @ exact**2
    assert orbit.errors.acceleration == pytest.approx(np.sqrt(apart / size), rel=1e-9)
    mismatch = BELT.stiffness * orbit.displacement(orbit.t1) / (BELT.mu_s * BELT.normal_force)
    assert orbit.transition_mismatch == pytest.approx(mismatch - 1, abs=1e-12)
    assert abs(orbit.transition_mismatch) < (0.1 if method == "c1" else 1e-12)


def test_the_exact_orbit_has_the_papers_times() -> None:
    exact = ns.exact(BELT)
    assert isinstance(exact, ExactStickSlipOrbit)
    assert (exact.t1, exact.period) == pytest.approx((EXACT.t1, EXACT.period), rel=1e-15)


def test_a_case_of_the_scene_is_the_papers() -> None:
    case = ns.scene("stick-slip")(**BELT.values)
    assert as_in_paper(case) == BELT
    assert hash(as_in_paper(case)) == hash(BELT)
    assert ns.StickSlip(**SECTION_4) == as_in_paper(ns.scene("stick-slip")())
    orbit = ns.solve(BELT, "c1", 7)
    again = pickle.loads(pickle.dumps((BELT, orbit, ns.exact(BELT))))
    assert again == (BELT, orbit, ns.exact(BELT))
    assert [type(each) for each in again] == [ns.StickSlip, StickSlipOrbit, ExactStickSlipOrbit]


@pytest.mark.parametrize("alpha", [1e-8, 1e7, 1e8])
def test_the_exact_orbit_is_found_as_far_as_parameters_go(alpha: float) -> None:
    belt = ns.StickSlip(**SECTION_4 | {"normal_force": 400.0 * alpha})
    stick, slip = ns.exact(belt).durations
    expected = 2 * belt.alpha, np.pi + 2 * np.arctan(1 / belt.alpha)
    off = belt.omega_n * np.array([stick, slip]) - expected
    assert np.abs(off).max() <= 1e-15 * sum(expected)
