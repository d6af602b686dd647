"""Systems that no scene can be are refused in one line: what is so, and what to use instead."""

import random
import string
from dataclasses import replace

import pytest
import sympy as sp
from small_scene import FLIGHT, F, Omega, a, c, forcing, g, k, m, r, refused, scene, v, x

from nonsmooth.cli import cli
from nonsmooth.codegen.scene import t
from nonsmooth.codegen.scene.checks.names import COMMANDS
from nonsmooth.codegen.scene.error import INSTEAD

MOTION = FLIGHT.equation
FREE = m * a + c * v + k * x
OWN_TIME, OWN_X = sp.Symbol("t"), sp.Function("x")
x2, v2, y = sp.symbols("x2 v2 y", real=True)

NOT_LINEAR, VARIES, BRANCH = "is not linear in ", "varies with time", "a phase of its own"
ANOTHER, ONE_COSINE = "if it is a coordinate of another mass", "in another way than one cosine"
PLACE = "which enters by forcing alone: expected forcing in place of "

#: The equation of motion, what is said of it, and whether something else is to be used for it.
EQUATIONS = {
    "Duffing": (MOTION + k * x**3 / g**2, f"k*x**3/g**2 {NOT_LINEAR}x;", True),
    "quadratic spring": (MOTION + k * x**2 / g, f"{NOT_LINEAR}x;", True),
    "drag": (MOTION + m * v * sp.Abs(v) / g, f"m*v*Abs(v)/g {NOT_LINEAR}v;", True),
    "van der Pol": (MOTION + c * v * (x**2 / g**2 - 1), f"{NOT_LINEAR}x and v;", True),
    "pendulum": (MOTION + F * sp.sin(x / g), f"F*sin(x/g) {NOT_LINEAR}x;", True),
    "pendulum with an angle": (MOTION + F * sp.sin(x), f"F*sin(x) {NOT_LINEAR}x;", True),
    "smoothed friction": (MOTION + F * sp.tanh(v / (g * Omega)), f"{NOT_LINEAR}v;", True),
    "attraction": (MOTION - F * g**2 / (g - x) ** 2, f"{NOT_LINEAR}x;", True),
    "geometry": (MOTION + k * sp.sqrt(x**2 + g**2), f"{NOT_LINEAR}x;", True),
    "a mass that depends on x": (MOTION + m * a * x / g, f"m*x/g {NOT_LINEAR}x and a;", True),
    "steps": (MOTION + F * sp.floor(x / g), f"{NOT_LINEAR}x;", True),
    "a force squared": (MOTION - F * forcing**2, f"{NOT_LINEAR}forcing;", True),
    "friction": (MOTION + F * sp.sign(v), f"F*sign(v) {NOT_LINEAR}v: give each", False),
    "two springs": (MOTION + k * sp.Abs(x), f"each branch of Abs {BRANCH}", False),
    "a clearance": (MOTION + k * sp.Max(0, x - g), f"each branch of Max {BRANCH}", False),
    "a stop": (
        MOTION + sp.Piecewise((k * (x - g), x > g), (0, True)),
        f"each branch of Piecewise {BRANCH}",
        False,
    ),
    "a step": (MOTION + k * (x - g) * sp.Heaviside(x - g), f"Heaviside {BRANCH}", False),
    "a square wave": (FREE - F * sp.sign(forcing), f"each branch of sign {BRANCH}", False),
    "Mathieu": (MOTION + k * r * forcing * x, "x has the coefficient forcing*k*r", True),
    "Mathieu in t": (MOTION + k * r * sp.cos(Omega * t) * x, VARIES, True),
    "Mathieu in its own t": (MOTION + k * r * sp.cos(Omega * OWN_TIME) * x, VARIES, True),
    "Hill": (MOTION + k * r * sp.sign(sp.sin(Omega * t)) * x, "x has the coeff", True),
    "a damper that varies": (MOTION + c * sp.exp(-Omega * t) * v, "v has the coeff", True),
    "a mass that is lost": (MOTION + m * a * sp.exp(-Omega * t), "a has the coeff", True),
    "a cosine": (FREE - F * sp.cos(Omega * t), f"{PLACE}cos(Omega*t)", False),
    "a sine": (FREE - F * sp.sin(Omega * OWN_TIME + 1), f"{PLACE}sin(Omega*t + 1)", False),
    "both": (
        FREE - F * sp.cos(Omega * t) - k * g * sp.sin(Omega * t),
        f"{PLACE}cos(Omega*t)",
        False,
    ),
    "two frequencies": (MOTION - F * sp.cos(2 * Omega * t), ONE_COSINE, True),
    "two harmonics": (FREE - F * sp.cos(Omega * t) - F * sp.cos(3 * t), ONE_COSINE, True),
    "a sawtooth": (FREE - F * sp.frac(Omega * t), ONE_COSINE, True),
    "a sawtooth by division": (FREE - F * sp.Mod(Omega * t, 2), ONE_COSINE, True),
    "a square wave in t": (FREE - F * sp.sign(sp.sin(Omega * t)), ONE_COSINE, True),
    "a ramp": (FREE - F * Omega * t, ONE_COSINE, True),
    "a decaying force": (
        FREE - F * sp.exp(-Omega * t) * sp.cos(Omega * t),
        ONE_COSINE,
        True,
    ),
    "two masses": (MOTION - k * x2, f"x2 is not a parameter of the scene; {ANOTHER}", True),
    "two masses and a damper": (
        FREE - c * v2,
        f"v2 is not a parameter of the scene; {ANOTHER}",
        True,
    ),
    "a plane": (MOTION + k * y, f"y is not a parameter of the scene; {ANOTHER}", True),
    "two equations": ([MOTION, FREE], "got a list, expected one expression;", True),
    "matrices": (sp.Matrix([MOTION, FREE]), "expected one expression;", True),
    "a delay": (MOTION + k * OWN_X(t - g / F), "got x(t - g/F), expected the symbols", True),
    "memory of all": (
        MOTION + k * Omega * sp.Integral(OWN_X(t), t),
        "got Integral(x(t), t), expected the symbols",
        True,
    ),
    "a first order": (c * v + k * x - F * forcing, "has no acceleration a;", True),
    "a parameter": (MOTION + sp.Symbol("stiff") * x, "stiff is not a parameter of", False),
    "units": (MOTION + k * v, "units clash", False),
    "derivatives": (
        m * sp.Derivative(OWN_X(t), t, t) + k * x,
        "expected the symbols x, v, a and forcing",
        False,
    ),
}


@pytest.mark.parametrize("what", EQUATIONS)
def test_what_cannot_be_is_said_and_what_to_use(what: str) -> None:
    equation, words, instead = EQUATIONS[what]
    message = refused(
        lambda: scene(phase={"equation": equation}), "phase flight: equation: ", words
    )
    assert message.endswith(INSTEAD) == instead
    assert not ("units" in message and what != "units")
    assert len(message) < 480


def test_of_a_held_phase_the_equation_is_said() -> None:
    rest = replace(FLIGHT, name="rest", equation=v, held=0)
    words = "v has no acceleration a; of a phase that is held, expected a"
    refused(lambda: scene(phases=(FLIGHT, rest)), "phase rest: equation: ", words)


@pytest.mark.parametrize(
    ("zero", "words"),
    [
        (t - 2 * sp.pi / Omega, ONE_COSINE),
        (k * x**2 / 2 - F * g, f"{NOT_LINEAR}x; {INSTEAD}"),
        (x - x2, f"x2 is not a parameter of the scene; {ANOTHER}"),
        (sp.Abs(x) - g, BRANCH),
    ],
    ids=str,
)
def test_events_of_another_kind(zero: sp.Expr, words: str) -> None:
    refused(lambda: scene(ends={"zero": zero}), "phase flight: ends: ", words)


@pytest.mark.parametrize("demand", [g**2 - x**2, g - sp.Max(x, -x), g * forcing * x], ids=str)
def test_demands_of_another_kind(demand: sp.Expr) -> None:
    words = "expected a linear form, or a bound - Abs(...)"
    make = lambda: scene(phase={"demands": {"right": demand}})  # noqa: E731
    assert refused(make, "phase flight: demand 'right': ", NOT_LINEAR).endswith(words)


def random_term(draw: random.Random) -> tuple[sp.Expr, bool]:
    """Return a force made of the state, and whether it is linear in it."""
    weight = draw.choice([k * g, F])
    odd = draw.randrange(4)
    one, other = (draw.choice([x / g, v / (g * Omega), a * m / F]) for _ in range(2))
    if odd == 0:
        return weight * (one + draw.randint(1, 3) * other), True
    if odd == 1:
        return weight * one * other, False
    if odd == 2:
        return weight * draw.choice([sp.sin, sp.exp, sp.Abs, sp.sign])(one + other), False
    return weight * one * draw.choice([forcing, sp.cos(draw.randint(1, 4) * Omega * t)]), False


@pytest.mark.parametrize("seed", [*range(12), pytest.param(200, marks=pytest.mark.long)])
def test_random_equations_are_accepted_if_linear_and_else_refused(seed: int) -> None:
    draw = random.Random(seed)
    for _ in range(max(1, seed // 2 - 50)):
        term, linear = random_term(draw)
        make = lambda term=term: scene(phase={"equation": MOTION + term})  # noqa: E731
        if linear:
            assert make().phases[0].equation == MOTION + term
        else:
            message = refused(make, "phase flight: equation: ")
            assert any(q in message for q in (INSTEAD, BRANCH)), message


#: Names that a command line would not take for a scene, or for another thing.
NAMES = (
    *("", "--help", "-x", "--", "a/b", "../a", "a b", "a\n", "a\tb", "A", "Ball", "2-balls"),
    *("ball_2", "ball.py", "é", "ball\x00", "class", "a" * 30 + "/", "=", "[scene]", "$HOME"),
    *sorted(COMMANDS),
)


@pytest.mark.parametrize("name", NAMES)
def test_names_that_no_scene_has(name: str) -> None:
    refused(lambda: scene(name=name), f"name: got {name!r}, ")


def test_names_by_chance() -> None:
    draw = random.Random(5)
    letters = string.ascii_lowercase
    for _ in range(200):
        name = "".join(draw.choices(letters[:2] + "0-_/ A\n", k=draw.randint(1, 4)))
        if name[0] in letters and set(name) <= {*letters, *string.digits, "-"}:
            assert scene(name=name).name == name
        else:
            refused(lambda name=name: scene(name=name), "name: got ", "lower-case letters")


def test_the_commands_whose_names_are_refused_are_all() -> None:
    assert {*cli.commands} <= COMMANDS
