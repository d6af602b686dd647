"""The conditions shown of each body, evaluated as they stand: those of the kernels."""

import re

import numpy as np
import pytest
import sympy as sp
from bodies import reference_bodies
from bodies.shown_bodies import Shown
from bodies.test_reference_bodies import start
from every_run import tried
from made_scenes import parameters

import nonsmooth as ns
from nonsmooth.codegen import scenes
from nonsmooth.codegen.equations import sections
from nonsmooth.codegen.printing.html import page_of
from nonsmooth.codegen.printing.latex import document_of
from nonsmooth.codegen.printing.text import text_of
from nonsmooth.scene import Body, Event, Phase, Scene
from nonsmooth.solver.scenes.case import Case

BODIES = tuple(scene for scene in map(scenes.load, scenes.names()) if scene.body is not None)

#: Few modes: quadrature is of what the fastest makes of a phase.
FEWER = {"beam-clearance": {"modes": 3}, "beam-impact": {"modes": 2}}

#: Of sums of some ten terms, as a part of what stands in them.
ROUNDING = 1e-12

CASES = {
    f"{scene.name} {method} {order}": (scene, method, order)
    for scene in BODIES
    for method in ("ck-tau", "hb", "hb-ck")
    for order in range(1, 6)
}
EVERY_RUN = (
    "absorber-friction ck-tau 3", "beam-clearance hb 2", "jenkins-absorber hb-ck 3",
    "chain-impact hb 1", "beam-clearance ck-tau 2",
)  # fmt: skip


def times_near(case: Case) -> np.ndarray:
    """Return times a little off those of the exact orbit, of a cell of the same length."""
    orbit = ns.exact(case)
    durations = np.array(orbit.cell_durations)
    off = durations * (1 + 0.02 * np.arange(len(durations)))
    return np.append(off * durations.sum() / off.sum(), orbit.angle + 0.05)


@pytest.mark.parametrize("name", tried(CASES, every_run=EVERY_RUN))
def test_conditions_shown_are_those_of_the_kernel(name: str) -> None:
    scene, method, order = CASES[name]
    case = ns.scene(scene.name)(**FEWER.get(scene.name, {}))
    shown = Shown(scene, case, method, order, 2, times_near(case))
    events, others = shown.rows()
    assert np.abs(others).max() <= ROUNDING * shown.size
    assert len(others) >= len(shown.record.blocks)
    assert events == pytest.approx(shown.residual[: len(events)], abs=1e-10)
    assert np.abs(events).max() > 1e-4  # at times of no orbit


#: Several contacts, with functions on several phases; nothing that forces; two cycles; dampers.
OTHERS = {
    f"{name} {method}": (name, method)
    for name in (
        *("two-stops-four-phases", "belt-2", "impact-2-two-cycles"),
        *("clearance-2-damped-contact", "chain-3-static-above-kinetic"),
    )
    for method in ("ck-tau", "hb", "hb-ck")
}
OTHERS_OF_EVERY_RUN = ("two-stops-four-phases hb", "belt-2 hb-ck", "impact-2-two-cycles hb")


@pytest.mark.parametrize("case", tried(OTHERS, every_run=OTHERS_OF_EVERY_RUN))
def test_so_they_are_of_other_bodies(case: str) -> None:
    name, method = OTHERS[case]
    r, own = reference_bodies.of(name), reference_bodies.case(name)
    times = start(r, 0.0)
    moved = 0.01 * times[0] if len(r.durations) > 1 else 0.0
    times[0] += moved
    times[-1] += 0.02 if r.angle is not None else 0.0
    if len(r.durations) > 1:
        times[1] -= moved
    shown = Shown(reference_bodies.scene(name), own, method, 3, 1, times)
    events, others = shown.rows()
    assert np.abs(others).max() <= ROUNDING * shown.size
    assert events == pytest.approx(shown.residual[: len(events)], abs=1e-10)
    assert np.abs(events).max() > 1e-4


def of_contacts(one: str, other: str) -> Scene:
    """Return a scene with a spring behind a gap at one contact and a damper at the other."""
    k, c, g, Omega = sp.symbols("k c g Omega", positive=True)
    K = sp.Matrix([[2, -1], [-1, 1]])
    at = {one: [1, 0], other: [0, 1]}
    body = Body(M=sp.eye(2), K=K, C=K / 20, forcing=[0, 0.3], at=at)
    first, second = body.at[one], body.at[other]
    damper, meets = second.force + c * second.v, Event(first.x - g)
    spring = first.force + k * (first.x - g)
    phases = (
        Phase("touch", (spring, damper), meets, {"it presses": first.x - g}),
        Phase("free", (first.force, damper), meets, {"nothing is met": g - first.x}),
    )
    own = parameters(
        stiffness=(k, "N/m", 5.0), damping=(c, "N s/m", 0.1), gap=(g, "m", 0.1),
        frequency=(Omega, "rad/s", 0.6),
    )  # fmt: skip
    return Scene("two", "two contacts", own, phases, body=body, frequency=Omega)


#: What is printed of the contacts: in LaTeX, and as text.
SIGNS = {
    ("a", "b"): (
        (r"f_{a, n}", r"\chi_{b, j}", "f_{a}(t)", "= b_{a}' q(t)", "x_{b}'(t)"),
        ("fₐ,ₙ", "χ_b,ⱼ", "fₐ(t)", "= bₐ'⋅q(t)", "x_b'(t)"),
    ),
    ("left", "right"): (
        (
            *(r"f^{\mathrm{left}}_{n}", r"\chi^{\mathrm{right}}_{j}"),
            *(r"f_{\mathrm{left}}(t)", r"= b_{\mathrm{left}}' q(t)"),
            r"x_{\mathrm{right}}'(t)",
        ),
        ("fˡᵉᶠᵗₙ", "χʳⁱᵍʰᵗⱼ", "f_left(t)", "= b_left'⋅q(t)", "x_right'(t)"),
    ),
}


@pytest.mark.parametrize("contacts", SIGNS)
def test_names_of_contacts_of_any_length_stand_below_or_above(
    contacts: tuple[str, str],
) -> None:
    typeset, drawn = SIGNS[contacts]
    shown = sections(of_contacts(*contacts))
    document = document_of(shown, "two contacts").replace("&", "")
    assert [sign for sign in typeset if sign not in document] == []
    assert [sign for sign in drawn if sign not in text_of(shown)] == []
    assert not re.search(r"_\{\w+\}_|'\}", document)  # a second index, a prime that is set low
    assert "merror" not in page_of(shown, "two contacts")
