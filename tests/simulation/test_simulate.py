"""Simulated motion: exact orbits are reached, demands hold, what ends is said in words."""

import json
import math
import re
from fractions import Fraction
from itertools import pairwise

import mpmath
import numpy as np
import pytest
from every_run import tried
from hypothesis import given, settings
from hypothesis import strategies as st
from made_scenes import dry, made
from reached import BELT, DAMPED, EVERY_RUN, IMPACT, REACHED

import nonsmooth as ns
from nonsmooth.solver.exact import exact_orbit


@pytest.mark.parametrize("name", tried(REACHED, every_run=EVERY_RUN))
def test_a_stable_orbit_is_reached_from_another_state(name) -> None:
    case, durations, angle, state, cycles = REACHED[name]
    orbit = exact_orbit(case, durations, angle)
    assert orbit.stable is True
    begin = 0.7 if case.cell.forced else 0.0
    motion = ns.simulate(case, state, cycles, forcing_phase=begin)
    assert motion.ended == ""
    count = len(durations)
    starts = [
        index
        for index, q in enumerate(motion.segments[: -count - 1])
        if (q.index, q.mirrored) == (0, False)
    ]
    phases = motion.phases[starts[-1] : starts[-1] + count]
    for found, expected in zip(phases, orbit.phases, strict=False):
        assert found.name == expected.name
        assert found.duration == pytest.approx(expected.duration, rel=1e-11)
        assert found.displacement == pytest.approx(expected.displacement, abs=1e-11)
        assert found.velocity == pytest.approx(expected.velocity, abs=1e-11)
    if case.cell.forced:
        omega = case.cell.omega / case.units.time
        turn = begin + omega * phases[0].start - orbit.forcing_phase
        assert math.sin(turn) == pytest.approx(0, abs=1e-10)
        assert math.cos(turn) == pytest.approx(1)


@given(
    damping=st.floats(0, 0.4), frequency=st.floats(0.5, 4),
    gap=st.integers(-4, 15).map(lambda tenths: tenths / 10),
    restitution=st.floats(0.4, 1), angle=st.floats(0, 6.2),
)  # fmt: skip
@settings(max_examples=25)
def test_between_events_nothing_is_violated(
    damping, frequency, gap, restitution, angle
) -> None:
    case = IMPACT(damping=damping, frequency=frequency, gap=gap, restitution=restitution)
    motion = ns.simulate(case, cycles=8, forcing_phase=angle)
    assert motion.ended == "" or motion.ended.startswith("chatter: flight ends ever sooner")
    samples = motion.samples()
    assert max(x.max() for _, x, _, _ in samples) <= gap + 1e-12
    for before, after in zip(motion.phases, motion.phases[1:], strict=False):
        end = before.start + before.duration
        assert after.start == pytest.approx(end, rel=1e-14)
        assert after.displacement == pytest.approx(gap, abs=1e-12)
        assert after.velocity <= 0
    speeds = np.array([[v[0], v[-1]] for _, _, v, _ in samples])
    assert speeds[1:, 0] == pytest.approx(-restitution * speeds[:-1, 1], rel=1e-12, abs=1e-15)


def test_the_motion_is_the_exact_one() -> None:
    case = IMPACT()
    orbit = ns.exact(case)
    first = orbit.phases[0]
    motion = ns.simulate(
        case, (first.displacement, first.velocity), 3, forcing_phase=orbit.forcing_phase
    )
    t = np.linspace(0, motion.time, 101).reshape(1, 101)
    for name in ("displacement", "velocity", "acceleration"):
        found = getattr(motion, name)(t)
        assert found.shape == t.shape
        inside = np.abs(t % orbit.period - orbit.period / 2) < orbit.period / 2 - 1e-6
        np.testing.assert_allclose(found[inside], getattr(orbit, name)(t)[inside], atol=1e-11)


def test_from_rest_on_the_belt() -> None:
    belt = ns.StickSlip(
        mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=400
    )
    orbit = ns.exact(belt)
    motion = ns.simulate(belt, (0, 1), time=2 * orbit.period)
    assert [q.name for q in motion.phases] == ["stick", "slip", "stick", "slip"]
    durations = [q.duration for q in motion.phases]
    slip = orbit.period - orbit.t1
    assert durations[:4] == pytest.approx([0.2, slip, orbit.t1, slip], rel=1e-14)
    assert motion.phases[1].displacement == pytest.approx(0.2, rel=1e-14)
    assert motion.time == pytest.approx(2 * orbit.period)
    # outside of what it may pull, stick does not hold
    assert ns.simulate(belt, (0.3, 1), cycles=1).phases[0].name == "slip"


def test_it_begins_at_the_nearest_state_at_rest() -> None:
    assert ns.simulate(IMPACT(), cycles=1).phases[0].displacement == 0.0
    beyond = ns.simulate(IMPACT(gap=-0.5), cycles=1, forcing_phase=math.pi)
    first = beyond.phases[0]
    assert (first.displacement, first.velocity) == (pytest.approx(-0.5), 0.0)
    # a force that presses it against the stop leaves no rest there: next to it
    first = ns.simulate(IMPACT(gap=-0.5), cycles=0.1).phases[0]
    length = 1 / 1.8**2
    assert (first.displacement, first.velocity) == (pytest.approx(-0.5 - length / 10), 0.0)


def test_a_state_that_no_phase_takes_is_said() -> None:
    belt = DAMPED(**BELT, mu_s=2, mu_k=1)
    with pytest.raises(ValueError, match=r"got \(0.0, 1.5\).*slower than the belt"):
        ns.simulate(belt, (0.0, 1.5))
    # it returns to the belt where the spring already pulls it on: faster than the belt then
    motion = ns.simulate(belt, (-6.0, 0.5), cycles=3)
    assert motion.ended.startswith("no phase of the scene takes the state at t = ")
    assert "in slip not true that the mass stays slower than the belt" in motion.ended
    assert len(motion.phases) == 1


def test_units_do_not_matter() -> None:
    small = IMPACT(
        mass=1e-6, damping=1e-7 * 1e3, stiffness=1, force=1e-6, frequency=1800, gap=1e-7
    )
    one, other = ns.simulate(IMPACT(), cycles=5), ns.simulate(small, cycles=5)
    for a, b in zip(one.phases, other.phases, strict=True):
        assert b.duration == pytest.approx(a.duration * 1e-3, rel=1e-9)
        assert b.velocity == pytest.approx(a.velocity * 1e-3, rel=1e-9)


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"case": 3}, TypeError, "case: got 3, expected a case, such as ns.scene(...)()"),
        ({"state": 1.0}, ValueError, "state: got 1.0, expected displacement and velocity"),
        ({"state": (0, 0, 0)}, ValueError, "expected displacement and velocity"),
        ({"state": (math.nan, 0)}, ValueError, "state: got nan, expected a finite displ"),
        ({"state": (0, "a")}, ValueError, "state: got 'a', expected a finite velocity"),
        ({"state": (1.0, 0)}, ValueError, "mass stays before the stop"),
        ({"cycles": 0}, ValueError, "cycles: got 0, expected a positive number"),
        ({"cycles": True}, ValueError, "cycles: got True"),
        ({"time": -1.0}, ValueError, "time: got -1.0"),
        ({"time": 1.0, "cycles": 2}, ValueError, "time: got 1.0 beside cycles"),
        ({"forcing_phase": math.inf}, ValueError, "forcing_phase: got inf"),
        ({"state": (-1e308, 0)}, ValueError, "state: got (-1e+308, 0.0), expected numbers"),
        ({"cycles": 1e9}, ValueError, "cycles: got 1000000000.0, expected at most 100000 c"),
        ({"time": 1e308}, ValueError, "time: got 1e+308, expected at most 100000 cycles"),
    ],
)
def test_bad_arguments_are_named(arguments, error, message) -> None:
    with pytest.raises(error, match=re.escape(message)):
        ns.simulate(**({"case": IMPACT()} | arguments))


#: Scenes whose return map is differenced: smooth near the orbit.
RETURNED = ("impact", "clearance", "backlash", "friction with stops", "two-sided")


@pytest.mark.parametrize("name", RETURNED)
def test_multipliers_are_those_of_the_simulated_return_map(name) -> None:
    case, durations, angle, *_ = REACHED[name]
    orbit = exact_orbit(case, durations, angle)
    instant = 0.37 * orbit.durations[0]  # inside of the first phase
    start = np.array([float(orbit.displacement(instant)), float(orbit.velocity(instant))])
    turn = orbit.forcing_phase + case.cell.omega / case.units.time * instant
    step, columns = 1e-4, []
    for unit in np.eye(2):
        ends = []
        for times in (1, -1, 2, -2):
            state = start + times * step * unit
            motion = ns.simulate(case, state, 1, forcing_phase=turn)
            ends.append([motion.displacement(motion.time), motion.velocity(motion.time)])
        one, other, far, near = map(np.array, ends)
        columns.append((8 * (one - other) - (far - near)) / (12 * step))  # of fourth order
    matrix = np.array(columns).T
    found = orbit.multipliers
    assert np.trace(matrix) == pytest.approx(found.sum().real, abs=1e-8)
    assert np.linalg.det(matrix) == pytest.approx(found.prod().real, abs=1e-8)


def test_samples_have_both_sides_of_every_switch() -> None:
    motion = ns.simulate(IMPACT(), cycles=4)
    samples = motion.samples()
    assert [t[0] for t, *_ in samples] == [q.start for q in motion.phases]
    assert [v[0] for _, _, v, _ in samples] == [q.velocity for q in motion.phases]
    for found in samples:
        t = found[0][1:-1]
        for values, name in zip(
            found[1:], ("displacement", "velocity", "acceleration"), strict=True
        ):
            np.testing.assert_allclose(values[1:-1], getattr(motion, name)(t), atol=1e-13)
        assert np.diff(found[0]).max() < 2 * math.pi / 1.8 / 90  # smooth in a picture
    (line,) = motion.plot().lines
    assert line.get_xdata()[-1] == pytest.approx(motion.time)
    assert line.get_ydata().max() == pytest.approx(0.1)


def test_a_constraint_holds_while_it_can() -> None:
    # a load between sliding and static friction: it may slide as well, and rests
    case = dry(0.4, 0.3, 0.6)()
    resting = ns.simulate(case, (0.5, 0), 1, forcing_phase=math.pi / 2)
    assert (resting.segments[0].index, resting.phases[0].velocity) == (1, 0.0)
    beyond = ns.simulate(case, (0.7, 0), 1, forcing_phase=math.pi / 2)
    assert (beyond.segments[0].index, beyond.segments[0].mirrored) == (0, False)


@pytest.mark.parametrize("cycles", [200, pytest.param(20_000, marks=pytest.mark.long)])
def test_times_and_angles_do_not_drift(cycles) -> None:
    case = IMPACT()
    motion = ns.simulate(case, cycles=cycles, forcing_phase=0.3)
    omega, t = Fraction(case.cell.omega), Fraction(0)
    with mpmath.workdps(40):
        for q in motion.segments:
            assert q.t == t  # not rounded
            angle = (mpmath.mpf(0.3) + mpf(omega * t)) % (2 * mpmath.pi)
            assert q.angle == pytest.approx(float(angle), rel=2e-16, abs=0)
            t += Fraction(q.s)
    # on the orbit the impacts are a period apart, to the rounding of the time itself
    orbit, late = ns.exact(case), motion.phases[60:-1]
    for number, phase in enumerate(late):
        expected = late[0].start + number * orbit.period
        assert abs(phase.start - expected) <= 4 * np.spacing(phase.start)
        assert phase.forcing_phase == pytest.approx(orbit.forcing_phase, rel=0, abs=1e-13)
        assert phase.duration == pytest.approx(orbit.period, rel=1e-14)
        assert phase.velocity == pytest.approx(orbit.phases[0].velocity, rel=1e-13)


def mpf(number):
    return mpmath.mpf(number.numerator) / number.denominator


def test_times_that_are_rounded_at_an_end_are_of_the_motion() -> None:
    case = IMPACT()
    period = 2 * math.pi / 1.8
    motion = ns.simulate(case, cycles=60)
    times = np.linspace(58 * period, 60 * period, 60)
    times[-1] = motion.time * (1 + 4e-16)
    assert times[-1] > motion.time
    assert motion.displacement(times)[-1] == motion.displacement(motion.time)
    assert motion.velocity(-1e-15) == motion.velocity(0.0)
    for t in (-1e-12, motion.time * (1 + 1e-13), math.nan, 1j, "a", [[0.0], [0.0, 1.0]]):
        with pytest.raises(ValueError, match="expected times from 0 to"):
            motion.displacement(t)


def test_of_two_rests_alike_the_declared_one_follows() -> None:
    """Rest behind sliding down and rest behind sliding up: the same but for their place."""
    down, up = (1, 0.1, 1, 0.4, 1), (1, 0.1, 1, -0.4, 1)
    held = {"the load is held": (-1, 0, 1, 0.6), "both ways": (1, 0, -1, 0.6)}
    stopped, speed = (1, 0, 0, 0, 0), (0, 1, 0, 0)
    case = made(
        [down, stopped, up, stopped],
        [speed, (-1, 0, 1, -0.6), speed, (1, 0, -1, -0.6)],
        omega=0.4,
        held=(None, 0.0, None, 0.0),
        demands=[{"down": (0, -1, 0, 0)}, held, {"up": (0, 1, 0, 0)}, held],
    )()
    motion = ns.simulate(case, (0.2, -0.1), cycles=6)
    followed = set(pairwise(q.index for q in motion.segments))
    assert {(0, 1), (2, 3)} <= followed
    assert not {(0, 3), (2, 1)} & followed


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    ("parameters", "state"),
    [
        ({}, (-5e307, -9e307)),
        ({}, (-1e-300, 0.0)),
        ({"gap": 1e300}, (-1e307, 0.0)),
        ({"stiffness": 1e300}, None),
        ({"stiffness": 1e-300}, None),
        ({"force": 1e300}, None),
        ({"damping": 1e300}, None),
        ({"frequency": 1e-150}, None),
        ({"restitution": 1e-300}, None),
    ],
)
def test_at_the_ends_of_float64_it_is_followed_or_said_not_to_be(parameters, state) -> None:
    motion = ns.simulate(IMPACT(**parameters), state, cycles=2)
    assert motion.phases
    reasons = ("", "the motion in flight is beyond float64", "chatter: ", "no phase of the sc")
    assert motion.ended.startswith(reasons)
    assert all(
        math.isfinite(number)
        for q in motion.phases
        for number in (q.start, q.duration, q.displacement, q.velocity)
    )
    json.dumps(motion.as_dict(), allow_nan=False)


def test_a_spring_that_is_hardly_there_is_followed() -> None:
    weak, none = IMPACT(stiffness=1e-300), IMPACT(stiffness=1e-30)
    one, other = ns.simulate(weak, cycles=3), ns.simulate(none, cycles=3)
    assert one.ended == other.ended == ""
    assert [q.start for q in one.phases] == pytest.approx([q.start for q in other.phases])
