"""What simulations settle on: times for Newton, or words on another order of phases."""

import math
import re
from dataclasses import replace

import numpy as np
import one_mass
import pytest
from branch.wells import WELLS
from every_run import tried
from made_scenes import dry, made, mirrored
from reached import EVERY_RUN, IMPACT, REACHED
from shown import ROOT

import nonsmooth as ns
from nonsmooth.solver.exact import _by_half, exact_orbit, starts
from nonsmooth.solver.flow import flow
from nonsmooth.solver.in_order import cases_in_order, settled_cases
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.start import RoughTimes
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.orbit.exact_orbit import from_times
from nonsmooth.solver.scenes.ordered import of_all_phases
from nonsmooth.solver.scenes.orders import Order, Step
from nonsmooth.solver.simulation import settle
from nonsmooth.solver.simulation.lasting import lasts
from nonsmooth.solver.simulation.machine import Machine
from nonsmooth.solver.simulation.outcome import Other, outcome_of
from nonsmooth.solver.simulation.settle import rough_times_by_simulation
from nonsmooth.solver.simulation.simulate import cycle
from nonsmooth.solver.simulation.steps.state import State
from nonsmooth.solver.simulation.walk import follow
from nonsmooth.solver.solve import solve_case

WITHOUT = "a simulation comes to a motion without switches"
OTHER = "a simulation settles on another sequence of phases"
IN_TWO = f"{OTHER}: flight, in every 2 periods of the forcing"


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
    assert head == OTHER
    names, _, every = phases.partition(", in ")
    assert names.count("phase 1") == 4
    assert every == "each period of the forcing"


@pytest.mark.parametrize(
    ("case", "words"),
    [
        (IMPACT(gap=5), WITHOUT),  # farther than the free motion goes
        (IMPACT(gap=1e300), WITHOUT),  # its square is beyond float64
        (IMPACT(restitution=0.3, frequency=0.3, damping=0.3), "a simulation ends: chatter: .*"),
        (IMPACT(frequency=3.6, damping=0.05, gap=0), IN_TWO),
    ],
)
def test_what_there_is_instead_is_said(case, words) -> None:
    (found,) = rough_times_by_simulation(case)
    assert found.times is None
    assert re.fullmatch(words, found.words)


def test_a_stop_however_far_is_said_to_be_out_of_reach() -> None:
    with pytest.raises(NoOrbit, match="no such orbit exists"):
        solve_case(IMPACT(gap=1e300))


def test_a_limit_that_is_only_touched_is_said() -> None:
    def words(load):
        case = registry.load("dry-friction")(force=load).of_motion("two-stops")
        return [each.words for each in rough_times_by_simulation(case)]

    settles = "a simulation settles on slide, stop"
    assert words(0.3) == [WITHOUT]
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


def test_where_no_orbit_is_known_a_slow_transient_is_followed_to_its_end() -> None:
    case = ns.scene("clearance")(frequency=1.684, damping=0.00153, gap=0.958)
    with pytest.raises(NoOrbit, match="separated, in every 5 periods of the forcing"):
        ns.exact(case)


def test_a_motion_that_winds_about_its_orbit_is_not_said_to_have_a_longer_period() -> None:
    """It is back sooner after two periods than after one."""
    case = ns.scene("clearance")(
        frequency=1.9688, gap=0.1991, contact_stiffness=4.7276, damping=0.0322, force=0.6028
    )
    with pytest.raises(NoOrbit, match=r"in each period of the forcing$"):
        ns.exact(replace(case, cycles=2))


def test_another_motion_of_the_scene_on_which_it_settles_is_that_motion() -> None:
    """Where its own phases do not admit the transient, nothing else leads to its orbit."""
    case = ns.scene("dry-friction")()
    (each, times), *_ = settled_cases(case)
    assert each == case.of_motion("sliding")
    durations = ns.exact(each).cell_durations
    assert times.durations == pytest.approx(durations, rel=1e-3)


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


def test_what_still_decays_has_not_settled() -> None:
    # two springs and no forcing: the durations are those of an orbit, the speed is not
    def settled_on(damping: float):
        case = made(
            [(1, damping, 4, 0, 0), (1, damping, 1, 0, 0)],
            [(1, 0, 0, 0), (1, 0, 0, 0)],
            demands=[{"beyond 0": (1, 0, 0, 0)}, {"before 0": (-1, 0, 0, 0)}],
        )()
        return outcome_of(case.cell, ns.simulate(case, (0, 1), cycles=60)).times

    assert settled_on(0.02) is None
    times = settled_on(0.0)
    assert times is not None
    assert times.durations == pytest.approx((math.pi / 2, math.pi))


def resonant(damping: float, yield_force: float):
    """Return an element that yields only when its resonance has built up."""
    values = {"damping": damping, "yield_force": yield_force, "hardening": 0, "frequency": 1}
    return registry.load("elastic-plastic")(**values)


def test_a_transient_is_followed_as_long_as_the_damping_lets_it_last() -> None:
    """It first yields after 128 cycles; before, it is a motion without switches until now."""
    case = resonant(0.008, 120)
    short = outcome_of(case.cell, ns.simulate(case, cycles=100))
    words = "does not settle: without a switch in the last 100, it may stay in elastic"
    assert (short.times, short.words) == (None, f"a simulation of 100 cycles {words}")
    (found,) = rough_times_by_simulation(case)
    assert found.words == "a simulation settles on elastic, plastic"
    (start,) = [words for words, _ in starts(case, (), [])]  # behind "from" in a reason
    assert start == "a simulation that settles on elastic, plastic"
    orbit = exact_orbit(
        case, [s * case.units.time for s in found.times.durations], found.times.angle
    )
    assert orbit.cell_durations == pytest.approx(found.times.durations, abs=1e-3)


@pytest.mark.long
def test_a_transient_of_eight_hundred_cycles_is_followed() -> None:
    case = replace(resonant(1, 1), values={
        "damping": 0.0012588256917278591, "yield_force": 761.8819214211377, "hardening": 0,
        "frequency": 1.0000005056922898,
    })  # fmt: skip
    (found,) = rough_times_by_simulation(case)
    assert found.words == "a simulation settles on elastic, plastic"
    assert solve_case(case).admissible


def test_the_work_is_bounded_and_what_was_done_is_said() -> None:
    slow = registry.load("clearance")(frequency=0.003, damping=1e-4)
    for case in (resonant(1e-5, 9e4), slow):
        (found,) = rough_times_by_simulation(case, 60)
        head, _, tail = found.words.partition(" cycles ")
        assert tail.startswith("does not settle")
        assert 0 <= int(head.removeprefix("a simulation of ")) < 500


def test_an_orbit_beside_the_linear_response_is_found_from_a_throw() -> None:
    """From rest the motion comes to the response that meets neither of its walls."""
    case = ns.scene(ROOT / "examples/scenes/unequal_stops.py")(
        mass=0.91, damping=0.02, stiffness=1.9, force=0.57, frequency=2.1, left=0.51, right=1.5,
        restitution=0.88,
    )  # fmt: skip
    (from_rest,) = rough_times_by_simulation(case)
    assert from_rest.words == "a simulation comes to a motion without switches"
    orbit = ns.exact(case)
    assert orbit.stable
    thrown = ns.simulate(case, (0.0, 3.0), cycles=400).phases[-2]
    assert thrown.duration == pytest.approx(orbit.durations[0], rel=1e-9)


def test_newton_starts_where_a_motion_almost_repeats() -> None:
    """In resonance the absorber slips without a stop, and transients last beyond the budget."""
    case = ns.scene("absorber-friction")(force=0.1, frequency=1)
    found = [*settle.from_several_states(of_all_phases(case), settle.FEW)]
    assert {each.words[-15:] for each in found} == {"does not settle", ""}
    assert not any(each.conclusive for each in found)
    assert any(each.other for each in found)
    orbit = ns.exact(case)
    assert orbit.case.scene.motion == "slip,mirrored"
    assert orbit.stable
    lasting = ns.simulate(case, cycles=1000).phases[-3:-1]
    assert [q.duration for q in lasting] == pytest.approx(orbit.durations, rel=1e-9)


def test_a_motion_that_never_settles_comes_near_to_orbits() -> None:
    """It is chaotic; one period of an unstable orbit that it passes is simulated."""
    case = WELLS(damping=0.14, negative=0.79, edge=0.54, force=0.52, frequency=0.65)
    assert not next(settle.from_several_states(of_all_phases(case))).conclusive
    orbit = ns.exact(case)
    assert (len(orbit.phases), orbit.stable) == (6, False)
    first, angle = orbit.phases[0], orbit.forcing_phase
    state = first.displacement, first.velocity
    motion = ns.simulate(case, state, cycles=1.01, forcing_phase=angle)
    assert [q.duration for q in motion.phases[:-1]] == pytest.approx(orbit.durations, rel=1e-9)


@pytest.mark.parametrize("belt", [0.03, 0.01])
def test_a_free_motion_settles_however_long_its_period_is(belt) -> None:
    """It sticks for 50 and for 153 units of time."""
    (found, *_) = rough_times_by_simulation(
        ns.scene("stick-slip-damped")(
            mass=1, stiffness=1, damping=0.27, belt_speed=belt, mu_s=1.29, mu_k=0.36,
            normal_force=1, weakening=0,
        )
    )  # fmt: skip
    assert found.conclusive
    assert sum(found.times.durations) > 50


def test_what_was_repeated_before_is_not_what_a_motion_settles_on() -> None:
    """The last phase goes on for many cycles, and does not last for ever."""
    case = IMPACT()
    motion = ns.simulate(case, cycles=40)
    assert outcome_of(case.cell, motion).times is not None
    *done, last = motion.segments
    left = replace(motion, segments=(*done, replace(last, s=200.0)))
    assert outcome_of(case.cell, left).times is None
    changed = replace(done[-1], s=done[-1].s + 2e-3)
    assert (
        outcome_of(case.cell, replace(motion, segments=(*done[:-1], changed, last))).times
        is None
    )


@pytest.mark.parametrize("velocity", [1.0, -1.0])  # the phase itself, and its mirror image
def test_a_switch_that_its_event_forbids_is_not_taken(velocity) -> None:
    """Where the load is below the static limit a mass that comes to rest does not slide on."""
    values = {"mu_s": 0.7, "mu_k": 0.137, "force": 0.876, "frequency": 1.8, "stiffness": 0.21}
    slides = registry.load("dry-friction")(mass=3.6, damping=0, normal_force=2.06, **values)
    case = slides.of_motion("sliding")
    start = State(0.0, velocity, 0.0)
    motion = follow(case, Machine(case.cell), start, 100 * cycle(case.cell))
    assert len(motion.segments) == 1
    assert "no phase of the scene takes the state" in motion.ended


def test_a_phase_that_ends_at_another_event_than_its_own_is_not_that_of_the_order() -> None:
    """The stop is declared to end where the mass would slide on, and ends where it turns."""
    forward, backward = (1, 0, -1, 0.3), (-1, 0, 1, 0.3)
    friction = made(
        [(1, 0.1, 1, 0.3, 1), (1, 0, 0, 0, 0)],
        [(0, 1, 0, 0), backward],
        omega=0.5,
        half=True,
        held=(None, 0.0),
        demands=[{"it slides": (0, -1, 0, 0)}, {"the load": forward, "holds": backward}],
    )()
    found = next(rough_times_by_simulation(friction))
    assert found.times is None
    assert found.words.startswith(f"{OTHER}: phase 0, -phase 1, -phase 0, phase 1, in each")
    durations = [phase.duration for phase in ns.exact(friction).phases]
    assert durations == pytest.approx(2 * list(found.other.times.durations), abs=1e-3)


def test_a_motion_that_excites_itself_starts_beside_its_equilibrium() -> None:
    """Damping is negative between two places, so that rest at 0 lasts for ever, unstable."""
    case = made(
        [(1, 0.6, 1, 0, 0), (1, -0.2, 1, 0, 0)],
        [(1, 0, 0, -1), mirrored(1, 0, 0, -1)],
        half=True,
        demands=[{"beyond": (1, 0, 0, -1)}, {"within": (-1, 0, 0, 1), "and": (1, 0, 0, 1)}],
    )()
    exact = ns.exact(case)
    found = [q.times.durations for q in rough_times_by_simulation(case) if q.times]
    assert found[0] == pytest.approx(exact.cell_durations, rel=1e-3)


def test_of_phases_with_one_equation_it_does_not_matter_which_is_followed() -> None:
    """Only the left of two stops is hit, once a period; the mass is in either phase between."""
    case = made(
        [(1, 0.15, 1, 0, 0.36)] * 2,
        [(1, 0, 0, 0.35), (1, 0, 0, -2.16)],
        omega=1.36,
        jumps=((-0.22, 0),) * 2,
        demands=({"between": (1, 0, 0, 0.35), "the stops": (-1, 0, 0, 2.16)},) * 2,
    )()
    (found,) = rough_times_by_simulation(case)
    assert found.words == f"{OTHER}: phase 0, in each period of the forcing"
    orbit = ns.exact(case)
    assert [phase.name for phase in orbit.phases] == ["phase 0"]
    assert orbit.stable


def test_a_phase_that_is_declared_twice_is_one() -> None:
    """A stop, and an order of two impacts; the mass hits it once in each period."""
    law, impact, there = (1, 0.1, 1, 0, 1.0), (1, 0, 0, -0.1), {"there": (-1, 0, 0, 0.1)}
    jumps = ((-0.6, 0),) * 2
    case = made([law] * 2, [impact] * 2, omega=1.8, jumps=jumps, demands=(there,) * 2, k=0)()
    orbit = ns.exact(case)
    assert orbit.case.scene.motion == "phase 0"
    assert orbit.durations == pytest.approx(ns.exact(ns.scene("impact")()).durations, rel=1e-13)


@pytest.mark.parametrize(
    ("name", "phases"),
    [("backlash", "engaged,loose,-engaged,-loose"), ("dry-friction", "slide,-slide")],
)
def test_what_settles_slowly_on_a_symmetric_orbit_is_symmetric(name, phases) -> None:
    """By the times of a simulation, whose halves still differ, it is one of a whole period."""
    case = ns.scene(name)()
    orbit = ns.exact(case)
    *_, whole = cases_in_order(case, phases)
    times = RoughTimes(tuple(2 * orbit.cell_durations.tolist()), orbit.angle, "")
    found = _by_half(from_times(whole, times))
    assert found.case.scene.motion == orbit.case.scene.motion != whole.scene.motion
    assert found.durations == pytest.approx(orbit.durations, rel=1e-12)


def test_what_repeats_itself_after_two_periods_may_be_of_one() -> None:
    """Times of a motion that comes to its orbit from both sides in turn are their means."""
    order, times = Order((Step(0), Step(1)) * 2), RoughTimes((1.0, 2.0, 1.5, 2.5), 0.3, "")
    twice = Other(order, times, 2)
    assert twice.within(2) is twice
    once = twice.within(1)
    assert once == Other(Order((Step(0), Step(1))), replace(times, durations=(1.25, 2.25)), 1)
    assert twice.within(3) is once.within(2) is None
    assert replace(twice, order=Order((Step(0), Step(1), Step(1), Step(0)))).within(1) is None


def test_of_two_orbits_of_the_declared_order_the_stable_one_is_found() -> None:
    """Rough times lead to the other one: between a stop and a buffer."""
    free, within = (1, 0.3698, 1, 0, 1), {"left": (-1, 0, 0, 0.768), "right": (1, 0, 0, 0.616)}
    case = made(
        [free, free, (1, 0.3698, 7.976, -6.976 * 0.616, 1)],
        [(1, 0, 0, -0.768), (1, 0, 0, 0.616), (1, 0, 0, 0.616)],
        omega=1.653,
        jumps=((-0.793, 0), (1, 0), (1, 0)),
        demands=(within, within, {"in the buffer": (-1, 0, 0, -0.616)}),
    )()
    stable = ns.exact(case)
    other = exact_orbit(case, (1.556, 1.589, 0.656), 0.0718)
    assert (stable.stable, other.stable) == (True, False)
    assert stable.durations[0] < other.durations[0] - 0.4
    assert ns.solve(case, "ck-tau", 12).stable


def some_motions(count: int, seed: int):
    """Yield cases of every scene with random parameters, and what was said of them."""
    rng = np.random.default_rng(seed)
    for _ in range(count):
        for scene in map(registry.load, one_mass.NAMES):
            values = {q.name: q.default * rng.uniform(0.5, 1.7) for q in scene.parameters}
            for name, factors in (("gap", [1, 3]), ("damping", [2, 4, 8])):
                if name in values:
                    values[name] *= rng.choice(factors)
            try:
                case = scene(**values).each_motion[-1]
            except ValueError:  # of parameters that do not go together
                continue
            machine = Machine(case.cell)
            start = machine.at_rest(0.0)
            if start is not None and machine.begin(start) is not None:
                yield case, machine, start, settle._followed(case, start, 400)[0].words


def holds(said: str, case, machine, start) -> bool:
    """Whether a statement holds in a simulation ten times as long."""
    cycles = settle._lasting(case.cell)
    motion = follow(case, machine, start, 10 * cycles * cycle(case.cell))
    if said.endswith("without switches"):
        return motion.segments[-1].t <= cycles * cycle(case.cell)
    order = said.rpartition(": ")[2].removeprefix("a simulation settles on ")
    names = order.partition(", in ")[0].split(", ")
    late = [f"{'-' * (q.step or q).mirrored}{q.phase.name}" for q in motion.segments[:-1]]
    if "another" not in said:  # of a cell; its mirror image follows
        late, names = [name.lstrip("-") for name in late], names * case.cell.cells
    turned = [names[i:] + names[:i] for i in range(len(names))]
    return late[-len(names) :] in turned and late[-2 * len(names) : -len(names)] in turned


@pytest.mark.parametrize("count", [1, pytest.param(12, marks=pytest.mark.long)])
def test_what_is_said_holds_in_a_simulation_ten_times_as_long(monkeypatch, count: int) -> None:
    monkeypatch.setattr(settle, "CYCLES", 12)
    said = []
    for *case, words in some_motions(count, seed=count):
        if words.startswith(("a simulation settles", "a simulation comes")):
            assert holds(words, *case), (case[0], words)
            said.append(words)
    assert len(said) >= 4 * count


@pytest.mark.parametrize("count", [100, pytest.param(5000, marks=pytest.mark.long)])
def test_a_phase_that_is_said_to_last_has_no_event(count: int) -> None:
    rng, shown = np.random.default_rng(count), 0
    for _ in range(count):
        c, k = rng.choice([0.0, 0.05, 0.5, 4.0]), rng.choice([0.0, 1.0, 9.0])
        x, v, angle, limit = *rng.uniform(-1, 1, 2), rng.uniform(0, 6), rng.uniform(0.5, 6)
        forms = [(1, 0, 0, limit), (-1, 0, 0, limit), (0, -1, 0, 2 * limit)]
        case = made([(1, c, k, 0, 1)], [(1, 0, 0, -limit)], omega=1.7)()
        phase = replace(case.cell.phases[0], demands=tuple(("", form) for form in forms))
        if lasts(phase, x, v, 1.7, angle):
            shown += 1
            t = np.linspace(0, 300, 3000)
            far, fast = (flow.motion(phase, np.array([x, v]), angle, 1.7, t, j) for j in (0, 1))
            assert np.abs(far).max() < limit
            assert fast.max() < 2 * limit
    assert shown > count / 10


@pytest.mark.parametrize(
    ("values", "why"),
    [
        (
            {"yield_force": 1e-3, "force": 1e12},
            "forcing; elastic, which sets a memory, is not among them",
        ),
        (
            {"frequency": 0.175, "damping": 0.02, "yield_force": 0.2},
            "forcing; -elastic ends by a demand there, not by its event",
        ),
    ],
)
def test_phases_that_cannot_be_asked_for_are_said_to_be_no_order(values, why) -> None:
    with pytest.raises(NoOrbit) as caught:
        ns.exact(ns.scene("elastic-plastic")(**values))
    said = "a simulation settles on phases that cannot be solved for: "
    assert any(each.startswith(said) and why in each for each in caught.value.tried)


def test_whether_a_phase_lasts_is_decided_at_the_edge() -> None:
    """Without damping, a mass at rest swings to twice the mean; no farther, and no less."""
    phase = made([(1, 0, 1, 1, 0)], [(1, 0, 0, -9)], omega=1)().cell.phases[0]
    for stop, expected in ((2 - 1e-9, False), (2 + 1e-9, True)):
        demands = (("below", (-1.0, 0.0, 0.0, stop)),)
        assert lasts(replace(phase, demands=demands), 0.0, 0.0, 1.0, 0.0) is expected
