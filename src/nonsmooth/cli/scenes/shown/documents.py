"""The JSON documents of a scene: one orbit, several, a sweep; and where they come from."""

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from nonsmooth.files.json_text import sealed
from nonsmooth.solver.case.registry import mathematics
from nonsmooth.solver.orbit.document import document_without_orbit
from nonsmooth.solver.orbit.orbit import SceneOrbit

if TYPE_CHECKING:
    from nonsmooth.solver.case.case import Case
    from nonsmooth.solver.flow.exact import ExactSceneOrbit
    from nonsmooth.solver.no_orbit import NoOrbit

#: Units of what is in a document, beside the parameters'; what is not here is a plain number.
UNITS = {
    "period": "s",
    "duration": "s",
    "durations": "s",
    "forcing_phase": "rad",
    "displacement": "m",
    "velocity": "m/s",
    "seconds": "s",
}


def of_orbits(
    case: "Case", found: "Mapping[str, SceneOrbit | NoOrbit]", order: int | None,
    functions: int | None, exact: "ExactSceneOrbit | None",
) -> list[dict[str, Any]]:  # fmt: skip
    """Return the document of each orbit, with null for what an absent one lacks."""
    return [
        orbit.as_dict()
        if isinstance(orbit, SceneOrbit)
        else document_without_orbit(case, method, order, functions, orbit, exact)
        for method, orbit in found.items()
    ]


def text_of_orbits(
    case: "Case", documents: Sequence[dict[str, Any]], methods: Iterable[str], one: bool
) -> str:
    """Return the text of one orbit's document, or of several in ``orbits``."""
    whole = dict(documents[0]) if one else {"scene": case.scene.name, "orbits": list(documents)}
    return text(case, whole, methods)


def text(case: "Case", document: dict[str, Any], methods: Iterable[str]) -> str:
    """Return a document as text that says where it comes from and ends with its digest."""
    from nonsmooth import __version__  # noqa: PLC0415

    units = {q.name: q.unit or "1" for q in case.scene.parameters} | UNITS
    origin = {"version": __version__, "mathematics": mathematics(case.scene, methods)}
    return sealed(document | {"units": units} | origin)
