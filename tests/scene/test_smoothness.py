"""The class of continuity at each switch, against the table of the mathematics."""

from dataclasses import replace

import pytest
import sympy as sp
from galerkin.derived import REFERENCES
from galerkin.oscillators import (
    CONTINUOUS,
    EQUAL_FRICTION,
    SCENES,
)
from small_scene import FLIGHT, g, k, refused, scene, stop
from small_scene import F as FORCE

from nonsmooth.codegen.scene import Event, forcing, switches, v, x
from nonsmooth.codegen.scene.smoothness import Switch, generator
from nonsmooth.codegen.scenes import dry_friction

SLIDING = SCENES["S3a"][0]
F, F_N = dry_friction.F, dry_friction.F_N


def classes(made):
    return [switch.k for switch in switches(made)]


@pytest.mark.parametrize("name", REFERENCES)
def test_the_classes_are_those_of_the_references(name):
    assert classes(SCENES[name][0]) == REFERENCES[name]["classes"]


def test_equal_friction_is_smoother_from_stick_to_slip_and_not_back():
    stop, start = switches(EQUAL_FRICTION)
    assert (stop.after, stop.before, stop.k, stop.derivative) == ("rest", "down", 2, "x'''")
    assert (start.after, start.before, start.k, start.derivative) == ("down", "rest", 1, "x''")
    assert classes(SCENES["S3b"][0]) == [1, 1]
    assert classes(CONTINUOUS) == [1, 2]


def test_an_impact_jumps_in_the_velocity():
    (impact,) = switches(SCENES["S6"][0])
    assert (impact.k, impact.jumps, impact.derivative) == (0, 1, "x'")


def test_a_law_that_changes_nothing_is_no_impact():
    law = ((F + F_N) ** 2 - F**2 - F_N**2) / (2 * F * F_N) * v
    assert law != v
    same = replace(SLIDING.phases[0], ends=Event(v, jump={v: law}))
    assert classes(replace(SLIDING, phases=(same,))) == [1]
    half = replace(SLIDING.phases[0], ends=Event(v, jump={v: v / 2}))
    assert classes(replace(SLIDING, phases=(half,))) == [0]


def test_a_contact_damper_makes_a_clearance_less_smooth():
    d = sp.Symbol("d", positive=True)
    made = SCENES["S2b"][0]
    damper = replace(made.parameters[1], name="damper", symbol=d)
    contact, separated = made.phases
    damped = replace(contact, equation=contact.equation + d * v)
    with_damper = replace(
        made, phases=(damped, separated), parameters=(*made.parameters, damper)
    )
    assert classes(with_damper) == [1, 1]
    assert classes(made) == [2, 2]


def test_the_damping_may_be_a_ratio():
    """Roots of parameters are no rational functions of them."""
    made = SCENES["S2b"][0]
    mass, stiffness = (sp.Symbol(name, positive=True) for name in ("m", "k"))
    ratio = sp.sqrt(stiffness * mass) * v / 5
    contact, separated = made.phases
    damped = [replace(q, equation=q.equation + ratio) for q in made.phases]
    assert classes(replace(made, phases=tuple(damped))) == [2, 2]
    assert classes(replace(made, phases=(damped[0], separated))) == [1, 1]
    assert classes(replace(made, phases=(contact, damped[1]))) == [1, 1]


def test_a_spring_that_begins_at_another_place_makes_a_step_of_the_force():
    made = SCENES["S2b"][0]
    contact, separated = made.phases
    begun = replace(contact, equation=contact.equation + F)
    assert classes(replace(made, phases=(begun, separated))) == [1, 1]


def test_the_mirrored_side_of_half_a_period_has_its_forces_mirrored():
    """Without the sign of the friction, nothing would change where it slides on."""
    phase = SLIDING.phases[0]
    q = generator(phase, sp.Symbol("Omega", positive=True))
    mirrored = generator(phase, sp.Symbol("Omega", positive=True), sign=-1)
    assert q - mirrored == sp.Matrix(5, 5, lambda i, j: 2 * q[1, 2] if (i, j) == (1, 2) else 0)
    assert q[1, 2] != 0


@pytest.mark.parametrize("place", [x, g])
def test_from_rest_on_a_stop_the_force_is_continuous_however_it_is_written(place):
    """`x` is `g` there, since the phase before the rest ends there."""
    assert classes(stop(rest={"ends": Event(FORCE * forcing - k * place)})) == [2, 0]


def test_where_nothing_changes_there_is_no_switch():
    phases = (replace(FLIGHT, name="one"), replace(FLIGHT, name="two", ends=Event(x)))
    refused(lambda: scene(phases=phases), "phase one: its motion is that of two; nothing")


def test_the_derivative_that_jumps_in_words():
    assert [Switch("", "", k).derivative for k in range(3)] == ["x'", "x''", "x'''"]
