"""Simulated motion against an integrator, and against its own mirror image."""

import itertools
import math

import numpy as np
import pytest
from every_run import tried
from integrated import STARTS, integrated, random_case

import nonsmooth as ns

#: Those that are integrated; of the other one the memory at the start is not chosen.
SCENES = tuple(STARTS)[:-1]


def begun(scene, seed):
    """Return a random case, a state and an angle from which its motion starts."""
    rng = np.random.default_rng([seed, tuple(STARTS).index(scene)])
    case = random_case(scene, rng)
    x, v = np.array(STARTS[scene]) + rng.uniform(-0.1, 0.1, 2)
    if scene == "backlash":
        x -= case.values["gap"] / case.units.length
    angle = float(rng.uniform(0, 6)) if "frequency" in case.values else 0.0
    return case, (x * case.units.length, v * case.units.of_motion(1)), angle


def name_of(phase):
    """Return the name that the mode of an integrated motion has."""
    alike = ("loose", "crossing", "stop")  # their mirror images are of the same equations
    return f"-{phase.name}" if phase.mirrored and phase.name not in alike else phase.name


def check_begins(phase, t, x, v, units) -> None:
    """Check when a phase begins, and its state there.

    Of an integrator, whose relative tolerance is 1e-12, a few hundred steps on; and it is what
    rounding of the angle of the forcing amounts to, a few events on.
    """
    assert phase.start == pytest.approx(t, rel=0, abs=1e-11 * units.time)
    assert phase.displacement == pytest.approx(x, rel=0, abs=1e-11 * units.length)
    assert phase.velocity == pytest.approx(v, rel=0, abs=1e-11 * units.of_motion(1))


@pytest.mark.parametrize(
    ("scene", "seed"),
    tried(
        [(scene, seed) for scene in SCENES for seed in range(25)],
        every_run=[(scene, 3) for scene in SCENES],
    ),
)
def test_events_are_those_of_an_integrator(scene, seed) -> None:
    """With parameters at random, among them gaps down to 1e-12 of the default."""
    case, state, angle = begun(scene, seed)
    motion = ns.simulate(case, state, 3, forcing_phase=angle)
    units, phases = case.units, motion.phases
    if motion.ended.startswith("chatter"):  # the integrator is no judge of the last impacts
        phases = tuple(itertools.takewhile(lambda q: q.duration > 1e-2 * units.time, phases))
        assert len(phases) < len(motion.phases)
    else:
        assert motion.ended == ""
    expected = integrated(case, name_of(phases[0]), state, angle, motion.time, len(phases) + 1)
    if not motion.ended:
        assert len(expected) == len(phases)
    assert [name_of(q) for q in phases] == [name for name, *_ in expected][: len(phases)]
    for found, (_, t, x, v) in zip(phases, expected, strict=False):
        check_begins(found, t, x, v, units)


@pytest.mark.parametrize(
    ("scene", "seed"),
    tried(
        [
            (scene, seed)
            for scene in ("impact-two-sided", "backlash", "dry-friction", "elastic-plastic")
            for seed in range(10)
        ],
        every_run=[("impact-two-sided", 0), ("backlash", 3), ("dry-friction", 1)],
    ),
)
def test_the_mirror_image_of_a_start_has_the_mirror_image_of_the_motion(scene, seed) -> None:
    case, (x, v), angle = begun(scene, seed)
    one = ns.simulate(case, (x, v), 3, forcing_phase=angle)
    other = ns.simulate(case, (-x, -v), 3, forcing_phase=angle + math.pi)
    assert one.ended == other.ended == ""
    assert [q.name for q in one.phases] == [q.name for q in other.phases]
    for a, b in zip(one.phases, other.phases, strict=True):
        check_begins(a, b.start, -b.displacement, -b.velocity, case.units)


@pytest.mark.parametrize("gap", [7e-7, 1e-9, 1e-12, 1e-16, 1e-100])
def test_two_surfaces_are_two_however_near(gap) -> None:
    """Each way through a play is a phase, and each stop is hit where it is."""
    case = ns.scene("backlash")
    wide, narrow = ns.simulate(case(gap=1e-5), cycles=4), ns.simulate(case(gap=gap), cycles=4)
    assert [name_of(q) for q in narrow.phases] == [name_of(q) for q in wide.phases]
    for phase in narrow.phases[1:]:
        assert abs(phase.displacement) == pytest.approx(gap, rel=1e-14)
    # pulled from the middle to a stop by a force that is constant for so short a time
    between = ns.simulate(ns.scene("impact-two-sided")(gap=gap), cycles=1)
    first, speed = between.phases[1], math.sqrt(2 * gap)
    near = speed + 1e-8  # damping and stiffness count for so much in so short a time
    assert first.start == pytest.approx(speed, rel=near)
    assert first.displacement == pytest.approx(gap, rel=1e-14)
    assert first.velocity == pytest.approx(-0.6 * speed, rel=near)
    when = float(between.ended.partition("at t = ")[2].split()[0])
    assert when == pytest.approx(speed * (1 + 2 * 0.6 / (1 - 0.6)), rel=near)


def test_where_two_stops_coincide_no_phase_is_between_them() -> None:
    motion = ns.simulate(ns.scene("clearance")(gap=0), (-1, 0), cycles=4)
    assert [q.name for q in motion.phases[:4]] == ["separated", "contact"] * 2
