"""Cells of two phases under a forcing: all solutions by a scan, and quick verdicts."""

import math

import numpy as np
import pytest
from every_run import tried

import nonsmooth as ns
from nonsmooth.solver.case import registry
from nonsmooth.solver.flow import existence, two_phases
from nonsmooth.solver.flow.exact import exact_orbit
from nonsmooth.solver.flow.exact_motion import from_times
from nonsmooth.solver.flow.existence import is_in_vain, scanned
from nonsmooth.solver.iteration.start import PATIENCE, RoughTimes

CLEARANCE, BACKLASH = registry.load("clearance"), registry.load("backlash")
PLASTIC, FRICTION = registry.load("elastic-plastic"), registry.load("dry-friction")

SEVERAL = BACKLASH(gap=20.0, frequency=0.1)

CASES = [
    CLEARANCE(),
    CLEARANCE(damping=0, cycles=2),
    SEVERAL,
    PLASTIC(),
    PLASTIC(hardening=0, yield_force=0.3),
    FRICTION(frequency=0.4).of_motion("two-stops"),
    FRICTION(mu_s=3.0).of_motion("two-stops"),
]


def found(case):
    solutions = two_phases.solutions(case.cell)
    assert solutions is not None
    return [RoughTimes(durations, angle, "scan") for durations, angle in solutions]


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
        return len(two_phases.solutions(CLEARANCE(gap=gap, frequency=1.6).cell))

    low, high = 0.5, 3.0
    assert (count(low), count(high)) == (2, 0)
    for _ in range(36):
        middle = (low + high) / 2
        low, high = (middle, high) if count(middle) else (low, middle)
    ends = [start.durations[0] for start in found(CLEARANCE(gap=low, frequency=1.6))]
    assert len(ends) == 2
    assert 0 < abs(ends[0] - ends[1]) < 1e-3


def test_where_nothing_is_decided():
    stiff = CLEARANCE(contact_stiffness=1e9)
    assert two_phases.solutions(stiff.cell) is None
    assert not is_in_vain(stiff)
    assert not two_phases.applies(registry.load("impact")().cell)
    assert not two_phases.applies(registry.load("stick-slip-damped")().cell)
    assert list(scanned(registry.load("impact")(gap=100.0))) == []


@pytest.mark.parametrize("case", CASES[:1] + CASES[2:], ids=repr)
def test_a_search_is_not_in_vain_where_an_orbit_is(case):
    assert not is_in_vain(case)
    assert list(scanned(case)) == []


@pytest.mark.parametrize(
    ("case", "words"),
    [
        (
            CLEARANCE(gap=5.0),
            "the exact equations have no solution: a scan of the durations of",
        ),
        (PLASTIC(frequency=5.0), "durations of elastic, from 0 to the whole cell, finds none"),
        (
            CLEARANCE(damping=3.0),
            r"finds one solution, which is not an orbit \(contact 2.851 s:",
        ),
    ],
    ids=repr,
)
def test_a_search_in_vain_ends_soon_and_says_why(case, words):
    assert is_in_vain(case)
    for search in (lambda: ns.solve(case, method="hb", order=5), lambda: exact_orbit(case)):
        with pytest.raises(ns.NoOrbit, match=words) as caught:
            search()
        assert caught.value.status == "not-converged"  # a scan is not a proof
        tried = caught.value.tried
        assert len(tried) <= PATIENCE + 2
        assert tried[-1] == "a simulation comes to a motion without switches"


def test_of_one_phase_a_proof_ends_the_search():
    case = registry.load("impact-two-sided")(stiffness=50.0)
    assert is_in_vain(case)
    with pytest.raises(ns.NoOrbit) as caught:
        ns.solve(case, method="hb", order=5)
    assert caught.value.proven
    assert caught.value.iterations < 40 * PATIENCE


#: Loads that only touch the static limit, or are above it by rounding.
TOUCHING = [
    {"force": 0.3},
    {"force": 0.4, "mu_s": 0.4, "mu_k": 0.4},
    {"force": 0.6, "normal_force": 2},
    {"force": 0.30000000000001},
]


@pytest.fixture
def from_the_scan(monkeypatch):
    """Return a list to which each solution of a scan that Newton's method polishes is added."""
    existence.scanned_words.cache_clear()
    starts = []

    def counted(case, rough):
        starts.append(rough)
        assert len(starts) < 100
        return from_times(case, rough)

    monkeypatch.setattr(existence, "from_times", counted)
    return starts


@pytest.mark.parametrize(
    "values", tried(TOUCHING, every_run=[*TOUCHING[:2], TOUCHING[3]]), ids=repr
)
def test_a_load_that_touches_the_static_limit_has_no_roots_of_rounding(values, from_the_scan):
    """There were 137170 of them: noise about a double root at a slide of no duration."""
    case = FRICTION(**values).of_motion("two-stops")
    assert [phase.name for phase in two_phases.vanishing(case.cell)] == ["slide"]
    with pytest.raises(ns.NoOrbit, match="only as slide lasts no time do they hold") as caught:
        ns.solve(case, method="ck-tau")
    assert caught.value.status == "not-converged"
    assert len(caught.value.tried) <= PATIENCE + 3
    assert from_the_scan == []


@pytest.mark.parametrize(
    ("force", "count"), [(0.3 + 1e-9, 1), (0.3 + 1e-11, 1), (0.3 - 1e-11, 0)]
)
def test_a_short_slide_is_told_from_none(force, count):
    case = FRICTION(force=force).of_motion("two-stops")
    assert len(two_phases.solutions(case.cell)) == count
    assert two_phases.vanishing(case.cell) == []


def test_rounding_that_is_taken_for_roots_decides_nothing(monkeypatch):
    monkeypatch.setattr(two_phases, "ROUNDING", 0.0)
    case = FRICTION(force=0.30000000000001).of_motion("two-stops")
    assert two_phases.solutions.__wrapped__(case.cell) is None
