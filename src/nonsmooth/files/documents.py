"""Results as documents of JSON: what stands beside their numbers, and several in one."""

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from nonsmooth.solver.kernels.registry import mathematics

from .json_text import sealed

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.space.modes import Modes
    from nonsmooth.solver.space.structure import Structure

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

#: What is said before several modes, if it is the same of all.
SAID_ONCE = ("structure", "class", "parameters", "position", "strength")


def text(case: "Case", document: dict[str, Any], methods: Iterable[str]) -> str:
    """Return a document as text that says where it comes from and ends with its digest."""
    return sealed(document | origin(case, methods))


def text_of_modes(structure: "Structure", document: dict[str, Any]) -> str:
    """Return a document of modes as text, as `text` does."""
    return sealed(document | origin_of_modes(structure))


def origin(case: "Case", methods: Iterable[str]) -> dict[str, Any]:
    """Return units, version and mathematics, as documents have them."""
    units = {q.name: q.unit or "1" for q in case.scene.parameters} | UNITS
    units |= dict.fromkeys(case.own_numbers, "s")
    return _origin(units, mathematics(case.scene, methods))


def origin_of_modes(structure: "Structure") -> dict[str, Any]:
    """Return units, version and mathematics of modes."""
    units = {q.name: q.unit or "1" for q in structure.parameters}
    units |= {"frequency": "Hz", "omega": "rad/s", "modal_mass": "kg"}
    return _origin(units, structure.module.MATHEMATICS[:16])


def _origin(units: dict[str, str], digest: str) -> dict[str, Any]:
    from nonsmooth import __version__  # noqa: PLC0415

    return {"units": units, "version": __version__, "mathematics": digest}


def document_of(kind: str, several: Sequence[Any]) -> dict[str, Any]:
    """Return the document of results of a kind, without its digest."""
    first = several[0]
    if kind == "modes":
        return of_modes(several) | origin_of_modes(first.structure)
    if kind == "shapes":
        added = origin_of_modes(first.attached.structure)
        return dict(first.as_dict() | added | {"units": added["units"] | first.table().units})
    if kind == "sweep":
        return dict(first.as_dict() | origin(first.case, first.rates()))
    if kind in {"branch", "map"}:
        used = [first.method] if kind == "branch" and first.order else ()
        return dict(first.as_dict() | origin(first.case, used))
    orbits = [result.as_dict() | origin(result.case, [result.method]) for result in several]
    return orbits[0] if len(orbits) == 1 else {"scene": first.case.scene.name, "orbits": orbits}


def of_modes(expansions: "Sequence[Modes]") -> dict[str, Any]:
    """Return the document of one expansion, or of several in ``expansions``."""
    documents = [expansion.as_dict() for expansion in expansions]
    if len(documents) == 1:
        return documents[0]
    shared = same_of_all(documents)
    head = {name: shared[name] for name in SAID_ONCE if name in shared}
    return head | {"expansions": documents}


def same_of_all(several: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Return what is the same in all of several mappings.

    Examples
    --------
    >>> same_of_all([{"a": 1, "b": 2}, {"a": 1, "b": 3}, {"a": 1}])
    {'a': 1}
    """
    first, *others = several
    return {q: v for q, v in first.items() if all(q in o and o[q] == v for o in others)}
