"""Modes as files: saved, loaded, equal to what was saved, and refused where they cannot be."""

import csv
import json
import math
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns

try:
    import netCDF4
except ImportError:
    netCDF4 = None

NETCDF = pytest.param(
    ".nc", marks=pytest.mark.skipif(netCDF4 is None, reason="netCDF4 is not installed")
)
FORMS = [".json", NETCDF]

MADE = {
    "default": lambda: ns.modes("beam-mass"),
    "node": lambda: ns.modes("beam-rotational-spring", position="1/2", count=3),
    "forced": lambda: ns.modes("string-mass", forced=2, order=5, position=0.27, mass=3.3),
    "nothing-proved": lambda: ns.modes("beam-crack", "ck", 12, length=2.0),
    "sound": lambda: ns.modes("beam-crack", "ritz", 4),
}


@pytest.fixture(scope="module")
def made():
    """Return one of each kind."""
    return {kind: make() for kind, make in MADE.items()}


@pytest.mark.parametrize("suffix", FORMS)
@pytest.mark.parametrize("kind", MADE)
def test_what_is_loaded_is_what_was_saved(kind: str, suffix: str, made, tmp_path: Path) -> None:
    path, saved = tmp_path / f"modes{suffix}", made[kind]
    ns.save(saved, path)
    found = ns.load(path)
    assert type(found) is ns.Modes
    assert found == saved
    assert found.attached == saved.attached
    x = np.linspace(0, saved.attached.length, 7)
    for mode, other in zip(found, saved, strict=True):
        assert mode.as_dict() == other.as_dict()
        assert (mode.shape(x, 1) == other.shape(x, 1)).all()


def several() -> list[ns.Modes]:
    """Return expansions of one structure, of different methods, places and counts."""
    methods = [ns.modes("beam-crack", method) for method in ("ritz", "ritz-ck", "ck")]
    return [*methods, ns.modes("beam-crack", position=0.25, compliance=3, count=2)]


@pytest.mark.parametrize("suffix", FORMS)
def test_several_of_one_structure(suffix: str, tmp_path: Path) -> None:
    path, saved = tmp_path / f"modes{suffix}", several()
    ns.save(saved, path)
    assert ns.load(path) == saved
    ns.save(saved[:1], path)
    assert ns.load(path) == saved[0]


def test_modes_of_several_structures_are_not_one_file(made, tmp_path: Path) -> None:
    with pytest.raises(TypeError, match="expected an orbit, a branch, a family, modes, a seq"):
        ns.save([made["default"], made["sound"]], tmp_path / "modes.json")
    assert list(tmp_path.iterdir()) == []


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


@pytest.mark.skipif(netCDF4 is None, reason="netCDF4 is not installed")
def test_arrays_that_contradict_the_document_are_refused(made, tmp_path: Path) -> None:
    path = tmp_path / "modes.nc"
    ns.save(made["default"], path)
    with netCDF4.Dataset(path, "a") as file:
        file["frequency"][2] = 1.0
    with pytest.raises(ns.FileError, match="frequency is not what its document says"):
        ns.load(path)


@pytest.mark.parametrize(
    "arguments",
    [
        ("--order", "5", "--count", "2"),
        ("--method", "all", "--count", "2"),
        ("--vary", "position=1/10:1/2:3", "--count", "2"),
        ("--vary", "bending-stiffness=1:2:2", "--count", "1"),
    ],
)
def test_what_the_command_line_writes_is_loaded(arguments, run, tmp_path: Path) -> None:
    path = tmp_path / "file.json"
    status, out, _ = run("modes", "beam-mass", *arguments, "--json", "-o", path)
    assert (status, path.read_text("utf-8")) == (0, out)
    found, document = ns.load(path), json.loads(out)
    every = document.get("expansions", document.get("points", [document]))
    several_found = found if isinstance(found, list) else [found]
    assert isinstance(found, list) == ("modes" not in document)
    for modes, each in zip(several_found, every, strict=True):
        assert modes.as_dict() == {name: each[name] for name in modes.as_dict()}
    if netCDF4 is not None:
        arrays = tmp_path / "file.nc"
        status, _, err = run("modes", "beam-mass", *arguments, "-o", arrays)
        assert (status, err) == (0, f"wrote {arrays}\n")
        assert ns.load(arrays) == found


def test_csv_has_what_is_needed_to_compute_it_again(made, run, tmp_path: Path) -> None:
    path, saved = tmp_path / "modes.csv", made["forced"]
    ns.save(saved, path)
    rows = list(csv.DictReader(path.read_text("utf-8").splitlines()))
    assert [float(row["frequency"]) for row in rows] == [mode.frequency for mode in saved]
    row = rows[0]
    given = {name: float(row[name]) for name in saved.attached.values}
    how = (row["structure"], row["method"], int(row["order"]), int(row["forced"]), len(rows))
    assert ns.modes(*how, position=row["position"], **given) == saved
    with pytest.raises(ns.FileError, match=r"CSV is for other programs; save as \.json"):
        ns.load(path)
    varied = ("--vary", "bending-stiffness=1:2:2", "--count", "1", "-o", path)
    assert run("modes", "beam-mass", *varied)[0] == 0
    header, *lines = path.read_text("utf-8").splitlines()
    assert header.startswith("bending-stiffness,method,")
    assert header.endswith("node,structure,position,strength,length,mass_per_length,mass")
    assert all(line.count(",") == header.count(",") for line in lines)


def test_a_study_of_convergence_is_not_loaded(run, tmp_path: Path) -> None:
    path = tmp_path / "study.json"
    assert run("sweep", "string-mass", "--orders", "4", "-o", path)[0] == 0
    with pytest.raises(ns.FileError, match="holds no modes"):
        ns.load(path)


def _mode(**changed):
    return lambda document: document["modes"][1].update(changed)


EDITS = {
    "mode 2: eigenvalue is 700.0, but its parameters give 716.66": _mode(eigenvalue=700.0),
    "mode 2: frequency is None": _mode(frequency=None),
    "mode 2: beta is -5": _mode(beta=-5),
    "mode 2: exact beta is 5.1": _mode(exact={"beta": 5.1}),
    "mode 2: error is 1e-09": _mode(error=1e-9),
    "mode 2: bound is 716.7,": _mode(bounds=[700, 716.7]),
    "mode 2: bound is None": lambda d: d["modes"][1]["bounds"].__setitem__(0, None),
    "mode 2: bound is 716.66, but": lambda d: d["modes"][1]["bounds"].__setitem__(0, 716.66),
    "mode 2: jump_mismatch is 0.5": _mode(jump_mismatch=0.5),
    "mode 2: node is 3, expected None": _mode(node=3),
    "mode 2: number is 1, expected 2": _mode(number=1),
    "strength is 3, but its parameters give 10.0": lambda d: d.update(strength=3),
    "unknowns is 3, expected 9": lambda d: d.update(unknowns=3),
    "forced is True, expected|forced: got True": lambda d: d.update(forced=True),
    "method is 'fem', expected one of": lambda d: d.update(method="fem"),
    "ParameterError mass: got -1": lambda d: d["parameters"].update(mass=-1),
    "position: got '2'": lambda d: d.update(position="2"),
    "order: got 0": lambda d: d.update(order=0),
    "count: got 0": lambda d: d.update(modes=[]),
    "KeyError 'order'": lambda d: d.pop("order"),
    "of another nonsmooth: structure: got 'plate'": lambda d: d.update(structure="plate"),
    "modes of other equations": lambda d: d.update(mathematics="0" * 16),
    "schema 3 is from a newer nonsmooth": lambda d: d.update(schema=3),
}


@pytest.mark.filterwarnings("ignore::nonsmooth.FileWarning")
@pytest.mark.parametrize("problem", EDITS)
def test_modes_that_cannot_be_right_are_refused(problem: str, made, tmp_path: Path) -> None:
    path = tmp_path / "modes.json"
    ns.save(made["default"], path)
    document = json.loads(path.read_text("utf-8"))
    EDITS[problem](document)
    path.write_text(json.dumps(document), "utf-8")
    with pytest.raises(ns.FileError, match=problem):
        ns.load(path)


def test_other_bits_are_kept_and_said(made, tmp_path: Path) -> None:
    """A file of a machine that rounds otherwise reads back with its own bits."""
    path = tmp_path / "modes.json"
    ns.save(made["default"], path)
    document = json.loads(path.read_text("utf-8"))
    row = document["modes"][0]
    row["eigenvalue"] *= 1 + 1e-15
    row["jump_mismatch"] += 1e-15
    row["error"] += 1e-15
    path.write_text(json.dumps(document), "utf-8")
    with pytest.warns(ns.FileWarning, match="its digest"):
        found = ns.load(path)
    assert found != made["default"]
    assert found[0].eigenvalue == row["eigenvalue"]
    assert (found[0].jump_mismatch, found[0].error) == (row["jump_mismatch"], row["error"])
    del document["sha256"]
    path.write_text(json.dumps(document), "utf-8")
    with pytest.warns(ns.FileWarning, match="has no digest"):
        assert ns.load(path) == found
