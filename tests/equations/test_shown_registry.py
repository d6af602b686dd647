"""Scenes and expansions by name, in Python and in the command; the jumps of a scene."""

import random
from pathlib import Path

import pytest
import sympy as sp
from every_run import tried
from shown_scenes import EVERY_RUN, SCENES

import nonsmooth as ns
from nonsmooth.codegen.equations import derive_scene, scene_equations, scene_named
from nonsmooth.codegen.equations.conditions.functions import Rate
from nonsmooth.codegen.equations.registry import conditions, methods
from nonsmooth.codegen.scene import Scene, forcing, switches, v, x
from nonsmooth.codegen.scene.smoothness import place
from nonsmooth.codegen.scenes import impact, names, stick_slip


def test_every_scene_and_expansion_of_the_folders_is_found() -> None:
    folder = Path(impact.__file__).parent
    assert len(names()) == len([q for q in folder.glob("*.py") if q.stem != "__init__"])
    assert set(methods(impact.SCENE)) == {"hb", "hb-ck", "ck", "ck-tau"}
    assert set(methods(stick_slip.SCENE)) - set(methods(impact.SCENE)) == {"hb-c1"}


@pytest.mark.parametrize("method", ["ck-tau", "c0-tau"])
def test_a_method_has_two_names(method: str) -> None:
    found = ns.equations(method, scene="impact")
    assert (found.method, found.section) == ("c0-tau", "3.3")
    assert found.equations == derive_scene(impact.SCENE, method).equations
    assert found is ns.equations(method, scene="impact")


def test_a_scene_without_its_formulas_is_refused() -> None:
    with pytest.raises(ValueError, match=r"scene: got <scene impact.*, expected its name, the"):
        ns.equations("ck", scene=ns.scene("impact"))


@pytest.mark.parametrize(("functions", "count"), [(None, 2), (1, 1), (3, 3)])
def test_the_number_of_functions_is_two_at_an_impact_or_what_is_asked(
    functions: int | None, count: int
) -> None:
    found = conditions(impact.SCENE, "hb-ck", functions)
    assert [block.name for block in found.blocks if block.name.startswith("c")] == [
        f"c{n}_flight" for n in range(2, 2 + count)
    ]


#: Beginnings of the rows that have a number of the paper, in its scene and in each method.
NUMBERED = {
    "": {
        "1": ["equation of motion in stick", "equation of motion in slip"],
        "2": ["the velocity is held in stick", "demanded in stick"],
    },
    "hb": {
        "3": ["expansion"],
        "4": ["residual in stick", "residual in slip"],
        "8": ["inner product"],
        "5": ["residual, orthogonal to the constant"],
        "6": ["residual, orthogonal to `sin"],
        "7": ["residual, orthogonal to `cos"],
        "10": ["the event that ends slip"],
    },
    "hb-c1": {
        "11": ["expansion"],
        "12": ["function in stick", "function in slip"],
        "13": ["residual in stick", "residual in slip"],
        "8": ["inner product"],
        "5": ["residual, orthogonal to the constant"],
        "6": ["residual, orthogonal to `sin"],
        "7": ["residual, orthogonal to `cos"],
        "14": ["residual, orthogonal to the function itself"],
        "10": ["the event that ends slip"],
    },
    "c1": {
        "16": ["expansion in stick", "expansion in slip"],
        "15": ["acceleration in slip"],
        "17": ["residual in slip"],
        "18": ["residual of slip, orthogonal to its tests"],
        "19": ["displacement is continuous where stick begins"],
        "20": ["velocity is continuous where stick begins"],
        "9": ["the displacement where stick begins"],
        "10": ["the event that ends slip"],
    },
}


@pytest.mark.parametrize("method", NUMBERED)
def test_the_equations_of_the_paper_have_its_numbers(method: str) -> None:
    scene = stick_slip.SCENE
    rows = derive_scene(scene, method).equations if method else scene_equations(scene)
    found: dict[str, list[str]] = {}
    for row in rows:
        if row.number:
            found.setdefault(row.number, []).append(row.title)
    expected = NUMBERED[method]
    assert found.keys() == expected.keys()
    for number, titles in expected.items():
        for title, begins in zip(found[number], titles, strict=True):
            assert title.startswith(begins)


@pytest.mark.parametrize(
    ("scene", "numbers"),
    [
        ("impact", {"18"}),  # of class C^0
        ("clearance", {"18"}),  # C^2
        ("stick-slip-damped", {"15", "16", "17", "18", "19", "20"}),  # C^1
    ],
)
def test_numbers_of_c1_functions_are_where_a_motion_is_c1(
    scene: str, numbers: set[str]
) -> None:
    assert {q.number for q in derive_scene(scene, "ck").equations} - {""} == numbers
    assert not any(q.number for q in scene_equations(scene_named(scene)))


SCENE_FILE = """
import sympy as sp
from nonsmooth.codegen.scene import Event, Parameter, Phase, Scene, a, v, x

m, k, g = sp.symbols("m k g", positive=True)
SCENE = Scene(
    "ball", "a ball on a spring & a floor",
    (
        Parameter("mass", m, "kg", 1.0, "mass"),
        Parameter("stiffness", k, "N/m", 1.0, "stiffness"),
        Parameter("gravity", g, "m/s^2", 9.81, "gravity"),
    ),
    (Phase("air", m*a + k*x + m*g, Event(x{more}, jump={{v: -v}})),),
    scales={{"length": m*g/k}},
)
"""


def test_a_scene_from_a_file(run, tmp_path: Path) -> None:
    path = tmp_path / "ball.py"
    path.write_text(SCENE_FILE.format(more=""))
    status, out, err = run("equations", path, "--method", "c0", "--format", "latex")
    assert (status, err) == (0, "")
    assert r"Galerkin equations of a ball on a spring \& a floor" in out
    assert r"gravity in m/s\textasciicircum{}2" in out
    path.write_text(SCENE_FILE.format(more="**2"))
    status, out, err = run("equations", path)
    assert (status, out) == (2, "")
    assert "phase air: ends" in err
    assert err.count("\n") == 1


def test_a_jump_into_a_phase_that_is_held() -> None:
    """The place and the law are said, and an event of the forcing alone as one writes it."""
    scene = scene_named("impact-inelastic")
    rows = [" ".join(q.text(unicode=False).split()[1:]) for q in scene_equations(scene)]
    for text in (
        "the displacement is held in rest; t1 <= t < T x(t) = g",
        "demanded in rest: the mass is pressed on to the stop F*cos(Omega*t + phi) >= g*k",
        "the velocity jumps where flight ends x'(t1^+) = 0",
        "rest ends F*cos(Omega*T + phi) = g*k",
        "small perturbation xi of the displacement where flight ends xi(t1^+) = 0",
    ):
        assert text in rows, text


def test_the_command_shows_a_scene_and_all_its_methods(run) -> None:
    status, out, _ = run("equations", "impact")
    assert status == 0
    assert all(f"({name})" in out for name in ("hb", "hb-c0", "c0", "c0-tau"))


def slopes(scene: Scene, p: int, state: dict[sp.Symbol, sp.Expr], order: int) -> list[sp.Expr]:
    """Return displacement and derivatives in phase `p`, from its equation of motion."""
    phase, t = scene.phases[p], sp.Symbol("time")
    a = sp.Symbol("a", real=True)
    force = sp.cos(sp.Symbol("w") * t + sp.Symbol("f"))
    functions = [state[x], state[v]]
    acceleration = sp.solve(phase.equation, a)[0]
    rates = acceleration.subs(forcing, force)
    for _ in range(order - 1):
        now = {x: state[x], v: state[v]}
        functions.append(rates.subs(now))
        rates = (
            rates.diff(t)
            + rates.diff(x) * v
            + rates.diff(v) * acceleration.subs(forcing, force)
        )
    return [q.subs({t: 0}) for q in functions[: order + 1]]


@pytest.mark.parametrize("scene", tried(SCENES, every_run=EVERY_RUN))
def test_the_jump_at_each_switch_is_that_of_the_equations_of_motion(scene: str) -> None:
    found = scene_named(SCENES[scene])
    drawn = random.Random(3)
    values = {symbol: sp.Float(drawn.uniform(0.5, 1.5), 30) for symbol in found.symbols}
    shown = [q for q in scene_equations(found) if "derivative jumps" in q.title]
    angle = sp.Float(0.7, 30)
    for p, (switch, row) in enumerate(zip(switches(found), shown, strict=True)):
        if switch.k == 0:
            continue
        left, sign = found.phases[p - 1], found.sign if p == 0 else 1
        state = {x: sp.Float(0.4, 30), v: sp.Float(0.3, 30), forcing: sp.cos(angle)}
        if left.held is not None:
            state[v] = sign * sp.sympify(left.held).subs(values)
        if place(found, (p - 1) % len(found.phases)) is not None:
            state[x] = sign * place(found, (p - 1) % len(found.phases)).subs(values)
        before = {x: sign * x, v: sign * v, forcing: sign * forcing}
        known = values | {q.symbol: sp.Float(0.25, 30) for q in found.memory}
        zero = left.ends.zero.subs(before, simultaneous=True).subs(known)
        pivot = next(q for q in (x, v, forcing) if zero.has(q))
        state[pivot] = sp.solve(
            zero.subs({q: e for q, e in state.items() if q != pivot}), pivot
        )[0]
        angle = sp.acos(state[forcing])
        known |= {q.symbol: q.value.subs(state) for q in found.memory if q.at == switch.before}
        mirrored = {q: sign * e for q, e in state.items()}
        now = {
            sp.Symbol("f"): angle,
            sp.Symbol("w"): values.get(found.frequency, sp.Integer(0)),
        }
        turned = now | {sp.Symbol("f"): angle if sign == 1 else angle + sp.pi}
        right = [q.subs(known).subs(now) for q in slopes(found, p, state, switch.jumps)]
        other = [
            sign * q.subs(known).subs(turned)
            for q in slopes(found, p - 1, mirrored, switch.jumps)
        ]
        jumps = [float(a - b) for a, b in zip(right, other, strict=True)]
        assert jumps[:-1] == pytest.approx([0.0] * switch.jumps, abs=1e-12)
        size = row.sides[1]
        at = {q: state[x] if q.func.__name__ == "x" else state[v]
              for q in size.atoms(Rate, sp.core.function.AppliedUndef)}  # fmt: skip
        waves = {
            q: sp.cos(angle) if q.func == sp.cos else sp.sin(angle)
            for q in size.atoms(sp.cos, sp.sin)
        }
        assert float(size.subs(at).subs(waves).subs(known)) == pytest.approx(
            jumps[-1], rel=1e-9
        )
        assert abs(jumps[-1]) > 1e-6
