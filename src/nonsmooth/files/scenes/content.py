"""Orbits, sweeps and families of any scene as what files hold."""

from typing import Any

from nonsmooth.solver.family import Family
from nonsmooth.solver.orbit.orbit import Orbit
from nonsmooth.solver.sweep import Sweep

from ..kinds import Content, all_are
from . import documents, tables


def content_of(thing: Any) -> Content | None:
    """Return what is to be written of a result of a scene; None of anything else."""
    if isinstance(thing, Sweep):
        return Content(
            f"{thing.case.scene.name}: sweep",
            lambda: documents.of_sweep(thing),
            lambda: [thing.table()],
            lambda target: tables.write_sweep(thing, target),
        )
    if isinstance(thing, Family):
        return Content(
            f"{thing.case.scene.name}: family",
            lambda: documents.of_family(thing),
            lambda: [thing.table()],
            lambda target: tables.write_family(thing, target),
        )
    orbits = [thing] if isinstance(thing, Orbit) else thing
    if not all_are(orbits, Orbit):
        return None
    return Content(
        f"{orbits[0].case.scene.name}: orbits",
        lambda: documents.of_orbits(orbits),
        lambda: [orbit.table() for orbit in orbits],
        lambda target: tables.write_orbits(orbits, target),
    )
