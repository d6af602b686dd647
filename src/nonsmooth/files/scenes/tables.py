"""CSV of any scene: rows of a sweep or a family, motions over time; for other programs."""

import csv
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.solver.case.names import shown
from nonsmooth.solver.results.motion import SAMPLES

if TYPE_CHECKING:
    from nonsmooth.solver.family import Family
    from nonsmooth.solver.orbit.orbit import Orbit
    from nonsmooth.solver.simulation.record import Simulation
    from nonsmooth.solver.sweep import Sweep

COLUMNS = ("method", "t", "displacement", "velocity", "acceleration")


def write_orbits(orbits: "Iterable[Orbit]", target: Path) -> None:
    """Write displacement, velocity and acceleration over a period: s, m, m/s, m/s**2."""

    def rows() -> Iterator[Iterable[Any]]:
        for orbit in orbits:
            t = orbit.period * np.arange(SAMPLES) / SAMPLES
            motion = (t, orbit.displacement(t), orbit.velocity(t), orbit.acceleration(t))
            name = shown(orbit.case.scene, orbit.method)
            columns = (column.tolist() for column in motion)
            yield from ((name, *row) for row in zip(*columns, strict=True))

    _write(target, COLUMNS, rows())


def write_simulation(motion: "Simulation", target: Path) -> None:
    """Write a simulated motion, each phase from its start to its end."""

    def rows() -> Iterator[Iterable[Any]]:
        for phase, samples in zip(motion.phases, motion.samples(), strict=True):
            columns = (column.tolist() for column in samples)
            yield from ((phase.name, *row) for row in zip(*columns, strict=True))

    _write(target, ("phase", *COLUMNS[1:]), rows())


def write_sweep(result: "Sweep", target: Path) -> None:
    """Write the rows of a sweep, each with the scene and its parameters behind it."""
    case = result.case
    constants = {"scene": case.scene.name, "motion": case.scene.motion, "cycles": case.cycles}
    found = []
    for values in result.dictionaries():
        durations = values.pop("durations") or ()
        for name in ("errors", "estimate"):
            head = name.removesuffix("s")
            values |= {f"{head}_{key}": value for key, value in values.pop(name).items()}
        values["durations"] = " ".join(map(repr, durations))
        found.append(values | constants | dict(case.values))
    _write_dictionaries(target, found)


def write_family(result: "Family", target: Path) -> None:
    """Write one line a value, with the scene and its other parameters behind it."""
    fixed = {name: v for name, v in result.case.values.items() if name != result.parameter}
    constants = {
        "scene": result.case.scene.name,
        "method": result.method,
        "order": result.order,
        "functions": result.functions,
    } | fixed
    found = []
    for row in result.rows:
        values = row.as_dict()
        estimate, ends = values.pop("estimate"), values.pop("extremes")
        values[result.parameter] = values.pop("value")
        values["durations"] = " ".join(map(repr, values["durations"] or ()))
        for name, pair in ends.items():
            low, high = pair or (None, None)
            values |= {f"least_{name}": low, f"largest_{name}": high}
        values |= {f"estimate_{key}": value for key, value in estimate.items()}
        found.append(values | constants)
    _write_dictionaries(target, found)


def _write_dictionaries(target: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    _write(target, rows[0] if rows else (), (row.values() for row in rows))


def _write(target: Path, columns: Iterable[str], rows: Iterable[Iterable[Any]]) -> None:
    with target.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(rows)
