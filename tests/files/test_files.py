"""Files: what was saved is loaded bit for bit, by whatever it was written."""

import csv
import json
import re
from pathlib import Path

import numpy as np
import pytest
from saved_things import BELT, FORMS, MAKERS, needs_netcdf, saved, thing

import nonsmooth as ns
from nonsmooth.codegen.scene import SceneError
from nonsmooth.codegen.scene.checks.names import check_free
from nonsmooth.files import api


@pytest.mark.parametrize("suffix", FORMS)
@pytest.mark.parametrize("kind", [q for q in MAKERS if not q.startswith("modes")])
def test_what_is_loaded_is_what_was_saved(kind: str, suffix: str, tmp_path: Path) -> None:
    if kind.startswith("body"):  # whose exact orbit, found anew, may be another to rounding
        thing.cache_clear()
    found, made = ns.load(saved(kind, tmp_path, suffix)), thing(kind)
    assert type(found) is type(made)
    assert found == made
    if isinstance(found, ns.Orbit):
        assert found.outcome.reason == "converged"
        assert (found.iterations, found.errors) == (made.iterations, made.errors)
        assert found.as_dict() == made.as_dict()
        assert found.unknowns.tobytes() == made.unknowns.tobytes()
        with pytest.raises(ValueError, match="read-only"):
            found.unknowns[0] = 1


def test_some_of_these_rows_have_no_orbit() -> None:
    for kind in ("belt-sweep", "belt-family", "family"):
        assert {row.status for row in thing(kind)} == {"ok", "no-orbit"}


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (("solve", "impact", "--order", "5"), 0),
        (("solve", "dry-friction", "--method", "hb", "--order", "4"), 0),
        (("solve", "--order", 4, "--normal-force", 100), 1),  # c1 has none there
        (("sweep", "impact", "--methods", "hb", "--orders", "3-4"), 0),
        (("sweep", "impact", "--vary", "gap=0.1:0.2:2", "--orders", "6"), 0),
    ],
)
def test_what_the_command_line_prints_is_loaded(arguments, expected, run, tmp_path) -> None:
    path = tmp_path / "file.json"
    status, out, _ = run(*arguments, "--json", "-o", path)
    assert status == expected
    assert path.read_text() == out
    found, document = ns.load(path), json.loads(out)
    rows = document.get("rows", document.get("orbits", [document]))
    there = [row for row in rows if row.get("converged", True)]
    assert (len(there) < len(rows)) == bool(expected)
    several = [found] if isinstance(found, ns.Orbit) else found
    for one, row in zip(several, there, strict=True):
        assert one.period == row["period"]
        if isinstance(one, ns.Orbit):
            assert one.as_dict().items() <= row.items()


def test_every_cell_of_a_csv_is_below_its_heading(tmp_path: Path) -> None:
    with saved("belt-sweep", tmp_path, ".csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    absent, found = (row for row in rows if row["method"] == "c1")
    made = thing("belt-sweep").of("c1")[1]
    assert (absent["status"], absent["t1"], absent["period"]) == ("no-orbit", "", "")
    assert float(found["t1"]) == made.durations[0]
    assert float(found["error_t1"]) == made.errors.t1
    assert (found["scene"], found["normal_force"]) == ("stick-slip", "100.0")


def test_no_parameter_has_the_name_of_a_column(tmp_path: Path) -> None:
    """Else its value would stand in the place of a result, or the other way round."""
    stop = ns.scene("impact")(gap=0.1)
    results = [
        thing("orbit"),
        thing("body-memory"),
        thing("sweep"),
        thing("family"),
        ns.branch(stop, "gap", 0.1, 0.11),
        ns.chart(stop, {"gap": (0.1, 0.11, 2), "force": (1.0, 1.1, 2)}),
        ns.diagram(stop, "gap", [0.1], transient=5, cycles=1),
        ns.basins(stop, [0.0], [0.0]),
    ]
    for result in results:
        case = result.case if hasattr(result, "case") else result.orbit.case
        table, path = result.table(), tmp_path / "result.csv"
        names = {*table.columns, *table.about}
        if not isinstance(result, ns.Diagram | ns.Basins):
            ns.save(result, path)
            names |= set(path.read_text().split("\n", 1)[0].split(","))
        for name in names - {*case.values, "class"}:
            with pytest.raises(SceneError, match="the name is taken by"):
                check_free(name, name)


@needs_netcdf
def test_netcdf_has_its_coordinates_in_the_root(tmp_path: Path) -> None:
    import xarray as xr

    for kind, coordinates in (
        ("orbit", {"t"}),
        ("sweep", {"method", "order"}),
        ("family", {"gap", "method", "order"}),
        ("several", {"method", "order", "t"}),
    ):
        with xr.open_dataset(saved(kind, tmp_path, ".nc")) as found:
            assert set(found.coords) >= coordinates
            if kind == "several":
                assert found["displacement"].dims == ("orbit", "sample")
                assert found["order"].values.tolist() == [5, 6]
                assert "gap" not in found.attrs  # of the first alone
                continue
            assert thing(kind).table().about.items() <= found.attrs.items()
            for name, there in thing(kind).to_xarray().data_vars.items():
                if there.dtype.kind == "f":
                    np.testing.assert_array_equal(found[name], there)


@needs_netcdf
@pytest.mark.parametrize("kind", ["orbit", "sweep", "family", "belt-c1", "several"])
def test_what_xarray_saved_again_loads(kind: str, tmp_path: Path) -> None:
    import xarray as xr

    with xr.open_dataset(saved(kind, tmp_path, ".nc")) as found:
        found.to_netcdf(tmp_path / "again.nc", engine="netcdf4")
    assert ns.load(tmp_path / "again.nc") == thing(kind)


@pytest.mark.parametrize("suffix", [".json", ".csv", pytest.param(".nc", marks=needs_netcdf)])
def test_what_is_not_there(suffix: str, tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        ns.load(tmp_path / f"nothing{suffix}")
    path = tmp_path / "nowhere" / f"orbit{suffix}"
    with pytest.raises(FileNotFoundError) as refusal:
        ns.save(thing("orbit"), path)
    assert refusal.value.filename == str(path)


@pytest.mark.parametrize("path", [None, 3, b"orbit.json", ["orbit.json"]])
def test_what_is_no_name_of_a_file(path: object) -> None:
    expected = re.escape(f"path: got {path!r}, expected the name of a file")
    with pytest.raises(TypeError, match=expected):
        ns.save(thing("orbit"), path)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=expected):
        ns.load(path)  # type: ignore[arg-type]


def test_a_failed_save_leaves_the_old_file(tmp_path: Path, monkeypatch) -> None:
    path = tmp_path / "orbit.json"
    path.write_text("old")

    def fail(*arguments: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("nonsmooth.files.api.sealed", fail)
    with pytest.raises(OSError, match="No space left"):
        ns.save(thing("orbit"), path)
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("missing", ["netCDF4", "xarray"])
def test_without_what_netcdf_needs(missing: str, run, tmp_path: Path, monkeypatch) -> None:
    def found(name: str) -> bool | None:
        return None if name == missing else True

    monkeypatch.setattr(api, "find_spec", found)
    monkeypatch.setattr("nonsmooth.extras.find_spec", found)
    with pytest.raises(ns.FileError, match=r"pip install 'nonsmooth\[netcdf\]'"):
        ns.save(thing("orbit"), tmp_path / "orbit.nc")
    status, _, err = run("solve", "--order", 5, "-o", tmp_path / "orbit.nc")
    assert status == 2
    assert err == f"nonsmooth: -o: netCDF needs {missing}: pip install 'nonsmooth[netcdf]'\n"


@pytest.mark.parametrize("kind", ["exact", "empty", "number", "both", "families", "modes"])
def test_what_is_no_orbit_is_not_saved(kind: str, tmp_path: Path) -> None:
    things = {
        "exact": ns.exact(BELT),
        "empty": [],
        "number": 3,
        "both": [thing("orbit"), thing("family")],
        "families": [thing("family")],
        "modes": [thing("modes"), thing("modes-sound")],  # of two structures
    }
    target = tmp_path / "orbit.json"
    target.write_text("before")
    with pytest.raises(TypeError, match=r"^thing: got .*, expected an orbit"):
        ns.save(things[kind], target)
    assert target.read_text() == "before"
