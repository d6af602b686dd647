"""Returned orbits: they satisfy the printed equations, and are what they say they are."""

import itertools

import numpy as np
import pytest
from paper import METHODS, Problem, cosine, one, sine

import nonsmooth as ns
from nonsmooth.solver.no_orbit import NoOrbit

BELT = ns.StickSlip(
    mass=0.7, stiffness=30.0, belt_speed=0.4, mu_s=0.6, mu_k=0.2, normal_force=5.0
)
CASES = [*itertools.product(METHODS, (3, 7)), ("hb", 20), ("hb-c1", 20)]


def problem(orbit: ns.Orbit) -> Problem:
    belt = orbit.belt
    return Problem(
        orbit.t1, orbit.period, belt.omega_n, belt.mu_k * belt.normal_force / belt.stiffness
    )


def from_coefficients(orbit: ns.Orbit):
    """Return x(t) and its acceleration from the paper's expansion and SI coefficients."""
    p, found = problem(orbit), orbit.coefficients
    if orbit.method == "c1":
        belt = orbit.belt
        x_0 = (2 * belt.mu_k - belt.mu_s) * belt.normal_force / belt.stiffness
        return p.polynomial(np.array(found["d"]), belt.belt_speed, x_0)
    x, acceleration = p.series(found["a0"], np.array(found["a"]), np.array(found["b"]))
    if orbit.method == "hb":
        return x, acceleration
    c1 = found["c1"]
    return (
        lambda t: x(t) + c1 * p.g1(t),
        lambda t: acceleration(t) + c1 * p.g1_acceleration(t),
    )


def phase_times(orbit: ns.Orbit) -> np.ndarray:
    """Return times inside stick and inside slip."""
    inside = np.linspace(0.02, 0.98, 23)
    return np.concatenate([orbit.t1 * inside, orbit.t1 + (orbit.period - orbit.t1) * inside])


@pytest.mark.parametrize(("method", "order"), CASES)
def test_coefficients_are_the_papers_in_si_units(method: str, order: int) -> None:
    orbit = ns.solve(BELT, method, order)
    x, acceleration = from_coefficients(orbit)
    t = phase_times(orbit)
    size = np.abs(orbit.displacement(t)).max()
    # c1 as printed cancels between g1 and its own harmonics: N**2.5 digits' worth.
    np.testing.assert_allclose(x(t), orbit.displacement(t), atol=1e-12 * size)
    size = np.abs(orbit.acceleration(t)).max()
    np.testing.assert_allclose(acceleration(t), orbit.acceleration(t), atol=1e-10 * size)


@pytest.mark.parametrize(("method", "order"), CASES)
def test_orbit_satisfies_the_printed_conditions(method: str, order: int) -> None:
    orbit = ns.solve(BELT, method, order)
    p = problem(orbit)
    stick, slip = p.residual(*from_coefficients(orbit))
    tests = {
        "hb": [one, *(f(j * p.omega_0) for j in range(1, order + 1) for f in (sine, cosine))],
        "c1": [
            lambda t, k=k: np.maximum(t - p.t1, 0) ** (k + 2) / ((k + 1) * (k + 2))
            for k in range(order + 1)
        ],
    }
    tests["hb-c1"] = [*tests["hb"], p.g1]
    accelerations = np.abs(orbit.acceleration(phase_times(orbit))).max()
    for test in tests[method]:
        size = accelerations * p.inner(one, one, lambda t, test=test: abs(test(t)))
        assert abs(p.inner(stick, slip, test)) < 1e-11 * size


@pytest.mark.parametrize("method", METHODS)
def test_velocity_and_acceleration_are_derivatives(method: str) -> None:
    orbit = ns.solve(BELT, method, 6)
    t, h = phase_times(orbit), 1e-5 * orbit.period
    for function, derivative in (
        (orbit.displacement, orbit.velocity),
        (orbit.velocity, orbit.acceleration),
    ):
        difference = (function(t + h) - function(t - h)) / (2 * h)
        size = np.abs(derivative(t)).max()
        np.testing.assert_allclose(difference, derivative(t), atol=1e-7 * size)


@pytest.mark.parametrize("method", METHODS)
def test_orbit_is_periodic_c1_and_keeps_the_shape_of_its_times(method: str) -> None:
    orbit = ns.solve(BELT, method, 6)
    t = phase_times(orbit).reshape(2, 23)
    for function in (orbit.displacement, orbit.velocity, orbit.acceleration):
        values = function(t)
        assert values.shape == (2, 23)
        size = np.abs(values).max()
        for periods in (-3, 1, 1000):
            again = function(t + periods * orbit.period)
            np.testing.assert_allclose(again, values, atol=1e-9 * size)
    for corner in (0.0, orbit.t1):
        near = np.array([corner - 1e-12, corner + 1e-12])
        assert np.ptp(orbit.displacement(near)) < 1e-10
        assert np.ptp(orbit.velocity(near)) < 1e-9


def test_a_scalar_time_gives_a_scalar_array(belt: ns.StickSlip) -> None:
    orbit = ns.solve(belt, "c1", 5)
    assert orbit.displacement(0.1).shape == ()
    assert float(orbit.velocity(0.1)) == pytest.approx(1.0)
    assert float(orbit.displacement(-1e-300)) == pytest.approx(0.0)


@pytest.mark.parametrize("time", [np.nan, np.inf, [0.0, -np.inf]])
def test_a_time_that_is_none_is_refused(time: object, belt: ns.StickSlip) -> None:
    with pytest.raises(ValueError, match=r"t: got .* expected finite times"):
        ns.exact(belt).velocity(time)  # type: ignore[arg-type]


def test_acceleration_at_a_jump_is_that_of_the_phase_that_begins(belt: ns.StickSlip) -> None:
    orbit = ns.exact(belt)
    assert orbit.acceleration(0.0) == 0
    assert orbit.acceleration(orbit.t1) == pytest.approx(-10.0)
    assert orbit.acceleration(np.nextafter(orbit.t1, 0)) == 0


def test_unknowns_of_an_orbit_cannot_be_changed(belt: ns.StickSlip) -> None:
    orbit = ns.solve(belt, "c1", 5)
    with pytest.raises(ValueError, match="read-only"):
        orbit.unknowns[0] = 1


def test_transition_mismatch_is_what_the_definition_says(belt: ns.StickSlip) -> None:
    orbit = ns.solve(belt, "c1", 3)
    force = belt.stiffness * float(orbit.displacement(orbit.t1))
    limit = belt.mu_s * belt.normal_force
    assert orbit.transition_mismatch == pytest.approx(force / limit - 1, rel=1e-9)
    assert orbit.transition_mismatch == pytest.approx(0.0332342, abs=1e-7)
    assert abs(ns.solve(belt, "c1", 7).transition_mismatch) < 4e-5


@pytest.mark.parametrize("method", METHODS)
def test_plain_and_compiled_solutions_have_the_same_bits(
    method: str, belt: ns.StickSlip
) -> None:
    one_, many = (ns.solve(belt, method, 9, many=m) for m in (False, True))
    assert one_.unknowns.tobytes() == many.unknowns.tobytes()


def test_an_orbit_prints_itself(belt: ns.StickSlip) -> None:
    text = str(ns.solve(belt, "hb-c1", 10))
    assert "Section 3.2" in text
    assert "admissible" in text


@pytest.mark.parametrize("alpha", [0.3, 0.1, 0.5, 0.75])
def test_c1_has_no_orbit_at_order_4_below_alpha_0_8(alpha: float) -> None:
    belt = ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )
    with pytest.raises(NoOrbit) as finding:
        ns.solve(belt, "c1", 4)
    assert finding.value.status == "no-orbit"
    assert finding.value.proven


#: Orders of `test_nothing_but_the_orbit_is_returned` without an orbit; none elsewhere.
ABSENT = {
    ("hb", 10): [1, 2],
    ("c1", 1e-3): [1, 2, 3, 4, 5, 8],
    ("c1", 0.01): [1, 2, 3, 4, 5, 8],
    ("c1", 0.1): [1, 2, 3, 4, 5],
    ("c1", 0.3): [2, 3, 4],
}


def found_or_proven_absent(belt: ns.StickSlip, method: str, order: int) -> ns.Orbit | None:
    """Return the orbit, or None; for c1, None only if it is shown that there is none."""
    try:
        return ns.solve(belt, method, order)
    except NoOrbit as finding:
        if method == "c1" and not finding.proven:
            raise
        return None


@pytest.mark.parametrize("alpha", [1e-3, 0.01, 0.1, 0.3, 1, 3, 10])
@pytest.mark.parametrize("method", METHODS)
def test_nothing_but_the_orbit_is_returned(method: str, alpha: float) -> None:
    belt = ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )
    exact, absent = ns.exact(belt), []
    for order in (1, 2, 3, 4, 5, 8, 13, 21):
        orbit = found_or_proven_absent(belt, method, order)
        if orbit is None:
            absent.append(order)
            continue
        assert orbit.converged
        assert orbit.admissible
        assert orbit.violations == ()
        assert orbit.residual_norm < 1e-11 * (1 + alpha)
        # Pure slip has t1 = 0 and T = 2 pi; other roots of c1 are further off still.
        assert 0 < orbit.t1 < orbit.period
        if method == "c1":
            assert abs(orbit.errors.t1) <= 1 / (2 * order)
        assert orbit.period - orbit.t1 < 2 * np.pi * 1.3 * belt.time_unit
        assert orbit.t1 < 2 * exact.t1
    assert absent == ABSENT.get((method, alpha), [])


def test_at_a_jump_the_acceleration_is_that_of_the_phase_which_begins() -> None:
    random = np.random.default_rng(12)
    for _ in range(60):
        mass, stiffness, speed, force = 10 ** random.uniform(-2, 3, 4)
        belt = ns.StickSlip(
            mass=mass, stiffness=stiffness, belt_speed=speed, mu_s=0.6, mu_k=0.2,
            normal_force=force,
        )  # fmt: skip
        motions = [ns.exact(belt)]
        if 0.1 < belt.alpha < 100:
            motions.append(ns.solve(belt, "c1", 20))
        for motion in motions:
            T, t1 = motion.period, motion.t1
            starts = np.array([-4 * T, -T, 0.0, T, 2 * T])
            assert not motion.acceleration(starts).any()
            assert not motion.acceleration(np.nextafter(t1, 0))
            fall = -belt.acceleration_unit * belt.alpha
            if belt.alpha > 1e-9:
                ends = np.array([t1, np.nextafter(T, 0), -np.nextafter(0, 1)])
                signs = np.array([1, -1, 0])
                expected = pytest.approx(signs * fall, rel=1e-5, abs=1e-300)
                assert motion.acceleration(ends) == expected
