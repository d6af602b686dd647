"""What float64 keeps of orbits of bodies, and the equations in balls that judge it."""

import math

import numpy as np
import pytest
from bodies.reference_bodies import Reference, case, references

pytest.importorskip("flint")

import flint

import nonsmooth as ns
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.bodies import exact_kernel
from nonsmooth.solver.precision import digits
from nonsmooth.solver.precision.bodies.frame import function, legendre
from nonsmooth.solver.precision.bodies.pieces import answers, moments
from nonsmooth.solver.precision.refine import refine

SCENES = tuple(name for name in registry.names() if registry.load(name).has_body)

#: Of a beam a few modes: of twenty each step in balls takes seconds.
FEW = {scene: {"modes": 6} for scene in SCENES if scene.startswith("beam")}

#: Where balls take seconds, for many modes.
COSTLY = {"all modes"}

EXTREMES = [
    pytest.param(
        case_,
        id=f"{scene}: {words or 'as given'}",
        marks=pytest.mark.long if words in COSTLY else [],
    )
    for scene in SCENES
    for words, case_ in digits.extremes(registry.load(scene)(**FEW.get(scene, {})))
]

#: Each law, an order of six phases, a body of poles that damping couples, one that nothing
#: forces.
EACH_LAW = {
    *("impact-3-not-proportional", "chain-3-static-above-kinetic", "jenkins-absorber"),
    *("two-stops-six-phases", "belt-2", "clearance-2-damped-contact"),
}

REFERENCES = [
    pytest.param(r, id=r.name, marks=[] if r.name in EACH_LAW else pytest.mark.long)
    for r in references()
]

#: Of each method its order and functions.
METHODS = {"exact": (0, None), "ck-tau": (6, None), "hb": (5, None), "hb-ck": (9, 2)}


def assert_kept(given, methods: tuple[str, ...] = ("hb", "hb-ck", "ck-tau")) -> None:
    """Hold the times of an orbit by the exact equations and by some methods against balls."""
    found = list(digits.at("", given, (10,), methods))
    assert [kept.method for kept in found] == ["exact", *methods]
    for kept in found:
        assert kept.status == "ok", kept
        assert kept.met, kept


@pytest.mark.parametrize("given", EXTREMES)
def test_the_times_keep_the_digits_that_the_orbit_leaves(given) -> None:
    assert set(registry.methods(given.scene)) == {"hb", "hb-ck", "ck-tau"}
    assert_kept(given)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("r", REFERENCES)
def test_solutions_in_balls_are_those_of_the_kernels(r: Reference, method: str) -> None:
    """And those of the exact equations the references, which are by other matrices."""
    own, (order, functions) = case(r.name), METHODS[method]
    times = np.array(r.durations) / own.units.time
    if r.angle is not None:
        times = np.append(times, r.angle)
    kernel = exact_kernel(own.cell)
    if order:
        kernel = registry.kernel(own.scene, method, functions)
    z = np.concatenate([np.zeros(kernel.size(order) - len(times)), times])
    status, *_ = kernel.iterate(kernel.given(own, order), z, 50)
    durations, _ = kernel.split(z)
    if status or np.min(durations) < 1e-6 * np.sum(durations):
        pytest.skip("of this order Newton's method finds none, or one without a phase")
    given = own.cell if method == "exact" else kernel.given(own, order)
    found = refine(kernel, given, kernel.times(z), 22, digits.in_balls(own, method))
    # Of two functions a switch rounding is 2e-13 to 2e-12 of the cell, by the processor.
    scale = (4e-12 if functions else 1e-12) * float(np.sum(times[: len(r.durations)]))
    assert [float(q) for q in found] == pytest.approx(list(kernel.times(z)), rel=0, abs=scale)
    if method == "exact":
        assert [float(q) for q in found] == pytest.approx(list(times), rel=0, abs=scale)
    assert all(float(q.rad()) < 1e-20 * scale * 1e12 for q in found)


@pytest.mark.parametrize("kappa", [0.0, 1e-9, 0.5 - 2j, -3 + 11.9j, -3 + 12.1j, -40 + 300j])
def test_moments_and_answers_are_those_of_their_equations(kappa: complex) -> None:
    """The moments by quadrature; of an answer p, ``p' - kappa p = P_n`` at three places."""
    with flint.ctx.workdps(80):
        found = moments(flint.acb(kappa), 5)
        for n, each in enumerate(found):
            by_panels = flint.acb.integral(
                lambda u, _, n=n: (kappa * u).exp() * (2 * u - 1).legendre_p(n), 0, 1
            )
            assert abs(each - by_panels) < 1e-20 * (1 + abs(by_panels))
            assert float(abs(each).rad()) < 1e-15
        if kappa == 0:
            return
        u = np.array([-0.3, 0.2, 0.9])
        for n, row in enumerate(answers(flint.acb(kappa), 4)):
            p = np.polynomial.Legendre([complex(q) for q in row])
            own = np.polynomial.Legendre([0.0] * n + [1.0])(u)
            if abs(kappa) > 0.1:  # else these have sizes that doubles do not subtract
                assert 2 * p.deriv()(u) - kappa * p(u) == pytest.approx(own, abs=1e-9)


@pytest.mark.parametrize("sign", [1, -1])
def test_functions_jump_in_one_derivative_and_repeat(sign: int) -> None:
    for n in range(1, 6):
        p = np.polynomial.Polynomial([float(flint.arb(q)) for q in function(n, sign).coeffs()])
        for order in range(n):
            own = p.deriv(order) if order else p
            jump = own(0.0) - sign * own(1.0)
            assert jump == pytest.approx(1.0 if order == n - 1 else 0.0, abs=1e-15)
        with flint.ctx.workdps(30):
            series = legendre(function(n, sign), flint.arb("0.25"), flint.arb("0.5"))
        found = np.polynomial.Legendre([float(series[j]) for j in range(len(series))])
        assert found(0.4) == pytest.approx(p(0.25 + 0.5 * 0.7))


def test_the_command_shows_them_of_what_moves_freely_too(run, tmp_path) -> None:
    status, out, _ = run("digits", "jenkins-absorber", "--orders", 5, "--methods", "ck-tau")
    assert status == 0
    assert "6 of 6 within" in out
    status, out, _ = run("digits", "chain-impact", "--quick", "--json")
    assert status == 0
    assert '"met": true' in out
    free = tmp_path / "free.py"
    free.write_text(FREE)
    status, out, _ = run("digits", free, "--orders", 10)
    assert status == 0
    assert "4 of 4 within" in out


FREE = """
import sympy as sp
from nonsmooth.scene import Body, Event, Parameter, Phase, Scene

m, k, F, Omega = sp.symbols("m k F Omega", positive=True)
PAIR = Body(
    M=sp.diag(m, m), K=k * sp.Matrix([[1, -1], [-1, 1]]), ratio=0.1,
    forcing=sp.Matrix([F, 0]), at={"end": [0, 1]},
)
END = PAIR.at["end"]
SCENE = Scene(
    "free-pair", "two masses on an elastic ground that may be left", body=PAIR, frequency=Omega,
    phases=(
        Phase("on", END.force + 4 * k * END.x, Event(END.x), {"pressed": END.x}),
        Phase("off", END.force + k * END.x / 4, Event(END.x), {"off": -END.x}),
    ),
    parameters=(
        Parameter("mass", m, "kg", 1.0, "each mass"),
        Parameter("stiffness", k, "N/m", 1.0, "between them"),
        Parameter("force", F, "N", 1.0, "amplitude"),
        Parameter("frequency", Omega, "rad/s", 0.6, "of the forcing"),
    ),
)
"""


def test_condition_leaves_out_what_is_a_whole_number() -> None:
    exact = ns.exact(ns.scene("beam-clearance")())
    assert math.isfinite(digits.condition(exact))
