"""The benchmarks run, and what they time does find the orbit; plain Python, few settings."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from shown import ROOT

#: Contenders of a scene, and an error of the times that the first setting of each keeps.
EVERYWHERE = {
    "ck-tau": 3e-3,
    "hb-ck": 3e-4,
    "hb": 2e-2,
    "exact flow, Python": 1e-14,
    "RK4 return map, numba": 2e-3,
    "solve_ivp to steady state": 2e-3,
}


def run(code: str, *arguments: str) -> str:
    """Run a benchmark in a process without numba's compiler; what it prints."""
    found = subprocess.run(
        [sys.executable, *code.split(), *arguments],
        cwd=ROOT,
        env={**os.environ, "NUMBA_DISABLE_JIT": "1", "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert found.returncode == 0, found.stderr
    return found.stdout


@pytest.fixture(scope="module")
def every_scene(tmp_path_factory) -> tuple[list[dict], str, Path]:
    folder = tmp_path_factory.mktemp("every")
    scenes = ("elastic-plastic", "stick-slip-damped")
    out = run("-m benchmarks.every_scene", *scenes, "--fewest", "-o", str(folder))
    points = json.loads((folder / "every_scene.json").read_text("utf-8"))["points"]
    return points, out, folder


@pytest.mark.parametrize(
    ("scene", "more"),
    [("elastic-plastic", {"AFT, NumPy": 3e-3}), ("stick-slip-damped", {})],
)
def test_every_contender_finds_the_orbit(every_scene, scene, more) -> None:
    points, out, folder = every_scene
    errors = {p["name"]: p["error"] for p in points if p["scene"] == scene}
    errors.pop("AFT, harmonicbalance", None)  # where it is installed
    expected = {**EVERYWHERE, **more}
    assert errors.keys() == expected.keys()
    assert all(errors[name] < most for name, most in expected.items()), errors
    assert all(p["seconds"] > 0 for p in points)
    assert (folder / f"speed_{scene}.png").stat().st_size > 10_000
    assert sum(line.startswith(scene) for line in out.splitlines()) == len(
        [p for p in points if p["scene"] == scene]
    )


#: Contenders of a row of masses, and an error that the first setting of each keeps.
OF_BODIES = {
    "force series": 1e-3,
    "force series, in a response": 1e-3,
    "exact orbit": 1e-14,
    "ns.solve": 1e-12,
    "ns.exact": 1e-13,
    "RK4 shooting, numba": 1e-4,
    "AFT, condensed, NumPy": 1e-2,
}


def test_every_code_for_bodies_finds_the_orbit(tmp_path, monkeypatch) -> None:
    pytest.importorskip("flint")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    run("-m benchmarks.bodies", "2", "--fewest", "-o", str(tmp_path))
    points = json.loads((tmp_path / "bodies.json").read_text("utf-8"))["points"]
    errors = {p["name"]: p["error"] for p in points}
    errors.pop("AFT, pyHarm", None)  # where it is installed
    assert errors.keys() == OF_BODIES.keys()
    assert all(errors[name] < most for name, most in OF_BODIES.items()), errors
    assert (tmp_path / "bodies.png").stat().st_size > 10_000


def test_the_two_scenes_with_rivals_by_hand_are_timed() -> None:
    """At the first setting of each contender."""
    code = (
        "from benchmarks import scenes\n"
        "for p in scenes.measure(1, fewest=True): print(p.scene, p.name, p.error, sep='; ')"
    )
    rows = [line.split("; ") for line in run("-c", code).splitlines()]
    assert {scene for scene, _, _ in rows} == {"impact", "stick-slip-damped"}
    assert len(rows) > 16
    for _, name, error in rows:
        assert float(error) < (1e-12 if "exact" in name else 5e-2), name
