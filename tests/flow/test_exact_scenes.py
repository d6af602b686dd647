"""Exact orbits against references of 30 digits, from another program's 60-digit Newton."""

import math
from functools import partial

import numpy as np
import pytest
from galerkin.solving import differences, jacobian, residual
from made_scenes import BACKLASH, CLEARANCE, TWO_SIDED, dry, made, mirrored

from nonsmooth.solver import exact
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.existence.known import Known
from nonsmooth.solver.flow import exact_system
from nonsmooth.solver.flow.exact_system import FAMILY, arrays, exact_kernel
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.no_orbit import NoOrbit

IMPACT = registry.load("impact")
DAMPED = registry.load("stick-slip-damped")
UNIT = {"mass": 1, "stiffness": 1, "belt_speed": 1, "normal_force": 1, "damping": 0.1}

#: Case; durations; phase of the forcing; states after the switches; ends of the motion.
SHIPPED = {
    "S1": (
        IMPACT(),
        [3.4906585039886591538],
        0.92964398603332421613,
        [(0.1, -1.4604048587365092380)],
        (-1.8404123508211993573, 0.1),
    ),
    "S5a": (
        DAMPED(**UNIT, mu_s=3, mu_k=1),
        [3.4164995840579205221, 4.2181014145160016296],
        None,
        [(-0.51649958405792052214, 1), (2.9, 1)],
        (-0.82820534768883191768, 3.1395834327438864669),
    ),
    "S5b": (
        DAMPED(**UNIT, mu_s=2, mu_k=1, weakening=0.2),
        [2.5642278415460451792, 4.4906752505591081333],
        None,
        [(-0.66422784154604517918, 1), (1.9, 1)],
        (-0.96175773508825492279, 2.3053654198892166231),
    ),
    "S5c": (
        DAMPED(**UNIT, mu_s=2.1, mu_k=2.1, weakening=0.5),
        [2.7249892355604707133, 4.9818380134796678897],
        None,
        [(-0.72498923556047071332, 1), (2.0, 1)],
        (-0.91132464050027462105, 2.9225152872932123386),
    ),
}


@pytest.mark.parametrize("name", SHIPPED)
def test_shipped_scenes_from_nothing(name) -> None:
    case, durations, angle, states, ends = SHIPPED[name]
    orbit = exact_orbit(case)
    assert orbit.durations == pytest.approx(durations, rel=1e-14)
    if angle is None:
        assert orbit.forcing_phase is None
    else:
        assert orbit.forcing_phase == pytest.approx(angle, rel=1e-14)
    for phase, (x, v) in zip(orbit.phases, states, strict=True):
        assert (phase.displacement, phase.velocity) == pytest.approx((x, v), rel=1e-14)
    assert orbit.extremes["displacement"] == pytest.approx(ends, rel=1e-14)
    assert orbit.admissible
    assert orbit.outcome.residual_norm < 1e-14 * max(1, orbit.period)


BELT = {"events": [(1, 0, 0, -1), (0, 1, 0, -1)], "held": (1.0, None)}

#: Scene; durations; phase of the forcing; first state; largest displacement.
MADE = {
    "S0": (
        made([(1, 0, 0, 0, 0), (1, 0, 1, 0, 0)], **BELT),
        [2, 4.7123889803846898577],
        0.0,
        (-1, 1),
        math.sqrt(2),
    ),
    "S2a": (
        BACKLASH,
        [3.6767483692903340681, 0.81124113583794198688],
        5.3516485882592236080,
        (1, 2.5051350800029609541),
        4.0309830686152585991,
    ),
    "S2b": (
        CLEARANCE,
        [1.3872449769106929390, 3.4459744901505274278],
        0.34693868484241333551,
        (0.5, 4.6696726434671664585),
        2.4992007296566841168,
    ),
    "S3a": (
        made([(1, 0.1, 1, 0.3, 1)], [mirrored(0, 1, 0, 0)], omega=0.8, half=True),
        [3.9269908169872415481],
        0.53969465639565687485,
        (2.3468719674220127595, 0),
        2.3468719674220127595,
    ),
    "S3b": (
        dry(0.4, 0.5, 0.6),
        [4.8747317078705435282, 2.9792499261039395680],
        1.1438446782849272448,
        (1.0140980227497468323, 0),
        1.0140980227497468323,
    ),
    "S6": (
        TWO_SIDED,
        [2.6179938779914943654],
        0.15319035673477921454,
        (0.8, -0.60201193025252685784),
        0.8,
    ),
}


@pytest.mark.parametrize("name", MADE)
def test_made_scenes_from_rough_times(name) -> None:
    scene, durations, angle, state, highest = MADE[name]
    rough = [s * (1.05 if p % 2 else 0.95) for p, s in enumerate(durations)]
    orbit = exact_orbit(scene(), rough, angle + 0.1)
    cells = 2 if scene.module.HALF_PERIOD else 1
    assert orbit.durations == pytest.approx(durations * cells, rel=2e-14)
    if scene.frequency:
        assert orbit.forcing_phase == pytest.approx(angle, rel=2e-14)
    found = orbit.phases[0].displacement, orbit.phases[0].velocity
    assert found == pytest.approx(state, rel=2e-14, abs=2e-14)
    low, high = orbit.extremes["displacement"]
    assert high == pytest.approx(highest, rel=2e-14)
    if cells == 2:
        assert low == -high


def test_the_second_half_is_the_mirror_image() -> None:
    scene, durations, angle, *_ = MADE["S2a"]
    orbit = exact_orbit(scene(), durations, angle)
    t = np.linspace(0, orbit.period, 29)
    half = orbit.period / 2
    for motion in (orbit.displacement, orbit.velocity, orbit.acceleration):
        np.testing.assert_allclose(motion(t[1:14] + half), -motion(t[1:14]), atol=1e-13)
    first, second = orbit.phases[:2], orbit.phases[2:]
    for one, other in zip(first, second, strict=True):
        assert (one.displacement, one.velocity) == (-other.displacement, -other.velocity)
        assert (one.name, one.duration) == (other.name, other.duration)


@pytest.mark.parametrize("name", MADE)
def test_the_jacobian_against_differences(name) -> None:
    scene, durations, angle, *_ = MADE[name]
    cell = scene().cell
    kernel, count = exact_kernel(cell), len(durations)
    generator = np.random.default_rng(1)
    times = [*durations, angle] if kernel.forced else durations
    z = np.concatenate([generator.normal(size=2 * count), times])
    expected = differences(partial(residual, kernel, cell), z, 1e-6)
    np.testing.assert_allclose(jacobian(kernel, cell, z).T, expected, atol=1e-8)


def test_compiled_equations_have_the_same_bits() -> None:
    compiled = FAMILY.compiled(exact_system.__name__)
    for scene, durations, angle, *_ in MADE.values():
        cell, count = scene().cell, len(durations)
        times = [*durations, angle] if cell.forced else durations
        z = np.concatenate([np.linspace(-1, 2, 2 * count), times])
        found = []
        for of in (FAMILY.plain(exact_system.__name__), compiled):
            R, J = np.empty(len(z)), np.empty((len(z), len(z)))
            of["residual"](arrays(cell), z, R)
            of["jacobian"](arrays(cell), z, J)
            found.append(np.column_stack([R, J]))
        assert found[0].tobytes() == found[1].tobytes()


def test_where_none_is_shown_to_be_there_the_reasons_of_each_start_are_said(
    monkeypatch,
) -> None:
    monkeypatch.setattr(exact, "known", lambda case: Known())  # it would be shown sooner
    monkeypatch.setattr(exact, "shown_to_be_none", lambda *found: None)
    with pytest.raises(NoOrbit) as caught:
        exact_orbit(registry.load("clearance")(gap=50))
    assert not caught.value.proven
    assert len(caught.value.tried) == 73
    assert caught.value.tried[0].startswith("from the scene's guess of the durations, ")
    assert caught.value.tried[-1] == "a simulation comes to a motion without switches"


@pytest.mark.parametrize("durations", [(1.0, 2.0), (-1.0,), (math.nan,), (math.inf,)])
def test_bad_times_are_refused(durations) -> None:
    with pytest.raises(ValueError, match="1 positive number"):
        exact_orbit(IMPACT(), durations)


def test_orbits_scale_with_their_units() -> None:
    small = IMPACT(
        mass=1e-6, damping=1e-7 * 1e3, stiffness=1, force=1e-6, frequency=1800, gap=1e-7
    )
    orbit, plain = exact_orbit(small), exact_orbit(IMPACT())
    assert orbit.forcing_phase == pytest.approx(plain.forcing_phase, rel=1e-13)
    assert orbit.period == pytest.approx(plain.period * 1e-3, rel=1e-13)
    assert orbit.phases[0].velocity == pytest.approx(plain.phases[0].velocity * 1e-3, rel=1e-13)
