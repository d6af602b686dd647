"""Motions, memory and demands at switches: what is checked, and the class that is deduced."""

from dataclasses import replace

import pytest
import sympy as sp
from small_scene import FLIGHT, F, Omega, belt, g, k, m, refused, scene

from nonsmooth.codegen import scenes
from nonsmooth.codegen.scene import Event, Memory, a, forcing, switches, v, x
from nonsmooth.codegen.scene.smoothness import classes_of

w = sp.Symbol("w", real=True)
OFFSET = Memory(w, "flight", x, "displacement at the last impact")
KEPT = {"equation": FLIGHT.equation + k * w}
GUESS = (2 * sp.pi / Omega,)


def remembering(phase=KEPT, **changes):
    """Return a scene with a memory that has changed fields."""
    return scene(phase=phase, memory=(replace(OFFSET, **changes),))


def several(**changes):
    """Return a scene with two motions and changed fields."""
    softer = replace(FLIGHT, ends=Event(x - g, jump={v: -v / 2}))
    motions = {"one": (FLIGHT,), "two-times": (replace(FLIGHT, name="first"), softer)}
    return scene(**({"phases": (), "motions": motions} | changes))


def test_the_scenes_that_are_changed_below_are_right():
    assert remembering().memory == (OFFSET,)
    made = several(guess={"one": GUESS})
    assert [motion.label for motion in made.each_motion] == ["small, one", "small, two-times"]
    assert [motion.guess for motion in made.each_motion] == [GUESS, ()]
    assert scene().each_motion == (scene(),)


MISTAKES = [
    (lambda: scene(memory=(w,)), "memory: got w", "a Memory"),
    (lambda: scene(memory=OFFSET), "memory: got", "(entry,)"),
    (
        lambda: remembering(symbol=sp.Symbol("w", positive=True)),
        "memory w: symbol: got other assumptions, expected real=True",
    ),
    (lambda: remembering(symbol=g), "memory g: symbol: there"),
    (lambda: remembering(symbol=x), "memory x: symbol"),
    (
        lambda: remembering(symbol=sp.Symbol("phi", real=True)),
        "memory phi: symbol: phi has a meaning of its own",
    ),
    (lambda: remembering(at="fligt"), "memory w: at: got 'fligt', expected one of flight"),
    (lambda: remembering(value=x**2 / g), "memory w: value", "is not linear in x"),
    (lambda: remembering(value=a / Omega**2), "memory w: val"),
    (lambda: remembering(value=g), "memory w: value: g depends on neither x, v nor forcing"),
    (lambda: remembering(value=k * x), "memory w: value: it is in kg m/s^2, expected m"),
    (lambda: remembering(value=x + v), "memory w: value: units"),
    (lambda: scene(memory=(OFFSET,)), "memory w: no equation, event or demand has it"),
    (lambda: remembering(value=v), "phase flight: equation: units clash"),
    (
        lambda: remembering({"equation": FLIGHT.equation + k * w * x / g}),
        "phase flight: equation",
        "is not linear in",
    ),
    (
        lambda: remembering({"ends": Event(x * w / g - g, jump={v: -v})}),
        "phase flight: ends",
        "is not linear in x",
    ),
    (
        lambda: remembering({**KEPT, "ends": Event(w - g, jump={v: -v})}),
        "phase flight: ends: -g + w depends on neither",
    ),
    (
        lambda: remembering({**KEPT, "ends": Event(x - g, jump={v: -v + Omega * w})}),
        "phase flight: jump",
        "the velocity v alone",
    ),
    (
        lambda: belt(memory=(Memory(w, "run", x * forcing / 2, "place"),)),
        "memory w: value: it has forcing, but the scene has no frequency",
    ),
    (lambda: scene(motions={"one": (FLIGHT,)}), "motions: got phases"),
    (lambda: several(motions=(FLIGHT,)), "motions: got", "mapping"),
    (lambda: several(motions={"one": ()}), "motion one: phases: got none"),
    (lambda: several(motions={"one": FLIGHT}), "motion one: got", "tuple"),
    (
        lambda: several(motions={"a b": (FLIGHT,)}),
        "motions: got 'a b', expected lower-case letters",
    ),
    (
        lambda: several(motions={"a-b": (FLIGHT,), "a_b": (FLIGHT,)}),
        "motions: got 'a_b', expected lower-case letters, digits and dashes",
    ),
    (
        lambda: several(motions={"one": (replace(FLIGHT, ends=Event(x**2 / g - g)),)}),
        "motion one: phase flight: ends",
        "is not linear in x",
    ),
    (lambda: several(guess=GUESS), "guess: got durations, expected"),
    (
        lambda: several(guess={"three": GUESS}),
        "guess: got 'three', expected one of one, two-times",
    ),
    (
        lambda: several(guess={"one": GUESS * 2}),
        "motion one: guess: got 2 durations for 1 phases",
    ),
    (lambda: scene(guess={"one": GUESS}), "guess: got a mapping, expected a tuple"),
    (
        lambda: several(
            motions={
                "one": (FLIGHT,),
                "two": (replace(FLIGHT, equation=FLIGHT.equation + m * a),),
            }
        ),
        "scales: the unit of mass is m in one, 2*m in two; give 'mass'",
    ),
    (
        lambda: several(motions={"one": (replace(FLIGHT, ends=Event(x - g)),)}),
        "motion one: phase flight: it follows itself",
    ),
    (lambda: scene(ends={"demands": {"fast": v**2 - g}}), "phase flight: ends: demand 'fast'"),
    (
        lambda: scene(ends={"demands": {"fast": v - g}}),
        "phase flight: ends: demand 'fast': units clash",
    ),
    (
        lambda: scene(ends={"demands": {"fast": "v"}}),
        "phase flight: ends: demand 'fast': got 'v'",
    ),
]


@pytest.mark.parametrize("mistake", MISTAKES, ids=lambda mistake: mistake[1])
def test_a_mistake_gets_one_line_that_names_the_field(mistake):
    make, *words = mistake
    refused(make, *words)


def test_before_the_switch_that_sets_it_a_memory_is_that_of_the_cell_before():
    """Of the cell before, that is mirrored in half a period: with the opposite sign."""
    late = replace(
        FLIGHT, name="late", equation=FLIGHT.equation + k * w, ends=Event(v - w * Omega)
    )
    phases = (late, replace(FLIGHT, name="early"))
    made = scene(phases=phases, memory=(replace(OFFSET, at="early"),), half_period=True)
    assert made.cell[0].equation == FLIGHT.equation - k * w
    assert made.cell[0].ends.zero == v + w * Omega
    assert made.cell[1] == made.phases[1]
    whole = scene(phases=phases, memory=(replace(OFFSET, at="early"),))
    assert whole.cell == whole.phases


def test_the_class_knows_what_a_switch_sets():
    """With w = x at the reversal the plastic force goes on: C3, and without that C1."""
    made = scenes.load("elastic-plastic")
    assert [switch.k for switch in switches(made)] == [3, 2]
    (memory,) = made.memory
    late = replace(made, memory=(replace(memory, at="plastic"),))
    assert switches(late)[0].k == 1


def test_equal_friction_is_smoother_where_the_mass_slides_on():
    made = scenes.load("dry-friction").of_motion("two-stops")
    assert [switch.k for switch in switches(made)] == [1, 1]
    values = {q.symbol: sp.sympify(q.default) for q in made.parameters}
    assert classes_of(made, values) == (2, 1)
    mu_s = next(q.symbol for q in made.parameters if q.name == "mu_s")
    assert classes_of(made, values | {mu_s: sp.Rational(2, 5)}) == (1, 1)


def test_a_force_of_nothing_is_no_switch_at_all():
    made = scenes.load("backlash")
    values = {q.symbol: sp.sympify(q.default) for q in made.parameters}
    same = {q.symbol: sp.Integer(1) for q in made.parameters if "stiffness" in q.name}
    assert classes_of(made, values | same) == (8, 8)
    assert F in values
