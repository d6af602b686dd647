"""Mistakes in a body: one line each, which names the argument."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from made_scenes import parameters

import nonsmooth as ns
from nonsmooth.cli.problems import Problem, as_problems
from nonsmooth.codegen.scene import Body, Event, Parameter, Phase, Scene, SceneError
from nonsmooth.codegen.scenes import jenkins_absorber
from nonsmooth.solver.scenes.parameter_error import ParameterError

g, k, Omega = sp.symbols("g k Omega", positive=True)

GOOD = {
    "M": np.eye(2),
    "K": [[2, -1], [-1, 1]],
    "ratio": 0.02,
    "forcing": [1, 0],
    "at": {"tip": [0, 1]},
}


OWN = parameters(spring=(k, "N/m", 10.0), gap=(g, "m", 0.5), frequency=(Omega, "rad/s", 0.9))


def scene(*more: Parameter, **body: object) -> Scene:
    made = Body(**(GOOD | body))  # type: ignore[arg-type]
    tip = next(iter(made.at.values()))
    law = tip.force + k * (tip.x - g)
    touching = Phase("touching", law, ends=Event(tip.x - g), demands={"it presses": tip.x - g})
    off = Phase("off", tip.force, ends=Event(tip.x - g), demands={"it is off": g - tip.x})
    return Scene(
        "bad-body", "a body", body=made, frequency=Omega, phases=(touching, off),
        parameters=(*OWN, *more),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ({"M": np.diag([1.0, -1.0])}, "body: M: it is not positive definite"),
        ({"M": np.diag([1.0, 0.0])}, "body: M: it is not positive definite"),
        ({"M": [[1, 1], [0, 1]]}, "body: M: it is not symmetric"),
        ({"K": [[2, -1], [0, 1]]}, "body: K: it is not symmetric, by 0.5 of the largest entry"),
        ({"K": [[2, -1], [-1.001, 1]]}, "; if this is rounding, use (K + K.T)/2"),
        ({"M": 1.0}, "body: M: got 1.0 of type float, expected a square matrix"),
        ({"M": None}, "body: M: got None of type NoneType, expected a square matrix"),
        ({"K": None}, "body: K: got None of type NoneType, expected 2 x 2"),
        ({"K": "eye"}, "body: K: got 'eye' of type str, expected 2 x 2"),
        ({"M": np.zeros((0, 0))}, "body: M: got 0 x 0 entries, expected a square matrix"),
        ({"M": np.ones((2, 3))}, "body: M: got 2 x 3 entries, expected a square matrix"),
        ({"K": [[1, 2], [3]]}, "body: K: expected rows of one length"),
        ({"K": [[None, 0], [0, None]]}, "body: K: expected numbers or expressions"),
        ({"K": np.eye(3)}, "body: K: got 3 x 3 entries, expected 2 x 2"),
        ({"M": [1, 2]}, "body: M: got"),
        ({"at": {"tip": [0, 1, 0]}}, "body: at 'tip': got 3 x 1 entries, expected 2 x 1"),
        ({"at": {"tip": [0, 0]}}, "body: at 'tip': expected numbers, not all zero"),
        ({"at": {}}, "body: at: expected a mapping"),
        ({"forcing": [0, 0]}, "body: forcing: got only zeros, on no degree of freedom"),
        ({"forcing": [1, 0, 0]}, "body: forcing: got 3 x 1 entries, expected 2 x 1"),
        ({"modes": 3}, "body: modes: got 3, expected a whole number, 1 to 2"),
        ({"modes": 1.5}, "body: modes: got 1.5"),
        ({"ratio": -0.1}, "body: ratio: got -0.1, expected a number not below 0"),
        ({"C": np.eye(2)}, "body: got C and ratio, expected one of them"),
        ({"K": [[np.nan, 0], [0, 1]]}, "body: K: expected real and finite numbers"),
        ({"K": np.array([[1j, 0], [0, 1]])}, "body: K: expected real and finite numbers"),
        ({"K": k * sp.eye(2) * sp.Symbol("h")}, "body: h is not a parameter of the scene"),
        ({"M": sp.eye(2) * k, "K": sp.eye(2) * k}, "which is not that of M"),
    ],
    ids=str,
)
def test_one_line_names_what_is_wrong(body: dict[str, object], words: str) -> None:
    with pytest.raises(SceneError) as caught:
        scene(**body)
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "given", [{"ratio": np.float64(0.02)}, {"ratio": Fraction(1, 50), "modes": np.int64(2)}]
)
def test_numbers_of_any_type_are_plain_in_kernels(given: dict[str, object]) -> None:
    usual, other = (ns.exact(ns.scene(scene(**q))()) for q in ({"ratio": 0.02}, given))
    assert other.durations == usual.durations


def test_a_law_says_what_the_force_is() -> None:
    good = scene()
    law = good.body.at["tip"].x - g
    with pytest.raises(SceneError, match="it says nothing of the force at tip"):
        replace(good, phases=(Phase("p", law, Event(law)), good.phases[1]))


@pytest.mark.parametrize("value", [g, k, sp.Integer(1)])
def test_what_a_velocity_jumps_to_is_one(value: sp.Expr) -> None:
    good = scene()
    tip = good.body.at["tip"]
    flight = Phase("off", tip.force, Event(tip.x - g, {tip.v: value}), {"it is off": g - tip.x})
    with pytest.raises(SceneError, match=f"phase off: jump: {value} is not a velocity"):
        replace(good, phases=(flight,))


def test_a_memory_knows_no_force() -> None:
    """It may jump where the memory is set."""
    good = jenkins_absorber.SCENE
    pair, (slider,) = good.body.at["joint"], good.memory
    words = "memory w: value: got force \\+ x, expected x, v, forcing and parameters"
    with pytest.raises(SceneError, match=words):
        replace(good, memory=(replace(slider, value=pair.x + pair.force),))


def test_modes_are_checked_with_the_parameters() -> None:
    beam = ns.scene("beam-clearance")
    with pytest.raises(ParameterError, match=r"modes: got 2\.5, expected a whole number"):
        ns.solve(beam(modes=2.5))


def test_impacts_that_the_modes_kept_cannot_turn_are_refused() -> None:
    """Of all modes any restitution is; of few an impulse of the whole body turns a part."""
    beam = ns.scene("beam-impact")
    words = r"go on as before, at 0\.073 of .*: keep more, or .* with more than 0\.079"
    with pytest.raises(ParameterError, match=words):
        ns.simulate(beam(modes=3, restitution=1e-3))
    assert beam(modes=3, restitution=0.08).cell.body.squares.size == 4
    assert beam(modes=60, restitution=1e-3).cell.body.squares.size == 60


def test_no_restitution_is_named_that_a_contact_cannot_have() -> None:
    """A light mass at the end of a row, of which the slowest modes move little."""
    K = 2 * np.eye(6) - np.eye(6, k=1) - np.eye(6, k=-1)
    light = np.diag([1, 1, 1, 1, 1, 0.02])
    body = Body(M=light, K=K, forcing=np.ones(6), at={"end": np.eye(6)[5]}, modes=2)
    end = body.at["end"]
    ends = Event(end.x - g, jump={end.v: -end.v / 2})
    phase = Phase("flight", end.force, ends=ends, demands={"before": g - end.x})
    own = parameters(gap=(g, "m", 0.1), frequency=(Omega, "rad/s", 0.3))
    made = Scene("light-end", "", own, (phase,), frequency=Omega, body=body)
    with pytest.raises(ParameterError, match=r"at 0\.72 of their velocity: keep more$"):
        ns.simulate(ns.scene(made)())


h = sp.Symbol("h", real=True)
EYE = sp.eye(2)


@pytest.mark.parametrize(
    ("matrices", "value", "words"),
    [
        ({"K": sp.Matrix([[2, -h], [-1, 1]])}, 2.0, "body: K: it is not symmetric with"),
        ({"M": sp.diag(h, 1)}, -1.0, "body: M: it is not positive definite with"),
        ({"M": sp.diag(h, 1)}, 0.0, "body: M: it is not positive definite with"),
        ({"K": EYE / h}, 0.0, r"body: an entry is no number .* \(float division by zero\)"),
        ({"K": EYE * sp.log(h)}, -1.0, r"body: an entry is no number .* \(math domain error\)"),
        ({"K": EYE * sp.sqrt(h)}, -1.0, "body: an entry is no number"),
    ],
    ids=str,
)
def test_parameters_that_spoil_a_matrix_are_refused(matrices, value: float, words: str) -> None:
    entry = Parameter("entry", h, "kg" if "M" in matrices else "", 1.0, "of a matrix")
    own = ns.scene(scene(entry, **matrices))
    with pytest.raises(ParameterError, match=words):
        ns.solve(own(entry=value))


@pytest.mark.parametrize("given", [("--ratio", 1), ("--modes", 2.5)])
def test_what_is_wrong_with_a_body_is_no_option(run, given) -> None:
    status, _, said = run("solve", "beam-impact", *given)
    assert status == 2
    assert said.startswith("nonsmooth: body: ")


def test_a_forcing_beyond_the_modes_that_are_kept_is_refused() -> None:
    """Those that are left out may resonate; of all there are none."""
    beam = ns.scene("beam-clearance")
    with pytest.raises(ParameterError, match="faster than all modes that are kept: keep more"):
        ns.solve(beam(modes=4, frequency=3300.0))
    assert beam(modes=4, frequency=3000.0).cell.body.squares.size == 4
    assert beam(modes=60, frequency=3300.0).cell.body.squares.size == 60


def test_a_scene_of_ones_own_is_solved_and_kept() -> None:
    """In SI units of steel: stiff, and displacements of micrometres."""
    K = 1e8 * np.array([[2.0, -1.0], [-1.0, 1.0]])
    own = ns.scene(scene(M=2 * np.eye(2), K=K, forcing=[50.0, 0.0]))
    orbit = ns.solve(own(spring=5e8, gap=1e-6, frequency=4000.0), order=10)
    assert orbit.admissible
    assert orbit.estimate.times < 1e-9
    again = ns.scene(scene(M=2 * np.eye(2), K=K, forcing=[50.0, 0.0]))
    assert again.folder == own.folder
    other = ns.scene(scene(M=2 * np.eye(2), K=1.001 * K, forcing=[50.0, 0.0]))
    assert other.folder != own.folder


def test_a_phase_without_an_eigenbasis_is_a_problem_of_the_body() -> None:
    """Its spring makes the damping critical: no option is wrong."""
    own = scene(M=np.eye(1), K=np.eye(1), ratio=2.0, forcing=[1], at={"tip": [1]})
    case = ns.scene(own)(spring=3.0, gap=0.05)
    with pytest.raises(Problem, match=r"^body: two of its poles"), as_problems():
        ns.exact(case)


@pytest.mark.parametrize("stiffness", [[[-9, 0.1], [0.1, 1]], [[-1e4, 1], [1, -1e4]]])
def test_a_motion_that_grows_beyond_floats_is_said_without_a_warning(
    stiffness: list[list[float]],
) -> None:
    falls = ns.scene(scene(K=stiffness))
    with pytest.raises(ns.NoOrbit, match="beyond float64"):
        ns.solve(falls(), order=10)


@pytest.mark.parametrize(
    ("name", "damping", "words"),
    [
        ("chain-impact", 1e150, "the motion in flight is beyond float64"),
        ("jenkins-absorber", 1e30, "two of its poles are one"),
    ],
)
def test_damping_beyond_floats_is_said_without_a_warning(
    name: str, damping: float, words: str
) -> None:
    with pytest.raises((ns.NoOrbit, ValueError), match=words):
        ns.exact(ns.scene(name)(damping=damping))
