"""A scene in numbers: the emitted functions against the expressions that they are made of."""

import ast
import hashlib

import numpy as np
import pytest
import sympy as sp
from every_run import tried
from galerkin.derived import in_numbers
from galerkin.oscillators import SCENES, parameters_of
from small_scene import PARAMETERS, F, Omega, belt, g, k, m, r, scene

from nonsmooth.codegen.emission.scene_numbers import scene_source
from nonsmooth.codegen.scene import a, forcing, linear_phase, v, x
from nonsmooth.codegen.scene.scales import scales

EVERY = {q.name: q for q, _ in SCENES.values()}
EVERY["all fields"] = scene(
    guess=(2 * sp.pi / Omega,),
    requires={"the gap is small": F / k - g, "r is below 1": 1 - r},
    scales={"length": F / k, "mass": m},
    source="somewhere",
)
STATE = dict(zip((x, v, a, forcing), (0.3, -1.7, 0.9, 0.4), strict=True))
POINT = np.array([STATE[x], STATE[v], STATE[forcing], 1.0])

#: The value of every memory.
KEPT = 0.7


def at_the_point(form):
    """Return the value of a linear form, with a factor of each memory behind the others."""
    return form[:4] @ POINT + KEPT * sum(form[4:])


def module_of(made):
    return in_numbers(made).module


def values_of(made):
    random = np.random.default_rng(list(made.name.encode()))
    return tuple(float(value) for value in random.uniform(0.2, 0.9, len(made.parameters)))


#: In every run; the others have fields and events of the same kinds.
EVERY_RUN = ("impact", "elastic-plastic", "stick-slip-damped", "stick-slip", "all fields")


@pytest.fixture(params=tried(EVERY, every_run=EVERY_RUN), scope="module")
def emitted(request):
    """Return a scene, its module, parameters in numbers, what evaluates an expression."""
    made = EVERY[request.param]
    numbers = values_of(made)
    symbols = dict(zip(made.symbols, numbers, strict=True))
    kept = {memory.symbol: KEPT for memory in made.memory}
    return (
        made,
        module_of(made),
        numbers,
        lambda e: float(sp.sympify(e).subs(symbols | kept).subs(STATE)),
    )


def test_coefficients_are_those_of_the_equations(emitted):
    made, module, numbers, value = emitted
    found = module.coefficients(*numbers)
    for phase, row in zip(made.phases, found, strict=True):
        mass, c, stiffness, f, amplitude, *memory = row
        left = mass * STATE[a] + c * STATE[v] + stiffness * STATE[x]
        right = f + amplitude * STATE[forcing] + KEPT * sum(memory)
        assert left - right == pytest.approx(value(phase.equation), abs=1e-14)


def test_events_and_jumps_are_those_of_the_scene(emitted):
    made, module, numbers, value = emitted
    events, jumps = module.events(*numbers), module.jumps(*numbers)
    for phase, event, (rho, d) in zip(made.phases, events, jumps, strict=True):
        assert at_the_point(event) == pytest.approx(value(phase.ends.zero), abs=1e-14)
        law = phase.ends.jump.get(v, v)
        assert rho * STATE[v] + d == pytest.approx(value(law), abs=1e-14)


def test_a_demand_with_a_modulus_is_the_lesser_of_two(emitted):
    made, module, numbers, value = emitted
    found = module.demands(*numbers)
    for phase, words, forms in zip(made.phases, module.DEMANDS, found, strict=True):
        assert len(words) == len(forms)
        assert list(dict.fromkeys(words)) == list(phase.demands)
        for each, demand in phase.demands.items():
            rows = [
                at_the_point(form)
                for word, form in zip(words, forms, strict=True)
                if word == each
            ]
            assert len(rows) == (2 if sp.sympify(demand).has(sp.Abs) else 1)
            assert min(rows) == pytest.approx(value(demand), abs=1e-14)


def test_what_has_no_state_is_evaluated(emitted):
    made, module, numbers, value = emitted
    held = [value(phase.held or 0) for phase in made.phases]
    assert module.held(*numbers) == pytest.approx(held)
    requires = in_numbers(made).numbers("requires", numbers)
    assert requires == pytest.approx([value(e) for e in made.requires.values()])
    assert tuple(made.requires) == module.REQUIRES
    guess = in_numbers(made).numbers("guess", numbers)
    assert guess == pytest.approx([value(e) for e in made.guess])
    assert module.scales(*numbers) == pytest.approx([value(e) for e in scales(made)])


def test_what_a_module_says_of_the_scene(emitted):
    made, module, *_ = emitted
    assert (made.name, made.title, made.source) == (module.NAME, module.TITLE, module.SOURCE)
    assert made.half_period == module.HALF_PERIOD
    assert min(k for k, _ in module.SWITCHES) == module.CLASS
    assert all(word == "x" + "'" * (k + 1) for k, word in module.SWITCHES)
    frequency = {q.name: q.symbol for q in made.parameters}.get(module.FREQUENCY)
    assert frequency == made.frequency
    assert [name for name, _ in module.PHASES] == [phase.name for phase in made.phases]
    assert [held for _, held in module.PHASES] == [p.held is not None for p in made.phases]
    for q, row in zip(made.parameters, module.PARAMETERS, strict=True):
        kind = {"": "real"}.get(row[5], row[5])
        assert row[:5] == (q.name, q.symbol.name, q.unit, q.default, q.what)
        assert sp.Symbol(row[1], **{kind: True}) == q.symbol
        assert row[6] == q.most


def test_the_text_has_a_hash_and_no_idle_import(emitted):
    made, module, *_ = emitted
    text = scene_source(made)
    body = text.partition("of the text below\n\n")[2]
    assert hashlib.sha256(body.encode()).hexdigest() == module.BODY
    tree = ast.parse(text)
    imported = {
        alias.name for q in tree.body if isinstance(q, ast.ImportFrom) for alias in q.names
    }
    assert imported <= {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}


def dimensionless(module, values):
    """Return the parameters in the units that the scene chooses."""
    mass, time, length = module.scales(*values)
    assert min(mass, time, length) > 0
    return [
        value / (mass**p * length**q * time**s)
        for value, (p, q, s) in zip(values, module.POWERS, strict=True)
    ]


def test_dimensionless_numbers_know_no_units(emitted):
    """The same oscillator in grams, feet and minutes has the same numbers without units."""
    made, module, numbers, _ = emitted
    units = (1e3, 3.28, 1 / 60)
    others = [
        value * np.prod(np.power(units, powers))
        for value, powers in zip(numbers, module.POWERS, strict=True)
    ]
    if made.name == "small" and "length" not in made.scales:
        assert module.scales(*others)[2] != module.scales(*numbers)[2]
    np.testing.assert_allclose(
        dimensionless(module, others), dimensionless(module, numbers), rtol=1e-13
    )


@pytest.mark.parametrize("name", tried(SCENES, every_run=("S0n", "S1", "S3b", "S4a", "S5b")))
def test_equations_in_these_units_have_numbers_of_moderate_size(name):
    made = SCENES[name][0]
    module = module_of(made)
    values = parameters_of(name)
    numbers = dimensionless(module, values)
    if made.frequency is not None:
        assert numbers[made.symbols.index(made.frequency)] == pytest.approx(1.0)
    found = [row for row in module.coefficients(*numbers) if any(row[1:])]
    assert found[0][0] == pytest.approx(1.0)


def test_units_that_a_scene_does_not_say_are_worked_out():
    def symbols(made):
        return scales(made)

    assert symbols(scene()) == (m, 1 / Omega, F / (Omega**2 * m))
    mass, time, length = symbols(belt())
    assert (mass, time) == (m, sp.sqrt(m / k))
    assert sp.simplify(length - belt().phases[0].held * time) == 0
    given = scene(scales={"mass": 2 * m, "time": sp.sqrt(m / k), "length": g})
    assert symbols(given) == (2 * m, sp.sqrt(m / k), g)
    assert symbols(scene(scales={"time": sp.sqrt(m / k)}))[2] == F / k


def test_forces_of_any_sign_make_a_length():
    real = sp.Symbol("F", real=True)
    amplitude = PARAMETERS[3].__class__("force", real, "N", -1.0, "force")
    phase = {"equation": m * a + k * x - real * forcing}
    parameters = tuple(q for q in PARAMETERS if q.name not in ("damping", "force"))
    made = scene(phase=phase, parameters=(*parameters, amplitude))
    assert scales(made)[2] == sp.Abs(real) / (Omega**2 * m)
    assert module_of(made).scales(1.0, 1.0, 2.0, 0.1, 0.5, -3.0) == (1.0, 0.5, 0.75)


def test_a_linear_phase_is_read_whatever_its_spelling():
    spelled = 2 * (m * a - F * (forcing - x * k / F)) + k * (g - v / Omega)
    used = tuple(q for q in PARAMETERS if q.name != "damping")
    made = scene(phase={"equation": spelled}, parameters=used)
    q = linear_phase(made.phases[0])
    expected = (2 * m, -k / Omega, 2 * k, -g * k, 2 * F)
    assert all(
        sp.simplify(one - two) == 0 for one, two in zip(q.coefficients, expected, strict=True)
    )
