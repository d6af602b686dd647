"""Modes as files: their arrays, their rows, and what the command line writes of them."""

import csv
import json
import math
from pathlib import Path

import pytest

import nonsmooth as ns

try:
    import netCDF4
except ImportError:
    netCDF4 = None


def several() -> list[ns.Modes]:
    """Return expansions of one structure, of different methods, places and counts."""
    methods = [ns.modes("beam-crack", method) for method in ("ritz", "ritz-ck", "ck")]
    return [*methods, ns.modes("beam-crack", position=0.25, compliance=3, count=2)]


@pytest.mark.skipif(netCDF4 is None, reason="netCDF4 is not installed")
def test_arrays_are_over_expansion_and_number(tmp_path: Path) -> None:
    path, saved = tmp_path / "modes.nc", several()
    ns.save(saved, path)
    with netCDF4.Dataset(path) as file:
        file.set_auto_mask(False)
        assert (file.kind, file.structure, file.order) == ("modes", "beam-crack", 8)
        assert file["frequency"].dimensions == ("expansion", "number")
        assert file["frequency"].units == "Hz"
        assert file["frequency"][3, 1] == saved[3][1].frequency
        assert math.isnan(file["frequency"][3, 2])  # only two of the fourth
        assert file["compliance"][:, 0].tolist() == [10.0, 10.0, 10.0, 3.0]
        assert file["position"][:, 0].tolist() == ["3/10", "3/10", "3/10", "1/4"]
        assert file["method"][:, 0].tolist() == ["ritz", "ritz-ck", "ck", "ritz-ck"]


@pytest.mark.parametrize(
    "arguments",
    [
        ("--order", "5", "--count", "2"),
        ("--method", "all", "--count", "2"),
        ("--vary", "position=1/10:1/2:3", "--count", "2"),
        ("--vary", "bending-stiffness=1:2:2", "--count", "1"),
    ],
)
def test_what_the_command_line_writes_is_what_it_prints(arguments, run, tmp_path: Path) -> None:
    path = tmp_path / "file.json"
    status, out, _ = run("modes", "beam-mass", *arguments, "--json", "-o", path)
    assert (status, path.read_text("utf-8")) == (0, out)
    with pytest.raises(ns.FileError, match="holds modes or shapes: they are not loaded"):
        ns.load(path)
    if netCDF4 is not None:
        arrays = tmp_path / "file.nc"
        status, _, err = run("modes", "beam-mass", *arguments, "-o", arrays)
        assert (status, err) == (0, f"wrote {arrays}\n")


def test_csv_has_what_is_needed_to_compute_it_again(run, tmp_path: Path) -> None:
    path = tmp_path / "modes.csv"
    saved = ns.modes("string-mass", forced=2, order=5, position=0.27, mass=3.3)
    ns.save(saved, path)
    rows = list(csv.DictReader(path.read_text("utf-8").splitlines()))
    assert [float(row["frequency"]) for row in rows] == [mode.frequency for mode in saved]
    row = rows[0]
    given = {name: float(row[name]) for name in saved.attached.values}
    how = (row["structure"], row["method"], int(row["order"]), int(row["forced"]), len(rows))
    assert ns.modes(*how, position=row["position"], **given) == saved
    varied = ("--vary", "bending-stiffness=1:2:2", "--count", "1", "-o", path)
    assert run("modes", "beam-mass", *varied)[0] == 0
    header, *lines = path.read_text("utf-8").splitlines()
    assert header.startswith("bending-stiffness,method,")
    assert header.endswith("node,structure,position,strength,length,mass_per_length,mass")
    assert all(line.count(",") == header.count(",") for line in lines)


def test_a_study_of_convergence_is_not_loaded(run, tmp_path: Path) -> None:
    path = tmp_path / "study.json"
    assert run("sweep", "string-mass", "--orders", "4", "-o", path)[0] == 0
    with pytest.raises(ns.FileError, match="holds modes or shapes"):
        ns.load(path)


@pytest.mark.parametrize("name", ["beam-crack", "string-mass"])
def test_shapes_as_files(name: str, tmp_path: Path) -> None:
    modes = ns.modes(name, count=2)
    shapes, columns = modes.shapes(11), ["displacement", "slope"]
    columns += ["moment", "shear_force"] if name.startswith("beam") else []
    ns.save(shapes, tmp_path / "shapes.csv")
    rows = list(csv.DictReader((tmp_path / "shapes.csv").read_text("utf-8").splitlines()))
    assert len(rows) == 22
    assert list(rows[0])[: 2 + len(columns)] == ["number", "x", *columns]
    row = rows[11 + 4]
    place = float(row["x"])
    assert place == pytest.approx(0.4)
    slope = float(modes[1].normalised(place, 1))
    assert float(row["slope"]) == pytest.approx(slope, rel=1e-14)
    if len(columns) == 4:
        expected = float(modes[1].moment(place)) / modes[1].modal_mass ** 0.5
        assert float(row["moment"]) == pytest.approx(expected, rel=1e-14)
    ns.save(shapes, tmp_path / "shapes.json")
    document = json.loads((tmp_path / "shapes.json").read_text("utf-8"))
    assert document["shapes"]["slope"][15] == float(row["slope"])
    assert document["units"]["x"] == "m"
    with pytest.raises(ValueError, match="they are not loaded"):
        ns.load(tmp_path / "shapes.json")
    if netCDF4 is not None:
        ns.save(shapes, tmp_path / "shapes.nc")
        with netCDF4.Dataset(tmp_path / "shapes.nc") as file:
            assert file["slope"].dimensions == ("number", "x")
            assert file["slope"][1, 4] == float(row["slope"])


def test_points_of_shapes_are_checked() -> None:
    with pytest.raises(ValueError, match="points: got 1, expected a whole number from 2"):
        ns.modes("beam-mass").shapes(1)


def test_the_command_writes_shapes(run, tmp_path: Path) -> None:
    shapes = ns.modes("beam-mass", count=2, mass=3.0).shapes(5)
    given = ("modes", "beam-mass", "--count", 2, "--mass", 3, "--shapes", 5)
    for name in ("shapes.csv", "shapes.json"):
        ns.save(shapes, tmp_path / name)
        status, out, _ = run(*given, "-o", tmp_path / f"own-{name}")
        assert status == 0
        assert "omega [rad/s]" in out
        assert (tmp_path / f"own-{name}").read_bytes() == (tmp_path / name).read_bytes()
    assert run(*given, "--json")[1] == (tmp_path / "shapes.json").read_text("utf-8")
