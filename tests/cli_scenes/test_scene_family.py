"""An orbit of a scene along one of its parameters, from Python and on the command line."""

import csv
import json
import signal
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.plots.families import family_figure
from nonsmooth.solver import family as families
from nonsmooth.solver.no_orbit import NoOrbit

IMPACT = ns.scene("impact")
ORDER = 8


@pytest.fixture(scope="module")
def along():
    """Return a family whose last value has no orbit: the mass does not reach the stop."""
    return ns.family(IMPACT(), "gap", [0.1, 0.2, 0.3, 50.0], order=ORDER)


def test_each_orbit_is_what_solve_gives(along) -> None:
    for row in along.rows[:-1]:
        orbit = ns.solve(IMPACT(gap=row.value), order=ORDER)
        assert row.status == "ok"
        assert row.forcing_phase == pytest.approx(orbit.forcing_phase, rel=1e-12)
        assert row.durations == pytest.approx(orbit.durations, rel=1e-13)
        assert row.extremes["displacement"] == pytest.approx(
            orbit.extremes["displacement"], rel=1e-9
        )
        assert row.estimate.times == pytest.approx(orbit.estimate.times, rel=0.01)
    assert [row.followed for row in along.rows] == [False, True, True, False]
    assert all(0 < row.iterations < 6 for row in along.rows[1:3])


def test_numbers_that_no_row_has_are_refused(along) -> None:
    with pytest.raises(
        KeyError, match="got 'nope', expected one of value, period, forcing_phase"
    ):
        along["nope"]
    assert along["iterations"].tolist() == [row.iterations for row in along.rows]


def test_where_there_is_none_the_row_says_why(along) -> None:
    last = along.rows[-1]
    assert (last.status, last.period, last.durations) == ("no-orbit", None, None)
    assert "no such orbit exists" in last.message
    assert np.isnan(along["period"][-1])
    assert last.as_dict()["estimate"] == dict.fromkeys(
        ("period", "times", "discontinuous", "switches")
    )


def test_an_orbit_that_no_branch_has_is_searched_anew(monkeypatch) -> None:
    monkeypatch.setattr(families, "orbits_at", lambda branch, value: iter(()))
    found = ns.family(IMPACT(), "gap", [0.1, 0.11], order=ORDER)
    assert [row.followed for row in found.rows] == [False, False]
    alone = ns.solve(IMPACT(gap=0.11), order=ORDER)
    assert found.rows[1].iterations == alone.iterations
    assert found.rows[1].period == alone.period


def test_a_branch_is_followed_in_units_that_fit(along) -> None:
    case = ns.scene("stick-slip-damped")
    forces = [400.0, 480.0, 4e7]  # the unit of length is another at each
    found = ns.family(case(), "normal_force", forces, order=12)
    assert [row.followed for row in found.rows] == [False, True, True]
    alone = ns.exact(case(normal_force=forces[-1]))
    assert found.rows[-1].durations == pytest.approx(alone.durations, rel=1e-6)


def test_where_a_branch_turns_back_a_value_has_several_rows() -> None:
    case = ns.scene("backlash")(force=0.3, damping=0.1)
    found = ns.family(case, "frequency", [0.5, 0.7, 0.85], order=12)
    assert [row.value for row in found] == [0.5, 0.7, 0.7, 0.85]
    assert [row.stable for row in found] == [True, True, False, None]
    both = sorted(row.extremes["displacement"][1] for row in found[1:3])
    assert both[0] < 2 < both[1]
    for row in found[1:3]:
        assert row.stable == (abs(row.multipliers[0]) < 1)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("gape", [0.1]), "parameter: got 'gape', expected one of mass"),
        (("gap", []), "values: got 0"),
        (("gap", [0.1, np.nan]), "gap: got nan"),
        (("restitution", [0.5, 1.5]), "restitution: got 1.5"),
        (("gap", ["a"]), "values: got"),
        (("gap", [0.1], "c1"), "method: got 'c1'"),
        (("gap", [0.1], "hb", 0), "order: got 0"),
    ],
)
def test_what_cannot_be_followed(arguments, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        ns.family(IMPACT(), *arguments)
    with pytest.raises(TypeError):
        ns.family("impact", "gap", [0.1])


def test_the_files_have_what_the_document_has(run, tmp_path: Path) -> None:
    target = tmp_path / "along.csv"
    flags = ("--vary", "gap=0.1:0.3:3", "--orders", ORDER, "--damping", 0.2)
    status, out, _ = run("sweep", "impact", *flags, "--json", "-o", target)
    document = json.loads(out)
    assert (status, document["scene"], document["order"]) == (0, "impact", ORDER)
    assert document["vary"] == {"parameter": "gap", "count": 3}
    assert document["parameters"]["damping"] == 0.2
    with target.open(newline="") as file:
        lines = list(csv.DictReader(file))
    for line, row in zip(lines, document["rows"], strict=True):
        assert float(line["gap"]) == row["value"]
        assert float(line["period"]) == row["period"]
        assert float(line["largest_velocity"]) == row["extremes"]["velocity"][1]
        assert [float(s) for s in line["durations"].split()] == row["durations"]
        assert float(line["estimate_times"]) == row["estimate"]["times"]
        assert (line["scene"], line["method"], line["damping"]) == ("impact", "ck-tau", "0.2")


def test_a_value_without_an_orbit_ends_with_status_1(run, tmp_path: Path) -> None:
    target = tmp_path / "along.svg"
    flags = ("--vary", "gap=0.1:50:2", "--log", "--orders", ORDER, "-o", target)
    status, out, err = run("sweep", "impact", *flags)
    assert (status, err) == (1, f"wrote {target}\n")
    assert "g = 0.1 to 50 m; c0-tau, N = 8" in out
    assert out.splitlines()[-1] == "1 ok; 1 no-orbit"
    assert target.exists()


@pytest.mark.parametrize("of", [("--vary", "gap=50:60:2"), ("--gap", "50", "--orders", "3,4")])
def test_a_table_without_any_orbit_says_why(run, of: tuple[str, ...]) -> None:
    status, out, err = run("sweep", "impact", *of)
    assert (status, "no-orbit" in out) == (1, True)
    assert err.startswith(
        "nonsmooth: no row has an orbit, the first for this reason: impact: no such orbit"
    )


def test_the_picture_has_the_ends_and_the_times(along) -> None:
    panels = family_figure(along).axes
    low, high, missing = panels[0].lines
    assert list(low.get_ydata()) == [r.extremes["displacement"][0] for r in along.rows[:3]]
    assert list(high.get_ydata()) == [r.extremes["displacement"][1] for r in along.rows[:3]]
    assert (missing.get_label(), list(missing.get_xdata())) == ("no orbit", [50.0])
    assert list(panels[2].lines[0].get_ydata()[:3]) == list(along["forcing_phase"][:3])
    assert list(panels[3].lines[0].get_ydata()[:3]) == [
        row.estimate.times for row in along.rows[:3]
    ]
    assert "gap $g$ [m]" in panels[2].get_xlabel()
    assert "displacement" in panels[0].get_ylabel()
    assert "velocity" in panels[1].get_ylabel()


def test_no_orbit_at_the_first_value_does_not_end_the_sweep() -> None:
    found = ns.family(IMPACT(), "gap", [50.0, 0.1], order=ORDER)
    assert [row.status for row in found.rows] == ["no-orbit", "ok"]
    with pytest.raises(NoOrbit):
        ns.solve(IMPACT(gap=50.0), order=ORDER)


@pytest.fixture(scope="module")
def between():
    """Return a family that goes over from one motion, with stops, to another, without."""
    return ns.family(ns.scene("dry-friction")(), "force", [0.36, 0.38, 0.5, 0.55], order=12)


def test_a_family_goes_over_from_one_motion_to_another(between) -> None:
    assert [row.motion for row in between] == ["two-stops", "two-stops", "sliding", "sliding"]
    assert [row.followed for row in between] == [False, True, True, True]
    for row in between:
        orbit = ns.solve(ns.scene("dry-friction")(force=row.value), order=12)
        assert orbit.case.scene.motion == row.motion
        assert row.durations == pytest.approx(orbit.durations, rel=1e-12)
    names = [list(between.durations_of(row)) for row in between]
    assert names == [["slide", "stop"]] * 2 + [["slide"]] * 2


def test_what_shows_a_family_of_several_motions(between, run, tmp_path: Path) -> None:
    ns.save(between, tmp_path / "between.json")
    assert ns.load(tmp_path / "between.json") == between
    _, _, slide, stop = between.plot(quantity="times").lines  # two are for the legend
    expected = [row.durations[1] / row.period for row in between.rows[:2]]
    assert list(stop.get_ydata()[:2]) == expected
    assert np.isnan(stop.get_ydata()[2:]).all()
    assert slide.get_ydata()[2] == pytest.approx(0.5)
    _, out, _ = run("sweep", "dry-friction", "--vary", "force=0.36:0.5:2", "--orders", 12)
    rows = [line.split() for line in out.splitlines() if line[:3] in {"0.3", "0.5"}]
    first, second = rows[:2]  # those behind them are the rest of the table
    assert (first[3], second[3]) == ("two-stops", "sliding")
    assert float(first[5]) == pytest.approx(between[0].durations[1], rel=1e-5)
    assert len(second) == len(first) - 1


def test_the_cycles_of_a_case_are_those_of_its_family(tmp_path: Path) -> None:
    case = IMPACT(frequency=3.4, cycles=2)
    (row,) = found = ns.family(case, "gap", [0.1], order=12)
    assert row.period == pytest.approx(2 * 2 * np.pi / 3.4, rel=1e-14)
    ns.save(found, tmp_path / "twice.json")
    assert ns.load(tmp_path / "twice.json") == found


#: What makes a row; values, and the command that makes one for each.
ROW, VALUES = families._row, 5
ALONG = ("sweep", "impact", "--vary", "gap=0.1:0.3:5", "--orders", ORDER)


def after(count: int):
    """Return what makes a row, until Ctrl-C comes where `count` of them are done."""
    rows = iter(range(count))

    def row(*arguments, **how):
        if next(rows, None) is None:
            signal.raise_signal(signal.SIGINT)
        return ROW(*arguments, **how)

    return row


@pytest.mark.parametrize("count", [1, VALUES - 1])
def test_what_was_done_before_an_interrupt_is_kept(
    count: int, run, tmp_path: Path, monkeypatch
) -> None:
    whole = ns.family(IMPACT(), "gap", np.linspace(0.1, 0.3, VALUES), order=ORDER)
    path = tmp_path / "family.json"
    monkeypatch.setattr(families, "_row", after(count))
    status, out, err = run(*ALONG, "-o", path)
    assert status == 130
    assert err.endswith(f"nonsmooth: interrupted: {count} of 5 values are done\n")
    assert f"g = 0.1 to {whole.rows[count - 1].value:g} m" in out
    assert ns.load(path).rows == whole.rows[:count]
    monkeypatch.setattr(families, "_row", after(count))
    status, out, _ = run(*ALONG, "--json")
    assert (status, out) == (130, path.read_text())


def test_an_interrupt_before_the_first_leaves_nothing(run, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(families, "_row", after(0))
    status, out, err = run(*ALONG, "-o", tmp_path / "family.json")
    assert (status, out, err.strip()) == (130, "", "nonsmooth: interrupted")
    assert list(tmp_path.iterdir()) == []


def test_from_python_an_interrupt_has_what_was_done(monkeypatch) -> None:
    monkeypatch.setattr(families, "_row", after(2))
    with pytest.raises(KeyboardInterrupt) as caught:
        ns.family(IMPACT(), "gap", [0.1, 0.2, 0.3], order=ORDER)
    assert caught.value.done["value"].tolist() == [0.1, 0.2]
