"""Cells of two phases under a forcing: all solutions by a scan, and quick verdicts."""

import math

import numpy as np
import pytest
from every_run import tried

import nonsmooth as ns
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.existence import enclosure, two_phases
from nonsmooth.solver.existence.known import known
from nonsmooth.solver.existence.reasons import not_decided, shown_to_be_none
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.start import RoughTimes
from nonsmooth.solver.orbit.exact_orbit import from_times

CLEARANCE, BACKLASH = registry.load("clearance"), registry.load("backlash")
PLASTIC, FRICTION = registry.load("elastic-plastic"), registry.load("dry-friction")

SEVERAL = BACKLASH(gap=20.0, frequency=0.1)

CASES = [
    CLEARANCE(),
    SEVERAL,
    PLASTIC(),
    PLASTIC(hardening=0, yield_force=0.3),
    FRICTION(frequency=0.4).of_motion("two-stops"),
    FRICTION(mu_s=3.0).of_motion("two-stops"),
]


def found(case):
    solutions = two_phases.solutions(case.cell)
    assert solutions.complete
    return [RoughTimes(durations, angle, "scan") for durations, angle in solutions.certain]


@pytest.mark.parametrize("case", CASES, ids=repr)
def test_what_is_found_solves_the_exact_equations(case):
    starts = found(case)
    assert starts
    for start in starts:
        orbit = from_times(case, start)
        assert orbit.outcome.converged
        np.testing.assert_allclose(orbit.cell_durations, start.durations, rtol=0, atol=1e-8)
        assert abs(math.remainder(orbit.angle - start.angle, 2 * math.pi)) < 1e-7


@pytest.mark.parametrize("case", [CLEARANCE(), SEVERAL, PLASTIC()], ids=repr)
def test_what_newtons_method_comes_to_is_among_them(case):
    starts, random = found(case), np.random.default_rng(5)
    seen = set()
    for _ in range(20):
        s = random.uniform(0.05, 0.95) * case.cell.duration
        rough = RoughTimes((s, case.cell.duration - s), random.uniform(0, 6.3), "random")
        orbit = from_times(case, rough)
        shortest = min(orbit.cell_durations) / case.cell.duration
        if orbit.outcome.converged and shortest > 1e-6:  # not a phase that vanishes
            apart = [
                abs(orbit.cell_durations[0] - start.durations[0])
                + abs(math.remainder(orbit.angle - start.angle, 2 * math.pi))
                for start in starts
            ]
            assert min(apart) < 1e-6
            seen.add(int(np.argmin(apart)))
    assert len(seen) >= min(len(starts), 2)


def test_two_solutions_are_found_just_before_they_meet():
    """The larger the gap, the nearer the two contacts are to each other, until none is left."""

    def count(gap):
        return len(two_phases.solutions(CLEARANCE(gap=gap, frequency=1.6).cell).certain)

    low, high = 0.5, 3.0
    assert (count(low), count(high)) == (2, 0)
    for _ in range(36):
        middle = (low + high) / 2
        low, high = (middle, high) if count(middle) else (low, middle)
    case = CLEARANCE(gap=low, frequency=1.6)
    ends = [durations[0] for durations, _ in two_phases.solutions(case.cell).certain]
    assert len(ends) == 2
    assert 0 < abs(ends[0] - ends[1]) < 1e-3


def test_where_nothing_is_decided():
    stiff = CLEARANCE(contact_stiffness=1e9)
    assert not two_phases.solutions(stiff.cell).complete
    assert not two_phases.applies(registry.load("impact")().cell)
    assert not two_phases.applies(registry.load("stick-slip-damped")().cell)
    assert not known(registry.load("stick-slip-damped")()).complete
    assert not known(CLEARANCE(damping=0, cycles=2)).complete  # of a continuum one is found


@pytest.mark.parametrize("gap", [0.0, 1e-12, 1e-5, -1e-5, 1e-3])
@pytest.mark.parametrize("damping", [1e-3, 0.0042, 0.06])
def test_at_small_gaps_the_two_roots_beside_a_zero_are_told_apart(gap, damping):
    """At a gap of 0 they are one duration: the motion, or its mirror image."""
    case = CLEARANCE(damping=damping, contact_stiffness=0.945, gap=gap, frequency=0.99)
    solutions = two_phases.solutions(case.cell)
    assert solutions.complete
    assert len(solutions.certain) == 2
    (one, _), (other, _) = solutions.certain
    limit = CLEARANCE(damping=damping, contact_stiffness=0.945, gap=0.0, frequency=0.99)
    zero = two_phases.solutions(limit.cell).certain[0][0]
    # they lie on both sides of that of a gap of 0, about as far from it
    assert one[0] + other[0] == pytest.approx(2 * zero[0], abs=10 * gap**2 + 1e-9)
    assert abs(one[0] - other[0]) == pytest.approx(abs(gap), rel=5, abs=1e-12)
    assert len(known(case).orbits) == 1
    assert ns.solve(case, method="ck-tau", order=20).exact is not None


def polynomials(*factors):
    """Return D, P and Q of one variable as `enclosure` wants them, from coefficients."""

    def function(s):
        return np.array([np.polyval(each, s) for each in factors])

    return function


def test_no_root_of_known_functions_is_missed():
    """``D = sin(20 s)`` and ``R = gap``: two roots beside each zero of D, however near."""
    for gap in (0.0, 1e-14, 1e-9, 1e-3, 0.5):
        edges = np.array([0.01, 0.5, 3.0])

        def function(s, gap=gap):
            return np.array([np.sin(20 * s), gap * np.cos(s), gap * np.sin(s)])

        roots = enclosure.roots(function, edges)
        assert roots.complete
        zeros = np.pi * np.arange(20) / 20
        off = math.asin(gap) / 20
        expected = np.sort(np.concatenate([zeros - off, zeros + off]))
        expected = expected[(expected > edges[0]) & (expected < edges[-1])]
        np.testing.assert_allclose(roots.places, expected, rtol=0, atol=1e-13)


def test_roots_that_rounding_cannot_tell_apart_decide_nothing():
    """``D**2 - R**2`` with a double zero at 0.3: a root, two or none."""
    double = polynomials([1.0, -0.6, 1.09], [1.0], [0.0])
    roots = enclosure.roots(double, np.array([0.0, 1.0]))
    assert not roots.complete
    ((low, high),) = roots.doubtful
    assert 0.3 - 1e-5 < low < 0.3 < high < 0.3 + 1e-5
    for apart, count in ((1e-9, 0), (-1e-9, 2)):
        near = polynomials([1.0, -0.6, 1.09 + apart], [1.0], [0.0])
        roots = enclosure.roots(near, np.array([0.0, 1.0]))
        assert (roots.complete, len(roots.places)) == (True, count)


@pytest.mark.parametrize(
    "rough",
    [lambda s: np.sin(1e5 * s), lambda s: np.abs(s - 0.3) ** 0.25],
    ids=["waves", "a cusp"],
)
def test_functions_that_are_not_resolved_decide_nothing(rough):
    """Not even where no part of them is doubtful, as beside the cusp."""

    def function(s):
        return np.array([rough(s) + 2, np.ones_like(s), np.zeros_like(s)])

    assert not enclosure.roots(function, np.array([0.0, 1.0])).complete


@pytest.mark.parametrize("case", CASES, ids=repr)
def test_nothing_is_said_to_be_none_where_an_orbit_is(case):
    assert shown_to_be_none(case) is None
    assert list(not_decided(case)) == []


@pytest.mark.parametrize(
    ("case", "words"),
    [
        (CLEARANCE(gap=5.0), "no real solution at any duration of contact"),
        (PLASTIC(frequency=5.0), "no real solution at any duration of elastic"),
        (CLEARANCE(damping=3.0), r"this one solution only; solution 1: contact 2.851 s, "),
        (registry.load("impact-two-sided")(stiffness=50.0), "such orbit exists"),
    ],
    ids=repr,
)
def test_a_complete_list_without_an_orbit_ends_the_search(case, words):
    for search in (lambda: ns.solve(case, method="hb", order=5), lambda: exact_orbit(case)):
        with pytest.raises(ns.NoOrbit, match=words) as caught:
            search()
        assert caught.value.status == "no-orbit"
        assert caught.value.iterations < 20  # nothing is searched for in vain
        assert caught.value.tried[-1] == "a simulation comes to a motion without switches"


#: Loads that only touch the static limit, or are above it by rounding.
TOUCHING = [
    {"force": 0.3},
    {"force": 0.4, "mu_s": 0.4, "mu_k": 0.4},
    {"force": 0.6, "normal_force": 2},
    {"force": 0.30000000000001},
]


@pytest.mark.parametrize(
    "values", tried(TOUCHING, every_run=[*TOUCHING[:2], TOUCHING[3]]), ids=repr
)
def test_a_load_that_touches_the_static_limit_has_no_roots_of_rounding(values):
    """There were 137170 of them: noise about a double root at a slide of no duration."""
    case = FRICTION(**values).of_motion("two-stops")
    assert [phase.name for phase in two_phases.vanishing(case.cell)] == ["slide"]
    solutions = two_phases.solutions(case.cell)
    assert len(solutions.certain) + len(solutions.doubtful) < 40
    with pytest.raises(ns.NoOrbit, match="as slide lasts no time they hold to") as caught:
        ns.solve(case, method="ck-tau")
    assert caught.value.status == "not-converged"


def test_a_phase_shorter_than_is_looked_at_is_not_shown_to_be_none():
    case = BACKLASH(gap=1e-11)  # whose play is crossed in 2e-11 s
    assert [phase.name for phase in two_phases.vanishing(case.cell)] == ["loose"]
    with pytest.raises(ns.NoOrbit, match="as loose lasts no time they hold to") as caught:
        ns.exact(case)
    assert caught.value.status == "not-converged"
    assert ns.exact(BACKLASH(gap=1e-9)).phases[1].duration == pytest.approx(1.8385054e-9)


def test_a_solution_that_cannot_be_followed_is_not_shown_to_be_none():
    """It was refused as not finite, and with it all orbits."""
    with pytest.raises(ns.NoOrbit, match="motion is not finite") as caught:
        ns.exact(PLASTIC(frequency=1e-6, mass=1e-12))
    assert caught.value.status == "not-converged"


def test_limits_that_nearly_meet_are_two():
    """The element yields either way at nearly the same displacement of a large motion."""
    for part in (1e-2, 1e-3):
        elastic = ns.exact(PLASTIC(yield_force=part**2 * 1e-4)).phases[0].duration
        assert elastic == pytest.approx(0.0167185 * part, rel=1e-5)


@pytest.mark.parametrize(
    ("force", "count"), [(0.3 + 1e-7, 1), (0.3 + 1e-9, 1), (0.3 - 1e-9, 0), (0.3 - 1e-11, 0)]
)
def test_a_short_slide_is_told_from_none(force, count):
    case = FRICTION(force=force).of_motion("two-stops")
    assert len(two_phases.solutions(case.cell).certain) == count
    assert two_phases.vanishing(case.cell) == []


def test_equations_beyond_float64_decide_nothing() -> None:
    with pytest.raises(ns.NoOrbit) as raised:
        exact_orbit(FRICTION(mass=1e-150, damping=1e9))
    assert not raised.value.proven


def test_a_change_of_sign_between_values_beyond_float64() -> None:
    """There is no false position: its interval is halved."""

    def grown(u: np.ndarray) -> np.ndarray:
        return np.where(np.abs(u - 0.3) < 1e-3, u - 0.3, np.copysign(np.inf, u - 0.3))

    found = enclosure.changes_of_sign(grown, np.zeros(1), np.ones(1), 50)
    assert found == pytest.approx([0.3], abs=1e-12)
