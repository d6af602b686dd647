"""JSON documents of the paper's methods."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, Protocol

from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip
from nonsmooth.solver.shortcuts.search.family_points import COLUMNS
from nonsmooth.solver.shortcuts.search.sweep import Sweep

from ..errors import other_kind
from ..json_text import ROWS, SCHEMA, Digest, as_json, end, finite
from .as_any_scene import scene
from .documents import of_orbits, of_sweep, to_orbit, to_sweep, with_origin
from .origin import check_mathematics, origin, units
from .points import Head, Points, to_families

#: What only the paper's methods have in the document of an orbit, beside all that others have.
OF_THE_PAPER = "transition_mismatch"

#: What only its sweeps and families have.
OF_ROWS = "c1_terms"


class Writable(Protocol):
    """What text can be written to."""

    def write(self, text: str, /) -> object:
        """Write the text."""


def write_points(points: Points, target: Path) -> None:
    """Write families."""
    with target.open("w", encoding="utf-8", newline="") as file:
        stream_points(points, file)


def orbit_document(orbits: Sequence[Orbit]) -> dict[str, Any]:
    """Return the whole document of one orbit, or of several."""
    return with_origin(of_orbits(orbits), [orbit.method for orbit in orbits])


def sweep_document(result: Sweep) -> dict[str, Any]:
    """Return the whole document of a sweep."""
    return with_origin(scene() | of_sweep(result), list(result.rates()))


def stream_points(points: Points, target: Writable) -> None:
    """Write families, a chunk at a time."""
    head = points.head
    document: dict[str, Any] = scene() | {
        "parameters": asdict(head.belt),
        "vary": {"parameter": head.parameter, "count": head.count},
        "methods": head.methods,
        "order": head.order,
        "c1_terms": head.c1_terms,
        "units": units() | {"value": units()[head.parameter]},
    }
    document |= origin(head.methods)
    digest = Digest(finite({"schema": SCHEMA} | document))
    target.write(as_json(document).removesuffix("\n}") + f',\n  "{ROWS}": [')
    separator = "\n"
    names = ("method", "order", "status", *COLUMNS)
    for rows in points.rows():
        for row in rows:
            values = dict(zip(names, row, strict=True))
            values["estimate"] = {
                name: values.pop(f"estimate_{name}") for name in ("period", "t1")
            }
            digest.add(values)
            target.write(f"{separator}    {json.dumps(values)}")
            separator = ",\n"
    target.write(end("\n  ],\n", digest.hexdigest()))


def is_of_the_paper(document: Mapping[str, Any]) -> bool:
    """Return whether a document is of the paper's methods, and not of any scene."""
    return (
        OF_THE_PAPER in document
        or any(OF_THE_PAPER in each for each in document.get("orbits", ()))
        or OF_ROWS in document
    )


def restored(path: Path, document: Mapping[str, Any]) -> Any:
    """Return what a document holds.

    Raises
    ------
    FileError
        If it holds nothing that can be restored, or orbits of other equations.
    NotRightError
        A `ValueError`: if a number in it cannot be right.
    """
    if "vary" in document:
        return _families(path, document)
    if "rows" in document:
        return to_sweep(document)
    if "orbits" in document or "outcome" in document:
        every = document.get("orbits", [document])
        check_mathematics(path, document["mathematics"], [each["method"] for each in every])
        found = [to_orbit(each) for each in every if each["converged"]]
        return found if "orbits" in document else found[0]
    raise other_kind(path)


def _families(path: Path, document: Mapping[str, Any]) -> Any:
    vary = document["vary"]
    head = Head(
        StickSlip(**document["parameters"]),
        vary["parameter"],
        tuple(document["methods"]),
        document["order"],
        document["c1_terms"],
        vary["count"],
    )
    rows = [
        (
            row["method"],
            row["status"],
            *(row[name] for name in COLUMNS if not name.startswith("estimate_")),
            *(row["estimate"][name] for name in ("period", "t1")),
        )
        for row in document["rows"]
    ]
    found = to_families(path, head, rows)
    return found[0] if len(found) == 1 else found
