"""The documents of a scene: orbits, a sweep, a family; and where they come from."""

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from nonsmooth.solver.case.registry import mathematics
from nonsmooth.solver.orbit.document import document_without_orbit
from nonsmooth.solver.orbit.orbit import Orbit

from ..json_text import sealed

if TYPE_CHECKING:
    from nonsmooth.solver.case.case import Case
    from nonsmooth.solver.family import Family
    from nonsmooth.solver.flow.exact import ExactOrbit
    from nonsmooth.solver.no_orbit import NoOrbit
    from nonsmooth.solver.sweep import Sweep

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


def of_orbits(orbits: Sequence[Orbit]) -> dict[str, Any]:
    """Return the document of one orbit, or of several of any cases."""
    found = [orbit.as_dict() | origin(orbit.case, [orbit.method]) for orbit in orbits]
    if len(found) == 1:
        return found[0]
    return {"scene": orbits[0].case.scene.name, "orbits": found}


def of_sweep(result: "Sweep") -> dict[str, Any]:
    """Return the document of a sweep over orders."""
    return result.as_dict() | origin(result.case, result.rates())


def of_family(result: "Family") -> dict[str, Any]:
    """Return the document of a family along a parameter."""
    return result.as_dict() | origin(result.case, [result.method])


def of_each(
    case: "Case", found: "Mapping[str, Orbit | NoOrbit]", order: int | None,
    functions: int | None, exact: "ExactOrbit | None",
) -> list[dict[str, Any]]:  # fmt: skip
    """Return the document of each orbit, with null for what an absent one lacks."""
    return [
        orbit.as_dict()
        if isinstance(orbit, Orbit)
        else document_without_orbit(case, method, order, functions, orbit, exact)
        for method, orbit in found.items()
    ]


def text_of_each(
    case: "Case", documents: Sequence[dict[str, Any]], methods: Iterable[str], one: bool
) -> str:
    """Return the text of one orbit's document, or of several in ``orbits``."""
    whole = dict(documents[0]) if one else {"scene": case.scene.name, "orbits": list(documents)}
    return text(case, whole, methods)


def text(case: "Case", document: dict[str, Any], methods: Iterable[str]) -> str:
    """Return a document as text that says where it comes from and ends with its digest."""
    return sealed(document | origin(case, methods))


def origin(case: "Case", methods: Iterable[str]) -> dict[str, Any]:
    """Return units, version and mathematics, as documents have them."""
    from nonsmooth import __version__  # noqa: PLC0415

    units = {q.name: q.unit or "1" for q in case.scene.parameters} | UNITS
    units |= dict.fromkeys(case.own_numbers, "s")
    return {
        "units": units,
        "version": __version__,
        "mathematics": mathematics(case.scene, methods),
    }
