"""One result of each kind that is saved, made once, and files of it that are changed."""

import json
import math
from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

import nonsmooth as ns
from nonsmooth.kim_perkins import SECTION_4

needs_netcdf = pytest.mark.skipif(
    find_spec("netCDF4") is None or find_spec("xarray") is None,
    reason="not installed: pip install 'nonsmooth[netcdf]'",
)
FORMS = [".json", pytest.param(".nc", marks=needs_netcdf)]

BELT = ns.StickSlip(**SECTION_4)
LIGHT = ns.StickSlip(**SECTION_4 | {"normal_force": 100})
ODD = ns.StickSlip(**SECTION_4 | {"mass": math.pi, "mu_s": 0.1 + 0.2, "mu_k": 0.2})

MAKERS: dict[str, Callable[[], Any]] = {
    "orbit": lambda: ns.solve(ns.scene("impact")(gap=math.pi / 10), "hb-ck", 5, functions=2),
    "motion": lambda: ns.solve(ns.scene("dry-friction")(frequency=0.4), order=6),
    "memory": lambda: ns.solve(ns.scene("elastic-plastic")(), order=6),
    "cycles": lambda: ns.solve(ns.scene("impact")(frequency=3.6), order=8, cycles=2),
    "order": lambda: ns.solve(ns.scene("dry-friction")(frequency=0.12, damping=0.05), order=9),
    "body": lambda: ns.solve(ns.scene("chain-impact")(), "hb-ck", 9, functions=2),
    "body-memory": lambda: ns.solve(ns.scene("jenkins-absorber")(), order=6),
    "body-memory-hb": lambda: ns.solve(ns.scene("jenkins-absorber")(), "hb", 12),
    "several": lambda: [thing("orbit"), thing("motion")],
    "sweep": lambda: ns.sweep(ns.scene("impact")(), ["hb", "ck"], [3, 5]),
    "sweep-of-nothing": lambda: ns.sweep(ns.scene("impact")(gap=50.0), ["hb"], [3]),
    "family": lambda: ns.family(ns.scene("impact")(), "gap", [0.1, 0.2, 50.0], order=6),
    "belt-scene": lambda: ns.solve(ns.scene("stick-slip")(), "c1", 9),
    "belt-scene-sweep": lambda: ns.sweep(ns.scene("stick-slip")(), ["hb", "c1"], [4, 5]),
    "belt-hb": lambda: ns.solve(ODD, "hb", 9),
    "belt-hb-c1": lambda: ns.solve(ODD, "hb-c1", 9),
    "belt-c1": lambda: ns.solve(ODD, "c1", 9),
    "belt-c1-tau": lambda: ns.solve(ODD, "c1-tau", 9),
    "belt-sweep": lambda: ns.sweep(LIGHT, ["hb", "c1"], [4, 5]),
    "belt-family": lambda: ns.family(BELT, "normal_force", [100.0, 400.0], "c1", 4),
    "modes": lambda: ns.modes("beam-mass"),
    "modes-node": lambda: ns.modes("beam-rotational-spring", position="1/2", count=3),
    "modes-forced": lambda: ns.modes("string-mass", forced=2, order=5, position=0.27, mass=3.3),
    "modes-nothing-proved": lambda: ns.modes("beam-crack", "ck", 12, length=2.0),
    "modes-sound": lambda: ns.modes("beam-crack", "ritz", 4),
    "modes-several": lambda: [
        *(ns.modes("beam-crack", method) for method in ("ritz", "ritz-ck", "ck")),
        ns.modes("beam-crack", position=0.25, compliance=3, count=2),
    ],
}


@cache
def thing(kind: str) -> Any:
    """Return the result of a kind."""
    return MAKERS[kind]()


def saved(kind: str, folder: Path, suffix: str = ".json") -> Path:
    """Return the path of the saved result of a kind."""
    path = folder / f"{kind}{suffix}"
    ns.save(thing(kind), path)
    return path


def change(path: Path, how: Callable[[dict[str, Any]], object]) -> None:
    """Change the document of a JSON file, and leave its digest."""
    document = json.loads(path.read_text())
    how(document)
    path.write_text(json.dumps(document))
