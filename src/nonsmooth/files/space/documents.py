"""Modes as JSON documents and as CSV tables."""

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..json_text import sealed

if TYPE_CHECKING:
    from nonsmooth.solver.space.convergence import Convergence
    from nonsmooth.solver.space.modes import Modes
    from nonsmooth.solver.space.structure import Structure

#: Columns of a table of modes.
COLUMNS = (
    "method", "order", "forced", "unknowns", "number", "frequency", "beta", "eigenvalue",
    "exact_beta", "error", "low", "high", "jump_mismatch", "node",
)  # fmt: skip

#: Behind them, before the parameters.
BEHIND = ("structure", "position", "strength")


def text(structure: "Structure", document: dict[str, Any]) -> str:
    """Return a document as text that says where it comes from and ends with its digest."""
    return sealed(document | origin(structure))


def origin(structure: "Structure") -> dict[str, Any]:
    """Return units, version and mathematics, as documents have them."""
    from nonsmooth import __version__  # noqa: PLC0415

    units = {q.name: q.unit or "1" for q in structure.parameters} | {"frequency": "Hz"}
    return {"units": units, "version": __version__, "mathematics": mathematics(structure)}


def mathematics(structure: "Structure") -> str:
    """Return the hash of the closed forms behind the modes of a structure."""
    found: str = structure.module.MATHEMATICS[:16]
    return found


def of_modes(found: "Sequence[Modes]") -> dict[str, Any]:
    """Return the document of one expansion, or of several in ``expansions``.

    Before several stands what is the same of all.
    """
    documents = [expansion.as_dict() for expansion in found]
    if len(documents) == 1:
        return documents[0]
    keys = ("structure", "class", "parameters", "position", "strength")
    first = documents[0]
    head = {key: first[key] for key in keys if all(q[key] == first[key] for q in documents)}
    return head | {"expansions": documents}


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
    """Write modes as CSV, a row a mode, with the structure and its parameters behind it.

    First stands the value of what is varied.
    """
    head, rows = [vary] if vary else [], []
    first = found[0].attached
    behind = [name for name in (*BEHIND, *first.values) if name != vary.replace("-", "_")]
    for place, expansion in enumerate(found):
        value = [repr(values[place])] if vary else []
        said = (expansion.method, expansion.order, expansion.forced, expansion.unknowns)
        a = expansion.attached
        known = {"structure": a.structure.name, "position": a.a, "strength": a.s}
        known |= a.values
        for mode in expansion:
            low, high = mode.bounds
            rows.append(
                [*value, *said, mode.number, mode.frequency, mode.beta, mode.eigenvalue,
                 mode.exact_beta, mode.error, low, high, mode.jump_mismatch, mode.node,
                 *(known[name] for name in behind)]
            )  # fmt: skip
    _write(target, [*head, *COLUMNS, *behind], rows)


def write_convergence(study: "Convergence", target: Path) -> None:
    """Write a study as CSV, a row an expansion and order."""
    rows = [list(vars(row).values()) for row in study.rows]
    _write(target, list(vars(study.rows[0])), rows)


def _write(target: Path, columns: Iterable[str], rows: Iterable[Sequence[object]]) -> None:
    with target.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(["" if cell is None else cell for cell in row] for row in rows)
