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


#: Runs the benchmarks one after the other, in a process that does without numba's compiler.
RUN = """
import runpy, sys
from benchmarks import scenes
_, every, bodies = sys.argv
for module, *arguments in (
    ("every_scene", "elastic-plastic", "stick-slip-damped", "--fewest", "-o", every),
    ("bodies", "2", "--fewest", "-o", bodies),
):
    sys.argv = [module, *arguments]
    runpy.run_module(f"benchmarks.{module}", run_name="__main__")
print("RIVALS")
for p in scenes.measure(1, fewest=True):
    print(p.scene, p.name, p.error, sep="; ")
"""


@pytest.fixture(scope="module")
def ran(tmp_path_factory) -> tuple[str, Path, Path]:
    """Return what is printed, and the folders of scenes of one mass and of bodies."""
    pytest.importorskip("flint")
    every, bodies, cache = map(tmp_path_factory.mktemp, ("every", "bodies", "cache"))
    own = {"NUMBA_DISABLE_JIT": "1", "XDG_CACHE_HOME": str(cache)}
    found = subprocess.run(
        [sys.executable, "-c", RUN, str(every), str(bodies)],
        cwd=ROOT,
        env={**os.environ, **own, "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert found.returncode == 0, found.stderr
    return found.stdout, every, bodies


def points_in(file: Path) -> list[dict]:
    return json.loads(file.read_text("utf-8"))["points"]


@pytest.mark.parametrize(
    ("scene", "more"),
    [("elastic-plastic", {"AFT, NumPy": 3e-3}), ("stick-slip-damped", {})],
)
def test_every_contender_finds_the_orbit(ran, scene, more) -> None:
    out, folder, _ = ran
    points = points_in(folder / "every_scene.json")
    errors = {p["name"]: p["error"] for p in points if p["scene"] == scene}
    errors.pop("AFT, harmonicbalance", None)  # where it is installed
    expected = {**EVERYWHERE, **more}
    assert errors.keys() == expected.keys()
    assert all(errors[name] < most for name, most in expected.items()), errors
    assert all(p["seconds"] > 0 for p in points)
    assert (folder / f"speed_{scene}.png").stat().st_size > 10_000
    printed = out.partition("RIVALS")[0].splitlines()
    assert sum(line.startswith(scene) for line in printed) == len(
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


def test_every_code_for_bodies_finds_the_orbit(ran) -> None:
    *_, folder = ran
    errors = {p["name"]: p["error"] for p in points_in(folder / "bodies.json")}
    errors.pop("AFT, pyHarm", None)  # where it is installed
    assert errors.keys() == OF_BODIES.keys()
    assert all(errors[name] < most for name, most in OF_BODIES.items()), errors
    assert (folder / "bodies.png").stat().st_size > 10_000


def test_the_two_scenes_with_rivals_by_hand_are_timed(ran) -> None:
    """At the first setting of each contender."""
    rows = [line.split("; ") for line in ran[0].partition("RIVALS\n")[2].splitlines()]
    assert {scene for scene, _, _ in rows} == {"impact", "stick-slip-damped"}
    assert len(rows) > 16
    for _, name, error in rows:
        assert float(error) < (1e-12 if "exact" in name else 5e-2), name


def test_what_branches_and_maps_cost_is_measured(monkeypatch) -> None:
    """In plain Python, on ranges of two or three orbits."""
    monkeypatch.syspath_prepend(ROOT)
    from benchmarks import branches

    for name, few in {"ROUNDS": 1, "STEPS": 2, "CYCLES": 3, "POINTS": 3, "LINES": 2}.items():
        monkeypatch.setattr(branches, name, few)
    values, _ = branches.RESPONSES["clearance"]
    monkeypatch.setitem(branches.RESPONSES, "clearance", (values, (0.99, 1.01)))
    monkeypatch.setitem(branches.MAPS, "clearance", ((0.29, 0.31), "force"))
    monkeypatch.setattr(branches, "RESPONSE", (99.9, 100.1))
    costs = *branches.measured("clearance"), branches.mapped("clearance"), *branches.of_beam(2)
    assert all(cost > 0 for cost in costs)
