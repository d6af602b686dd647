"""Where no orbit is, or none alone: shown in closed form, and said with the parameter."""

import math

import numpy as np
import pytest
from galerkin.solving import residual
from hypothesis import given, settings
from hypothesis import strategies as st
from made_scenes import in_a_row, made

from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.existence import one_phase
from nonsmooth.solver.existence.known import known
from nonsmooth.solver.existence.reasons import not_decided, shown_to_be_none, without_switches
from nonsmooth.solver.flow.exact_system import exact_kernel
from nonsmooth.solver.in_order import cases_in_order
from nonsmooth.solver.kernels import registry, start
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.solve import solve_case


@pytest.fixture(autouse=True)
def few_starts(monkeypatch):
    """Search in vain from fewer starts: as much in vain, and quicker."""
    monkeypatch.setattr(start, "ANGLES", 2)
    monkeypatch.setattr(start, "UNEQUAL", ())


IMPACT, FRICTION = registry.load("impact"), registry.load("dry-friction")
TWO_SIDED, BACKLASH = registry.load("impact-two-sided"), registry.load("backlash")


def sliding(**values):
    return FRICTION(**values).of_motion("sliding")


@settings(max_examples=30)
@given(
    st.sampled_from([IMPACT, TWO_SIDED, FRICTION]),
    st.floats(0.3, 3.0), st.floats(0.0, 1.0), st.floats(0.01, 2.0),
)  # fmt: skip
def test_the_solutions_in_closed_form_satisfy_the_exact_equations(scene, omega, c, size):
    if scene is FRICTION:
        case = sliding(frequency=omega, damping=c, normal_force=size)
    else:
        case = scene(frequency=omega, damping=c, gap=size)
    found = one_phase.solutions(case.cell).states
    for x, v, angle in found:
        z = np.array([x, v, case.cell.duration, angle])
        R = residual(exact_kernel(case.cell), case.cell, z)
        assert np.abs(R).max() < 1e-9 * (1 + abs(x) + abs(v))
    assert len(found) in (0, 2)


@pytest.mark.parametrize("values", [{}, {"gap": 0.4}, {"frequency": 2.8, "restitution": 0.8}])
def test_what_the_search_finds_is_among_them(values):
    orbit = exact_orbit(IMPACT(**values))
    angles = [angle for *_, angle in one_phase.solutions(orbit.case.cell).states]
    apart = [abs(math.remainder(orbit.angle - angle, 2 * math.pi)) for angle in angles]
    assert min(apart) < 1e-12


@pytest.mark.parametrize("n", [1, 3, 5, 7])
def test_dry_friction_in_resonance_has_no_sliding_orbit(n):
    """Half a period returns what friction adds with its own sign, again and again."""
    finding = shown_to_be_none(sliding(damping=0, frequency=1 / n, mu_s=0.4))
    part = "" if n == 1 else f"1/{n} of "
    why = f"resonance: frequency = {1 / n:.6g} rad/s is {part}the natural frequency of slide"
    assert finding.proven
    assert str(finding) == (
        f"dry-friction, sliding: no such orbit exists: {why}, and nothing damps it"
    )
    damped = one_phase.solutions(sliding(damping=1e-6, frequency=1 / n).cell)
    assert not damped.none


def test_the_command_says_so_with_the_status_of_no_orbit(run):
    arguments = ("dry-friction", "--motion", "sliding", "--damping", 0, "--frequency", 1 / 3)
    status, out, err = run("solve", *arguments, "--method", "ck-tau")
    assert status == 1
    assert "no-orbit" in out
    assert err.startswith("nonsmooth: dry-friction, sliding: no such orbit exists: resonance: ")
    assert "frequency = 0.333333 rad/s is 1/3 of the natural frequency" in err


def test_even_parts_of_the_natural_frequency_have_their_orbit():
    """The antisymmetric one, of a continuum of others: a multiplier is 1."""
    orbit = exact_orbit(sliding(damping=0, frequency=0.5))
    assert np.abs(orbit.multipliers - 1).min() < 1e-12
    assert orbit.stable is None


def test_a_gap_out_of_reach_is_shown_to_be_one():
    for search in (exact_orbit, lambda case: solve_case(case, "hb", 8)):
        with pytest.raises(NoOrbit) as caught:
            search(IMPACT(gap=100.0))
        why = caught.value
        assert (why.status, why.proven, why.iterations) == ("no-orbit", True, 0)
        assert str(why) == (
            "impact: no such orbit exists: its equations have no real solution; the mass can "
            "move in flight for ever, without switches, |x| up to 0.444994 m; a simulation "
            "comes to a motion without switches"
        )


def test_solutions_that_are_no_orbits_are_named_one_by_one():
    """Of dry friction that hardly drives: both roots leave the static limit uncrossed."""
    finding = shown_to_be_none(sliding(mu_s=2.0))
    assert finding.proven
    assert [why.partition(":")[0] for why in finding.tried] == ["solution 1", "solution 2"]
    assert "the load exceeds the static limit" in "".join(finding.tried)
    assert shown_to_be_none(sliding()) is None


def test_where_every_motion_is_shown_to_have_none_the_whole_is():
    with pytest.raises(NoOrbit) as caught:
        solve_case(FRICTION(force=0.2))
    assert caught.value.status == "no-orbit"
    with pytest.raises(NoOrbit) as caught:
        solve_case(FRICTION(force=0.3))  # slides that last no time are not told from none
    assert caught.value.status == "not-converged"


def test_equations_with_infinitely_many_solutions_are_said_to_have_them():
    """Half a period is three half turns: what leaves one stop arrives at the other, always."""
    case = TWO_SIDED(damping=0, frequency=1 / 3)
    assert shown_to_be_none(case) is None
    (words,) = not_decided(case)
    assert words.startswith(
        "the equations have infinitely many solutions, none isolated: resonance: frequency = "
        "0.333333 rad/s is 1/3 of the natural frequency of crossing"
    )
    assert list(not_decided(TWO_SIDED(damping=0, frequency=0.35))) == []
    (declared,) = cases_in_order(case, "crossing,mirrored")
    with pytest.raises(NoOrbit, match="infinitely many solutions, none isolated"):
        solve_case(declared)
    assert solve_case(case).case.scene.motion == "crossing,crossing,crossing,mirrored"


def test_a_constant_on_the_circle_alone_decides():
    """Free masses: the rows fix the forcing, and its amplitude is the right one or is not."""

    def at(push):
        return made([(1, 0, 0, push, 1)], [(0, 1, 0, 0)], omega=1.0)().cell

    assert one_phase.solutions(at(0.5)).none  # a constant force: the mass runs away
    free = one_phase.solutions(at(0.0))  # its mean position is free
    assert (free.none, free.states) == (False, ())


@pytest.mark.parametrize(("gap", "reaches"), [(1.04, False), (1.03, True)])
def test_a_body_that_does_not_reach_its_stop_says_how_far_it_comes(gap, reaches):
    """By the response of its matrices."""
    case = registry.load("chain-impact")(gap=gap)
    rows = in_a_row([1] * 5) * (1 + 0.05j * 0.5) - 0.25 * np.eye(5)
    size = abs(np.linalg.solve(rows, np.eye(5)[0])[4])
    words = [
        f"the contact can move in flight for ever, without switches, |x| up to {size:.6g} m"
    ]
    assert list(without_switches(case)) == ([] if reaches else words)


def test_a_motion_without_switches_is_named_where_it_is_why():
    (words,) = without_switches(BACKLASH(force=0.2))
    size = 0.2 / math.hypot(0.7**2, 0.1 * 0.7)
    assert words == (
        f"the mass can move in loose for ever, without switches, |x| up to {size:.6g} m"
    )
    assert list(without_switches(BACKLASH())) == []  # it would leave the play
    with pytest.raises(NoOrbit, match="in loose for ever, without switches"):
        exact_orbit(BACKLASH(force=0.05))
    words, also = without_switches(BACKLASH(damping=0, frequency=1))
    assert "without switches, |x| up to 0.8 m" in also
    assert words.startswith(
        "resonance: frequency = 1 rad/s is the natural frequency of engaged"
    )


def test_a_message_has_the_first_starts_and_the_last_and_says_how_many_more() -> None:
    tried = tuple(f"start {i}" for i in range(100))
    finding = NoOrbit("none was found", False, tried)
    words = (
        "none was found; start 0; start 1; start 2; ... and 94 more starts, in `tried` ...; "
    )
    assert str(finding) == words + "start 97; start 98; start 99"
    assert finding.in_full == "; ".join(("none was found", *tried))
    assert str(NoOrbit("none", False, tried[:7])) == "; ".join(("none", *tried[:7]))


def test_squares_beyond_float64_are_not_taken():
    found = known(IMPACT(mass=1e300, stiffness=1e300))
    assert (found.orbits, found.refused, found.complete) == ((), (), True)


@pytest.mark.parametrize(
    ("values", "angles", "count"),
    [
        ({"stiffness": 1e-12, "gap": -1e6}, [3.0860931791, 6.2276877712], 1),
        ({"mass": 1e-12, "damping": 0}, [1.4706276361, 4.812555132], 0),
        ({"frequency": 1e-6, "damping": 1e-9}, [1.4706289056, 4.8125564015], 0),
    ],
)
def test_solutions_are_told_however_far_the_motion_is_from_its_units(values, angles, count):
    """Of the first none was said to exist, of the others infinitely many; by 60 digits."""
    found = known(IMPACT(**values))
    both = sorted(each.forcing_phase for each in (*found.orbits, *found.refused))
    np.testing.assert_allclose(both, angles, rtol=0, atol=1e-8)
    assert (len(found.orbits), found.infinite) == (count, False)
