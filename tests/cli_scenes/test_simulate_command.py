"""``nonsmooth simulate``: its table, documents, files, pictures; bad input in one line."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.plots.simulations import simulation_figure as figure

CHATTER = ("--restitution", 0.3, "--frequency", 0.3, "--damping", 0.3)


def table(out: str) -> list[list[str]]:
    """Return the cells of the table of phases."""
    lines = [line.split() for line in out.splitlines()]
    head = next(i for i, cells in enumerate(lines) if cells[:1] == ["phase"])
    return [cells for cells in lines[head + 1 : lines.index([], head)] if len(cells) > 1]


def test_of_a_long_motion_the_first_and_the_last_are_printed(run) -> None:
    _, out, _ = run("simulate", "impact", "--cycles", 30)
    starts = [float(cells[1]) for cells in table(out)]
    assert len(starts) == 20
    assert starts[0] == 0
    assert starts[-1] > 100
    assert "\n..." in out
    motion = ns.simulate(ns.scene("impact")(), cycles=30)
    assert f"{len(motion.phases)} phases in {motion.time:.6g} s" in out


def test_the_default_scene_is_the_papers(run) -> None:
    status, out, _ = run("simulate", "--state", "0,1", "--time", 0.6)
    assert status == 0
    assert out.startswith("stick-slip: ")
    assert [cells[0] for cells in table(out)] == ["stick", "slip"]
    assert run("simulate", "stick-slip", "--state", "0,1", "--time", 0.6)[1] == out
    assert "--normal-force" in run("simulate", "--help")[1]


def test_chatter_is_status_1_with_its_reason(run) -> None:
    status, out, err = run("simulate", "impact", *CHATTER)
    assert status == 1
    assert err.startswith(
        "nonsmooth: ended at t = 0.854775 s: chatter: flight ends ever sooner"
    )
    assert err.count("\n") == 1
    assert table(out)
    document = json.loads(run("simulate", "impact", *CHATTER, "--json")[1])
    assert document["ended"].startswith("chatter")


def test_the_document(run, tmp_path: Path) -> None:
    arguments = ("simulate", "impact", "--cycles", 2, "--forcing-phase", 0.5, "--gap", 0.2)
    document = json.loads(run(*arguments, "--json")[1])
    motion = ns.simulate(ns.scene("impact")(gap=0.2), cycles=2, forcing_phase=0.5)
    assert {name: document[name] for name in motion.as_dict()} == motion.as_dict()
    assert document["units"]["displacement"] == "m"
    assert set(document) >= {"version", "mathematics", "sha256"}
    run(*arguments, "-o", tmp_path / "m.json")
    assert json.loads((tmp_path / "m.json").read_text("utf-8")) == document


def test_files_of_a_motion(run, tmp_path: Path) -> None:
    status, _, err = run("simulate", "impact", "--cycles", 2, "-o", tmp_path / "m.csv")
    assert (status, err) == (0, f"wrote {tmp_path / 'm.csv'}\n")
    with (tmp_path / "m.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    motion = ns.simulate(ns.scene("impact")(), cycles=2)
    t, x, v, a = map(np.concatenate, zip(*motion.samples(), strict=True))
    assert {row["phase"] for row in rows} == {"flight"}
    columns = {"t": t, "displacement": x, "velocity": v, "acceleration": a}
    for name, values in columns.items():
        assert [float(row[name]) for row in rows] == values.tolist()
    path = tmp_path / "m.svg"
    assert run("simulate", "impact", "--cycles", 2, "-o", path)[0] == 0
    assert path.stat().st_size > 5000


def test_what_is_drawn_is_the_motion_and_its_late_part() -> None:
    motion = ns.simulate(ns.scene("impact")(), cycles=10)
    t, x, v, _ = map(np.concatenate, zip(*motion.samples(), strict=True))
    place, plane, speed = figure(motion).axes
    for axes, values in ((place, x), (speed, v)):
        (line,) = axes.lines
        assert np.array_equal(line.get_xdata(), t)
        assert np.array_equal(line.get_ydata(), values)
    whole, late = plane.lines
    assert np.array_equal(whole.get_xdata(), x)
    count = len(late.get_xdata())
    assert np.array_equal(late.get_ydata(), v[-count:])
    assert t[-count] == pytest.approx(0.8 * motion.time, rel=0.01)
