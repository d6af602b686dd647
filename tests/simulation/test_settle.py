"""What simulations settle on: times for Newton, or words on another order of phases."""

import math

import pytest
from every_run import tried
from made_scenes import made
from reached import EVERY_RUN, IMPACT, REACHED, dry

import nonsmooth as ns
from nonsmooth.solver.case import registry
from nonsmooth.solver.flow.exact import exact_orbit
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.simulation.settle import rough_times_by_simulation, settled
from nonsmooth.solver.solve import solve_case


@pytest.mark.parametrize("name", tried(REACHED, every_run=EVERY_RUN))
def test_the_declared_order_is_found_with_its_times(name) -> None:
    case, durations, angle, *_ = REACHED[name]
    found = [q.times for q in rough_times_by_simulation(case) if q.times is not None]
    orbit = exact_orbit(case, durations, angle)
    assert found
    for times in found:
        assert times.durations == pytest.approx(orbit.cell_durations, abs=1e-6)
        if case.cell.forced:
            turn = (times.angle - orbit.angle) % (2 * math.pi)
            assert min(turn, 2 * math.pi - turn) < 1e-6


def test_four_stops_are_said_where_two_are_declared() -> None:
    (found,) = rough_times_by_simulation(dry(0.15, 0.2, 0.2)())
    assert found.times is None
    head, _, phases = found.words.partition(": ")
    assert head == "a simulation settles on another order of phases"
    names, _, every = phases.partition(", in ")
    assert names.count("phase 1") == 4
    assert every == "each period of the forcing"


def test_what_does_not_move_on_is_said() -> None:
    (found,) = rough_times_by_simulation(IMPACT(gap=5))  # farther than the free motion goes
    assert (found.times, found.words) == (
        None, "a simulation comes to a motion without switches",
    )  # fmt: skip
    (found,) = rough_times_by_simulation(IMPACT(restitution=0.3, frequency=0.3, damping=0.3))
    assert found.words.startswith("a simulation ends: chatter: ")


@pytest.mark.filterwarnings("error")
def test_a_stop_however_far_is_said_to_be_out_of_reach() -> None:
    far = IMPACT(gap=1e300)  # its square is beyond float64
    (found,) = rough_times_by_simulation(far)
    assert found.words == "a simulation comes to a motion without switches"
    with pytest.raises(NoOrbit, match="no such orbit exists"):
        solve_case(far)


def test_a_limit_that_is_only_touched_is_said() -> None:
    def words(load):
        case = registry.load("dry-friction")(force=load).of_motion("two-stops")
        return [each.words for each in rough_times_by_simulation(case)]

    settles = "a simulation settles on slide, stop"
    assert words(0.3) == ["a simulation comes to a motion without switches"]
    assert words(0.3 + 1e-9) == [settles]


@pytest.mark.parametrize("load", [0.3, 0.4])
def test_what_only_touches_a_limit_is_no_phase(load) -> None:
    """At none of the 40 times that the load comes to its limit does the mass slide."""
    case = registry.load("dry-friction")(force=load, mu_s=load, mu_k=0.2)
    motion = ns.simulate(case, cycles=20)
    assert motion.ended == ""
    assert [(q.name, q.displacement) for q in motion.phases] == [("stop", 0.0)]


def test_solve_falls_back_on_it() -> None:
    # a short stick beside a long slip: rough times lead nowhere
    belt = ns.StickSlip(
        mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=40
    )
    orbit = ns.solve(belt, "c1-tau", 8)
    assert orbit.period == pytest.approx(ns.exact(belt).period, rel=1e-6)
    for search in (lambda case: solve_case(case, "ck-tau", 8), exact_orbit):
        with pytest.raises(NoOrbit) as caught:
            search(IMPACT(gap=5))
        assert caught.value.tried[-1] == "a simulation comes to a motion without switches"


def test_exact_orbits_start_from_it_too() -> None:
    # two phases of which no rough split into equal, long and short ones is near
    scene = made(
        [(1, 0.2, 401, 0.5 * 400, 1), (1, 0.2, 1, 0, 1)],
        [(1, 0, 0, -0.5), (1, 0, 0, -0.5)],
        omega=1.3,
        demands=[{"in contact": (1, 0, 0, -0.5)}, {"free": (-1, 0, 0, 0.5)}],
    )
    orbit = exact_orbit(scene())
    assert orbit.admissible
    assert orbit.durations[0] < 0.1 * orbit.period


def test_one_impact_in_two_periods_is_not_one_a_period() -> None:
    (found,) = rough_times_by_simulation(IMPACT(frequency=3.6, damping=0.05, gap=0))
    assert found.times is None
    words = "a simulation settles on another order of phases: flight, in every 2 periods"
    assert found.words == f"{words} of the forcing"


def test_what_still_decays_has_not_settled() -> None:
    # two springs and no forcing: the durations are those of an orbit, the speed is not
    scene = made(
        [(1, 0.02, 4, 0, 0), (1, 0.02, 1, 0, 0)],
        [(1, 0, 0, 0), (1, 0, 0, 0)],
        demands=[{"beyond 0": (1, 0, 0, 0)}, {"before 0": (-1, 0, 0, 0)}],
    )
    case = scene()
    found = settled(case.cell, ns.simulate(case, (0, 1), cycles=60))
    assert found.times is None
    lossless = made(
        [(1, 0, 4, 0, 0), (1, 0, 1, 0, 0)],
        [(1, 0, 0, 0), (1, 0, 0, 0)],
        demands=[{"beyond 0": (1, 0, 0, 0)}, {"before 0": (-1, 0, 0, 0)}],
    )()
    times = settled(lossless.cell, ns.simulate(lossless, (0, 1), cycles=60)).times
    assert times is not None
    assert times.durations == pytest.approx((math.pi / 2, math.pi))
