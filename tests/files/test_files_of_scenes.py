"""Orbits, sweeps and families of any scene: saved, loaded, and equal to what was saved."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.files.json_text import sealed

try:
    import netCDF4
except ImportError:
    netCDF4 = None

NETCDF = pytest.param(
    ".nc", marks=pytest.mark.skipif(netCDF4 is None, reason="netCDF4 is not installed")
)
FORMS = [".json", NETCDF]

MADE = {
    "orbit": lambda: ns.solve(ns.scene("impact")(gap=math.pi / 10), "hb-ck", 5, functions=2),
    "motion": lambda: ns.solve(ns.scene("dry-friction")(frequency=0.4), order=6),
    "memory": lambda: ns.solve(ns.scene("elastic-plastic")(), order=6),
    "cycles": lambda: ns.solve(ns.scene("impact")(frequency=3.6), order=8, cycles=2),
    "sweep": lambda: ns.sweep(ns.scene("impact")(), ["hb", "ck"], [3, 5]),
    "sweep-of-nothing": lambda: ns.sweep(ns.scene("impact")(gap=50.0), ["hb"], [3]),
    "family": lambda: ns.family(ns.scene("impact")(), "gap", [0.1, 0.2, 50.0], order=6),
}


@pytest.fixture(scope="module")
def made():
    """Return one of each kind."""
    return {kind: make() for kind, make in MADE.items()}


@pytest.mark.parametrize("suffix", FORMS)
@pytest.mark.parametrize("kind", MADE)
def test_what_is_loaded_is_what_was_saved(kind: str, suffix: str, made, tmp_path: Path) -> None:
    path = tmp_path / f"thing{suffix}"
    ns.save(made[kind], path)
    found = ns.load(path)
    assert type(found) is type(made[kind])
    assert found == made[kind]
    if isinstance(found, ns.Orbit):
        assert found.outcome.reason == "converged"
        assert found.iterations == made[kind].iterations
        assert found.as_dict() == made[kind].as_dict()


@pytest.mark.parametrize("suffix", FORMS)
def test_several_orbits_of_several_cases(suffix: str, made, tmp_path: Path) -> None:
    several = [made["orbit"], made["motion"]]
    ns.save(several, tmp_path / f"orbits{suffix}")
    assert ns.load(tmp_path / f"orbits{suffix}") == several


@pytest.mark.parametrize(
    "arguments",
    [
        ("solve", "impact", "--order", "5"),
        ("solve", "dry-friction", "--method", "hb", "--order", "4"),
        ("sweep", "impact", "--methods", "hb", "--orders", "3-4"),
        ("sweep", "impact", "--vary", "gap=0.1:0.2:2", "--orders", "6"),
    ],
)
def test_what_the_command_line_prints_is_loaded(arguments, run, tmp_path: Path) -> None:
    path, printed = tmp_path / "file.json", tmp_path / "printed.json"
    status, out, _ = run(*arguments, "--json", "-o", path)
    assert status == 0
    printed.write_text(out)
    assert path.read_text() == out
    found = ns.load(printed)
    document = json.loads(out)
    if "rows" in document:
        assert [row.period for row in found] == [row["period"] for row in document["rows"]]
    else:
        several = found if isinstance(found, list) else [found]
        assert [q.method for q in several] == [
            q["method"] for q in document.get("orbits", [document])
        ]


@pytest.mark.parametrize("kind", ["orbit", "sweep", "family"])
def test_csv_is_for_other_programs(kind: str, made, tmp_path: Path) -> None:
    path = tmp_path / "thing.csv"
    ns.save(made[kind], path)
    assert path.read_text().count("\n") > 3
    with pytest.raises(
        ns.FileError, match=r"CSV is for other programs; save as \.json to load it"
    ):
        ns.load(path)


def test_a_scene_that_is_not_shipped_is_given(tmp_path: Path, made) -> None:
    path = tmp_path / "own.json"
    ns.save(made["orbit"], path)
    path.write_text(path.read_text().replace('"scene": "impact"', '"scene": "drum"'))
    with (
        pytest.warns(ns.FileWarning, match="digest"),
        pytest.raises(ns.FileError, match=r"of the scene 'drum', which is not shipped: "),
    ):
        ns.load(path)
    with (
        pytest.warns(ns.FileWarning, match="digest"),
        pytest.raises(ns.FileError, match=r"of the scene 'drum', got 'impact'"),
    ):
        ns.load(path, scene="impact")


def _edited(path: Path, change) -> None:
    document = json.loads(path.read_text())
    change(document)
    path.write_text(json.dumps(document))


def _unknown(document: dict, value: float) -> None:
    document["outcome"]["unknowns"][0] = value


EDITS = {
    "period is -1": lambda d: d.update(period=-1),
    "period is 4.0, but its durations give 3.49": lambda d: d.update(period=4.0),
    "duration 1 is 0": lambda d: d["phases"][0].update(duration=0),
    r"\d+ unknowns, expected \d+": lambda d: d["outcome"]["unknowns"].append(0.0),
    "an orbit that does not satisfy its equations": lambda d: _unknown(d, 0.3),
    "unknowns that are not finite": lambda d: _unknown(d, math.inf),
    "an orbit of other equations": lambda d: d.update(mathematics="0" * 16),
    "ParameterError mass: got -1": lambda d: d["parameters"].update(mass=-1),
    "KeyError 'method'": lambda d: d.pop("method"),
    "without its unknowns": lambda d: d.pop("outcome"),
}


@pytest.mark.filterwarnings("ignore::nonsmooth.FileWarning")
@pytest.mark.parametrize("problem", EDITS)
def test_an_orbit_that_cannot_be_right_is_refused(problem: str, made, tmp_path: Path) -> None:
    path = tmp_path / "orbit.json"
    ns.save(made["orbit"], path)
    _edited(path, EDITS[problem])
    with pytest.raises(ns.FileError, match=problem):
        ns.load(path)


ROW_EDITS = {
    "status is 'fine'": lambda r: r.update(status="fine"),
    "period is 0": lambda r: r.update(period=0),
    "iterations is -1": lambda r: r.update(iterations=-1),
    "times is -0.1": lambda r: r["estimate"].update(times=-0.1),
    "but its durations give": lambda r: r.update(durations=[1.0]),
}


@pytest.mark.filterwarnings("ignore::nonsmooth.FileWarning")
@pytest.mark.parametrize("kind", ["sweep", "family"])
@pytest.mark.parametrize("problem", ROW_EDITS)
def test_a_row_that_cannot_be_right_is_refused(
    problem: str, kind: str, made, tmp_path: Path
) -> None:
    path = tmp_path / "rows.json"
    ns.save(made[kind], path)
    place = 0 if kind == "family" else 1
    assert json.loads(path.read_text())["rows"][place]["status"] == "ok"
    _edited(path, lambda d: ROW_EDITS[problem](d["rows"][place]))
    with pytest.raises(ns.FileError, match=problem):
        ns.load(path)


@pytest.mark.filterwarnings("ignore::nonsmooth.FileWarning")
def test_a_family_with_a_row_too_few_is_refused(made, tmp_path: Path) -> None:
    path = tmp_path / "family.json"
    ns.save(made["family"], path)
    _edited(path, lambda d: d["rows"].pop())
    with pytest.raises(ns.FileError, match="2 rows of 3"):
        ns.load(path)


def test_what_has_no_orbit_is_no_file_of_one(run, tmp_path: Path) -> None:
    path = tmp_path / "none.json"
    run("solve", "impact", "--gap", "5", "--method", "ck", "--order", "7", "-o", path)
    with pytest.raises(ns.FileError, match="no orbit: impact: no such orbit exists"):
        ns.load(path)


@pytest.mark.skipif(netCDF4 is None, reason="netCDF4 is not installed")
def test_netcdf_has_its_coordinates_in_the_root(made, tmp_path: Path) -> None:
    xr = pytest.importorskip("xarray", reason="xarray is not installed")
    for kind, coordinates in (
        ("orbit", {"t"}),
        ("sweep", {"method", "order"}),
        ("family", {"gap"}),
    ):
        path = tmp_path / f"{kind}.nc"
        ns.save(made[kind], path)
        with xr.open_dataset(path) as found:
            assert set(found.coords) >= coordinates
            there = made[kind].to_xarray()
            for name in there.data_vars:
                if there[name].dtype.kind == "f":
                    np.testing.assert_array_equal(found[name], there[name])
    ns.save([made["orbit"], made["motion"]], tmp_path / "two.nc")
    with xr.open_dataset(tmp_path / "two.nc") as two:
        assert set(two.coords) >= {"method", "order", "t"}
        assert two["displacement"].dims == ("orbit", "sample")
        assert two["order"].values.tolist() == [5, 6]


@pytest.mark.parametrize(
    "content",
    [
        {"scene": "impact", "parameters": {}, "lost": False, "rows": []},  # of ``digits``
        {"scene": "impact", "parameters": {}, "points": []},  # of ``tradeoff``
        {"scene": "impact", "parameters": {}, "phases": [{}]},  # of ``simulate``
    ],
)
def test_files_for_other_programs(content, tmp_path: Path) -> None:
    path = tmp_path / "other.json"
    path.write_text(sealed(content))
    with pytest.raises(
        ns.FileError, match="json: holds no orbit, sweep, family or modes: noth"
    ):
        ns.load(path)


@pytest.mark.parametrize("kind", ["orbit", "sweep", "family"])
def test_a_parameter_that_is_missing_has_no_default(kind: str, made, tmp_path: Path) -> None:
    path = tmp_path / "thing.json"
    ns.save(made[kind], path)
    document = json.loads(path.read_text())
    del document["parameters"]["mass"]  # 1, as its default
    path.write_text(sealed(document))
    with pytest.raises(ns.FileError, match=r"damaged: parameters without mass$"):
        ns.load(path)


def test_a_folder_that_is_not_there(made, tmp_path: Path) -> None:
    path = tmp_path / "nowhere" / "orbit.json"
    with pytest.raises(FileNotFoundError) as refusal:
        ns.save(made["orbit"], path)
    assert refusal.value.filename == str(path)
