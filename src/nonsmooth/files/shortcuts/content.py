"""Orbits, sweeps and families of the paper's oscillator as what files hold."""

from importlib import import_module
from pathlib import Path
from typing import Any

from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
from nonsmooth.solver.shortcuts.search.family import Family
from nonsmooth.solver.shortcuts.search.sweep import Sweep

from ..kinds import Content, all_are
from . import tables, texts
from .points import Points, of_families

#: The module that writes points to each kind of file.
WRITERS = {".json": "texts", ".csv": "tables", ".nc": "netcdf"}


def points_of(thing: Any) -> Points | None:
    """Return families as points, in memory or not; None of anything else."""
    if isinstance(thing, Points):
        return thing
    families = [thing] if isinstance(thing, Family) else thing
    return of_families(families) if all_are(families, Family) else None


def write_points(points: Points, target: Path) -> None:
    """Write families, a chunk at a time."""
    module = import_module(f".{WRITERS[target.suffix.lower()]}", __package__)
    module.write_points(points, target)


def content_of(thing: Any) -> Content | None:
    """Return what is to be written of orbits or a sweep; None of anything else."""
    if isinstance(thing, Sweep):
        return Content(
            "Stick-slip oscillator: sweep",
            lambda: texts.sweep_document(thing),
            lambda: [thing.table()],
            lambda target: tables.write_sweep(thing, target),
        )
    orbits = [thing] if isinstance(thing, Orbit) else thing
    if not all_are(orbits, Orbit):
        return None
    return Content(
        "Stick-slip oscillator: orbits",
        lambda: texts.orbit_document(orbits),
        lambda: [orbit.table() for orbit in orbits],
        lambda target: tables.write_orbits(orbits, target),
    )
