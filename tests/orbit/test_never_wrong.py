"""Solutions of the equations that are not orbits, made on purpose and refused with reasons."""

import contextlib
import math
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from galerkin.solving import differences, jacobian, residual
from made_scenes import Given, made, parameters, scene_of
from numpy.polynomial import Polynomial

from nonsmooth.scene import Body, Event, Memory, Phase
from nonsmooth.solver import exact, solve
from nonsmooth.solver.exact import exact_orbit, from_times
from nonsmooth.solver.existence import one_phase
from nonsmooth.solver.existence.known import Known, known
from nonsmooth.solver.existence.reasons import motions_without_switches
from nonsmooth.solver.flow.exact_system import exact_kernel
from nonsmooth.solver.iteration.newton import newton
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.start import RoughTimes, with_coefficients
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.orbit.admissible import violations
from nonsmooth.solver.orbit.exact_orbit import ExactOrbit
from nonsmooth.solver.orbit.solution import attempt
from nonsmooth.solver.solve import orbits_of, solve_case, with_motion

IMPACT, FRICTION = registry.load("impact"), registry.load("dry-friction")
BACKLASH = registry.load("backlash")


def reason(case, durations, angle=0.0):
    """Return why no orbit is found from given times; without units they are those in SI."""
    with pytest.raises(NoOrbit) as caught:
        exact_orbit(case, [s * case.units.time for s in durations], angle)
    (why,) = caught.value.tried
    return why


def test_a_contact_that_is_left_before_a_node_sees_it():
    """It bounces once on a landing that is over in a ten-thousandth of the contact."""
    case = registry.load("clearance")(
        damping=80.0, contact_stiffness=47000.0, gap=-0.3, force=0.53, frequency=0.012
    )
    why = reason(case, np.array([314.5898, 209.0090]) / case.units.time, 4.680616)
    assert "in contact, not true that the second spring is pressed: by 8.02e-07" in why
    bouncing = exact_orbit(case)
    assert bouncing.stable
    durations = [314.56481, 209.00896, 0.021243781, 0.0037560888]
    assert bouncing.durations == pytest.approx(durations, rel=1e-7)


def test_sliding_where_the_mass_would_stop():
    case = FRICTION(frequency=0.4, mu_s=0.6, mu_k=0.5).of_motion("sliding")
    start = reason(case, [math.pi], 1.5)
    assert "where slide ends, not true that the load exceeds the static limit" in start
    # a higher static limit alone, of an orbit that is one at a lower limit
    assert exact_orbit(FRICTION(mu_s=0.5)).violations == ()
    orbit = exact_orbit(FRICTION())
    high = FRICTION(mu_s=2.0).of_motion("sliding")
    assert "by 0." in reason(high, orbit.cell_durations, orbit.angle)


def test_a_stop_whose_load_exceeds_the_limit():
    """Rest that begins while the load is beyond the limit: the mass would not stay there."""
    case = FRICTION(frequency=0.4, mu_s=0.6, mu_k=0.5).of_motion("two-stops")
    orbit = exact_orbit(case)
    rest, start = float(orbit.phases[1].displacement), orbit.angle + orbit.cell_durations[0]
    assert abs(math.cos(start) - rest) < 0.6  # within the limit, in units of k and F
    still = Given(
        case, tuple(orbit.cell_durations), Polynomial([0.0]), -orbit.cell_durations[0]
    )
    (why,) = [each for each in violations(still) if "static limit" in each]
    assert why.startswith("in stop, not true that the load stays within the static limit")


def test_several_cycles_are_not_one_of_them_repeated():
    """Two flights, each of one cycle: an orbit of one cycle, twice."""
    flight = (1.0, 0.1, 1.0, 0.0, 1.0)
    stop, law = (1.0, 0.0, 0.0, -0.1), (-0.6, 0.0)
    scene = made(
        [flight, flight], [stop, stop], omega=1.8, jumps=(law, law), k=0, folder=Path("none")
    )
    single = exact_orbit(IMPACT()).cell_durations[0] / 1.8
    angle = exact_orbit(IMPACT()).angle
    why = reason(scene(cycles=2), [single, single], angle)
    assert "it is an orbit of 1 cycle of the forcing, 2 times in a row" in why


def test_the_jacobian_of_the_exact_equations_with_a_memory():
    """By differences, of a memory of displacement, velocity and forcing set within the cell."""
    cell = registry.load("elastic-plastic")().cell
    (memory,) = cell.memory
    general = type(memory)("w", 1, 0, (0.7, -0.4, 0.3, 0.2))
    for one in (cell, type(cell)(**{**vars(cell), "memory": (general,)})):
        kernel = exact_kernel(one)
        z = np.array([2.4, 0.1, 1.4, -1.5, 2.2, 1.1, 2.7, 2.3])
        expected = differences(partial(residual, kernel, one), z, 1e-6)
        np.testing.assert_allclose(jacobian(kernel, one, z).T, expected, rtol=0, atol=1e-8)


#: Solutions by an expansion that are no orbits: a higher order, or the exact equations, say so.
DISPROVED = [
    (
        {
            "damping": 0.019767996350776345, "frequency": 1.9999769783284103,
            "gap": 0.3333145972094319, "restitution": 0.023372925272368988, "cycles": 3,
        },
        20,
    ),
    (
        {
            "damping": 0.3102208332053689, "frequency": 0.3366305043143572,
            "gap": 1.120214300212283, "restitution": 0.324171717427616, "cycles": 2,
        },
        10,
    ),
    ({"damping": 52.664, "frequency": 1.1045, "gap": 0.016674, "restitution": 0.13355}, 20),
]  # fmt: skip


@pytest.mark.parametrize(("values", "order"), DISPROVED, ids=["repeats", "grazes", "creeps"])
@pytest.mark.parametrize("method", ["ck-tau", "hb"])
def test_what_the_exact_equations_disprove_is_not_returned(values, order, method, monkeypatch):
    case = IMPACT(**values)
    with pytest.raises(NoOrbit, match="no such orbit exists"):
        solve_case(case, method, order)
    # also by itself, where nothing is known of the exact solutions
    for module in (solve, exact):
        monkeypatch.setattr(module, "known", lambda case: Known())
        monkeypatch.setattr(module, "known_orbits", lambda case: [])
    with pytest.raises(NoOrbit):
        solve_case(case, method, order)


def test_a_solution_is_no_orbit_where_the_exact_one_next_to_it_is_none():
    """The impact leaves the stop at 4e-8 m/s, and order 6 does not know in which direction."""
    case = IMPACT(damping=0, restitution=0.8, gap=0.5, frequency=math.sqrt(3) - 1e-8)
    (grazing,) = (q for q in one_phase.solutions(case.cell).states if abs(q[1]) < 1e-6)
    near = from_times(case, RoughTimes((case.cell.duration,), grazing[2], "the exact times"))
    kernel = registry.quicker_kernel(case.scene, "ck-tau", None, 6)
    found = attempt(kernel, case, 6, near.times)
    assert found.converged
    assert not found.own_violations
    (why,) = found.violations
    assert "the exact solution next to it" in why
    assert "wrong direction" in why


def test_a_demand_is_measured_by_itself_where_it_is_little_of_its_terms():
    """A limit is passed again and again on the way, by 1e-12 of the displacement.

    Only the first of these solutions is an orbit, here with its times from 60 digits.  Which
    are found hangs on rounding: their elastic phases pass 1,500 floats.
    """
    stiff = registry.load("elastic-plastic")(stiffness=1e12, hardening=0.64)
    elastic, angle = 6.31256505632991e-07, 1.550925421091825  # without units
    turn = 2 * math.pi / math.sqrt(stiff.cell.phases[0].k)
    times = ((s, math.pi - s) for s in (elastic, elastic + turn, elastic + 2 * turn))
    found = [from_times(stiff, RoughTimes(each, angle, "known")) for each in times]
    assert [q.outcome.converged for q in found] == [True, True, True]
    assert [q.violations == () for q in found] == [True, False, False]
    with contextlib.suppress(NoOrbit):
        orbit = solve_case(stiff, "ck-tau", 10)
        apart = abs(float(orbit.cell_durations[0]) - elastic) / (2 * math.pi)
        assert apart <= 2 * orbit.estimate.times
    far = known(IMPACT(stiffness=1e-12, gap=-1e9))  # of which one passes the stop by 0.3 m
    assert (len(far.orbits), len(far.refused)) == (1, 1)


@pytest.mark.parametrize("drop", [0.0, 1e-10, 1e-9])
def test_a_stick_that_may_be_all_rounding_is_none(drop):
    """It was found, and found stable, where the slip alone fills the period."""
    case = registry.load("stick-slip")(mu_s=0.25 + drop)
    with pytest.raises(NoOrbit, match="and rounding may be as much"):
        exact_orbit(case)
    with pytest.raises(NoOrbit):
        solve_case(case, "hb", 12)


def test_a_slip_of_a_body_that_is_all_rounding_is_none():
    """The slider creeps to where it no longer slips: of that motion nothing is left."""
    case = registry.load("jenkins-absorber")(
        frequency=0.96, friction=0.158, tangential_stiffness=0.3, damping=0.3,
        absorber_damping=0.2, absorber_mass=1.0,
    )  # fmt: skip
    with pytest.raises(NoOrbit, match="settles on another sequence of phases: slip, -stick"):
        exact_orbit(case)


def stop_and_joint():
    """Return four masses in a row, a stop at the last, and a friction joint of two of them."""
    K = np.array(
        [
            [7.14958348, -3.54717733, 0, 0],
            [-3.54717733, 7.28091106, -3.73340373, 0],
            [0, -3.73340373, 11.14577673, -7.412373],
            [0, 0, -7.412373, 7.412373],
        ]
    )
    C = [[0.23386516, -0.02615929, -0.01691877, -0.00911963],
         [-0.10952312, 0.2253014, -0.01526328, 0.12219074],
         [-0.0063751, -0.13179516, 0.2322414, -0.14597099],
         [0.00024105, -0.15577133, -0.06320293, 0.14664298]]  # fmt: skip
    masses = np.diag([1.56897172, 1.62806821, 1.35512036, 0.69487672])
    at = {"end": [0, 0, 0, 1], "joint": [0, -1, 1, 0]}
    body = Body(M=masses, K=K, C=np.array(C), forcing=[0, 0, 0, 1], at=at)
    (end, joint), w = body.at.values(), sp.Symbol("w", real=True)
    k, g, spring, limit, frequency = sp.symbols("k g k_t f Omega", positive=True)
    pull, phases = spring * (joint.x - w), []
    stops = {"open_": (end.force, 1), "touch_": (end.force + k * (end.x + g), -1)}
    for (name, (stop, side)), other in zip(stops.items(), ("touch_", "open_"), strict=True):
        away = {"side of the stop": side * (g + end.x)}
        for how, slip in (("stick", 0), ("ahead", 1), ("back", -1)):
            ends = Event(-end.x - g, to=other + how)
            if slip:
                ends |= Event(joint.v, to=f"{name}stick")
                law, holds = slip * limit, slip * joint.v
            else:
                ends |= Event(pull - limit, to=f"{name}ahead")
                ends |= Event(pull + limit, to=f"{name}back")
                law, holds = pull, limit - sp.Abs(pull)
            laws = stop, joint.force + law
            phases.append(Phase(name + how, laws, ends, {**away, "joint": holds}))
    values = {"k": (k, "N/m", 26.98), "gap": (g, "m", 0.3734), "spring": (spring, "N/m", 14.81)}
    values |= {"limit": (limit, "N", 2.755), "frequency": (frequency, "rad/s", 0.6828)}
    sets = Memory(w, ("open_stick", "touch_stick"), joint.x + joint.force / spring, "slider")
    return scene_of("stop-and-joint", parameters(**values), *phases, body=body, memory=(sets,))


@pytest.mark.parametrize("limit", [2.755, 2.76])
def test_a_slip_at_a_double_root_of_the_equations_is_none(limit):
    """There Newton's method ends at 1e-7 s; the slider sticks for ever, at any place."""
    with pytest.raises(NoOrbit, match="none of them sets w"):
        exact_orbit(stop_and_joint()(limit=limit))


def test_of_two_orbits_the_stable_one_is_returned_and_the_other_named():
    case = IMPACT(
        mass=0.022676366, damping=0.20214459, stiffness=95.458992, force=77046612000,
        frequency=24.487056, gap=946825740, restitution=0.81313913,
    )  # fmt: skip
    orbit = solve_case(case, "ck-tau", 20)
    (other,) = orbit.others
    assert (orbit.stable, other.stable) == (True, False)
    assert [each.stable for each in orbits_of(case, order=20)] == [True, False]
    (still,) = motions_without_switches(case)
    assert (still.stable, still.phase) == (True, "flight")
    assert orbit.as_dict()["others"][0]["stable"] is False


def test_the_motion_that_occurs_is_found_whatever_the_order():
    case = FRICTION(
        damping=31.090267377334186, normal_force=46.596900233665814,
        mu_s=0.0045101800933892095, mu_k=0.001111668978050268, frequency=0.46721042650884287,
    )  # fmt: skip
    assert solve_case(case, order=40).case.scene.motion == "two-stops"
    assert with_motion(case).scene.motion == "two-stops"


def test_what_leads_to_no_exact_orbit_is_not_returned():
    """Damping lets this mass slide on for ever; order 21 ends the slip after two periods."""
    case = registry.load("stick-slip-damped")(
        mass=0.19645675225597792, stiffness=2.2840852421427464
    )
    with pytest.raises(NoOrbit, match="its times lead to no exact orbit"):
        solve_case(case, order=21)


#: A mass so light that within a phase it forgets the state in which that began.
LIGHT = BACKLASH(mass=0.003, gap_stiffness=1e-3)


def test_a_state_that_a_phase_forgets_does_not_follow_from_its_end():
    exact, kernel = exact_orbit(LIGHT), exact_kernel(LIGHT.cell)
    start = with_coefficients(kernel, LIGHT.cell, kernel.size(1), exact.times * (1 + 1e-3))
    assert np.abs(start).max() < 100


def test_a_jacobian_at_states_of_another_size_shows_no_convergence():
    kernel = exact_kernel(LIGHT.cell)
    states = -6.183632695836534e20, 8.784039356353224e22, 6.227368801043483e20
    more = 1.3081399608108409e19, 2.596499730519118, 0.5450929230706747, -0.9476282028759936
    found = newton(kernel.iterate, LIGHT.cell, np.array([*states, *more]))
    assert not found.converged or found.residual_norm < 1e-14


def test_an_exact_orbit_solves_its_equations():
    exact = exact_orbit(LIGHT)
    z = exact.outcome.unknowns * (1 + 1e-5)
    (why,) = ExactOrbit(LIGHT, replace(exact.outcome, unknowns=z)).violations
    assert why.startswith("it does not close: by ")
