"""Files: what was saved is loaded bit for bit, and what is damaged is refused."""

import csv
import json
import math
import re
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.files import api, json_text
from nonsmooth.kim_perkins import SECTION_4
from nonsmooth.solver.case.registry import mathematics

try:
    import netCDF4
except ImportError:
    netCDF4 = None

DEFAULT = ns.StickSlip(**SECTION_4)
BELT = ns.StickSlip(**SECTION_4 | {"mass": math.pi, "mu_s": 0.1 + 0.2, "mu_k": 0.2})

NETCDF = pytest.param(
    ".nc", marks=pytest.mark.skipif(netCDF4 is None, reason="netCDF4 is not installed")
)
EVERY = [".json", NETCDF]


@pytest.mark.parametrize("suffix", EVERY)
@pytest.mark.parametrize("method", ["hb", "hb-c1", "c1", "c1-tau"])
def test_an_orbit_of_the_paper(method: str, suffix: str, tmp_path: Path) -> None:
    orbit = ns.solve(BELT, method, 9)
    ns.save(orbit, tmp_path / f"orbit{suffix}")
    found = ns.load(tmp_path / f"orbit{suffix}")
    assert found == orbit
    assert (type(found), found.errors) == (type(orbit), orbit.errors)
    assert found.unknowns.tobytes() == orbit.unknowns.tobytes()
    with pytest.raises(ValueError, match="read-only"):
        found.unknowns[0] = 1


@pytest.mark.parametrize("suffix", EVERY)
def test_rows_of_the_paper_some_without_orbits(suffix: str, tmp_path: Path) -> None:
    light = ns.StickSlip(**SECTION_4 | {"normal_force": 100})
    for thing in (
        ns.sweep(light, ["hb", "c1"], [4, 5]),
        ns.family(DEFAULT, "normal_force", [100.0, 400.0], "c1", 4),
    ):
        assert {row.status for row in thing} == {"ok", "no-orbit"}
        ns.save(thing, tmp_path / f"rows{suffix}")
        assert ns.load(tmp_path / f"rows{suffix}") == thing


def test_every_cell_of_a_csv_is_below_its_heading(tmp_path: Path) -> None:
    sweep = ns.sweep(ns.StickSlip(**SECTION_4 | {"normal_force": 100}), ["c1"], [4, 5])
    ns.save(sweep, tmp_path / "rows.csv")
    with (tmp_path / "rows.csv").open(newline="") as file:
        absent, found = csv.DictReader(file)
    assert (absent["status"], absent["t1"], absent["period"]) == ("no-orbit", "", "")
    assert float(found["t1"]) == sweep[1].durations[0]
    assert float(found["error_t1"]) == sweep[1].errors.t1
    assert (found["scene"], found["normal_force"]) == ("stick-slip", "100.0")


def test_what_solve_prints_is_loaded(tmp_path: Path, run) -> None:
    printed = tmp_path / "printed.json"
    status, out, _ = run("solve", "--order", 4, "--normal-force", 100, "--json")
    printed.write_text(out)
    assert status == 1  # c1 has none there
    orbits = [orbit for orbit in json.loads(out)["orbits"] if orbit["converged"]]
    assert "c1" not in [orbit["method"] for orbit in orbits]
    assert [orbit.t1 for orbit in ns.load(printed)] == [orbit["t1"] for orbit in orbits]


def test_the_motion_of_orbits_as_csv(tmp_path: Path, run) -> None:
    target = tmp_path / "motion.csv"
    run("solve", "--order", 6, "-o", target)
    table = np.genfromtxt(target, delimiter=",", names=True, dtype=None, encoding=None)
    orbit = ns.solve(DEFAULT, "c1", 6)
    own = table[table["method"] == "c1"]
    assert np.array_equal(own["displacement"], orbit.displacement(own["t"]))
    assert np.array_equal(own["acceleration"], orbit.acceleration(own["t"]))
    with pytest.raises(
        ns.FileError,
        match=r"motion.csv: CSV is for other programs; save",
    ):
        ns.load(target)


def test_units_version_and_mathematics(tmp_path: Path) -> None:
    path = tmp_path / "orbit.json"
    ns.save(ns.solve(BELT, "c1", 5), path)
    document = json.loads(path.read_text())
    assert document["schema"] == 1
    assert document["version"] == ns.__version__
    assert document["mathematics"] == mathematics(BELT.scene, ["ck"])
    assert document["units"]["period"] == "s"


@pytest.mark.parametrize("suffix", EVERY)
def test_every_byte_that_is_changed_is_noticed(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"sweep{suffix}"
    sweep = ns.sweep(BELT, ["c1"], orders=range(5, 25))
    ns.save(sweep, path)
    whole = path.read_bytes()
    rng = np.random.default_rng(1)
    for place in rng.integers(0, len(whole), 150).tolist():
        changed = bytearray(whole)
        changed[place] ^= 1 << int(rng.integers(0, 8))
        path.write_bytes(changed)
        try:
            found = ns.load(path)
        except (ns.FileError, ns.FileWarning) as error:
            assert str(path) in str(error)  # noqa: PT017
        else:  # an e of a number that became an E, a byte of the word before the digest
            assert found == sweep


@pytest.mark.parametrize("suffix", EVERY)
def test_a_file_that_ends_early(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"family{suffix}"
    family = ns.family(DEFAULT, "mass", np.linspace(1, 2, 30), order=5)
    ns.save(family, path)
    whole = path.read_bytes()
    for part in (0, 10, len(whole) // 2, len(whole) - 40):
        path.write_bytes(whole[:part])
        if suffix == ".nc" and part == len(whole) - 40:  # its document has a digest, too
            assert ns.load(path) == family
            continue
        with pytest.raises(ns.FileError):
            ns.load(path)


@pytest.mark.parametrize("suffix", EVERY)
def test_a_newer_schema(suffix: str, tmp_path: Path, monkeypatch) -> None:
    path = tmp_path / f"sweep{suffix}"
    sweep = ns.sweep(DEFAULT, ["c1"], orders=[5])
    with monkeypatch.context() as patch:
        for module in ("json_text", "netcdf"):
            if module != "netcdf" or netCDF4 is not None:
                patch.setattr(f"nonsmooth.files.{module}.SCHEMA", 2)
        ns.save(sweep, path)
    with pytest.raises(ns.FileError, match=r"schema 2 is from a newer nonsmooth; .* up to 1"):
        ns.load(path)


@pytest.mark.parametrize(
    ("name", "content", "expected"),
    [
        ("a.json", "{}", "not a file of nonsmooth"),
        ("a.json", "[1]", "not a file of nonsmooth"),
        ("a.json", "nothing", "not JSON"),
        ("a.json", json_text.sealed({"roots": []}), "holds no orbit, sweep, family or modes"),
        ("a.csv", "x,y\n1,2\n", "CSV is for other programs"),
        ("a.txt", "", "expected a name that ends in one of .json, .csv, .nc"),
    ],
)
def test_files_of_others(name: str, content: str, expected: str, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_text(content)
    with pytest.raises(ns.FileError, match=expected):
        ns.load(path)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    for suffix in (".json", ".csv"):
        with pytest.raises(FileNotFoundError):
            ns.load(tmp_path / f"nothing{suffix}")


def test_a_failed_save_leaves_the_old_file(tmp_path: Path, monkeypatch) -> None:
    path = tmp_path / "orbit.json"
    path.write_text("old")

    def fail(*arguments: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("nonsmooth.files.api.sealed", fail)
    with pytest.raises(OSError, match="No space left"):
        ns.save(ns.solve(DEFAULT, "c1", 5), path)
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_without_netcdf4(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(api, "find_spec", lambda name: None)
    with pytest.raises(ns.FileError, match=r"pip install 'nonsmooth\[netcdf\]'"):
        ns.save(ns.solve(DEFAULT, "c1", 5), tmp_path / "orbit.nc")


@pytest.mark.parametrize("kind", ["exact", "empty", "number", "both"])
def test_what_is_no_orbit_is_not_saved(kind: str, tmp_path: Path) -> None:
    orbit = ns.solve(DEFAULT, "c1", 5)
    family = ns.family(DEFAULT, "belt_speed", [1.0], "c1", 5)
    things = {"exact": ns.exact(DEFAULT), "empty": [], "number": 3, "both": [orbit, family]}
    target = tmp_path / "orbit.json"
    target.write_text("before")
    with pytest.raises(TypeError, match=r"^thing: got .*, expected an orbit"):
        ns.save(things[kind], target)
    assert target.read_text() == "before"


def test_a_document_of_no_sensible_depth(tmp_path: Path) -> None:
    path = tmp_path / "deep.json"
    path.write_text("[" * 200_000)
    with pytest.raises(ns.FileError, match="not JSON"):
        ns.load(path)


#: What documents of the kernels for the paper alone had, which was given up.
OLD = {
    "an orbit of other equations (4877ec5e16119ccc): compute it anew": {
        "method": "c1", "order": 5, "converged": True, "exact": {}, "phases": [],
        "outcome": {"unknowns": []},
    },
    "a sweep of other equations (4877ec5e16119ccc): compute it anew": {
        "c1_terms": 1, "rows": [{"method": "c1"}], "rates": {},
    },
    "damaged: KeyError 'method'": {
        "vary": {"parameter": "mass"}, "order": 5, "c1_terms": 1, "rows": [],
    },
}  # fmt: skip


@pytest.mark.parametrize("problem", OLD)
def test_what_older_kernels_found_is_refused(problem: str, tmp_path: Path) -> None:
    path = tmp_path / "old.json"
    head = {"schema": 1, "scene": "stick-slip", "mathematics": "4877ec5e16119ccc"}
    path.write_text(json_text.sealed(head | {"parameters": SECTION_4} | OLD[problem]))
    with pytest.raises(ns.FileError, match=re.escape(problem)):
        ns.load(path)
