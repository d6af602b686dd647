"""Files that were changed: what does no harm loads, what cannot be right does not."""

import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.files.json_text import digest
from nonsmooth.kim_perkins import SECTION_4

netcdf = pytest.mark.skipif(
    __import__("importlib.util").util.find_spec("netCDF4") is None,
    reason="netCDF4 is not installed",
)
BELT = ns.StickSlip(**SECTION_4)
OTHER = "was changed since it was written: its digest"


@pytest.fixture(scope="module")
def made():
    """Return one of each kind of the paper's oscillator, and an orbit of a scene."""
    return {
        "orbit": ns.solve(BELT, "c1", 6),
        "sweep": ns.sweep(BELT, ["hb", "c1"], [2, 3]),
        "family": ns.family(BELT, "mass", [1.0, 2.0, 3.0], order=6),
        "scene": ns.solve(ns.scene("impact")(), order=5),
    }


KINDS = ("orbit", "sweep", "family", "scene")


@pytest.fixture
def saved(made, tmp_path: Path):
    """Return a saver of a kind, as what it writes and the path."""

    def save(kind: str, suffix: str = ".json"):
        path = tmp_path / f"{kind}{suffix}"
        ns.save(made[kind], path)
        return made[kind], path

    return save


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("how", ["compact", "sorted", "integers"])
def test_the_same_content_in_another_text_loads_without_a_word(kind, how, saved) -> None:
    thing, path = saved(kind)
    document = json.loads(path.read_text())
    if how == "integers":  # 400.0 as 400, as jq may write it
        text = path.read_text().replace(".0,", ",")
        assert text != path.read_text()
    else:
        text = json.dumps(document, sort_keys=how == "sorted", separators=(",", ":"))
    path.write_text(text)
    assert ns.load(path) == thing


@pytest.mark.skipif(shutil.which("jq") is None, reason="jq is not installed")
@pytest.mark.parametrize("kind", KINDS)
def test_what_went_through_jq_loads_without_a_word(kind, saved) -> None:
    thing, path = saved(kind)
    again = subprocess.run(["jq", "-S", ".", path], check=True, capture_output=True, text=True)
    path.write_text(again.stdout)
    assert ns.load(path) == thing


@pytest.mark.parametrize("kind", KINDS)
def test_a_note_and_a_digest_that_is_gone_are_warned_of(kind, saved) -> None:
    thing, path = saved(kind)
    document = json.loads(path.read_text())
    path.write_text(json.dumps(document | {"note": "of Monday"}))
    with pytest.warns(ns.FileWarning, match=f"{path.name} {OTHER}"):
        assert ns.load(path) == thing
    del document["sha256"]
    path.write_text(json.dumps(document))
    with pytest.warns(ns.FileWarning, match=f"{path.name} has no digest"):
        assert ns.load(path) == thing


def test_the_digest_is_of_the_content() -> None:
    first = {"a": 1, "rows": [{"x": 0.5, "y": None}], "c": -0.0}
    assert digest(first) == digest({"c": 0, "rows": [{"y": None, "x": 0.5}], "a": 1.0})
    assert digest(first) == digest(first | {"sha256": "any"})
    for other in (first | {"a": 2}, first | {"a": True}, first | {"rows": [{"x": 0.5}]},
                  first | {"rows": [{"x": 0.5, "y": None}] * 2}, first | {"d": 1}):  # fmt: skip
        assert digest(first) != digest(other)


def _change(path: Path, change) -> None:
    document = json.loads(path.read_text())
    change(document)
    path.write_text(json.dumps(document))


@pytest.mark.filterwarnings("ignore::nonsmooth.FileWarning")
@pytest.mark.parametrize(
    ("method", "order"), [("hb", 150), ("hb-c1", 8), ("hb-ck", 8), ("c1", 9), ("c1-tau", 9)]
)
def test_every_method_s_equations_are_checked(method, order, tmp_path: Path) -> None:
    path = tmp_path / "orbit.json"
    orbit = ns.solve(BELT, method, order)
    ns.save(orbit, path)
    assert ns.load(path) == orbit
    _change(path, lambda d: d["outcome"]["unknowns"].__setitem__(2, 0.01))
    with pytest.raises(ns.FileError, match="does not satisfy its equations"):
        ns.load(path)


@netcdf
@pytest.mark.parametrize("kind", KINDS)
def test_what_xarray_saved_again_loads(kind, saved) -> None:
    xr = pytest.importorskip("xarray", reason="xarray is not installed")
    thing, path = saved(kind, ".nc")
    again = path.with_name(f"again-{path.name}")
    with xr.open_dataset(path) as found:
        found.to_netcdf(again, engine="netcdf4")
    assert ns.load(again) == thing


@netcdf
@pytest.mark.parametrize(
    ("kind", "name"), [("orbit", "velocity"), ("sweep", "period"), ("family", "period")]
)
def test_arrays_that_are_not_those_of_the_document_are_refused(kind, name, saved) -> None:
    netcdf4 = pytest.importorskip("netCDF4")
    _, path = saved(kind, ".nc")
    with netcdf4.Dataset(path, "a") as file:
        file[name][:] = 2 * np.asarray(file[name][:])
    with pytest.raises(ns.FileError, match=f"{name} is not what its document says|its bytes"):
        ns.load(path)
