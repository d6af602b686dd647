"""What is measured of orbits: against sums by hand, in other units, and the exact orbit."""

import numpy as np
import pytest
from computed import ODD, Exact, acceleration_errors, case, period_errors, rate
from paper import METHODS
from scipy.special import sici

import nonsmooth as ns
from nonsmooth.report.case import DEFAULT, Case, at_alpha
from nonsmooth.report.checks.fourier import GIBBS, rising
from nonsmooth.report.measures import MEASURES


@pytest.fixture(params=[0.3, 5.0])
def pair(request) -> list[Case]:
    """Return two oscillators of the same alpha and other units."""
    return [at_alpha(belt, request.param) for belt in (DEFAULT, ODD)]


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
def test_the_overshoot_is_measured_in_jumps(pair, method: str) -> None:
    for each in pair:
        for order in (10, 40):
            orbit = ns.solve(each.belt, method, order)
            times = np.linspace(orbit.t1 / 2, orbit.t1, 4_000, endpoint=False)
            over = orbit.acceleration(times).max() / Exact(each.belt).jump
            assert each.measured("overshoot", method, order) == pytest.approx(over, rel=1e-3)
            assert 1e-3 < over < 0.11


def test_the_largest_errors_are_measured_in_jumps_and_amplitudes(pair) -> None:
    part = (np.arange(4000) + 0.5) / 4000
    for each in pair:
        exact, orbit = Exact(each.belt), ns.solve(each.belt, "hb", 10)
        amplitude = np.hypot(exact.reach, exact.speed / exact.omega)
        sizes = (amplitude, amplitude * exact.omega, exact.jump)
        for derivative, name in enumerate(("displacement", "velocity", "acceleration")):
            errors = []
            for start, end, from_, to in (
                (0, orbit.t1, 0, exact.t1),
                (orbit.t1, orbit.period, exact.t1, exact.period),
            ):
                found = getattr(orbit, name)(start + (end - start) * part)
                there = (from_ + (to - from_) * part) / exact.period
                errors.append(np.abs(found - exact.motion(there, derivative)))
            largest = np.max(errors) / sizes[derivative]
            measured = each.measured(f"largest {name}", "hb", 10)
            assert measured == pytest.approx(largest, rel=1e-2)
        inside = np.array(errors)[:, 1000:3000].max() / exact.jump
        assert each.measured("inside", "hb", 10) == pytest.approx(inside, rel=1e-2)
        assert inside < largest / 3


def test_the_jerk_is_the_slope_of_the_acceleration_in_slip(pair) -> None:
    for each in pair:
        orbit, exact = ns.solve(each.belt, "c1", 7), Exact(each.belt)
        slip = orbit.period - orbit.t1
        u = np.linspace(0.001, 0.999, 999)
        step = 1e-5
        sides = [orbit.acceleration(orbit.t1 + slip * (u + sign * step)) for sign in (-1, 1)]
        found = (sides[1] - sides[0]) / (2 * step * slip)
        part = (exact.t1 + (exact.period - exact.t1) * u) / exact.period
        errors = np.abs(found + exact.omega**2 * exact.motion(part, 1))
        size = np.hypot(exact.reach, exact.speed / exact.omega) * exact.omega**3
        measured = each.measured("largest jerk", "c1", 7)
        assert measured == pytest.approx(errors.max() / size, rel=0.05)


def test_what_is_measured_has_no_unit(pair) -> None:
    for of in MEASURES:
        one, other = (each.measured(of, "c1", 7) for each in pair)
        assert one == pytest.approx(other, rel=1e-6), of


def test_the_ripple_of_many_harmonics_is_that_of_gibbs() -> None:
    constant = sici(np.pi)[0] / np.pi - 0.5
    assert pytest.approx(constant, rel=1e-12) == GIBBS
    assert Case(DEFAULT).measured("overshoot", "hb", 160) == pytest.approx(constant, rel=0.02)


@pytest.mark.parametrize(("proven", "words"), [(True, "has"), (False, "leads to")])
def test_an_orbit_that_is_not_found_is_looked_for_once(proven, words, monkeypatch) -> None:
    asked = []

    def nothing(*arguments: object) -> None:
        asked.append(arguments)
        raise ns.NoOrbit("none", proven, ())

    monkeypatch.setattr(ns, "solve", nothing)
    case = Case(DEFAULT)
    for _ in range(2):
        with pytest.raises(ns.NoOrbit, match=f"^c1 {words} no orbit at N = 3$"):
            case.measured("period", "c1", 3)
    assert not case.has("c1", 3)
    assert asked == [(DEFAULT, "c1", 3)]


def test_what_is_shown_to_be_none_is_not_looked_for(monkeypatch) -> None:
    found = [N for N in range(1, 13) if at_alpha(DEFAULT, 0.02).has("c1", N)]
    assert found == [9, 10, 11, 12]
    asked = []
    monkeypatch.setattr(ns, "solve", lambda belt, method, N: asked.append(N))
    case = at_alpha(DEFAULT, 0.02)
    assert not any(case.has("c1", N) for N in range(1, 9))
    with pytest.raises(ns.NoOrbit, match=r"^c1 has no orbit at N = 8$"):
        case.orbit("c1", 8)
    assert asked == []


def test_errors_rates_and_who_is_behind_are_those_of_a_sweep() -> None:
    for method in METHODS:
        for of in ("period", "acceleration"):
            expected = rate(DEFAULT, of, method)
            # rounding is up to 1e-2 of the smallest errors that count: 1e-16 of 1e-12 in the
            # period, 1e-8 of 1e-6 in (22), where a jump lies one bit elsewhere
            assert case().rate(of, method) == pytest.approx(expected, rel=1e-6)
    size = {m: {N: abs(e) for N, e in period_errors(DEFAULT, m).items()} for m in METHODS}
    behind = [N for N in range(1, 13) if size["c1"][N] > size["hb-c1"][N]]
    assert case().behind("period", "c1", "hb-c1") == behind == [1, 2, 3, 4]
    for method, expected in (("hb", [5, 15, 22, 25, 32]), ("c1", [2, 6, 8, 10, 12, 14])):
        errors = acceleration_errors(DEFAULT, method)
        up = [N for N in range(2, 41) if errors[N] > errors[N - 1] and errors[N] > 1e-6]
        assert up == rising(case(), method) == expected
