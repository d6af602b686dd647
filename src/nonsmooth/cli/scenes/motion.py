"""The motion of orbits of a scene, and simulated motion, as CSV for other programs."""

import csv
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from nonsmooth.solver.case.names import shown

from ..output import write_whole

if TYPE_CHECKING:
    from nonsmooth.solver.orbit.orbit import SceneOrbit
    from nonsmooth.solver.simulation.record import Simulation
    from nonsmooth.solver.sweep import SceneSweep

#: Times over one period at which a motion is written.
SAMPLES = 1000

COLUMNS = ("method", "t", "displacement", "velocity", "acceleration")


def write_motion(orbits: "Iterable[SceneOrbit]", path: Path) -> None:
    """Write displacement, velocity and acceleration: s, m, m/s, m/s**2."""

    def write(target: Path) -> None:
        with target.open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(COLUMNS)
            for orbit in orbits:
                t = orbit.period * np.arange(SAMPLES) / SAMPLES
                motion = (t, orbit.displacement(t), orbit.velocity(t), orbit.acceleration(t))
                name = shown(orbit.case.scene, orbit.method)
                rows = zip(*(column.tolist() for column in motion), strict=True)
                writer.writerows((name, *row) for row in rows)

    write_whole(path, write)


def write_transient(motion: "Simulation", path: Path) -> None:
    """Write a simulated motion, each phase from its start to its end."""

    def write(target: Path) -> None:
        with target.open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(("phase", *COLUMNS[1:]))
            for phase, samples in zip(motion.phases, motion.samples(), strict=True):
                rows = zip(*(column.tolist() for column in samples), strict=True)
                writer.writerows((phase.name, *row) for row in rows)

    write_whole(path, write)


def write_rows(result: "SceneSweep", path: Path) -> None:
    """Write the rows of a sweep, each with the scene and its parameters behind it."""
    case = result.case
    constants = {"scene": case.scene.name, "motion": case.scene.motion, "cycles": case.cycles}
    constants |= dict(case.values)

    def write(target: Path) -> None:
        with target.open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            for index, row in enumerate(result.rows):
                values = row.as_dict()
                durations = values.pop("durations") or ()
                for name in ("errors", "estimate"):
                    found = values.pop(name)
                    head = name.removesuffix("s")
                    values |= {f"{head}_{key}": value for key, value in found.items()}
                values["durations"] = " ".join(map(repr, durations))
                values |= constants
                if index == 0:
                    writer.writerow(values)
                writer.writerow(values.values())

    write_whole(path, write)
