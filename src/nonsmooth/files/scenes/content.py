"""Orbits, sweeps and families of any scene as what files hold."""

from typing import Any

from nonsmooth.solver.family import SceneFamily
from nonsmooth.solver.orbit.orbit import SceneOrbit
from nonsmooth.solver.sweep import SceneSweep

from ..kinds import Content, all_are
from . import documents, tables


def content_of(thing: Any) -> Content | None:
    """Return what is to be written of a result of a scene; None of anything else."""
    if isinstance(thing, SceneSweep):
        return Content(
            f"{thing.case.scene.name}: sweep",
            lambda: documents.of_sweep(thing),
            lambda: [thing.table()],
            lambda target: tables.write_sweep(thing, target),
        )
    if isinstance(thing, SceneFamily):
        return Content(
            f"{thing.case.scene.name}: family",
            lambda: documents.of_family(thing),
            lambda: [thing.table()],
            lambda target: tables.write_family(thing, target),
        )
    orbits = [thing] if isinstance(thing, SceneOrbit) else thing
    if not all_are(orbits, SceneOrbit):
        return None
    return Content(
        f"{orbits[0].case.scene.name}: orbits",
        lambda: documents.of_orbits(orbits),
        lambda: [orbit.table() for orbit in orbits],
        lambda target: tables.write_orbits(orbits, target),
    )
