"""What can be saved, by its kind."""

import reprlib
from collections.abc import Sequence
from typing import Any

from nonsmooth.solver.results.branch import Branch
from nonsmooth.solver.results.chart import Chart
from nonsmooth.solver.results.family import Family
from nonsmooth.solver.results.orbit import Orbit
from nonsmooth.solver.results.sweep import Sweep


def kind_of(thing: Any) -> tuple[str, Sequence[Any]]:
    """Return the kind of what is to be saved, and its results: one, or several.

    A `TypeError` is raised if it is not a result, or not one that is saved.

    Returns
    -------
    {"orbits", "sweep", "family", "branch", "map", "modes", "shapes"}, sequence
    """
    from nonsmooth.solver.space.mode import Shapes  # noqa: PLC0415
    from nonsmooth.solver.space.modes import Modes  # noqa: PLC0415  (SciPy)

    alone = {Sweep: "sweep", Chart: "map", Branch: "branch", Family: "family", Shapes: "shapes"}
    for each, kind in alone.items():
        if isinstance(thing, each):
            return kind, [thing]
    several: Any = [thing] if isinstance(thing, Orbit | Modes) else thing
    if _all_are(several, Orbit):
        return "orbits", several
    if _all_are(several, Modes) and len({found.structure for found in several}) == 1:
        return "modes", several
    kinds = (
        "an orbit, a branch, a family, a map, modes, their shapes, a sweep, or a sequence of "
        "orbits or modes"
    )
    raise TypeError(f"thing: got {reprlib.repr(thing)}, expected {kinds}")


def _all_are(things: Any, kind: type) -> bool:
    """Return whether it is a sequence, not empty, of things of one kind."""
    several = isinstance(things, Sequence) and not isinstance(things, str) and len(things) > 0
    return several and all(isinstance(thing, kind) for thing in things)
