"""netCDF-4 of orbits, sweeps, families, modes: arrays over coordinates, and the document.

The arrays are for other programs; what is loaded is the document, a text beside them, and it
is refused if they do not say the same.  By netCDF4, the extra ``netcdf``.
"""

import errno
import json
import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from netCDF4 import Dataset

from nonsmooth.solver.results.frames import arrays
from nonsmooth.solver.results.table import Table

from .checks import SAME, NotRightError
from .json_text import SCHEMA, sealed
from .netcdf_seal import seal_of

#: The variable that holds the document.
DOCUMENT = "document"

#: What is in a document, by a key that only it has; without these, orbits.
KINDS = {"structure": "modes", "rates": "sweep", "vary": "family"}

#: What columns of a kind are stored as.
TYPES = {"b": "i1", "i": "i8", "f": "f8", "U": str}


@contextmanager
def created(target: Path, attributes: Mapping[str, Any]) -> Iterator[Dataset]:
    """Create a file with attributes, and seal it when it is complete.

    Raises
    ------
    OSError
        If it cannot be written.
    """
    try:
        with Dataset(target, "w", format="NETCDF4") as file:
            file.setncatts({"schema": SCHEMA, **attributes})
            yield file
    except RuntimeError as error:  # the library's word for a disk that is full
        raise OSError(errno.EIO, f"{os.strerror(errno.EIO)} ({error})") from error
    with target.open("ab") as sealed:
        sealed.write(seal_of(target, target.stat().st_size))


def write(
    title: str, document: Mapping[str, Any], tables: Sequence[Table], target: Path
) -> None:
    """Write a document and its tables.

    Parameters
    ----------
    title : str
        What it is.
    document : mapping
        As JSON has it, without its digest.
    tables : sequence of Table
        One; or several motions, which get a dimension ``orbit``.
    target : Path
        The file.
    """
    first, *others = (table.about for table in tables)
    about = {n: v for n, v in first.items() if all(q.get(n) == v for q in others)}
    origin = {name: document[name] for name in ("version", "mathematics") if name in document}
    kind = next((kind for key, kind in KINDS.items() if key in document), "orbits")
    with created(target, {"title": title, "kind": kind} | origin | about) as file:
        for name, (dimensions, values, unit) in variables(tables).items():
            for dimension, length in zip(dimensions, np.shape(values), strict=True):
                if dimension not in file.dimensions:
                    file.createDimension(dimension, length)
            stored: Any = TYPES[values.dtype.kind]
            variable = file.createVariable(name, stored, dimensions)
            if unit or stored == "f8":
                variable.units = unit or "1"
            variable[...] = values.astype(object) if stored is str else values
        text = np.array(sealed(dict(document)), dtype=object)
        file.createVariable(DOCUMENT, str, ())[...] = text
        file[DOCUMENT].description = "the same and more as JSON: what nonsmooth loads"
        if len(tables) > 1:
            for name in set(tables[0].columns) - {"t"}:
                file[name].coordinates = "t method order"


def variables(tables: Sequence[Table]) -> dict[str, tuple[tuple[str, ...], Any, str | None]]:
    """Return the variables of tables: dimensions, values, unit.

    Of one table over its index; of several motions over ``orbit`` and ``sample``, with
    coordinates `method`, `order` and `t`.
    """
    units = tables[0].units
    found = {}
    if len(tables) == 1:
        for name, (dimensions, values) in arrays(tables[0]).items():
            found[name] = (dimensions, values, units.get(name))
        for name in ("method", "order"):
            if name in tables[0].about and name not in found:
                found[name] = ((), np.array(tables[0].about[name]), None)
        return found
    for name in tables[0].columns:
        values = np.array([table.columns[name] for table in tables])
        found[name] = (("orbit", "sample"), values, units.get(name))
    for name in ("method", "order"):
        found[name] = (("orbit",), np.array([table.about[name] for table in tables]), None)
    return found


def document_of(file: Dataset) -> dict[str, Any]:
    """Return the document in an open file."""
    found: dict[str, Any] = json.loads(str(file[DOCUMENT][...]))
    return found


def check_same(file: Dataset, tables: Sequence[Table]) -> None:
    """Check that the arrays of a file say what its document does.

    Raises
    ------
    NotRightError
        Naming the first that does not.
    """
    for name, (_, values, _) in variables(tables).items():
        if name not in file.variables:
            raise NotRightError(f"{name} is missing")
        there = np.asarray(file[name][...])
        equal = there.shape == values.shape
        if equal and values.dtype.kind in "OU":
            equal = there.astype(str).tolist() == values.astype(str).tolist()
        elif equal:
            equal = np.allclose(there.astype(float), values.astype(float), SAME, 0, True)
        if not equal:
            raise NotRightError(f"{name} is not what its document says")
