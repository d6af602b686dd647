"""Files: what was saved is loaded bit for bit, and what is damaged is refused."""

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.files import api, json_text
from nonsmooth.files.shortcuts.origin import mathematics
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT, PARAMETERS

try:
    import netCDF4
except ImportError:
    netCDF4 = None

BELT = replace(DEFAULT, mass=math.pi, mu_s=0.1 + 0.2, mu_k=0.2, belt_speed=0.05)

NETCDF = pytest.param(
    ".nc", marks=pytest.mark.skipif(netCDF4 is None, reason="netCDF4 is not installed")
)
EVERY = [".json", ".csv", NETCDF]
ORBITS = [".json", NETCDF]


def there_and_back(thing, path: Path):
    ns.save(thing, path)
    return ns.load(path)


def assert_same_orbit(found: ns.Orbit, orbit: ns.Orbit) -> None:
    assert found.belt == orbit.belt
    assert (found.method, found.order, found.c1_terms) == (
        orbit.method, orbit.order, orbit.c1_terms,
    )  # fmt: skip
    assert found.unknowns.tobytes() == orbit.unknowns.tobytes()
    assert found.iterations == orbit.iterations
    for name in ("converged", "iterations", "correction", "residual_norm", "reason"):
        assert getattr(found.outcome, name) == getattr(orbit.outcome, name)
    assert found.errors == orbit.errors
    assert found.estimate == orbit.estimate
    assert str(found) == str(orbit)


@pytest.mark.parametrize("suffix", ORBITS)
@pytest.mark.parametrize(
    ("method", "order", "terms"), [("hb", 9, 1), ("hb-c1", 9, 1), ("hb-c1", 9, 3), ("c1", 9, 1)]
)
def test_an_orbit(suffix: str, method: str, order: int, terms: int, tmp_path: Path) -> None:
    orbit = ns.solve(BELT, method, order, c1_terms=terms)
    found = there_and_back(orbit, tmp_path / f"orbit{suffix}")
    assert_same_orbit(found, orbit)
    with pytest.raises(ValueError, match="read-only"):
        found.unknowns[0] = 1


@pytest.mark.parametrize("suffix", ORBITS)
def test_several_orbits(suffix: str, tmp_path: Path) -> None:
    orbits = [ns.solve(BELT, "c1", 7), ns.solve(DEFAULT, "hb", 5)]
    found = there_and_back(orbits, tmp_path / f"orbits{suffix}")
    for one, orbit in zip(found, orbits, strict=True):
        assert_same_orbit(one, orbit)


@pytest.mark.parametrize("suffix", EVERY)
def test_a_sweep(suffix: str, tmp_path: Path) -> None:
    sweep = ns.sweep(BELT, orders=[1, 2, 3, 8], c1_terms=2)
    assert {row.status for row in sweep.rows} > {"ok"}
    assert there_and_back(sweep, tmp_path / f"sweep{suffix}") == sweep


@pytest.mark.parametrize("suffix", EVERY)
@pytest.mark.parametrize("parameter", PARAMETERS)
def test_a_family(suffix: str, parameter: str, tmp_path: Path) -> None:
    first = getattr(BELT, parameter)
    family = ns.family(BELT, parameter, np.linspace(1.1 * first, 1.3 * first, 7), "hb", 3)
    found = there_and_back(family, tmp_path / f"family{suffix}")
    assert found.points.tobytes() == family.points.tobytes()
    assert (found.parameter, found.method, found.order) == (parameter, "hb", 3)
    assert found.belt == family.belt


@pytest.mark.parametrize("suffix", EVERY)
def test_families_without_some_orbits(suffix: str, tmp_path: Path, run) -> None:
    target = tmp_path / f"family{suffix}"
    vary = ("--vary", "belt-speed=0.001:1:4", "--log", "--orders", 5)
    run("sweep", *vary, "--methods", "hb,c1", "-o", target)
    values = ns.load(target)[0]["value"]
    assert (values[0], values[-1]) == (0.001, 1.0)
    for found, method in zip(ns.load(target), ("hb", "c1"), strict=True):
        expected = ns.family(DEFAULT, "belt_speed", values, method, 5)
        assert found.points.tobytes() == expected.points.tobytes()


@pytest.mark.parametrize("suffix", EVERY)
def test_what_the_command_line_writes_is_loaded(suffix: str, tmp_path: Path, run) -> None:
    target = tmp_path / f"sweep{suffix}"
    assert run("sweep", "--orders", "5-6", "--methods", "c1,hb", "-o", target)[0] == 0
    assert [row.method for row in ns.load(target).rows] == ["c1", "c1", "hb", "hb"]


def test_what_solve_prints_is_loaded(tmp_path: Path, run) -> None:
    target, printed = tmp_path / "orbits.json", tmp_path / "printed.json"
    status, out, _ = run("solve", "--order", 4, "--belt-speed", 0.05, "--json", "-o", target)
    printed.write_text(out)
    assert target.read_text() == out
    assert status == 1  # hb-c1 has none there
    found = ns.load(printed)
    expected = [
        (orbit["method"], orbit["t1"])
        for orbit in json.loads(out)["orbits"]
        if orbit["converged"]
    ]
    assert [(orbit.method, orbit.t1) for orbit in found] == expected
    status, out, _ = run("solve", "--method", "c1", "--order", 5, "--digits", 15, "--json")
    printed.write_text(out)
    assert ns.load(printed).order == 5


def test_the_motion_of_orbits_as_csv(tmp_path: Path, run) -> None:
    target = tmp_path / "motion.csv"
    run("solve", "--order", 6, "-o", target)
    table = np.genfromtxt(target, delimiter=",", names=True, dtype=None, encoding=None)
    orbit = ns.solve(DEFAULT, "c1", 6)
    own = table[table["method"] == "c1"]
    assert np.array_equal(own["displacement"], orbit.displacement(own["t"]))
    assert np.array_equal(own["acceleration"], orbit.acceleration(own["t"]))
    with pytest.raises(ns.FileError, match=r"motion.csv: the motion of an orbit; save"):
        ns.load(target)


def test_no_orbit_is_no_file(tmp_path: Path, run) -> None:
    target = tmp_path / "motion.csv"
    arguments = ("--method", "hb", "--order", 3, "--belt-speed", 1e-4)
    status, _, err = run("solve", *arguments, "-o", target)
    assert status == 1
    assert "is not written" in err
    assert not target.exists()


def test_units_version_and_mathematics(tmp_path: Path) -> None:
    path = tmp_path / "orbit.json"
    ns.save(ns.solve(BELT, "c1", 5), path)
    document = json.loads(path.read_text())
    assert document["schema"] == 1
    assert document["version"] == ns.__version__
    assert document["mathematics"] == mathematics(["c1"])
    assert document["units"]["period"] == "s"
    assert document["units"]["coefficients"] == {"c1": {"d": "m/s**(n + 2)"}}


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
        else:
            # A digit of a CSV may become another one; in JSON, an e of a number an E.
            assert suffix == ".csv" or (suffix == ".json" and found == sweep)


@pytest.mark.parametrize("suffix", EVERY)
def test_a_file_that_ends_early(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"family{suffix}"
    family = ns.family(DEFAULT, "mass", np.linspace(1, 2, 30))
    ns.save(family, path)
    whole = path.read_bytes()
    for part in (0, 10, len(whole) // 2, len(whole) - 40):
        path.write_bytes(whole[:part])
        if suffix == ".nc" and part == len(whole) - 40:  # it ends within its digest
            with pytest.warns(ns.FileWarning, match="has no digest"):
                assert ns.load(path) == family
            continue
        with pytest.raises(ns.FileError):
            ns.load(path)
    if suffix == ".csv":
        path.write_bytes(whole[: whole[:-1].rindex(b"\n") + 1])
        with pytest.raises(ns.FileError, match="29 rows of 30"):
            ns.load(path)


@pytest.mark.parametrize("suffix", EVERY)
def test_a_newer_schema(suffix: str, tmp_path: Path, monkeypatch) -> None:
    path = tmp_path / f"sweep{suffix}"
    sweep = ns.sweep(DEFAULT, ["c1"], orders=[5])
    with monkeypatch.context() as patch:
        for module in ("json_text", "shortcuts.tables", "netcdf"):
            if module != "netcdf" or netCDF4 is not None:
                patch.setattr(f"nonsmooth.files.{module}.SCHEMA", 2)
        ns.save(sweep, path)
    with pytest.raises(ns.FileError, match=r"schema 2 is from a newer nonsmooth; .* up to 1"):
        ns.load(path)


@pytest.mark.parametrize("suffix", ORBITS)
def test_an_orbit_of_other_equations(suffix: str, tmp_path: Path, monkeypatch) -> None:
    path = tmp_path / f"orbit{suffix}"
    with monkeypatch.context() as patch:
        patch.setattr("nonsmooth.generated.shortcuts.c1.MATHEMATICS", "other")
        ns.save(ns.solve(DEFAULT, "c1", 5), path)
    with pytest.raises(ns.FileError, match="an orbit of other equations"):
        ns.load(path)


@pytest.mark.parametrize(
    ("name", "content", "expected"),
    [
        ("a.json", "{}", "not a file of nonsmooth"),
        ("a.json", "[1]", "not a file of nonsmooth"),
        ("a.json", "nothing", "not JSON"),
        ("a.json", json_text.sealed({"roots": []}), "holds no orbit, sweep, family or modes"),
        ("a.csv", "", "not a file of nonsmooth"),
        ("a.csv", "x,y\n1,2\n", "not a file of nonsmooth"),
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


def test_families_over_other_values_do_not_go_together(tmp_path: Path) -> None:
    families = [ns.family(DEFAULT, "mass", [1.0, 2.0]), ns.family(DEFAULT, "mass", [1.0, 3.0])]
    with pytest.raises(ValueError, match="same values"):
        ns.save(families, tmp_path / "families.json")


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


def edited(path: Path, line: int, column: str, factor: float) -> None:
    """Multiply one number of a CSV file."""
    rows = [row.split(",") for row in path.read_text().splitlines()]
    place = rows[0].index(column)
    rows[line - 1][place] = repr(float(rows[line - 1][place]) * factor)
    path.write_text("\n".join(map(",".join, rows)) + "\n")


@pytest.mark.parametrize(
    ("column", "named"),
    [
        *((name, name) for name in ("t1", "period", "error_t1", "error_period")),
        ("mass", "parameters"),
    ],
)
def test_an_edited_number_of_a_sweep_is_named(column: str, named: str, tmp_path: Path) -> None:
    path = tmp_path / "sweep.csv"
    ns.save(ns.sweep(DEFAULT, ["hb"], orders=[5, 6]), path)
    edited(path, 2, column, 1.0)
    assert len(ns.load(path).rows) == 2
    edited(path, 2, column, 1 + 1e-9 if column.startswith("error") else 1 + 1e-11)
    if column == "mass":
        edited(path, 3, column, 1 + 1e-11)
    with pytest.raises(ns.FileError, match=rf"damaged.*line 2: .*{named}"):
        ns.load(path)


@pytest.mark.parametrize("column", ["period", "t1", "stick_fraction", "alpha", "mass"])
def test_an_edited_number_of_a_family_is_named(column: str, tmp_path: Path) -> None:
    path = tmp_path / "family.csv"
    ns.save(ns.family(DEFAULT, "mass", [1.0, 2.0, 3.0], "c1", 8), path)
    edited(path, 3, column, 1.0)
    assert len(ns.load(path).points) == 3
    edited(path, 3, column, 1 + 1e-11)
    with pytest.raises(ns.FileError, match=rf"damaged.*line 3: .*{column}"):
        ns.load(path)


@pytest.mark.parametrize(
    ("old", "new"), [(",ok,", ",banana,"), ("c1,5,", "c2,5,"), ("c1,5,", "c1,five,")]
)
def test_a_row_that_is_none(old: str, new: str, tmp_path: Path) -> None:
    path = tmp_path / "rows.csv"
    ns.save(ns.sweep(DEFAULT, methods=["c1"], orders=[5]), path)
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))
    with pytest.raises(ns.FileError, match="damaged"):
        ns.load(path)


def test_a_document_of_no_sensible_depth(tmp_path: Path) -> None:
    path = tmp_path / "deep.json"
    path.write_text("[" * 200_000)
    with pytest.raises(ns.FileError, match="not JSON"):
        ns.load(path)
