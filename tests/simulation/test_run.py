"""A motion at whole turns of the forcing: as simulated, and the same bits if compiled."""

import math
from fractions import Fraction

import mpmath
import numpy as np
import one_mass
import pytest
from test_chatter import resting

import nonsmooth as ns
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.scenes.ordered import of_all_phases
from nonsmooth.solver.simulation.machine import AT_ONCE, with_arrays
from nonsmooth.solver.simulation.machines import machine_of
from nonsmooth.solver.simulation.simulate import cycle
from nonsmooth.solver.simulation.steps import run
from nonsmooth.solver.simulation.steps.clock import angle_of, at_start, later, time_to
from nonsmooth.solver.simulation.steps.column import NONE
from nonsmooth.solver.simulation.steps.locate import CUT, EVENT
from nonsmooth.solver.simulation.steps.state import State
from nonsmooth.solver.simulation.steps.step import CHATTERS, REFUSED
from nonsmooth.solver.simulation.walk import Place, follow

#: Scenes, and one whose impacts accumulate before it rests; bodies.
SCENES = (*one_mass.NAMES, "impacts and a rest")
BODIES = tuple(name for name in registry.names() if registry.load(name).has_body)

#: Of a beam a few modes: each is one more of the same.
FEW = {"modes": 3}


def drawn(name, count):
    """Return the machine of a scene, and random states that a phase of it takes."""
    scene = registry.load(name) if name in registry.names() else None
    case = of_all_phases(scene(**FEW if "beam" in name else {})) if scene else resting(0.5)
    machine, random = machine_of(case.cell), np.random.default_rng(1)
    found, turn = [machine.at_rest(0.0)], float(case.cell.forced)
    while len(found) < count:
        x, v = random.normal(0, 1, 2).tolist()
        found.append(machine.released(x, v, turn * float(random.uniform(0, 6))))
        if machine.begin(found[-1]) is None:
            found.pop()
    return case, machine, found


def bits(passed):
    """Return all that a step returns, bit by bit."""
    flat = [value.tobytes() if isinstance(value, np.ndarray) else value for value in passed]
    return [bits(value) if isinstance(value, tuple) else value for value in flat]


@pytest.mark.parametrize("name", [*SCENES, *BODIES])
def test_plain_and_compiled_motions_have_the_same_bits(name) -> None:
    _, machine, states = drawn(name, 6)
    forms = machine.family.plain(run.__name__), machine.family.compiled(run.__name__)
    for start in states:
        place = Place.first(machine, start)
        begin = place.phase, with_arrays(place.state), place.clock
        arguments = *begin, (60.0, 0.0), 50.0, AT_ONCE
        one, other = (of["several"](machine.rules, *arguments) for of in forms)
        assert bits(tuple(one)) == bits(tuple(other))
        one, other = (of["run"](machine.rules, with_arrays(start), 3) for of in forms)
        assert bits(one) == bits(other)


@pytest.mark.parametrize("most", [math.inf, 9.5])
@pytest.mark.parametrize("name", [*SCENES, *BODIES])
def test_phases_followed_together_are_those_followed_one_by_one(name, most) -> None:
    _, machine, states = drawn(name, 4)
    end = Fraction(40) + Fraction(1, 10**16)
    for start in states:
        place, t, effort = Place.first(machine, start), Fraction(0), most
        p, state, clock = place.phase, with_arrays(place.state), place.clock
        time = float(end), float(end - Fraction(float(end)))
        together = machine.by("several", p, state, clock, time, most, AT_ONCE)
        for passed in together:
            left = float(end - t)
            window = machine.by("window_of", p, state)
            longest = min(left, run.reach(window, effort))
            assert bits(machine.by("step", p, state, clock, longest)) == bits(passed)
            effort, t = effort - run.effort(window, passed.s), t + Fraction(passed.s)
            p, state, clock = passed.phase, passed.state, passed.clock
        *others, last = together
        assert all(one.how == EVENT and one.away == NONE for one in others)
        goes_on = last.how == EVENT and last.away == NONE and effort >= 1
        assert goes_on == (len(together) == AT_ONCE)


@pytest.mark.parametrize("name", SCENES)
def test_the_states_at_whole_turns_are_those_of_the_simulation(name) -> None:
    case, machine, states = drawn(name, 3)
    period, units = cycle(machine.cell), case.units
    for start in states:
        found, phases, how = machine.strobed(start, 12)
        motion = follow(case, machine, start, 12 * period)
        assert (how == CUT) == (motion.ended == "")
        assert len(found) == len(phases) == 13 if how == CUT else len(found) < 13
        times = np.minimum(np.arange(len(found)) * period * units.time, motion.time)
        expected = motion.displacement(times) / units.length, motion.velocity(times)
        np.testing.assert_allclose(found[:, 0], expected[0], rtol=0, atol=1e-10)
        np.testing.assert_allclose(
            found[:, 1] * units.of_motion(1), expected[1], rtol=0, atol=1e-10
        )
        for time, p, state in zip(times / units.time, phases, found, strict=True):
            inside = [q for q in motion.segments if q.t <= Fraction(time) + Fraction(1, 10**9)]
            last = inside[-1]
            assert machine.nodes[p].step == (last.index, last.mirrored)
            remembering = machine.nodes[p].phase.remembering(state[2:].tolist())
            assert remembering.f == pytest.approx(last.phase.f, rel=1e-10)


def test_it_says_why_it_ends() -> None:
    case = registry.load("impact")(restitution=0.3, frequency=0.3, damping=0.3)
    machine = machine_of(case.cell)
    states, _, how = machine.strobed(State(0.0, 0.0, 0.0), 10)
    assert how == CHATTERS
    assert len(states) == 1 + math.floor(ns.simulate(case, (0, 0), 10).time * 0.3 / 2 / math.pi)
    inside = State(99.0, 0.0, 0.0)  # of the stop
    assert [len(part) for part in machine.strobed(inside, 10)[:2]] == [0, 0]
    assert machine.strobed(inside, 10)[2] == REFUSED


@pytest.mark.parametrize("omega", [1.3, 1e-3, 1e200, 3e-200])
def test_the_clock_loses_no_digit_behind_many_phases(omega) -> None:
    random = np.random.default_rng(3)
    clock, t = at_start(-2.3, omega), Fraction(0)
    for s in (random.exponential(1, 3000) * 10 ** random.uniform(-8, 2, 3000) / omega).tolist():
        clock, t = later(clock, s), t + Fraction(s)
        assert 0 <= angle_of(clock) <= 2 * math.pi
    with mpmath.workdps(60):
        turned = Fraction(omega) * t
        exact = mpmath.mpf(turned.numerator) / turned.denominator
        here = clock.turns * 2 * mpmath.pi + mpmath.mpf(clock.high) + mpmath.mpf(clock.low)
        assert abs(here - exact) < 1e-27
        assert angle_of(clock) == float((exact - mpmath.mpf(2.3)) % (2 * mpmath.pi))
        ahead = 2 * mpmath.pi * (clock.turns + 7) - exact
        assert time_to(clock, clock.turns + 7) == pytest.approx(float(ahead) / omega, rel=1e-15)
    assert time_to(clock, clock.turns) == 0.0  # that is past
    assert angle_of(later(at_start(0.4, 0.0), 3.0)) == 0.4  # where nothing forces
