"""Modes as JSON documents and as CSV tables."""

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonsmooth.files.json_text import sealed

if TYPE_CHECKING:
    from nonsmooth.solver.space.convergence import Convergence
    from nonsmooth.solver.space.modes import Modes
    from nonsmooth.solver.space.structure import Structure

#: Columns of a table of modes.
COLUMNS = (
    "method", "order", "forced", "unknowns", "number", "frequency", "beta", "eigenvalue",
    "exact_beta", "error", "low", "high", "jump_mismatch", "node",
)  # fmt: skip


def text(structure: "Structure", document: dict[str, Any]) -> str:
    """Return a document as text that says where it comes from and ends with its digest."""
    from nonsmooth import __version__  # noqa: PLC0415

    units = {q.name: q.unit or "1" for q in structure.parameters} | {"frequency": "Hz"}
    origin = {"version": __version__, "mathematics": structure.module.MATHEMATICS[:16]}
    return sealed(document | {"units": units} | origin)


def of_modes(found: "Sequence[Modes]") -> dict[str, Any]:
    """Return the document of one expansion, or of several in ``expansions``."""
    documents = [expansion.as_dict() for expansion in found]
    if len(documents) == 1:
        return documents[0]
    head = {key: documents[0][key] for key in ("structure", "class", "parameters", "position")}
    return head | {"strength": documents[0]["strength"], "expansions": documents}


def of_family(name: str, values: Sequence[float], found: "Sequence[Modes]") -> dict[str, Any]:
    """Return the document of modes over a parameter."""
    first = found[0]
    return {
        "structure": first.structure.name,
        "class": f"C{first.structure.k}",
        "vary": name,
        "points": [
            {"value": value} | expansion.as_dict()
            for value, expansion in zip(values, found, strict=True)
        ],
    }


def write_modes(
    found: "Sequence[Modes]", target: Path, vary: str = "", values: Sequence[float] = ()
) -> None:
    """Write modes as CSV, a row a mode; first the value of what is varied."""
    head = [vary] if vary else []
    rows = []
    for place, expansion in enumerate(found):
        value = [repr(values[place])] if vary else []
        said = (expansion.method, expansion.order, expansion.forced, expansion.unknowns)
        for mode in expansion:
            low, high = mode.bounds
            rows.append(
                [*value, *said, mode.number, mode.frequency, mode.beta, mode.eigenvalue,
                 mode.exact_beta, mode.error, low, high, mode.jump_mismatch, mode.node]
            )  # fmt: skip
    _write(target, [*head, *COLUMNS], rows)


def write_convergence(study: "Convergence", target: Path) -> None:
    """Write a study as CSV, a row an expansion and order."""
    rows = [list(vars(row).values()) for row in study.rows]
    _write(target, list(vars(study.rows[0])), rows)


def _write(target: Path, columns: Iterable[str], rows: Iterable[Sequence[object]]) -> None:
    with target.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(["" if cell is None else cell for cell in row] for row in rows)
