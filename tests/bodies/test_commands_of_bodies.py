"""Commands on bodies: what they compute, and what they refuse."""

import json

import numpy as np
import pytest
from refusals import refused
from shown import ROOT

import nonsmooth as ns
from nonsmooth.solver.solve import solve_case
from nonsmooth.solver.trade.choice import size
from nonsmooth.solver.trade.tolerance import choose_order


@pytest.mark.parametrize("method", ["hb", "hb-ck", "hb-c1", "ck-tau"])
def test_methods_of_contact_forces(run, method: str) -> None:
    _, out, _ = run("solve", "absorber-friction", "--method", method, "--order", 9, "--json")
    document = json.loads(out)
    assert document["admissible"]
    assert document["method"] in (method, "hb-ck", "ck-tau")
    exact = ns.exact(ns.scene("absorber-friction")())
    own = [phase["duration"] for phase in document["phases"][:2]]
    assert own == pytest.approx(exact.durations[:2], rel=5e-2 if method == "hb" else 1e-3)


def test_a_sweep_has_all_methods_of_bodies(run) -> None:
    _, out, _ = run("sweep", "chain-impact", "--orders", "1,3", "--json")
    rows = json.loads(out)["rows"]
    assert {row["method"] for row in rows} == {"hb", "hb-ck", "ck-tau"}
    assert all(row["status"] == "ok" and row["errors"]["times"] < 1e-14 for row in rows)


@pytest.mark.parametrize("command", [("solve", "--order", 5), ("equations",)], ids=str)
@pytest.mark.parametrize("method", ["ck", "c2"])
def test_coordinates_are_not_expanded_and_it_says_why(run, command, method: str) -> None:
    name, *flags = command
    said = refused(run, name, "beam-clearance", *flags, "--method", method)
    assert "--method" in said
    assert "coordinates" in said
    assert "ck-tau" in said


@pytest.mark.parametrize("command", ["solve", "sweep", "tradeoff", "digits", "report"])
def test_a_body_without_an_eigenbasis_is_refused(run, tmp_path, command: str) -> None:
    flags = ("-o", tmp_path / "page") if command == "report" else ()
    said = refused(run, command, "absorber-friction", "--mass", 1e-30, *flags)
    assert said.startswith("nonsmooth: body: two of its poles are one")


def test_functions_of_harmonics_are_checked(run) -> None:
    said = refused(run, "solve", "chain-impact", "--method", "hb-ck", "--functions", 9)
    assert "functions" in said
    assert "1, 2, 3" in said


@pytest.mark.parametrize(
    ("name", "format_"),
    [("jenkins-absorber", "text"), ("beam-impact", "latex"), ("jenkins-absorber", "html")],
)
def test_equations_of_a_body(run, name: str, format_: str) -> None:
    status, out, _ = run("equations", name, "--format", format_)
    assert status == 0
    for words in ("dynamic compliance", "tested with", "the motion repeats", "mobility"):
        assert words in out


def test_a_diagram_and_basins_of_a_body(run) -> None:
    vary = ("--vary", "gap=0.4:0.6:3", "--transient", 10, "--cycles", 4, "--json")
    status, out, _ = run("simulate", "chain-impact", *vary)
    assert status == 0
    assert [len(each) for each in json.loads(out)["states"]] == [4, 4, 4]
    grid = ("--grid", "x=-0.5:0:2", "--grid", "v=0:0.5:2", "--cycles", 40)
    status, out, _ = run("simulate", "chain-impact", *grid, "--json")
    assert status == 0
    assert np.shape(json.loads(out)["index"]) == (2, 2)


def test_documents_files_and_families_of_a_body(run, tmp_path) -> None:
    _, out, _ = run("solve", "chain-impact", "--method", "ck-tau", "--order", 2, "--json")
    document = json.loads(out)
    assert document["admissible"]
    orbit = ns.solve(ns.scene("chain-impact")(), order=2)
    assert document["phases"][0]["duration"] == orbit.phases[0].duration
    ns.save(orbit, tmp_path / "orbit.json")
    assert ns.load(tmp_path / "orbit.json").durations == orbit.durations
    rows = ns.family(orbit.case, "gap", [0.4, 0.5], order=2).rows
    assert [row.status for row in rows] == ["ok", "ok"]
    assert rows[1].forcing_phase == pytest.approx(orbit.forcing_phase, abs=1e-12)


@pytest.mark.parametrize("scene", ["beam-clearance", "jenkins-absorber"])
def test_orders_that_are_not_judged_have_the_errors_of_their_orbits(scene: str) -> None:
    case, tol = ns.scene(scene)(), 1e-6
    choice = choose_order(case, tol)
    assert size(choice.orbit.errors) <= tol
    refused = [q for q in choice.trials if size(q.estimate) > tol]
    assert refused
    assert max(q.order for q in refused) == choice.orbit.order - 1
    for trial in refused:
        errors = solve_case(case, order=trial.order).errors
        assert size(trial.estimate) == pytest.approx(size(errors), rel=1e-6)


def test_a_scene_file_follows_the_matrices_that_it_reads(run, tmp_path) -> None:
    gone = 'first_stiffness", k_1', 'second_stiffness", k_2'
    text = (ROOT / "examples/scenes/two_masses.py").read_text("utf-8")
    matrix, read = (
        "sp.Matrix([[k_1 + k_2, -k_2], [-k_2, k_2]])",
        f"np.load({str(tmp_path / 'K.npy')!r})",
    )
    assert matrix in text
    lines = ["import numpy as np", *text.replace(matrix, read).splitlines()]
    file = tmp_path / "own.py"
    file.write_text("\n".join(q for q in lines if not any(name in q for name in gone)), "utf-8")
    phases = []
    for stiffness in (1.0, 1.2):
        np.save(tmp_path / "K.npy", stiffness * np.array([[2.0, -1.0], [-1.0, 1.0]]))
        _, out, _ = run("solve", file, "--method", "ck-tau", "--order", 2, "--json")
        phases.append(json.loads(out)["forcing_phase"])
    assert abs(phases[1] - phases[0]) > 0.01
