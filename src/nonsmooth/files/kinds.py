"""What can be saved: for each kind of result its document, its tables, its rows as CSV."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from nonsmooth.solver.results.table import Table


@dataclass(frozen=True)
class Content:
    """What is to be written, in the forms that it is written in.

    Parameters
    ----------
    title : str
        What it is, in words.
    document : callable
        Returns the document of JSON, without its digest.
    tables : callable
        Returns a table, or several of the same columns, for netCDF.
    write_csv : callable
        Writes it to a path as CSV.
    """

    title: str
    document: Callable[[], dict[str, Any]]
    tables: Callable[[], Sequence[Table]]
    write_csv: Callable[[Path], None]


def all_are(things: Any, kind: type) -> bool:
    """Return whether it is a sequence, not empty, of things of one kind."""
    several = isinstance(things, Sequence) and not isinstance(things, str) and len(things) > 0
    return several and all(isinstance(thing, kind) for thing in things)
