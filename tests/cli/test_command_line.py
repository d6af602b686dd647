"""The command line: documents, tables, files, exit status."""

import json
import shutil
from pathlib import Path

import pytest
from printed_table import KEYS

import nonsmooth as ns
from nonsmooth.codegen import generate as stage

#: What the documents of the paper's oscillator have, some of it beside those of any scene.
OF_THE_PAPER = {*KEYS, "t1", "transition_mismatch"}

EXACT = {"T": 0.671238898038469, "t1": 0.2}


@pytest.mark.parametrize("method", ["hb", "hb-c1", "c1"])
def test_solve_prints_the_fixed_keys(method: str, run, belt: ns.StickSlip) -> None:
    status, out, err = run("solve", "--method", method, "--order", 7, "--json")
    document = json.loads(out)
    assert status == 0
    assert set(document) == OF_THE_PAPER
    assert document["schema"] == 2
    assert document["method"] == method
    assert document["order"] == 7
    assert document["converged"] is True
    assert document["admissible"] is True
    assert document["violations"] == []
    names = ["mass", "stiffness", "belt_speed", "mu_s", "mu_k", "normal_force"]
    assert list(document["parameters"]) == names
    assert set(document["exact"]) == {"t1", "period", "forcing_phase", "durations"}
    errors, t1, period = document["errors"], document["t1"], document["period"]
    names = {"period", "t1", "acceleration", "acceleration_aligned", "times", "discontinuous"}
    names |= {"switches"}
    assert set(errors) == names
    assert errors["period"] == pytest.approx(period / EXACT["T"] - 1, abs=1e-14)
    assert errors["t1"] == pytest.approx(t1 / EXACT["t1"] - 1, abs=1e-14)
    off = max(abs(t1 - EXACT["t1"]), abs(period - t1 - (EXACT["T"] - EXACT["t1"])))
    assert errors["times"] == pytest.approx(off / EXACT["T"], abs=1e-14)
    assert errors["acceleration_aligned"] == errors["discontinuous"]
    coefficients = {"hb": ["a0", "a", "b"], "hb-c1": ["a0", "a", "b", "c1"], "c1": ["d"]}
    assert list(document["coefficients"]) == coefficients[method]
    orbit = ns.solve(belt, method, 7).as_dict()
    assert {name: document[name] for name in orbit} == json.loads(json.dumps(orbit))
    assert err == ""


def test_no_digit_of_a_table_is_left_out(run) -> None:
    _, out, _ = run("solve", "--mass", 1e-300, "--stiffness", 1e300)
    assert "…" not in out
    assert "2.03161592e-298" in out


def test_an_absent_orbit_is_said_to_be_absent(run) -> None:
    arguments = ("solve", "--method", "c1", "--order", 4, "--normal-force", 100)
    status, out, err = run(*arguments, "--json")
    document = json.loads(out)
    assert status == 1
    assert set(document) == OF_THE_PAPER | {"status"}
    assert (document["t1"], document["exact"]["t1"]) == (None, pytest.approx(0.05))
    assert document["status"] == "no-orbit"
    assert document["converged"] is False
    assert document["period"] is None
    assert "real solutions" in document["violations"][0]
    assert "none is an orbit" in err
    status, out, _ = run(*arguments)
    assert status == 1
    assert "no-orbit" in out
    assert "is assumed" not in out


@pytest.mark.parametrize(
    ("command", "suffix"),
    [
        ("solve", "pdf"),
        ("sweep", "svg"),
    ],
)
def test_pictures_are_written_and_reproducible(
    run, tmp_path: Path, command: str, suffix: str
) -> None:
    pytest.importorskip("matplotlib")
    orders = {"solve": ("--order", 3), "sweep": ("--orders", "1-4", "--methods", "c1")}[command]
    contents = []
    for attempt in range(2):
        target = tmp_path / f"{attempt}.{suffix}"
        assert run(command, *orders, "-o", target)[0] == 0
        contents.append(target.read_bytes())
    assert contents[0] == contents[1]
    start = {"png": b"\x89PNG", "svg": b"<?xml", "pdf": b"%PDF"}[suffix]
    assert contents[0].startswith(start)


@pytest.mark.parametrize("how", [(), ("--json",)])
def test_a_file_is_written_also_where_the_reader_of_stdout_has_left(
    how, interruptible, tmp_path: Path
) -> None:
    target = tmp_path / "orbit.json"
    with interruptible("solve", "impact", *how, "-o", target) as program:
        program.stdout.close()
        assert program.stderr.read() == f"wrote {target}\n"
    assert program.returncode == 0
    assert target.is_file()


def test_roots_without_an_orbit_exit_with_1(run) -> None:
    status, out, _ = run("roots", "--order", 4, "--normal-force", 100)
    assert status == 1
    assert "the orbit" not in out
    _, document, _ = run("roots", "--order", 4, "--normal-force", 100, "--json")
    said = [root["violations"][0] for root in json.loads(document)["roots"]]
    lines = out.splitlines()
    head = next(i for i, line in enumerate(lines) if "verdict" in line)
    first = lines[head].index("verdict")
    verdicts = " ".join(line[first:].strip() for line in lines[head + 1 :])
    assert verdicts == " ".join(said)  # no word is cut


def test_generate_check_passes_and_fails_with_status_1(
    run, tmp_path: Path, monkeypatch
) -> None:
    # What is derived is held against the files in test_generated.
    present = stage._present(stage.FOLDER)
    monkeypatch.setattr(stage, "sources", lambda: present)
    assert run("generate", "--check") == (0, "generated/ is up to date\n", "")
    folder = tmp_path / "generated"
    shutil.copytree(stage.FOLDER, folder, ignore=shutil.ignore_patterns("__pycache__"))
    (folder / "stick_slip" / "scene.py").write_text("wrong")
    monkeypatch.setattr(stage, "FOLDER", folder)
    assert run("generate", "--check") == (1, "stick_slip/scene.py: differs\n", "")
    assert (folder / "stick_slip" / "scene.py").read_text() == "wrong"
    assert run("generate") == (0, "stick_slip/scene.py: written\n", "")
    assert run("generate") == (0, "generated/ was up to date\n", "")
