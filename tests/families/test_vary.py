"""``nonsmooth sweep --vary``: values, tables, files, what is refused."""

import csv
import json
import shutil
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.cli.shortcuts.families.family_store import WRITTEN
from nonsmooth.cli.shortcuts.families.vary import parse_vary
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

VARY = ("--vary", "belt-speed=0.1:10:30", "--log")


def test_values_end_where_they_were_told_to() -> None:
    for text, log in (("mass=1:1e-3:7", True), ("mu-k=0.1:0.4:10", False)):
        vary = parse_vary(text, log)
        values = vary.values(0, vary.count)
        assert values[0] == vary.first
        assert values[-1] == vary.last
        steps = np.diff(np.log(values) if log else values)
        np.testing.assert_allclose(steps, steps[0], rtol=1e-12)
        parts = [vary.values(start, start + 1)[0] for start in range(vary.count)]
        assert parts == values.tolist()


@pytest.mark.parametrize("log", [False, True])
@pytest.mark.parametrize("ends", ["0.3:0.9", "1:1e-3", "0.2:0.9", "0.1:0.3", "0.9:0.3"])
def test_no_rounding_is_left_at_the_ends(ends: str, log: bool) -> None:
    """Of 0.3, 0.6, 0.9 the last would be 0.9000000000000001, by a factor 0.8999999999999999."""
    for count in (*range(2, 40), 1000, 16385):
        vary = parse_vary(f"mu-s={ends}:{count}", log)
        first, last = map(float, ends.split(":"))
        values = vary.values(0, count)
        assert len(values) == count
        assert (values[0], values[-1]) == (first, last)
        assert vary.values(count - 1, count).tolist() == [last]
        assert min(first, last) == values.min()
        assert max(first, last) == values.max()


@pytest.mark.parametrize("log", [(), ("--log",)])
def test_the_last_point_of_a_file_is_the_end(log, run, tmp_path: Path) -> None:
    path = tmp_path / "family.csv"
    assert run("sweep", "--vary", "mu-s=0.3:0.9:3", *log, "-o", path)[0] == 0
    assert ns.load(path)["value"][[0, -1]].tolist() == [0.3, 0.9]


def test_the_table_says_that_only_alpha_matters(run) -> None:
    status, out, _ = run("sweep", *VARY)
    assert status == 0
    assert "alpha runs from 10 to 0.1." in out
    assert "changes nothing else but the unit of length" in " ".join(out.split())
    assert "25 of 30 points" in out
    assert "30 ok; largest estimated error of T:" in out


def test_the_widest_table_fits_80_columns(run) -> None:
    vary = ("--vary", "normal-force=0.123456789:123456789:5", "--log")
    _, out, _ = run("sweep", *vary, "--methods", "hb-c1,c1", "--orders", 200)
    assert max(map(len, out.splitlines())) <= 80


def test_what_moves_only_alpha_is_said_to(run) -> None:
    _, out, _ = run("sweep", "--vary", "mu-s=0.3:0.9:3")
    assert "mu_s changes nothing else." in out


def test_csv_has_a_row_a_point(run, tmp_path: Path) -> None:
    target = tmp_path / "family.csv"
    assert run("sweep", *VARY, "--methods", "hb,c1", "--orders", 20, "-o", target)[0] == 0
    with target.open(newline="") as file:
        rows = list(csv.DictReader(file))
    family = ns.family(DEFAULT, "belt_speed", parse_vary(VARY[1], True).values(0, 30), "hb", 20)
    assert [row["method"] for row in rows] == ["hb"] * 30 + ["c1"] * 30
    for row, point in zip(rows, family.points, strict=False):
        assert float(row["belt_speed"]) == point["value"]
        assert float(row["period"]) == point["period"]
        assert float(row["amplitude"]) == point["amplitude"]
        assert row["status"] == "ok"
    assert not (tmp_path / "family.csv.part").exists()


def test_json_has_the_rows_of_a_sweep(run, tmp_path: Path) -> None:
    target = tmp_path / "family.json"
    status, out, _ = run("sweep", *VARY, "--json", "-o", target)
    assert status == 0
    assert out == target.read_text()
    document = json.loads(out)
    assert document["schema"] == 1
    assert document["vary"] == {"parameter": "belt_speed", "count": 30}
    assert document["units"]["value"] == "m/s"
    assert len(document["rows"]) == 30
    assert list(document["rows"][0]) == [
        "method", "order", "status", "value", "alpha", "t1", "period", "amplitude",
        "stick_fraction", "estimate",
    ]  # fmt: skip


def test_a_point_without_an_orbit_is_a_point_all_the_same(run, tmp_path: Path) -> None:
    arguments = ("--vary", "belt-speed=0.001:1:4", "--log", "--methods", "hb", "--orders", 5)
    status, out, _ = run("sweep", *arguments, "--json", "-o", tmp_path / "family.csv")
    rows = json.loads(out)["rows"]
    assert status == 1
    assert [row["status"] for row in rows] == ["not-converged"] * 2 + ["ok"] * 2
    assert rows[0]["period"] is None
    assert rows[0]["estimate"] == {"period": None, "t1": None}
    assert (
        "\nhb,5,not-converged,0.001,1000.0,,,,,,,10.0," in (tmp_path / "family.csv").read_text()
    )


def test_netcdf_has_units_and_every_bit(run, tmp_path: Path) -> None:
    netcdf = pytest.importorskip("netCDF4")
    target = tmp_path / "family.nc"
    assert run("sweep", *VARY, "--methods", "hb,c1", "--orders", 20, "-o", target)[0] == 0
    family = ns.family(DEFAULT, "belt_speed", parse_vary(VARY[1], True).values(0, 30), "c1", 20)
    with netcdf.Dataset(target) as file:
        assert file["period"].dimensions == ("method", "belt_speed")
        assert file["period"].units == "s"
        assert file["belt_speed"].units == "m/s"
        assert file["method"][:].tolist() == ["hb", "c1"]
        assert file.normal_force == 400.0
        assert np.array_equal(file["period"][1], family["period"])
        assert np.array_equal(file["amplitude"][1], family["amplitude"])
        assert np.array_equal(file["belt_speed"][:], family["value"])


def test_a_picture(run, tmp_path: Path) -> None:
    target = tmp_path / "family.svg"
    assert run("sweep", *VARY, "-o", target)[0] == 0
    assert "<svg" in target.read_text()


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["--vary", "belt-speed"], "got 'belt-speed', expected NAME=FROM:TO:POINTS"),
        (["--vary", "speed=1:2:3"], "unknown parameter 'speed', expected one of mass,"),
        (["--vary", "mass=1:2"], "expected NAME=FROM:TO:POINTS"),
        (["--vary", "mass=a:2:3"], "expected NAME=FROM:TO:POINTS"),
        (["--vary", "mass=1:1:3"], "expected two different numbers"),
        (["--vary", "mass=1:inf:3"], "expected two different numbers"),
        (["--vary", "mass=1:2:1"], "got '1' points, expected a whole number from 2"),
        (["--vary", "mass=1:2:2.5"], "got '2.5' points"),
        (["--vary", "mass=1:2:2000000000"], "a whole number from 2 to 1000000000"),
        (["--vary", "mass=0:2:3"], "--vary: mass: got 0.0, expected a positive number"),
        (["--vary", "mu-k=0:0.5:3"], "mu_k: got 0.5, expected less than mu_s"),
        (["--vary", "mu-k=0:0.4:3", "--log"], "--log: got an end"),
        (["--vary", "belt-speed=1e-12:1:3"], "their alpha is"),
        (["--vary", "mass=1:2:3", "--mass", "3"], "--mass: given beside --vary mass"),
        (["--vary", "mass=1:2:3", "--orders", "1-4"], "expected one order"),
        (["--vary", "mass=1:2:3", "--orders", "401"], "--orders: order: got 401"),
        (["--vary", "mass=1:2:3", "--methods", "x"], "--methods: got 'x', expected some of"),
        (
            ["--vary", "mass=1:2:3", "--methods", "hb-c1", "--c1-terms", "9"],
            "--c1-terms: got 9",
        ),
        (["--vary", "mass=1:2:3", "-o", "family.txt"], "-o: got family.txt"),
        (["--log"], "--log: expected --vary"),
    ],
)
def test_bad_input(run, arguments: list[str], expected: str) -> None:
    status, out, err = run("sweep", *arguments)
    assert status == 2
    assert expected in err
    assert out == ""
    assert err.count("\n") == 1


def test_a_disk_without_room_is_said_before_the_work(run, tmp_path: Path, monkeypatch) -> None:
    usage = shutil.disk_usage(tmp_path)
    monkeypatch.setattr("shutil.disk_usage", lambda folder: usage._replace(free=309_999))
    status, _, err = run("sweep", "--vary", "mass=1:2:1000", "-o", tmp_path / "family.csv")
    assert status == 2
    assert "--vary: 1000 points need about 0.00031 GB in" in err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("suffix", [".csv", ".json", ".nc"])
def test_the_file_takes_what_was_asked_of_the_disk(run, tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"family{suffix}"
    assert run("sweep", "--vary", "mass=1:2:10000", "-o", path)[0] == 0
    assert path.stat().st_size == pytest.approx(10_000 * WRITTEN[suffix], rel=0.03)


def test_netcdf_without_its_library_says_so(run, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr("nonsmooth.cli.output.find_spec", lambda name: None)
    status, _, err = run("sweep", *VARY, "-o", tmp_path / "family.nc")
    assert status == 2
    assert "pip install 'nonsmooth[netcdf]'" in err


def test_values_whose_quotient_is_no_float(run) -> None:
    vary = parse_vary("mu-k=1e-320:0.25:5", log=True)
    values = vary.values(0, 5)
    assert values[-1] == 0.25
    assert values[0] == pytest.approx(1e-320, rel=1e-3)  # subnormal
    assert np.diff(np.log(values)) == pytest.approx(np.full(4, 183.8), rel=1e-3)
    assert run("sweep", "--vary", "mu-k=1e-320:0.25:5", "--log")[0] == 0
