"""What solves the equations and is not an orbit is found, and refused in words."""

import math

import numpy as np
import pytest
from galerkin.solving import residual
from made_scenes import Given, made

import nonsmooth as ns
from nonsmooth.solver.exact import ExactOrbit, exact_orbit
from nonsmooth.solver.existence.known import known
from nonsmooth.solver.flow.exact_system import exact_kernel
from nonsmooth.solver.iteration.newton import newton
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.start import RoughTimes
from nonsmooth.solver.orbit import admissible, chebyshev
from nonsmooth.solver.orbit.admissible import seen_violated
from nonsmooth.solver.orbit.allowance import MOST, by_residual, defect
from nonsmooth.solver.orbit.exact_orbit import from_times
from nonsmooth.solver.orbit.solution import attempt

IMPACT = registry.load("impact")
DAMPED = registry.load("stick-slip-damped")


def case_with(demands, events=((1, 0, 0, 0),), **options):
    return made([(1, 0, 1, 0, 0)], list(events), demands=(demands,), **options)()


def polynomial_with(roots):
    return np.polynomial.Polynomial.fromroots(roots)


def exact_roots(case, starts):
    """Return what the exact equations have as roots, admissible or not."""
    found = (from_times(case, RoughTimes(durations, angle, "")) for durations, angle in starts)
    return [orbit for orbit in found if orbit.outcome.converged]


def test_impacts_from_beyond_the_stop_are_refused_by_name() -> None:
    turns = np.arange(12) * math.pi / 6
    roots = exact_roots(IMPACT(), [((2 * math.pi,), angle) for angle in turns])
    bad = [orbit for orbit in roots if orbit.phases[0].velocity > 0]
    good = [orbit for orbit in roots if orbit.phases[0].velocity < 0]
    assert len(bad) >= 3  # the phase of the forcing differs by about pi
    assert len(good) >= 3
    assert all(orbit.admissible for orbit in good)
    for orbit in bad:
        assert abs(math.remainder(orbit.angle - good[0].angle, 2 * math.pi)) > 2
        (line,) = orbit.violations
        assert line.startswith(
            "throughout flight, not true that the mass stays before the stop"
        )


@pytest.mark.parametrize("method", ["ck", "ck-tau", "hb"])
@pytest.mark.parametrize("order", [4, 7, 12])
def test_the_same_of_expansions_is_refused_at_any_order(method, order) -> None:
    kernel, case = registry.kernel(IMPACT, method), IMPACT()
    found = [
        attempt(kernel, case, order, np.array([2 * math.pi, angle]))
        for angle in np.arange(12) * math.pi / 6
    ]
    roots = [orbit for orbit in found if orbit.outcome.converged]
    bad = [orbit for orbit in roots if orbit.phases[0].velocity > 0]
    assert bad
    assert not any(orbit.admissible for orbit in bad)
    assert any(orbit.admissible for orbit in roots)


def test_a_phase_without_duration_solves_the_equations_and_is_refused() -> None:
    # without damping: slip that closes upon itself, and a rest of no duration
    scene = made(
        [(1, 0, 0, 0, 0), (1, 0, 1, 0, 0)],
        [(1, 0, 0, -1), (0, 1, 0, -1)],
        held=(1.0, None),
    )
    cell = scene().cell
    kernel = exact_kernel(cell)
    z = np.array([1, 1, 1, 1, 1e-13, 2 * math.pi])
    assert np.abs(residual(kernel, cell, z)).max() < 1e-12
    orbit = ExactOrbit(scene(), newton(kernel.iterate, cell, z))
    orbit.outcome.unknowns[:] = z
    assert any("has no duration" in line for line in orbit.violations)
    assert exact_orbit(scene(), (1.9, 4.8)).admissible


@pytest.mark.parametrize("duration", [0.0, -1.0, math.nan])
def test_durations_must_be_positive(duration) -> None:
    case = case_with({})
    motion = Given(case, (duration,), polynomial_with([0.5]))
    (line,) = admissible.violations(motion)
    assert "has no duration" in line


@pytest.mark.parametrize("width", [1e-2, 1e-3, 1e-4])
@pytest.mark.parametrize("where", [0.3141, 0.5, 0.99])
def test_a_dip_between_any_samples_is_found(width, where) -> None:
    # x = (u - where)**2 - width**2 is negative on an interval of 2 widths only
    dip = polynomial_with([where - width, where + width])
    case = case_with({"x is not negative": (1, 0, 0, 0)}, events=[(0, 0, 0, 1)])
    motion = Given(case, (2.0,), dip)
    (line,) = admissible.violations(motion)
    assert "x is not negative" in line
    assert f"at t = {2 * where:.6g} s" in line
    assert f"x = {-(width**2):.6g} m" in line
    touching = Given(motion.case, (2.0,), dip + width**2)
    assert not admissible.violations(touching)


def test_rounding_is_allowed_and_no_more() -> None:
    case = case_with({"x is not negative": (1, 0, 0, 0)}, events=[(0, 0, 0, 1)])
    shape = polynomial_with([0.5, 0.5])  # 0 to 1/4
    scale = 0.25
    assert not admissible.violations(Given(case, (1.0,), shape - 0.9e-9 * scale))
    assert admissible.violations(Given(case, (1.0,), shape - 1.1e-9 * scale))
    assert not admissible.violations(Given(case, (1.0,), shape - 0.01), lambda p, form: 0.1)


def test_events_are_crossed_downwards_whatever_is_allowed() -> None:
    case = case_with({"x is not negative": (1, 0, 0, 0)})
    falling, rising = polynomial_with([1.0]) * -1, polynomial_with([1.0])
    assert not admissible.violations(Given(case, (1.0,), falling))
    (line,) = admissible.violations(Given(case, (1.0,), rising), lambda p, form: math.inf)
    assert "wrong direction" in line
    assert "x = 0 m and x' = 1 m/s" in line  # not a rounding error


def test_the_event_of_a_demand_is_known_by_its_form() -> None:
    demands = {"twice the event": (-2, 0, 0, 1)}
    rising = polynomial_with([0.5])  # x = 1/2 at the end: the demand falls
    motion = Given(case_with(demands, [(4, 0, 0, -2)]), (1.0,), rising)
    assert not admissible.violations(motion)
    other = Given(case_with(demands, [(4, 0, 0, -3)]), (1.0,), rising * -1)
    assert not admissible.violations(other)  # falls short of it: no event at its end


def test_a_held_phase_that_moves_otherwise_is_refused() -> None:
    case = made([(1, 0, 0, 0, 0)], [(1, 0, 0, 0)], held=(1.0,))()
    moving = np.polynomial.Polynomial([0.0, 1.0])
    assert not admissible.violations(Given(case, (1.0,), moving))
    (line,) = admissible.violations(Given(case, (1.0,), moving * 0.4))
    assert "mean velocity" in line


def test_what_is_excused_falls_with_the_order_and_is_bounded() -> None:
    form, found = (-1, 0, 0, 0.324), {}
    for method in ("ck-tau", "hb"):
        kernel = registry.kernel(IMPACT, method)
        for order in (3, 8, 24):
            orbit = attempt(kernel, IMPACT(), order, np.array([2 * math.pi, 1.0]))
            found[method, order] = by_residual(orbit)(0, form)
    assert found["ck-tau", 3] <= MOST
    assert found["ck-tau", 24] == admissible.ROUNDING
    assert found["ck-tau", 3] > 10 * found["ck-tau", 8] > 100 * found["ck-tau", 24]
    assert found["hb", 24] < found["hb", 8] / 2  # 1/N


def test_the_defect_is_the_motion_that_the_residual_would_give() -> None:
    case = made([(1, 0, 0, 0, 0)], [(1, 0, 0, 0)])()
    # x = t**2 / 2 of a free mass: the residual is 1, the velocity t - 3/2 at its smallest,
    # the displacement t (t - 3)/2 but for a constant
    motion = Given(case, (3.0,), np.polynomial.Polynomial([0, 0, 4.5]))
    assert defect(motion, 0) == pytest.approx((1.5, 9 / 16), rel=1e-13)


@pytest.mark.parametrize("waves", [1, 7, 60])
def test_critical_points_are_exact_to_rounding(waves) -> None:
    def wave(u):
        return np.sin(2 * math.pi * waves * u + 0.3)

    low, high = chebyshev.extremes(wave)
    assert (low, high) == pytest.approx((-1, 1), abs=1e-14)
    parts = chebyshev.pieces(wave)
    u = np.linspace(0, 1, 101)
    slope = chebyshev.derivative_at(parts, u, 1) / (2 * math.pi * waves)
    np.testing.assert_allclose(slope, np.cos(2 * math.pi * waves * u + 0.3), atol=1e-10)


def test_noise_is_not_resolved_for_ever() -> None:
    generator, calls = np.random.default_rng(0), []

    def noisy(u):
        calls.append(len(u))
        return np.cos(u) + 1e-11 * generator.normal(size=len(u))

    assert len(chebyshev.pieces(noisy)) <= 4
    assert len(calls) <= 8


def test_a_narrow_peak_is_resolved() -> None:
    def peak(u):
        return 1 / (1 + ((u - 0.3) / 0.02) ** 2)

    u = np.linspace(0, 1, 333)
    slope = -2 * (u - 0.3) / 0.02**2 * peak(u) ** 2
    found = chebyshev.derivative_at(chebyshev.pieces(peak), u, 1)
    np.testing.assert_allclose(found, slope, atol=1e-9)


def test_what_a_few_points_show_is_violated() -> None:
    case = registry.load("clearance")(contact_stiffness=400.0)
    found = known(case)
    seen = [orbit for orbit in found.refused if seen_violated(orbit)]
    assert len(seen) >= 3
    assert all(orbit.violations for orbit in seen)
    assert found.orbits
    assert not any(map(seen_violated, found.orbits))


def test_forms_whose_squares_are_beyond_float64_are_compared() -> None:
    with pytest.raises(ns.NoOrbit, match="its event is crossed in the wrong direction"):
        ns.exact(ns.scene("impact-inelastic")(frequency=1e150))
