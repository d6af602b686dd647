"""Modes as what files hold."""

from collections.abc import Sequence
from typing import Any

from nonsmooth.solver.results.table import Table
from nonsmooth.solver.space.modes import Modes

from ..kinds import Content, all_are
from . import documents


def content_of(thing: Any) -> Content | None:
    """Return what is to be written of modes, or of several of one structure; else None."""
    several = [thing] if isinstance(thing, Modes) else thing
    if not all_are(several, Modes):
        return None
    structure = several[0].structure
    if any(found.structure != structure for found in several):
        return None
    return Content(
        f"{structure.name}: modes",
        lambda: documents.of_modes(several) | documents.origin(structure),
        lambda: [several[0].table() if len(several) == 1 else joined(several)],
        lambda target: documents.write_modes(several, target),
    )


def joined(several: Sequence[Modes]) -> Table:
    """Return the rows of several expansions over `expansion`, from 1, and `number`.

    What is the same of all is said of the whole; what is not has a column.
    """
    tables = [found.table() for found in several]
    first = tables[0].about
    same = {q: v for q, v in first.items() if all(table.about[q] == v for table in tables)}
    columns: dict[str, list[Any]] = {"expansion": []}
    for place, table in enumerate(tables, 1):
        rows = len(table.columns["number"])
        columns["expansion"] += [place] * rows
        for name, values in table.columns.items():
            columns.setdefault(name, []).extend(values)
        for name, value in table.about.items():
            if name not in same:
                columns.setdefault(name, []).extend([value] * rows)
    return Table(("expansion", "number"), columns, tables[0].units, same)
