"""netCDF-4 of results, by xarray: arrays over coordinates, the document, a digest of all.

The arrays are for other programs; what is loaded is the document, a text beside them, and it
is refused if they do not say the same.  Needs the extra ``netcdf``.
"""

import errno
import hashlib
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from nonsmooth.solver.presentation.documents import SCHEMA
from nonsmooth.solver.presentation.frames import dataset
from nonsmooth.solver.presentation.table import Table

from .checks import SAME, check
from .documents import document_of, same_of_all
from .file_errors import damaged, other_kind, refused
from .json_text import check_schema, sealed

#: The variable that holds the document.
DOCUMENT = "document"

#: What the seal behind the content starts with, and its length.
SEAL = b"nonsmooth sha256 "
SEALED = len(SEAL) + 64

#: What is said of each orbit of several, or of all rows.
HOW = ("method", "order")


def write(kind: str, several: Sequence[Any], target: Path) -> None:
    """Write results of a kind, and seal the file when it is complete.

    An `OSError` is raised if it cannot be written.
    """
    document, file = document_of(kind, several), arrays_of(kind, several)
    for variable in file.variables.values():
        if variable.dtype.kind == "f":
            variable.attrs.setdefault("units", "1")
    words = {"description": "the same and more as JSON: what nonsmooth loads"}
    file[DOCUMENT] = ((), sealed(document), words)
    name = document["structure" if "structure" in document else "scene"]
    title = {"title": f"{name}: {kind}", "kind": kind}
    origin = {key: document[key] for key in ("version", "mathematics") if key in document}
    file.attrs = {"schema": SCHEMA} | title | origin | file.attrs
    try:
        file.to_netcdf(target, engine="netcdf4", format="NETCDF4")
    except RuntimeError as error:  # the library's word for a disk that is full
        raise OSError(errno.EIO, f"{os.strerror(errno.EIO)} ({error})") from error
    seal = _seal(target.read_bytes())
    with target.open("ab") as end:
        end.write(seal)


def arrays_of(kind: str, several: Sequence[Any]) -> xr.Dataset:
    """Return results of a kind as arrays, with `method` and `order` where these are known.

    They are over the coordinates of a result; of several orbits over ``orbit`` and ``sample``,
    of several modes over ``expansion`` and ``number``.
    """
    tables = [result.table() for result in several]
    if len(tables) > 1 and kind == "orbits":
        return _motions(tables)
    table = tables[0] if len(tables) == 1 else _joined(tables)
    arrays: xr.Dataset = dataset(table)
    coordinates = {q: table.about[q] for q in HOW if q in table.about and q not in arrays}
    return arrays.assign_coords(coordinates)


def _motions(tables: Sequence[Table]) -> xr.Dataset:
    """Return several motions as arrays, with the coordinates `t`, `method` and `order`."""
    heads, units = [table.about for table in tables], tables[0].units
    arrays: dict[str, Any] = {name: ("orbit", [each[name] for each in heads]) for name in HOW}
    for name in tables[0].columns:
        values = np.array([table.columns[name] for table in tables])
        unit = {"units": units[name]} if name in units else {}
        arrays[name] = (("orbit", "sample"), values, unit)
    return xr.Dataset(arrays, attrs=same_of_all(heads)).set_coords(["t", *HOW])


def _joined(tables: Sequence[Table]) -> Table:
    """Return the rows of several modes over `expansion`, from 1, and `number`.

    What is the same of all is said of the whole; what is not has a column.
    """
    shared = same_of_all([table.about for table in tables])
    rows = [
        {"expansion": place} | row
        for place, table in enumerate(tables, 1)
        for row in table.rows()
    ]
    columns = {name: [row[name] for row in rows] for name in rows[0] if name not in shared}
    return Table(("expansion", "number"), columns, tables[0].units, shared)


def read(path: Path) -> xr.Dataset:
    """Return what a file holds, in memory.

    A `FileError` is raised if it is damaged, or not a file of a schema known here.
    """
    check_seal(path)
    with (
        refused(path, OSError, RuntimeError),
        xr.open_dataset(path, engine="netcdf4", decode_cf=False) as file,
    ):
        check_schema(path, file.attrs.get("schema"))
        if DOCUMENT not in file:
            raise other_kind(path)
        return file.load()


def check_seal(path: Path) -> None:
    """Check the bytes of a file that is sealed, before HDF5 sees them: some would crash it.

    A file that another program wrote has no seal.  A `FileError` is raised if the file has a
    seal, and its bytes are others.
    """
    with path.open("rb") as file:
        size = max(path.stat().st_size - SEALED, 0)
        file.seek(size)
        seal = file.read()
        file.seek(0)
        if seal.startswith(SEAL) and seal != _seal(file.read(size)):
            raise damaged(path, "its bytes are not those of its digest (sha256)")


def _seal(content: bytes) -> bytes:
    """Return what stands behind the content of a file, which HDF5 does not read."""
    return SEAL + hashlib.sha256(content).hexdigest().encode()


def check_same(file: xr.Dataset, expected: xr.Dataset) -> None:
    """Check that the arrays of a file say what its document does.

    A `NotRightError` names the first that does not.
    """
    for name, variable in expected.variables.items():
        check(name in file.variables, f"{name} is missing")
        stored, computed = file[name].values, variable.values
        equal = stored.shape == computed.shape
        if equal and computed.dtype.kind in "OU":
            equal = stored.astype(str).tolist() == computed.astype(str).tolist()
        elif equal:
            equal = np.allclose(stored.astype(float), computed.astype(float), SAME, 0, True)
        check(equal, f"{name} is not what its document says")
