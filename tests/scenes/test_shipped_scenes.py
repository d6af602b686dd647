"""Every shipped scene against references of 30 digits and against closed formulas."""

import math

import numpy as np
import pytest
from galerkin.derived import REFERENCES
from galerkin.oscillators import CYCLES, SCENES, parameters_of

from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.scenes.classes import classes
from nonsmooth.solver.solve import solve_case
from nonsmooth.solver.sweep import sweep

FRICTION = registry.load("dry-friction")

#: Scenes of the references that come with the program, as cases.
SHIPPED = [name for name, (scene, _) in SCENES.items() if scene.name in registry.names()]


def case_of(name):
    """Return a case of the references, which are in units of 1."""
    made = SCENES[name][0]
    values = dict(zip((q.name for q in made.parameters), parameters_of(name), strict=True))
    case = registry.load(made.name)(**values, cycles=CYCLES.get(name, 1))
    return case.of_motion(made.motion) if made.motion else case


def times_of(orbit):
    """Return durations of a cell and the phase of the forcing, as the references have them."""
    count = len(orbit.case.cell.phases)
    turn = [] if orbit.forcing_phase is None else [orbit.forcing_phase]
    return [*orbit.durations[:count], *turn]


@pytest.mark.parametrize("name", SHIPPED)
def test_the_exact_orbit_is_that_of_the_references(name):
    case = case_of(name)
    orbit = exact_orbit(case)
    reference = REFERENCES["S0n" if name == "S0" else name]  # the same orbit
    expected = np.array(reference["exact"], float)
    assert times_of(orbit) == pytest.approx(expected, abs=2e-14 * orbit.period)
    assert classes(case.cell) == tuple(reference["classes"])
    if name.startswith("S4"):
        assert orbit.memory["w"] == pytest.approx(orbit.phases[0].displacement, rel=1e-14)


@pytest.mark.parametrize("name", registry.names())
def test_every_scene_is_found_from_nothing_by_every_method(name):
    case = registry.load(name)()
    exact = exact_orbit(case).extremes["displacement"]
    size = max(map(abs, exact))
    for method in registry.methods(case.scene):
        orbit = solve_case(case, method, 6)
        assert orbit.admissible
        assert orbit.extremes["displacement"] == pytest.approx(exact, abs=0.2 * size)
        assert method != "ck-tau" or orbit.errors.times < 2e-5


def test_what_a_motion_is_named_by():
    low = FRICTION(frequency=0.4)
    orbit = solve_case(low, order=6)
    assert orbit.case.scene.motion == "two-stops"
    assert solve_case(FRICTION()).case.scene.motion == "sliding"
    assert exact_orbit(low).case.scene.label == "dry-friction, two-stops"
    row = sweep(low.of_motion("two-stops"), "ck-tau", [6]).rows[0]
    assert row.forcing_phase == pytest.approx(orbit.forcing_phase)
    with pytest.raises(NoOrbit, match="where slide ends, not true that the load exceeds"):
        solve_case(low.of_motion("sliding"))
    with pytest.raises(ValueError, match=r"motion: got 'slidin', .* did you mean sliding"):
        solve_case(low.of_motion("slidin"))
    with pytest.raises(ValueError, match="motion: got 'sliding', but impact has only one"):
        solve_case(registry.load("impact")().of_motion("sliding"))
    with pytest.raises(
        ValueError, match="motion: got none, expected one of sliding, two-stops"
    ):
        _ = low.cell


def test_equal_friction_by_the_kernel_of_the_general_class():
    """S3c: from rest to sliding x'' is continuous there, and nothing in the kernel says so."""
    case = FRICTION(mu_s=0.5, mu_k=0.5, frequency=0.4)
    expected = np.array(REFERENCES["S3c"]["exact"], float)
    orbit = solve_case(case, order=16)
    assert times_of(orbit) == pytest.approx(expected, abs=1e-12)
    assert orbit.as_dict()["classes"] == ["C2", "C1"]
    assert classes(FRICTION(mu_s=0.6, mu_k=0.5).of_motion("two-stops").cell) == (1, 1)


@pytest.mark.parametrize("damping", [0.0, 0.08])
def test_amplitude_of_sliding_is_that_of_den_hartog(damping):
    """``x_0 = -G mu + sqrt(V^2 - H^2 mu^2)`` in units of m, k, F, derived by the half period.

    From x_0, at rest, the mass slides down for pi/Omega to -x_0, at rest.  With the steady
    response ``U cos + W sin`` of the linear oscillator, V its amplitude, x_0 is a solution of
    two linear equations in ``cos(phi), sin(phi)``: those of the free part q about mu + steady,

        q(0) = x_0 - mu - s(0),  q'(0) = -s'(0),  q(h) = -x_0 - mu + s(0),  q'(h) = s'(0),

    which gives ``s(0) = x_0 + G mu`` and ``s'(0) = H mu Omega`` by the flow of q over h; their
    squares add up to ``V^2``.
    """
    for frequency in (0.7, 0.8, 1.4):
        mu = 0.2
        zeta, w = damping / 2, math.sqrt(1 - damping**2 / 4)
        h = math.pi / frequency
        e, c, s = math.exp(-zeta * h), math.cos(w * h), math.sin(w * h) / w
        flow = e * np.array([[c + zeta * s, s], [-s, c - zeta * s]])
        # flow (x_0 - mu - s0, -s1) = (-x_0 - mu + s0, s1): s0 = x_0 + G mu, s1 = H mu Omega
        matrix = np.eye(2) + flow
        gap, rate = np.linalg.solve(matrix, (np.eye(2) - flow) @ [1.0, 0.0])
        g, big_h = gap, rate / frequency
        v = 1 / math.hypot(1 - frequency**2, damping * frequency)
        expected = -g * mu + math.sqrt(v**2 - (big_h * mu) ** 2)
        case = FRICTION(damping=damping, frequency=frequency, mu_s=mu, mu_k=mu)
        found = solve_case(case.of_motion("sliding"), order=14).phases[0].displacement
        assert found == pytest.approx(expected, rel=1e-11), frequency


def test_the_first_stop_without_damping_is_where_den_hartog_has_it():
    """``mu = |V|/sqrt(U^2 + Omega^-4)``, in units of m, k, F, with U for the H above.

    Without damping ``G = 0``: the steady part is x_0 at the reversal, with the acceleration
    ``-Omega^2 x_0``, and the free part about -mu is mu there, with the acceleration -mu after
    it.  The mass slides on if their sum has the new direction, ``mu < Omega^2 x_0``, where
    ``x_0 = sqrt(V^2 - U^2 mu^2)``.
    """
    frequency = 0.7
    u = math.sin(math.pi / frequency) / (frequency * (1 + math.cos(math.pi / frequency)))
    v = 1 / (1 - frequency**2)
    limit = abs(v) / math.sqrt(u**2 + frequency**-4)
    for mu, motion in ((limit * (1 - 1e-4), "sliding"), (limit * (1 + 1e-4), "two-stops")):
        case = FRICTION(damping=0, frequency=frequency, mu_s=mu, mu_k=mu)
        assert solve_case(case, order=12).case.scene.motion == motion


def test_without_hardening_the_orbit_is_the_limit_of_that_with_less_and_less():
    scene = registry.load("elastic-plastic")
    limit = solve_case(scene(hardening=0), order=12)
    for hardening in (1e-4, 1e-6):
        near = solve_case(scene(hardening=hardening), order=12)
        assert near.memory["w"] == pytest.approx(limit.memory["w"], rel=30 * hardening)


def test_a_subharmonic_has_the_harmonics_of_its_own_period():
    case = registry.load("impact")(frequency=3.6, cycles=2)
    found = {method: solve_case(case, method, 24) for method in ("hb", "hb-ck", "ck")}
    exact = float(REFERENCES["S1n2"]["exact"][1])
    assert found["hb"].forcing_phase == pytest.approx(exact, abs=0.1)
    assert found["hb-ck"].forcing_phase == pytest.approx(exact, abs=3e-5)
    assert found["ck"].forcing_phase == pytest.approx(exact, abs=1e-10)
    assert found["ck"].period == pytest.approx(4 * math.pi / 3.6)
    assert found["ck"].case != registry.load("impact")(frequency=3.6)
    assert found["ck"].as_dict()["cycles"] == 2
