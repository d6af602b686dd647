"""Every mistake in a scene is refused in one line that names the field."""

from dataclasses import replace

import pytest
import sympy as sp
from small_scene import (
    BELT,
    FLIGHT,
    PARAMETERS,
    F,
    Omega,
    V,
    a,
    belt,
    c,
    forcing,
    g,
    k,
    m,
    mu,
    r,
    refused,
    scene,
    stop,
    v,
    with_parameter,
    x,
)

from nonsmooth.codegen.scene import Event, Parameter, Phase, t
from nonsmooth.codegen.scene.linear import without_modulus
from nonsmooth.codegen.scene.smoothness import place

stranger = sp.Symbol("stranger", positive=True)
MOTION = FLIGHT.equation


def test_the_scenes_that_are_changed_below_are_right():
    assert scene().symbols == tuple(q.symbol for q in PARAMETERS)
    assert belt().sign == 1
    assert place(stop(), 1) == g
    assert place(belt(), 0) is None
    # a jump to the speed of a belt, and a stop on the other side of half a period
    struck = Event(k * x - F, jump={v: V})
    assert belt(run={"ends": struck}).phases[1].ends is struck
    rest, flight = stop().phases[1], replace(FLIGHT, ends=Event(x + g, jump={v: 0}))
    assert place(stop(half_period=True, phases=(rest, flight)), 0) == g
    assert scene(half_period=True).sign == -1


NAMES = [
    (lambda: with_parameter(0, name="a b"), "parameter a b: got"),
    (lambda: with_parameter(0, name="lambda"), "parameter lambda"),
    (lambda: with_parameter(0, name="order"), "parameter order", "taken"),
    (
        lambda: with_parameter(0, symbol=sp.Symbol("lambda", positive=True)),
        "parameter mass: symbol: got 'lambda', a word of Python",
    ),
    (
        lambda: with_parameter(0, symbol=sp.Symbol("m_{1}", positive=True)),
        "parameter mass: symbol: got 'm_{1}'",
    ),
    (lambda: with_parameter(0, symbol=x), "parameter mass: symbol: x"),
    (
        lambda: with_parameter(0, symbol=sp.Symbol("N", positive=True)),
        "parameter mass: symbol: N has a meaning of its own",
        "as have N, R, J, T, z,",
    ),
    (
        lambda: with_parameter(0, symbol=sp.Symbol("s_flight", positive=True)),
        "parameter mass: symbol: s_flight has a meaning of its own",
    ),
    (
        lambda: with_parameter(0, symbol=sp.Symbol("t1", positive=True)),
        "parameter mass: symbol: t1 has a meaning of its own",
    ),
    (
        lambda: with_parameter(0, symbol=sp.Symbol("C_flight", positive=True)),
        "parameter mass: symbol: C_flight has a meaning of its own",
    ),
    (lambda: with_parameter(0, symbol=sp.Symbol("m")), "parameter mass: symbol: got m", "real"),
    (
        lambda: with_parameter(0, symbol=sp.Symbol("m", negative=True)),
        "parameter mass: symbol: got m",
        "positive, nonnegative or real",
    ),
    (
        lambda: with_parameter(0, symbol=sp.Symbol("m", integer=True)),
        "parameter mass: symbol: got m",
    ),
    (lambda: with_parameter(1, name="mass"), "parameters: name mass", "twice"),
    (lambda: with_parameter(1, symbol=m), "parameters: symbol m", "twice"),
    (lambda: scene(phase={"name": "a b"}), "phase a b: name: got"),
    (lambda: scene(phase={"name": "pass"}), "phase pass: name: got"),
    (lambda: belt(run={"name": "rest"}), "phases: got rest, rest"),
    (lambda: scene(phases=()), "phases: got none"),
]

PARAMETER = [
    (lambda: with_parameter(0, unit="pound"), "parameter mass: unit: got 'pound'"),
    (lambda: with_parameter(0, unit="Ns/m"), "parameter mass: unit: got", "as in 'N s/m'"),
    (lambda: with_parameter(0, symbol=sp.Symbol("m")), "parameter mass: symbol", "=True)"),
    (lambda: with_parameter(0, default=0.0), "parameter mass: default: got 0.0", "above 0"),
    (lambda: with_parameter(1, default=-1.0), "parameter damping: default", "0 or more"),
    (
        lambda: with_parameter(6, default=1.5),
        "parameter restitution: default: got 1.5",
        "above 0 and at most 1",
    ),
    (
        lambda: with_parameter(5, default=float("inf")),
        "parameter gap: default: got inf",
        "a number",
    ),
    (lambda: with_parameter(5, default=float("nan")), "parameter gap: default: got nan"),
    (
        lambda: scene(parameters=(*PARAMETERS, Parameter("idle", mu, "", 1.0, "idle"))),
        "parameter idle: no equation",
    ),
]

FIELDS = [
    (
        lambda: scene(phase={"equation": MOTION + stranger * x}),
        "phase flight: equation: stranger is not a parameter",
    ),
    (lambda: scene(ends={"zero": x - stranger}), "phase flight: ends: stranger is not"),
    (lambda: scene(ends={"jump": {v: -stranger * v}}), "phase flight: jump: stranger is not"),
    (
        lambda: scene(phase={"demands": {"right": stranger - x}}),
        "phase flight: demand 'right': stranger is not",
    ),
    (lambda: scene(requires={"right": stranger}), "requires 'right': stranger is not"),
    (lambda: scene(requires={"right": m < k}), "requires 'right': got m < k", "the larger"),
    (lambda: scene(guess=(stranger / Omega,)), "guess: stranger is not"),
    (lambda: scene(scales={"length": stranger * g}), "scales 'length': stranger is not"),
    (
        lambda: scene(phase={"equation": MOTION + sp.Symbol("c") * v}),
        "phase flight: equation: c is not a parameter",
        "another symbol of that name",
        "nonnegative=True",
    ),
    (
        lambda: scene(phase={"equation": m * a + k * v - F * forcing + c * v}),
        "phase flight: equation: units clash",
        "k*v in kg m/s^3",
    ),
    (lambda: scene(ends={"zero": x - v}), "phase flight: ends: units clash", "is in m", "m/s"),
    (
        lambda: scene(phase={"demands": {"right": g - v}}),
        "phase flight: demand 'right': units clash",
    ),
    (lambda: scene(requires={"right": g - m}), "requires 'right': units clash"),
    (lambda: scene(ends={"zero": m * a + F}), "phase flight: ends", "acceleration"),
    (
        lambda: scene(phase={"demands": {"right": F - m * a}}),
        "phase flight: demand 'right'",
        "acceleration",
    ),
    (
        lambda: scene(phase={"demands": {"right": sp.Abs(x) - g}}),
        "phase flight: demand 'right'",
        "a bound - Abs(...)",
    ),
    (
        lambda: scene(phase={"demands": {"right": g**2 - sp.Abs(x - g) ** 2 * r}}),
        "phase flight: demand 'right'",
    ),
    (lambda: scene(phase={"equation": -MOTION}), "phase flight: equation: got -m times a"),
    (lambda: scene(ends={"zero": g}), "phase flight: ends: g depends on neither"),
    (lambda: scene(ends={"zero": 0.0}), "phase flight: ends: 0.0 dep"),
    (lambda: scene(ends={"jump": {x: -x}}), "phase flight: jump: got a jump of x"),
    (
        lambda: scene(ends={"jump": {v: -r * v**2}}),
        "phase flight: jump: ",
        "-r*v**2 is not linear in v",
    ),
    (
        lambda: scene(ends={"jump": {v: -r * sp.Abs(v)}}),
        "phase flight: jump",
        "not linear in v",
    ),
    (
        lambda: scene(ends={"jump": {v: -r * v + Omega * x}}),
        "phase flight: jump: got",
        "the velocity v alone",
    ),
    (lambda: scene(ends={"jump": {v: -r * x}}), "phase flight: jump: -r*x is not a velocity"),
    (lambda: scene(ends={"zero": x - g * Omega * t}), "phase flight: ends"),
    (
        lambda: scene(
            phases=(
                Phase("here", MOTION / m, Event(x - g)),
                Phase("there", m * a + c * v - F * forcing * r, Event(x - g)),
            )
        ),
        "phase there: equation: it is in kg m/s^2, that of here in m/s^2",
    ),
]

WHOLE = [
    (
        lambda: scene(frequency=None),
        "phase flight: equation: it has forcing, but the scene has no frequency",
    ),
    (
        lambda: belt(rest={"ends": Event(F * forcing - k * x)}),
        "phase rest: ends: it has forcing",
    ),
    (
        lambda: belt(
            parameters=(*BELT, Parameter("frequency", Omega, "1/s", 1.0, "frequency")),
            frequency=Omega,
        ),
        "frequency: no equation and no event has forcing",
    ),
    (lambda: scene(frequency=stranger), "frequency: stranger is not a parameter"),
    (lambda: scene(frequency=k), "frequency: got the unit 'N/m', expected rad/s"),
    (
        lambda: scene(
            frequency=sp.Symbol("w", real=True),
            parameters=(*PARAMETERS, Parameter("w", sp.Symbol("w", real=True), "1/s", 1.0, "")),
        ),
        "frequency: got w, expected a positive symbol",
    ),
    (lambda: belt(guess=(m * V / F,)), "guess: got 1 durations for 2"),
    (lambda: scene(start={x: g}), "start: the phase of the"),
    (lambda: belt(start={x: V * m / F, v: V}), "start: got x, v, expected"),
    (lambda: belt(start={a: F / m}), "start: got a, expected either"),
    (lambda: belt(start={x: V}), "start: V is in m/s, expected m"),
    (lambda: belt(start={v: V * v / V}), "start: v is not a parameter"),
    (lambda: scene(guess=(g,)), "guess: g is in m, expected s"),
    (lambda: scene(guess=(3.0,)), "guess: 3.0", "expected s"),
    (lambda: scene(guess=(x / v,)), "guess: v is not a parameter"),
    (lambda: scene(scales={"force": F}), "scales 'force': expected one of mass"),
    (lambda: scene(scales={"length": F}), "scales 'length': F is in kg m/s^2, expected m"),
    (lambda: scene(scales={"length": 0}), "scales 'length': got 0"),
    (
        lambda: scene(phase={"ends": Event(x - g)}, parameters=PARAMETERS[:-1]),
        "phase flight: it follows itself, and nothing changes where it ends; is a phase",
    ),
    (
        lambda: belt(
            rest={"equation": m * a + F, "held": None},
            run={"ends": Event(k * x - F)},
            parameters=tuple(q for q in BELT if q.symbol != V),
        ),
        "scales: no length can be worked out",
    ),
    (lambda: belt(run={"equation": m * a + F}), "scales: no time can be worked out"),
    (
        lambda: belt(
            run={"equation": a, "held": V, "ends": Event(k * x + F)},
            rest={"ends": Event(v - V)},
        ),
        "phases: got only held ones",
    ),
]

HELD = [
    (
        lambda: belt(rest={"ends": Event(v - V)}),
        "phase rest: ends: -V + v does not change while it is held",
    ),
    (
        lambda: belt(rest={"held": sp.Integer(0)}, run={"ends": Event(v)}),
        "phase rest: ends: F - k*x does not change while it is held",
    ),
    (
        lambda: belt(rest={"equation": m * a + k * x}),
        "phase rest: held: got the equation",
        "expected a",
    ),
    (lambda: belt(rest={"held": V * m}), "phase rest: held: V*m is not a velocity"),
    (lambda: belt(run={"ends": Event(k * x - F)}), "phase run: ends: got", "expected -V + v"),
    (
        lambda: belt(run={"ends": Event(v - 2 * V)}),
        "phase run: ends: got -2*V + v, expected -V + v",
    ),
    (
        lambda: belt(run={"ends": Event(v - V, jump={v: -v})}),
        "phase run: jump: got -v, expected V: the velocity at which rest is held",
    ),
    (
        lambda: stop(flight={"ends": Event(x - g, jump={v: -r * v})}, parameters=PARAMETERS),
        "phase flight: jump: got -r*v, expected 0: the velocity at which rest is held",
    ),
    (
        lambda: stop(flight={"ends": Event(x - g)}),
        "phase flight: ends: got -g + x, expected v: the velocity at which rest is held",
    ),
    (
        lambda: belt(rest={"held": v}),
        "phase rest: held: got v, expected a velocity in the parameters",
    ),
    (lambda: belt(half_period=True), "phase run: ends: got -V + v, expected V + v"),
]

TYPES = [
    (lambda: scene(phases=FLIGHT), "phases: got", "(entry,)"),
    (lambda: scene(phases=(FLIGHT.ends,)), "phases: got", "expected a Phase"),
    (
        lambda: scene(phase={"ends": FLIGHT}),
        "phase flight: ends: got a Phase, expected an Event",
    ),
    (lambda: scene(phase={"ends": x - g}), "phase flight: ends: got -g + x, expected an Event"),
    (lambda: scene(parameters=(m, k)), "parameters: got m, expected a Parameter"),
    (lambda: with_parameter(0, symbol=1.0), "parameter mass: symbol: got 1.0"),
    (lambda: with_parameter(0, name=m, symbol="mass"), "parameter: name: got m, expected text"),
    (lambda: with_parameter(0, unit=None), "parameter mass: unit: got No"),
    (
        lambda: with_parameter(0, default="1"),
        "parameter mass: default: got '1', expected a number",
    ),
    (lambda: with_parameter(0, name="velocity"), "parameter velocity: the name is"),
    (lambda: with_parameter(0, default=True), "parameter mass: default: got True"),
    (lambda: with_parameter(6, most="1"), "parameter restitution: most"),
    (
        lambda: scene(phase={"equation": sp.Eq(m * a, -k * x)}),
        "phase flight: equation: got an equation",
    ),
    (
        lambda: scene(phase={"equation": "m*a + k*x"}),
        "phase flight: equation: got 'm*a + k*x'",
        "expression of SymPy",
    ),
    (
        lambda: scene(phase={"demands": {"right": "g - x"}}),
        "phase flight: demand 'right': got 'g - x'",
    ),
    (
        lambda: scene(phase={"demands": {"right": g >= x}}),
        "phase flight: demand 'right': got",
        "expression",
    ),
    (lambda: scene(phase={"demands": (g - x,)}), "phase flight: demand: got", "mapping"),
    (
        lambda: scene(phase={"demands": {1: g - x}}),
        "phase flight: demand: got 1, expected text",
    ),
    (lambda: scene(ends={"jump": -r * v}), "phase flight: jump: got -r*v, expected a mapping"),
    (
        lambda: scene(ends={"jump": {"v": -r * v}}),
        "phase flight: jump: got 'v', expected a symbol",
    ),
    (
        lambda: scene(phase={"demands": {"right": sp.oo - x}}),
        "phase flight: demand 'right': got",
    ),
    (
        lambda: scene(phase={"equation": MOTION + sp.I * c * v}),
        "phase flight: equation: got",
        "real and finite",
    ),
    (lambda: scene(frequency="frequency"), "frequency: got 'freq"),
    (lambda: scene(frequency=1.8), "frequency: got 1.8"),
    (lambda: scene(guess=1 / Omega), "guess: got 1/Omega", "(entry,)"),
    (lambda: scene(scales=(m, 1, g)), "scales: got", "mapping"),
    (lambda: scene(half_period="yes"), "half_period: got 'yes'"),
    (lambda: scene(name=None), "name: got None, expected text"),
    (lambda: scene(title="two\nlines"), "title: got", "one line"),
]

MISTAKES = [*NAMES, *PARAMETER, *FIELDS, *WHOLE, *HELD, *TYPES]


@pytest.mark.parametrize("mistake", MISTAKES, ids=lambda mistake: mistake[1])
def test_a_mistake_gets_one_line_that_names_the_field(mistake):
    make, *words = mistake
    refused(make, *words)


def test_numbers_of_any_kind_are_numbers():
    made = scene(
        parameters=tuple(
            replace(
                q, default=sp.Rational(1, 2), most=None if q.most is None else sp.Integer(1)
            )
            for q in PARAMETERS
        ),
        ends={"jump": {v: -0.5 * r * v}},
        scales={"length": 2.0, "mass": 3},
        guess=[2 * sp.pi / Omega],
    )
    assert float(made.parameters[0].default) == 0.5


def test_a_bound_of_a_modulus_is_two_bounds():
    parts = without_modulus(g - sp.Abs(x - c * v / k) - sp.Abs(F / k), (x, v))
    assert set(parts) == {g - (x - c * v / k) - F / k, g + x - c * v / k - F / k}
    two = without_modulus(g - sp.Abs(x) - r * sp.Abs(v) * m / k, (x, v))
    assert len(two) == 4
    assert all(not part.has(sp.Abs) for part in two)
