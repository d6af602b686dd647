"""Commands of a scene: what is printed, as a table and as JSON, and what is refused."""

import csv
import json
import math
from contextlib import nullcontext
from pathlib import Path

import numpy as np
import pytest
from printed_table import KEYS
from refusals import refused

import nonsmooth as ns
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.solve import solve_case

CASE = "[impact]\nmass = 2\ndamping = 0.1\nstiffness = 3\nforce = 1.5\nfrequency = 2.2\n"


def test_the_list_of_scenes(run) -> None:
    status, out, err = run("scenes")
    assert (status, err) == (0, "")
    for name in registry.names():
        scene = registry.load(name)
        (line,) = [q for q in out.splitlines() if q.split()[0] == name]
        assert line.split()[1] == f"C{scene.k}"
        orders = (", ".join(motion.phases) for motion in scene.each_motion)
        assert "; ".join(orders) in line
    assert max(map(len, out.splitlines())) <= 80
    _, out, _ = run("scenes", "--json")
    document = json.loads(out)
    assert document["schema"] == 2
    assert [each["name"] for each in document["scenes"]] == list(registry.names())
    assert [set(each) for each in document["scenes"]] == [
        {"name", "what", "class", "phases", "motions"}
    ] * len(registry.names())


def test_what_a_scene_is(run) -> None:
    _, out, _ = run("scenes", "stick_slip_damped")
    words = " ".join(out.split())
    for text in (
        "stick-slip-damped: a damped mass on a moving belt, with weakening friction (C1)",
        "--belt-speed V m/s 1 speed of the belt; a positive number",
        "--damping c N s/m 5 viscous damping; a number not below 0",
        "expected: mu_k is at most mu_s",
        "stick: x' = V begins C1: x'' jumps ends -K x + F_N*mu_s - V*c = 0 demands",
        "demands K x + F_N*mu_s + V*c >= 0 (the load stays within the static limit)",
        "slip: M x'' + (-F_N*w + c) x' + K x = -F_N*(V*w - mu_k) begins C1: x'' jumps",
        "ends x' - V = 0 demands -x' + V >= 0 (the mass stays slower than the belt)",
        "methods: hb, hb-c1 (K = 1, 2, 3), c1, c1-tau",
    ):
        assert text in words, text
    assert max(map(len, out.splitlines())) <= 80
    words = " ".join(run("scenes", "impact-inelastic")[1].split())
    assert "ends x - g = 0, then x' -> 0 demands" in words
    assert "rest: x' = 0 begins C0: x' jumps" in words
    document = json.loads(run("scenes", "impact", "--json")[1])
    (phase,) = document["phases"]
    assert phase["equation"] == "m x'' + c x' + k x = F cos(Omega t + phi)"
    assert phase["ends"] == "x - g = 0"
    assert phase["jump"] == "x' -> -r x'"
    begins = {"class": "C0", "jumps": "x'", "class_of_defaults": "C0"}
    assert phase["begins"] == begins
    assert phase["demands"][0] == {
        "what": "the mass stays before the stop",
        "expression": "-x + g >= 0",
    }
    assert document["frequency"] == "frequency"
    by_name = {q["name"]: q for q in document["parameters"]}
    assert by_name["restitution"]["most"] == 1
    assert by_name["gap"]["bound"] == ""
    assert by_name["gap"]["default"] == 0.1


def test_solve_of_a_scene_says_whether_it_is_stable_and_what_its_headings_mean(run) -> None:
    status, out, err = run("solve", "impact", "--gap", 0.2, "--order", 6)
    assert (status, err) == (0, "")
    assert "g = 0.2 m" in out
    assert "exact: multipliers 0.45284 +- 0.22105i of modulus 0.50391: stable" in out
    for heading in ("T:", "phi:", "times:", "x':", "estimate:", "it:"):
        assert heading in out


def test_a_document_has_the_fixed_keys_and_the_numbers_of_the_solver(run) -> None:
    status, out, _ = run("solve", "impact", "--method", "c0-tau", "--order", 9, "--json")
    document = json.loads(out)
    assert status == 0
    assert list(document) == KEYS
    orbit = solve_case(registry.load("impact")(), "ck-tau", 9)
    assert document["method"] == "ck-tau"
    assert document["period"] == orbit.period
    assert document["forcing_phase"] == orbit.forcing_phase
    assert document["errors"]["times"] == orbit.errors.times
    assert document["units"]["gap"] == "m"
    assert document["phases"][0]["start"]["velocity"] == orbit.phases[0].velocity
    found = [complex(q["re"], q["im"]) for q in document["multipliers"]]
    assert found == orbit.multipliers.tolist()
    assert document["stable"] is True
    several = json.loads(run("solve", "impact", "--order", 4, "--json")[1])
    assert several["scene"] == "impact"
    assert [q["method"] for q in several["orbits"]] == ["hb", "hb-ck", "ck", "ck-tau"]
    assert several["mathematics"] != document["mathematics"]


@pytest.mark.parametrize(
    ("command", "more"), [("branch", ""), ("map", ":2 --vary force=1:2:2"), ("simulate", ":2")]
)
def test_a_parameter_that_varies_is_told_by_its_range(
    run, monkeypatch, command: str, more: str
) -> None:
    # here alone is quicker
    monkeypatch.setattr("nonsmooth.cli.scenes.branch.pool", nullcontext)
    _, out, _ = run(command, "impact", *f"--vary gap=0.2:0.3{more}".split())
    assert "g = 0.2 to 0.3 m\n" in out
    assert "g = 0.1 m" not in out
    assert ("F = 1 N," in out) is not ("F = 1 to 2 N\n" in out)


@pytest.mark.parametrize("json_", [False, True])
def test_no_orbit_is_status_1_with_its_reason(run, json_) -> None:
    more = ("--json",) if json_ else ()
    status, out, err = run("solve", "impact", "--gap", 5, "--method", "ck", "--order", 7, *more)
    assert status == 1
    first, instead, below = err.splitlines()
    assert instead.startswith(
        "  the mass can move in flight for ever, without switches, |x| up"
    )
    assert (
        first == "nonsmooth: impact: no such orbit exists: its equations have no real solution"
    )
    assert below == "  a simulation comes to a motion without switches"
    if not json_:
        assert [line.split() for line in out.splitlines() if line.startswith("c0")] == [
            ["c0", "no-orbit"]
        ]
        return
    document = json.loads(out)
    assert set(document) == {*KEYS, "status"}
    assert document["status"] == "no-orbit"
    assert document["converged"] is False
    assert document["iterations"] == 0  # nothing was searched for
    for key in ("period", "forcing_phase", "residual_norm", "coefficients"):
        assert document[key] is None
    assert document["parameters"]["gap"] == 5
    (why,) = document["violations"]
    assert f"nonsmooth: {why}" == f"{first};{instead[1:]};{below[1:]}"


def test_of_no_orbits_no_table_is_printed(run) -> None:
    status, out, err = run("solve", "dry-friction", "--mu-s", 2, "--mu-k", 2, "--all")
    assert status == 1
    assert out.endswith("\n\nnone found\n")
    assert "T [s]" not in out
    assert "no admissible orbit of any motion" in err


def test_a_tolerance_chooses_the_lowest_order(run) -> None:
    status, out, _ = run("solve", "impact", "--tol", 1e-9, "--json")
    document = json.loads(out)
    assert status == 0
    assert document["method"] == "ck-tau"
    assert document["estimate"]["times"] <= 1e-9
    orders = [trial["order"] for trial in document["trials"]]
    assert orders == list(range(2, document["order"] + 1))
    last = document["trials"][-2]["estimate"]["times"]
    assert last > 0.9e-9
    assert "the lowest order, of 8 tried" in run("solve", "impact", "--tol", 1e-9)[1]


def test_several_mistakes_are_a_line_each(run) -> None:
    error = refused(run, "solve", "impact", "--mass", -1, "--restitution", 2, below=1)
    first, second = error.splitlines()
    assert first == "nonsmooth: mass: got -1.0, expected a positive number"
    assert second == "  restitution: got 2.0, expected a positive number, at most 1"


def test_a_case_file_names_its_scene(run, tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_text(f"{CASE}gap = 0.05\nrestitution = 0.7\n")
    arguments = ("--method", "ck-tau", "--order", 6, "--json")
    expected = json.loads(run("solve", "impact", "--case", path, *arguments)[1])
    assert expected["parameters"]["mass"] == 2
    for given in (("--case", path), (f"--case={path}",)):
        assert json.loads(run("solve", *given, *arguments)[1]) == expected
    found = json.loads(run("solve", "--case", path, "--mass", 3, *arguments)[1])
    assert found["parameters"] == expected["parameters"] | {"mass": 3}
    path.write_text(path.read_text().replace("impact", "stick-slip-damped"))
    assert "belt_speed: missing" in refused(run, "solve", "--case", path, below=8)
    assert "no table [impact]" in refused(run, "solve", "impact", "--case", path)
    path.write_text(f"{CASE}gab = 1\n")
    error = refused(run, "solve", "--case", path, below=2)
    assert error.startswith(f"nonsmooth: {path}: gab: not a parameter of impact; did you mean")
    assert "gap: missing, expected displacement at which the mass hits the stop in m" in error
    assert "gab: not a parameter of impact; did you mean gap?" in error
    error = refused(run, "solve", "--case", path, "--gap", 0.1, below=1)
    assert "got" not in error.split("gab:")[0]


def test_help_lists_the_flags_of_the_scene(run) -> None:
    for command in ("solve", "sweep"):
        status, out, _ = run(command, "impact", "--help")
        assert status == 0
        assert f"Usage: nonsmooth {command} impact [OPTIONS]" in out
        words = " ".join(out.split())
        assert (
            "--restitution FLOAT r: speed after over speed before an impact; "
            "a positive number, at most 1. [default: 0.6]" in words
        )
        assert "--frequency FLOAT Omega in rad/s: angular" in words
        assert "table [impact]" in words
        assert "--belt-speed" not in out
        assert max(map(len, out.splitlines())) <= 80
    assert "and is run" in " ".join(run("scenes", "--help")[1].split())


def test_a_sweep_has_rows_and_rates(run, tmp_path: Path) -> None:
    status, out, err = run(
        "sweep", "impact", "--methods", "hb,c0-tau", "--orders", "2-8", "--json"
    )
    document = json.loads(out)
    assert status == 1  # c0-tau has no orbit at N = 2
    assert err == ""  # of what is done in ten seconds there is no progress
    assert [row["order"] for row in document["rows"]] == [*range(2, 9)] * 2
    assert [row["method"] for row in document["rows"]] == ["hb"] * 7 + ["ck-tau"] * 7
    assert {row["status"] for row in document["rows"]} == {"ok", "not-converged"}
    bad = document["rows"][7]
    assert bad["status"] == "not-converged"
    assert set(bad["errors"].values()) == {None}
    assert "no admissible orbit" in bad["message"]
    good = document["rows"][0]
    assert good["seconds"] > 0
    orders = np.log10([row["order"] for row in document["rows"][:7]])
    errors = np.log10([row["errors"]["times"] for row in document["rows"][:7]])
    rates = document["rates"]
    assert rates["hb"]["kind"] == "power"
    assert rates["hb"]["times"] == pytest.approx(-np.polyfit(orders, errors, 1)[0], rel=1e-12)
    assert rates["ck-tau"]["kind"] == "geometric"
    assert 1.1 < rates["ck-tau"]["times"] < 1.7


def test_a_sweep_writes_its_rows_and_says_where_orders_are_too_few(run, tmp_path: Path) -> None:
    target = tmp_path / "rows.csv"
    status, out, _ = run("sweep", "impact", "--orders", "3,5", "--methods", "ck", "-o", target)
    assert status == 0
    lines = [line.split() for line in out.splitlines() if line.startswith("c0 ")]
    assert lines[2] == ["c0", *("too", "few", "orders") * 2]
    orbit = solve_case(registry.load("impact")(), "ck", 5)
    with target.open(newline="") as file:
        first, second = csv.DictReader(file)
    assert float(second["error_times"]) == orbit.errors.times
    assert float(second["estimate_discontinuous"]) == orbit.estimate.discontinuous
    assert float(second["durations"]) == orbit.period
    assert (first["scene"], float(first["gap"])) == ("impact", 0.1)


def test_files_of_an_orbit(run, tmp_path: Path) -> None:
    arguments = ("solve", "impact", "--method", "c0-tau", "--order", 6)
    _, out, err = run(*arguments, "--json", "-o", tmp_path / "orbit.json")
    assert (tmp_path / "orbit.json").read_text() == out
    assert "wrote" in err
    run(*arguments, "-o", tmp_path / "motion.csv")
    with (tmp_path / "motion.csv").open(newline="") as file:
        motion = list(csv.DictReader(file))
    orbit = solve_case(registry.load("impact")(), "ck-tau", 6)
    t = np.array([float(row["t"]) for row in motion])
    assert {row["method"] for row in motion} == {"c0-tau"}
    for name in ("displacement", "velocity", "acceleration"):
        written = [float(row[name]) for row in motion]
        np.testing.assert_array_equal(written, getattr(orbit, name)(t))
    status, _, err = run(
        "solve", "impact", "--gap", 5, "--method", "ck", "-o", tmp_path / "n.csv"
    )
    assert status == 1
    assert "no orbit" in err
    assert not (tmp_path / "n.csv").exists()


def test_what_is_drawn_are_the_orbits_and_the_errors() -> None:
    from nonsmooth.plots.orbits import orbit_figure
    from nonsmooth.plots.sweeps import convergence_figure

    case = registry.load("impact")()
    orbit = solve_case(case, "ck-tau", 8)
    exact = exact_orbit(case)
    figure = orbit_figure([orbit], exact)
    plane, _, velocity, _ = figure.axes
    assert [line.get_label() for line in plane.lines] == ["exact", "c0-tau, N = 8"]
    x, v = plane.lines[1].get_data()
    assert v.min() == pytest.approx(orbit.phases[0].velocity, rel=1e-6)
    assert v.max() == pytest.approx(-orbit.phases[0].velocity / 0.6, rel=1e-6)
    assert x.max() == pytest.approx(0.1, rel=1e-6)
    assert (velocity.lines[0].get_xdata() < 1).sum() == 400
    result = ns.sweep(case, ["hb", "ck"], [3, 4])
    times, jumps = convergence_figure(result).axes
    errors = [row.errors.times for row in result.of("c0")]
    np.testing.assert_array_equal(times.lines[1].get_ydata(), errors)
    assert jumps.get_ylabel() == "error of $x'$"


@pytest.mark.parametrize("there", [True, False])
def test_generate_of_one_scene(run, tmp_path: Path, monkeypatch, there: bool) -> None:
    """Of one that is shipped, or whose kernels were never generated."""
    from nonsmooth.codegen import generate

    name, folder = "impact-two-sided", tmp_path / "generated"
    if not there:
        others = tuple(each for each in registry.names() if each != name)
        monkeypatch.setattr(registry, "names", lambda: others)
    fresh = {"__init__.py": "# a\n", "scene.py": "b = 1\n"}
    monkeypatch.setattr(generate, "FOLDER", folder)
    monkeypatch.setattr(generate, "scene_sources", lambda scene: iter(fresh.items()))
    folder.mkdir()
    status, out, _ = run("generate", name, "--check")
    lines = [f"impact_two_sided/{each}: missing\n" for each in fresh]
    assert (status, out) == (1, "".join(lines))
    assert list(folder.iterdir()) == []
    assert run("generate", name)[0] == 0
    assert (folder / "impact_two_sided" / "scene.py").read_text() == "b = 1\n"
    assert run("generate", name, "--check")[0] == 0
    for unknown in ("impact-three-sided", "../scenes/impact"):
        assert run("generate", unknown)[0] == 2


def test_an_orbit_that_is_far_off_is_not_returned_without_a_word(run) -> None:
    status, _, err = run("solve", "impact", "--method", "hb", "--order", 1)
    assert status == 0
    assert "its times are off by 18 % of the period, by the estimate" in err


def test_full_digits_are_those_that_the_estimate_leaves(run) -> None:
    _, out, _ = run("solve", "impact", "--method", "c0-tau", "--order", 10)
    (line,) = [q for q in out.splitlines() if q.startswith("c0-tau, N = 10: T = ")]
    exact = exact_orbit(registry.load("impact")())
    phi = line.split("phi = ")[1].split()[0]
    assert float(phi) == pytest.approx(exact.forcing_phase, abs=3 * 4.4e-13 * 2 * math.pi)
    assert len(phi) > 11


def test_what_is_rounding_beside_the_rest_is_printed_as_nothing(run) -> None:
    status, out, _ = run("sweep", "impact", "--vary", "gap=0:0.1:2")
    assert status == 0
    row = next(line for line in out.splitlines() if line.startswith("0 "))
    assert row.split()[4] == "0"
