"""JSON files: one document, with the SHA-256 of its own text at the end."""

import hashlib
import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, Protocol

from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip
from nonsmooth.solver.shortcuts.search.family_points import COLUMNS
from nonsmooth.solver.shortcuts.search.sweep import Sweep

from ..errors import FileError, damaged, of_a_scene
from ..json_text import DIGEST, as_json, seal, sealed
from .documents import of_orbits, of_sweep, to_orbit, to_sweep, with_origin
from .origin import check_mathematics, check_schema, origin, units
from .points import Head, Points, to_families

#: What only the paper's methods have in the document of an orbit, beside all that others have.
OF_THE_PAPER = "transition_mismatch"


class Writable(Protocol):
    """What text can be written to."""

    def write(self, text: str, /) -> object:
        """Write the text."""


def write_sweep(result: Sweep, target: Path) -> None:
    """Write a sweep."""
    target.write_text(sealed(sweep_document(result)), "utf-8", newline="")


def write_orbits(orbits: Sequence[Orbit], target: Path) -> None:
    """Write orbits."""
    target.write_text(sealed(orbit_document(orbits)), "utf-8", newline="")


def write_points(points: Points, target: Path) -> None:
    """Write families."""
    with target.open("w", encoding="utf-8", newline="") as file:
        stream_points(points, file)


def orbit_document(orbits: Sequence[Orbit]) -> dict[str, Any]:
    """Return the whole document of one orbit, or of several."""
    return with_origin(of_orbits(orbits), [orbit.method for orbit in orbits])


def sweep_document(result: Sweep) -> dict[str, Any]:
    """Return the whole document of a sweep."""
    return with_origin(of_sweep(result), list(result.rates()))


def stream_points(points: Points, target: Writable) -> None:
    """Write families, a chunk at a time."""
    digest = hashlib.sha256()

    def put(text: str) -> None:
        digest.update(text.encode())
        target.write(text)

    head = points.head
    document: dict[str, Any] = {
        "parameters": asdict(head.belt),
        "vary": {"parameter": head.parameter, "count": head.count},
        "methods": head.methods,
        "order": head.order,
        "c1_terms": head.c1_terms,
        "units": units() | {"value": units()[head.parameter]},
    }
    put(as_json(document | origin(head.methods)).removesuffix("\n}") + ',\n  "rows": [')
    separator = "\n"
    names = ("method", "order", "status", *COLUMNS)
    for rows in points.rows():
        for row in rows:
            values = dict(zip(names, row, strict=True))
            values["estimate"] = {
                name: values.pop(f"estimate_{name}") for name in ("period", "t1")
            }
            put(f"{separator}    {json.dumps(values)}")
            separator = ",\n"
    put("\n  ],\n")
    target.write(f'{DIGEST}"{digest.hexdigest()}"\n}}\n')


def read(path: Path) -> Any:
    """Return what a JSON file holds; see `load`."""
    document = _document(path)
    try:
        return _restored(path, document)
    except FileError:
        raise
    except (KeyError, TypeError, ValueError) as error:
        raise damaged(path, f"{type(error).__name__} {error}") from error


def _document(path: Path) -> dict[str, Any]:
    try:
        text = path.read_bytes().decode("utf-8")
        document = json.loads(text)
    except (ValueError, RecursionError) as error:  # of the encoding, or of the JSON
        raise damaged(path, f"not JSON: {error}") from error
    if not isinstance(document, dict):
        raise FileError(path, "no file of nonsmooth")
    check_schema(path, document.get("schema"))
    before, found, _ = text.rpartition(DIGEST)
    if not found or text != before + seal(before):
        raise damaged(path, "its digest is not that of its text")
    return document


def _restored(path: Path, document: dict[str, Any]) -> Any:
    if "scene" in document and OF_THE_PAPER not in document:
        raise of_a_scene(path, document["scene"])
    if "vary" in document:
        return _families(path, document)
    if "rows" in document:
        return to_sweep(document)
    if "orbits" in document or "outcome" in document:
        every = document.get("orbits", [document])
        check_mathematics(path, document["mathematics"], [each["method"] for each in every])
        found = [to_orbit(each) for each in every if each["converged"]]
        return found if "orbits" in document else found[0]
    raise FileError(path, "holds no orbit, sweep or family")


def _families(path: Path, document: dict[str, Any]) -> Any:
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
