"""Orbits against formulas in closed form, with parameters at random."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from made_scenes import made

from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.existence import one_phase
from nonsmooth.solver.existence.reasons import shown_to_be_none
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.scenes.classes import classes
from nonsmooth.solver.solve import solve_case
from nonsmooth.solver.stability.monodromy import monodromy

FEW = settings(max_examples=6)
PLASTIC = registry.load("elastic-plastic")


def orbit_of(case):
    """Return the exact orbit of a case; Hypothesis draws another where there is none."""
    try:
        return exact_orbit(case)
    except NoOrbit:
        assume(False)


@given(st.floats(0.1, 10), st.floats(0.1, 10), st.floats(0.2, 5))
def test_the_free_period_of_a_bilinear_spring(soft, stiff, speed):
    """``T = pi (sqrt(m/k_1) + sqrt(m/k_2))``, whatever the amplitude: half a wave of each.

    No force and no damping: the speed with which the stiff spring is met is given, as what the
    switch there makes of any; it is the speed that the motion brings back.
    """
    scene = made(
        [(1, 0, stiff, 0, 0), (1, 0, soft, 0, 0)],
        [(1, 0, 0, 0), (1, 0, 0, 0)],
        jumps=((1, 0), (0, speed)),
        demands=[{"pressed": (1, 0, 0, 0)}, {"free": (-1, 0, 0, 0)}],
        k=0,
    )
    expected = [math.pi / math.sqrt(k) for k in (stiff, soft)]
    orbit = exact_orbit(scene(), [1.2 * s for s in expected])
    assert orbit.durations == pytest.approx(expected, rel=1e-13)
    before = float(orbit.part(1, np.ones(1), 1)[0])
    assert before == pytest.approx(speed, rel=1e-13)
    low, high = orbit.extremes["displacement"]
    assert high == pytest.approx(speed / math.sqrt(stiff), rel=1e-12)
    assert low == pytest.approx(-speed / math.sqrt(soft), rel=1e-12)


@FEW
@given(st.floats(0.1, 0.5), st.floats(1, 20), st.floats(0.0, 0.5), st.floats(1.0, 1.6))
def test_the_state_space_of_a_clearance_shrinks_by_its_damping_alone(c, contact, gap, omega):
    """``det M = exp(-c T/m)``: a spring that is met makes no difference (Liouville)."""
    case = registry.load("clearance")(
        damping=c, contact_stiffness=contact, gap=gap, frequency=omega, mass=1.1
    )
    orbit = orbit_of(case)
    found = float(np.linalg.det(monodromy(orbit)[0]))
    assert found == pytest.approx(math.exp(-c / 1.1 * orbit.period), rel=1e-9)


@FEW
@given(st.floats(0.0, 0.4), st.floats(0.2, 0.8), st.floats(0.0, 1.0), st.floats(0.5, 1.1))
def test_the_force_works_what_loop_and_damper_take(c, limit, hardening, omega):
    """The loop of an elastic-plastic element has the area ``4 F_y (X - F_y/k)`` (Caughey)."""
    case = PLASTIC(
        damping=c, yield_force=limit, hardening=hardening, frequency=omega, stiffness=1.3
    )
    orbit = orbit_of(case)
    nodes, weights = np.polynomial.legendre.leggauss(40)
    ends = np.cumsum([0.0, *orbit.durations])
    work = lost = 0.0
    for low, high in pairwise(ends):
        t = (low + high) / 2 + (high - low) / 2 * nodes
        v = orbit.velocity(t)
        force = case.values["force"] * np.cos(omega * t + orbit.forcing_phase)
        work += float(weights @ (force * v)) * (high - low) / 2
        lost += float(weights @ (c * v * v)) * (high - low) / 2
    reach = orbit.extremes["displacement"][1]
    assert work - lost == pytest.approx(4 * limit * (reach - limit / 1.3), rel=1e-10)


def third_and_fourth(orbit, p, end):
    """Return x''' and x'''' at an end of a phase, from its equation differentiated."""
    phase, omega = orbit.cell.phases[p], orbit.cell.omega
    v, a = (float(orbit.part(p, np.array([float(end)]), j)[0]) for j in (1, 2))
    angle = orbit.angle + omega * float(np.sum(orbit.cell_durations[: p + end]))
    third = -phase.c * a - phase.k * v - phase.g * omega * math.sin(angle)
    third /= phase.m
    fourth = -phase.c * third - phase.k * a - phase.g * omega**2 * math.cos(angle)
    return third, fourth / phase.m


@FEW
@given(st.floats(0.0, 0.4), st.floats(0.2, 0.8), st.floats(0.0, 1.0), st.floats(0.5, 1.1))
def test_the_reversal_of_an_elastic_plastic_element_is_c3(c, limit, hardening, omega):
    """There x''' goes on and x'''' jumps, by ``-k x''/m``; at yield x''' jumps already."""
    case = PLASTIC(damping=c, yield_force=limit, hardening=hardening, frequency=omega)
    orbit = orbit_of(case)
    assert classes(case.cell) == (3, 2)
    before, after = third_and_fourth(orbit, 1, 1), third_and_fourth(orbit, 0, 0)
    size = max(map(abs, (*before, *after)))
    assert -before[0] - after[0] == pytest.approx(0, abs=1e-12 * size)
    a = float(orbit.part(0, np.zeros(1), 2)[0])
    phase = orbit.cell.phases[0]
    softer = phase.k - orbit.cell.phases[1].k
    assert after[1] + before[1] == pytest.approx(-softer * a / phase.m, abs=1e-11 * size)
    jump = third_and_fourth(orbit, 1, 0)[0] - third_and_fourth(orbit, 0, 1)[0]
    v = float(orbit.part(1, np.zeros(1), 1)[0])
    assert jump == pytest.approx(softer * v / phase.m, abs=1e-11 * size)


@pytest.mark.parametrize("functions", [0, 1, 2])
def test_its_first_discontinuous_derivative_converges_as_its_switches_say(functions):
    """K functions at a switch of class C^k leave ``x^(k+1+K)``: as ``N^-(K + 1/2)`` in L2."""
    method = ("hb-ck", functions) if functions else ("hb",)
    orders = (9, 13, 17, 23, 31)
    orbits = [solve_case(PLASTIC(), *(method[:1]), n, *method[1:]) for n in orders]
    errors = [orbit.errors.discontinuous for orbit in orbits]
    rate = -np.polyfit(np.log(orders), np.log(errors), 1)[0]
    assert rate == pytest.approx(functions + 0.5, abs=0.15)


def test_a_second_touch_of_the_stop_is_seen_at_once():
    """Where the orbit between two impacts just touches the stop; from its closed form."""
    touch = 1.00621643423140580  # c = 0, r = 0.8, gap = 0

    def at(frequency):
        values = {"damping": 0, "restitution": 0.8, "gap": 0, "frequency": frequency}
        return registry.load("impact")(**values)

    assert shown_to_be_none(at(touch * (1 + 1e-6))) is None
    finding = shown_to_be_none(at(touch * (1 - 1e-6)))
    assert any("not true that the mass stays before the stop" in q for q in finding.tried)
    assert len(one_phase.solutions(at(touch * (1 - 1e-6)).cell).states) == 2
