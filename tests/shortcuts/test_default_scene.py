"""The paper's oscillator: its own methods, and beside them those of every scene."""

import json
from dataclasses import asdict
from pathlib import Path

import pytest
from refusals import refused

import nonsmooth as ns
from nonsmooth.solver.case import registry
from nonsmooth.solver.precision import digits
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
from nonsmooth.solver.solve import solve_case


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("stick-slip", "--method", "c1-tau", "--digits", 9), "--digits: expected beside"),
        (("stick-slip", "--no-shortcuts", "--c1-terms", 2), "--c1-terms: expected beside"),
    ],
)
def test_options_of_the_papers_methods_alone(run, arguments, words) -> None:
    assert words in refused(run, "solve", *arguments)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--methods", "c1,c1-tau"), "expected --no-shortcuts"),
        (("--methods", "c1-tau", "--vary", "mass=1:2:3"), "--vary: expected beside"),
    ],
)
def test_options_of_a_sweep_by_the_papers_methods_alone(run, arguments, words) -> None:
    assert words in refused(run, "sweep", *arguments)


@pytest.mark.parametrize("command", ["solve", "sweep"])
def test_help_says_that_a_scene_may_be_named(run, command: str) -> None:
    assert "Python" in run(command, "--help")[1]
    assert f"nonsmooth {command} [SCENE] [OPTIONS]" in run(command, "--help")[1]


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        (("--functions", "2"), "expected a SCENE"),
        (("--method", "ck-tau"), "'ck-tau' is not one of"),
    ],
)
def test_equations_that_need_a_scene(run, arguments, named) -> None:
    assert named in refused(run, "equations", *arguments)


def test_the_papers_equations_are_those_of_its_scene(run) -> None:
    equations = ("--method", "c1")
    assert run("equations", "stick-slip", *equations) == run("equations", *equations)


def test_an_orbit_of_another_scene_is_not_one_of_the_papers(run, tmp_path: Path) -> None:
    path = tmp_path / "orbit.json"
    run("solve", "impact", "--method", "c0-tau", "--order", 6, "-o", path)
    assert ns.load(path) == ns.solve(ns.scene("impact")(), "c0-tau", 6)


def test_without_a_scene_the_equations_are_those_of_the_paper() -> None:
    found = ns.equations("c1")
    assert found is ns.equations("c1")
    assert found.equation("18").functions  # of the paper's own kernel


def test_the_default_scene_keeps_the_papers_methods(run) -> None:
    plain = run("solve", "--order", 5)
    assert run("solve", "stick-slip", "--order", 5) == plain
    assert run("solve", "stick_slip", "--method", "ck", "--order", 5) == run(
        "solve", "--method", "c1", "--order", 5
    )
    assert run("sweep", "stick-slip", "--methods", "hb-ck", "--orders", 3) == run(
        "sweep", "--methods", "hb-c1", "--orders", 3
    )
    generic = json.loads(
        run("solve", "--no-shortcuts", "--method", "c1", "--order", 5, "--json")[1]
    )
    case = registry.load("stick-slip")()
    assert (
        generic["period"]
        == solve_case(case, "ck", 5).period
        != ns.solve(ns.StickSlip(**case.values), "c1", 5).period
    )
    for arguments in (("--method", "c1-tau"), ("--method", "ck-tau", "--no-shortcuts")):
        found = json.loads(run("solve", *arguments, "--order", 10, "--json")[1])
        assert (found["scene"], found["method"]) == ("stick-slip", "ck-tau")
        assert abs(found["errors"]["period"]) < 1e-12
    found = json.loads(
        run(
            "solve", "--method", "hb-c1", "--functions", 2, "--mass", 11, "--order", 4, "--json"
        )[1]
    )
    assert (found["functions"], found["parameters"]["mass"]) == (2, 11)
    assert "F_N = 400 N is assumed" in run("solve", "--method", "c1-tau")[1]
    assert "our choice" not in run("solve", "--method", "c1-tau", "--mass", 11)[1]


def test_the_belt_by_the_kernels_of_every_scene() -> None:
    belt = ns.StickSlip(**(asdict(DEFAULT) | {"mass": 12}))
    orbit = ns.solve(belt, method="c1-tau", order=10)
    assert isinstance(orbit, ns.SceneOrbit)
    assert dict(orbit.case.values) == asdict(belt)
    assert orbit.period == pytest.approx(ns.exact(belt).period, rel=1e-12)
    assert ns.solve(belt, "ck", 7).coefficients == ns.solve(belt, "c1", 7).coefficients
    assert isinstance(ns.solve(belt, "hb-ck", 5), ns.Orbit)
    assert isinstance(ns.solve(belt, "hb-c1", 5, functions=2), ns.SceneOrbit)
    assert isinstance(ns.solve(belt, "c1-tau", tol=1e-4), ns.SceneOrbit)
    assert isinstance(ns.sweep(belt, ["c1-tau"], [3]), ns.SceneSweep)
    assert isinstance(ns.sweep(belt, "hb-ck", [3]), ns.Sweep)
    with pytest.raises(ValueError, match="either the paper's or those of every scene"):
        ns.sweep(belt, ["c1", "c1-tau"], [3])
    with pytest.raises(ValueError, match="c1_terms"):
        ns.sweep(belt, ["c1-tau"], [3], c1_terms=2)
    assert isinstance(ns.exact(DEFAULT), ns.ExactOrbit)


def test_digits_of_it_by_the_kernels_of_every_scene(run, monkeypatch) -> None:
    monkeypatch.setattr(digits, "QUICK_ORDERS", (4,))
    status, out, _ = run("digits", "--no-shortcuts", "--quick")
    assert status == 0
    assert "alpha = 1e-6" in out
    assert "c1-tau" in out
