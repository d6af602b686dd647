"""Files that were changed: what does no harm loads, what cannot be right does not."""

import json
import math
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from saved_things import BELT, FORMS, change, needs_netcdf, saved, thing

import nonsmooth as ns
from nonsmooth.files.json_text import digest, sealed
from nonsmooth.kim_perkins import SECTION_4

KINDS = pytest.mark.parametrize("kind", ["orbit", "sweep", "family", "belt-c1", "belt-sweep"])
quiet = pytest.mark.filterwarnings("ignore::nonsmooth.FileWarning")


@KINDS
@pytest.mark.parametrize("how", ["compact", "sorted", "integers", "jq"])
def test_the_same_content_in_another_text_loads_without_a_word(kind, how, tmp_path) -> None:
    path = saved(kind, tmp_path)
    text = path.read_text()
    if how == "integers":  # 400.0 as 400, as jq may write it
        again = text.replace(".0,", ",")
    elif how == "jq":
        if shutil.which("jq") is None:
            pytest.skip("jq is not installed")
        again = subprocess.check_output(["jq", "-S", ".", path], text=True)
    else:
        again = json.dumps(json.loads(text), sort_keys=how == "sorted", separators=(",", ":"))
    assert again != text
    path.write_text(again)
    assert ns.load(path) == thing(kind)


@KINDS
def test_a_note_and_a_digest_that_is_gone_are_warned_of(kind: str, tmp_path: Path) -> None:
    path = saved(kind, tmp_path)
    changed = f"{path.name} was changed since it was written: its digest"
    change(path, lambda d: d.update(note="of Monday"))
    with pytest.warns(ns.FileWarning, match=changed):
        assert ns.load(path) == thing(kind)
    change(path, lambda d: d.pop("sha256"))
    with pytest.warns(ns.FileWarning, match=f"{path.name} has no digest"):
        assert ns.load(path) == thing(kind)


def test_the_digest_is_of_the_content() -> None:
    first = {"a": 1, "rows": [{"x": 0.5, "y": None}], "c": -0.0}
    assert digest(first) == digest({"c": 0, "rows": [{"y": None, "x": 0.5}], "a": 1.0})
    assert digest(first) == digest(first | {"sha256": "any"})
    for other in (first | {"a": 2}, first | {"a": True}, first | {"rows": [{"x": 0.5}]},
                  first | {"rows": [{"x": 0.5, "y": None}] * 2}, first | {"d": 1}):  # fmt: skip
        assert digest(first) != digest(other)


@quiet
@pytest.mark.parametrize(
    ("method", "order"), [("hb", 150), ("hb-c1", 8), ("hb-ck", 8), ("c1", 9), ("c1-tau", 9)]
)
def test_every_method_s_equations_are_checked(method, order, tmp_path: Path) -> None:
    path = tmp_path / "orbit.json"
    orbit = ns.solve(BELT, method, order)
    ns.save(orbit, path)
    assert ns.load(path) == orbit
    change(path, lambda d: d["outcome"]["unknowns"].__setitem__(2, 0.01))
    with pytest.raises(ns.FileError, match="does not satisfy its equations"):
        ns.load(path)


def _unknown(value: float):
    return lambda document: document["outcome"]["unknowns"].__setitem__(0, value)


def _row(**changed):
    return lambda document: next(
        row for row in document["rows"] if row["status"] == "ok"
    ).update(changed)


#: Of any kind; the parameter that is missing has a default, the scene the same names.
ANY = {
    "damaged: parameters without mass$": lambda d: d["parameters"].pop("mass"),
    "of other equations .0000": lambda d: d.update(mathematics="0" * 16),
    "of other equations": lambda d: d.update(scene="impact-two-sided"),
    "which is not shipped: ": lambda d: d.update(scene="drum"),
}

#: Of a sweep or a family.
ROWS = {
    "status is 'fine'": _row(status="fine"),
    "period is 0": _row(period=0),
    "OverflowError int too large": _row(period=10**400),
    "iterations is -1": _row(iterations=-1),
    "times is -0.1": _row(estimate={"period": 0, "times": -0.1, "discontinuous": 0}),
    "but its durations give": _row(durations=[1.0]),
    "message is None": _row(status="no-orbit", message=None),
}


EDITS = {
    "orbit": ANY | {
        "period is -1": lambda d: d.update(period=-1),
        "period is 4.0, but its durations give 3.49": lambda d: d.update(period=4.0),
        "duration 1 is 0": lambda d: d["phases"][0].update(duration=0),
        r"\d+ unknowns, expected \d+": lambda d: d["outcome"]["unknowns"].append(0.0),
        "an orbit that does not satisfy its equations": _unknown(0.3),
        "unknowns that are not finite": _unknown(math.inf),
        "ParameterError mass: got -1": lambda d: d["parameters"].update(mass=-1),
        "iterations is 'zz'": lambda d: d.update(iterations="zz"),
        "iterations is -1": lambda d: d["outcome"].update(iterations=-1),
        "correction is 'zz'": lambda d: d["outcome"].update(correction="zz"),
        "KeyError 'method'": lambda d: d.pop("method"),
        "without its unknowns": lambda d: d.pop("outcome"),
    },
    "sweep": ANY | ROWS | {"order is 'x', expected a whole": _row(order="x")},
    "family": ANY | ROWS | {
        "2 rows of 3": lambda d: d["rows"].pop(),
        r"extremes of velocity are \[1\]": _row(extremes={"velocity": [1]}),
    },
}  # fmt: skip


@quiet
@pytest.mark.parametrize(
    ("kind", "problem"), [(kind, problem) for kind in EDITS for problem in EDITS[kind]]
)
def test_what_cannot_be_right_is_refused(kind: str, problem: str, tmp_path: Path) -> None:
    path = saved(kind, tmp_path)
    change(path, EDITS[kind][problem])
    expected = f"{kind} {problem}" if problem.startswith("of other equations") else problem
    with pytest.raises(ns.FileError, match=expected):
        ns.load(path)


def test_another_scene_is_given(tmp_path: Path) -> None:
    with pytest.raises(ns.FileError, match="of the scene 'impact', got 'elastic-plastic'"):
        ns.load(saved("orbit", tmp_path), scene="elastic-plastic")


@needs_netcdf
@pytest.mark.parametrize(
    ("kind", "name"),
    [
        ("orbit", "velocity"),
        ("sweep", "period"),
        ("family", "period"),
        ("several", "velocity"),
    ],
)
@pytest.mark.parametrize("how", ["other", "missing"])
def test_arrays_that_are_not_those_of_the_document_are_refused(
    kind, name, how, tmp_path
) -> None:
    import xarray as xr

    with xr.open_dataset(saved(kind, tmp_path, ".nc")) as file:
        arrays = file.load()
    arrays = (
        arrays.drop_vars(name) if how == "missing" else arrays.assign({name: 2 * arrays[name]})
    )
    arrays.to_netcdf(tmp_path / "again.nc")
    with pytest.raises(ns.FileError, match=f"{name} is (missing|not what its document says)$"):
        ns.load(tmp_path / "again.nc")


@pytest.mark.parametrize("suffix", FORMS)
def test_every_byte_that_is_changed_is_noticed(suffix: str, tmp_path: Path) -> None:
    path = saved("belt-sweep", tmp_path, suffix)
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
            assert found == thing("belt-sweep")
            assert suffix == ".json" or place >= len(whole) - 81


@pytest.mark.parametrize("suffix", FORMS)
def test_a_file_that_ends_early(suffix: str, tmp_path: Path) -> None:
    path = saved("family", tmp_path, suffix)
    whole = path.read_bytes()
    for part in (0, 10, len(whole) // 2, len(whole) - 40):
        path.write_bytes(whole[:part])
        if suffix == ".nc" and part == len(whole) - 40:  # its document has a digest, too
            assert ns.load(path) == thing("family")
            continue
        with pytest.raises(ns.FileError):
            ns.load(path)


@pytest.mark.parametrize("kind", ["orbit", "body-memory"])
def test_an_orbit_of_the_first_schema_is_judged_by_its_residual(
    kind: str, tmp_path: Path
) -> None:
    """Its hash is that of kernels that are not there any more."""
    path = saved(kind, tmp_path, ".json")
    document = json.loads(path.read_text("utf-8"))
    old = {"schema": 1, "mathematics": "of before"}
    path.write_text(sealed(document | old))
    assert ns.load(path) == thing(kind)
    outcome, found = dict(document["outcome"]), document["outcome"]["unknowns"]
    for changed in ([1.001 * q for q in found], [1.001 * found[0], *found[1:]]):
        outcome["unknowns"] = changed
        path.write_text(sealed(document | old | {"outcome": outcome}))
        with pytest.raises(ns.FileError, match="does not satisfy its equations"):
            ns.load(path)


@pytest.mark.parametrize("suffix", FORMS)
def test_a_newer_schema(suffix: str, tmp_path: Path, monkeypatch) -> None:
    with monkeypatch.context() as patch:
        for module in ("json_text", *(["netcdf"] if suffix == ".nc" else [])):
            patch.setattr(f"nonsmooth.files.{module}.SCHEMA", 3)
        path = saved("sweep", tmp_path, suffix)
    with pytest.raises(ns.FileError, match=r"schema 3 is from a newer nonsmooth; .* up to 2"):
        ns.load(path)


OTHER = "holds no orbit, sweep or family: nothing else can be loaded"
IMPACT = {"scene": "impact", "parameters": {}}

#: What is not written by `save`: a name, its content, and what is said of it.
NOT_OURS = [
    ("a.json", "{}", "not a file of nonsmooth"),
    ("a.json", "[1]", "not a file of nonsmooth"),
    ("a.json", "nothing", "not JSON"),
    ("a.json", "[" * 200_000, "not JSON"),
    ("a.json", sealed({"roots": []}), OTHER),
    ("digits.json", sealed(IMPACT | {"lost": False, "rows": []}), OTHER),
    ("tradeoff.json", sealed(IMPACT | {"points": []}), OTHER),
    ("diagram.json", sealed(IMPACT | {"vary": {}, "values": [], "states": []}), OTHER),
    ("simulate.json", sealed(IMPACT | {"phases": [{}]}), OTHER),
    ("a.csv", "x,y\n1,2\n", "CSV is for other programs"),
    ("a.txt", "", "expected a name that ends in one of .json, .csv, .nc"),
]


@pytest.mark.parametrize(("name", "content", "expected"), NOT_OURS)
def test_files_of_others(name: str, content: str, expected: str, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_text(content)
    with pytest.raises(ns.FileError, match=f"{name}: .*{expected}"):
        ns.load(path)


@needs_netcdf
def test_netcdf_of_others(tmp_path: Path) -> None:
    import xarray as xr

    path = tmp_path / "other.nc"
    for attributes, expected in (({}, "it has no schema"), ({"schema": 1}, OTHER)):
        xr.Dataset({"x": ("t", [1.0, 2.0])}, attrs=attributes).to_netcdf(path)
        with pytest.raises(ns.FileError, match=expected):
            ns.load(path)
    path.write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(100))
    with pytest.raises(ns.FileError, match=r"other\.nc: damaged: OSError"):
        ns.load(path)


@pytest.mark.parametrize("scene", ["drum", 3])
def test_a_scene_that_is_none(scene: object, tmp_path: Path) -> None:
    with pytest.raises(ns.FileError, match=f"sweep.json: scene: got {scene!r}, expected"):
        ns.load(saved("sweep", tmp_path, ".json"), scene=scene)


def test_what_has_no_orbit_is_no_file_of_one(run, tmp_path: Path) -> None:
    path = tmp_path / "none.json"
    run("solve", "impact", "--gap", "5", "--method", "ck", "--order", "7", "-o", path)
    with pytest.raises(ns.FileError, match="no orbit: impact: no such orbit exists"):
        ns.load(path)


#: What documents of the kernels for the paper alone had, which was given up.
OLD = {
    "0 unknowns, expected 14": {
        "method": "c1", "order": 5, "converged": True, "exact": {}, "phases": [],
        "outcome": {"unknowns": []}, "iterations": 1,
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
    path.write_text(sealed(head | {"parameters": SECTION_4} | OLD[problem]))
    with pytest.raises(ns.FileError, match=re.escape(problem)):
        ns.load(path)
