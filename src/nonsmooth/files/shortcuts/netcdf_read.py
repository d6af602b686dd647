"""netCDF-4 files read back, if the SHA-256 at their end says that they are as written."""

import hashlib
from pathlib import Path
from typing import Any

import numpy as np
from netCDF4 import Dataset

from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
from nonsmooth.solver.shortcuts.orbit.oscillator import PARAMETERS, StickSlip
from nonsmooth.solver.shortcuts.search.family import Family
from nonsmooth.solver.shortcuts.search.family_points import COLUMNS, POINT
from nonsmooth.solver.shortcuts.search.newton import Outcome
from nonsmooth.solver.shortcuts.search.sweep import Sweep

from ..errors import FileError, damaged
from . import documents
from .origin import check_mathematics, check_schema
from .tables import ERRORS, ESTIMATES

#: Bytes that are read at once; what the seal starts with, and its length.
BLOCK = 1 << 24
SEAL = b"nonsmooth sha256 "
SEALED = len(SEAL) + 64

#: Numbers of a row of a sweep.
NUMBERS = ("t1", "period", "seconds")


def seal_of(path: Path, size: int) -> bytes:
    """Return what stands behind the first `size` bytes of a file, which HDF5 does not read.

    A changed byte is found before HDF5 sees it: some would crash it.
    """
    digest = hashlib.sha256()
    with path.open("rb") as file:
        while size > 0 and (block := file.read(min(size, BLOCK))):
            digest.update(block)
            size -= len(block)
    return SEAL + digest.hexdigest().encode()


def _check_seal(path: Path) -> None:
    size = path.stat().st_size - SEALED
    with path.open("rb") as file:
        file.seek(max(size, 0))
        found = file.read()
    if not found.startswith(SEAL):
        raise FileError(path, "no file of nonsmooth, or changed since: it has no digest")
    if found != seal_of(path, size):
        raise damaged(path, "its digest is not that of its content")


def read(path: Path) -> Any:
    """Return what a netCDF file holds; see `load`."""
    _check_seal(path)
    try:
        with Dataset(path) as file:
            file.set_auto_mask(False)
            kinds = {"family": _families, "sweep": _sweep, "orbits": _orbits}
            check_schema(path, int(getattr(file, "schema", 0)))
            return kinds[file.kind](path, file)
    except FileError:
        raise
    except (AttributeError, IndexError, KeyError, OSError, RuntimeError, ValueError) as error:
        raise damaged(path, f"{type(error).__name__} {error}") from error


def _belt(file: Any, **others: float) -> StickSlip:
    given = {name: float(getattr(file, name)) for name in PARAMETERS if name not in others}
    return StickSlip(**given, **others)


def _families(path: Path, file: Any) -> Any:
    parameter = file.parameter
    values = file[parameter][:]
    belt = _belt(file, **{parameter: float(values[0])})
    found = []
    for i, method in enumerate(file["method"][:].tolist()):
        points = np.empty(len(values), dtype=POINT)
        points["status"] = file["status"][i]
        for name in COLUMNS:
            variable = file[parameter if name == "value" else name]
            points[name] = variable[:] if variable.ndim == 1 else variable[i]
        order, terms = int(file.order), int(file.c1_terms)
        found.append(Family(belt, parameter, method, order, terms, points))
    return found[0] if len(found) == 1 else found


def _sweep(path: Path, file: Any) -> Sweep:
    rows = []
    for i, status in enumerate(file["status"][:].tolist()):
        row: dict[str, Any] = {
            "method": str(file["method"][i]),
            "order": int(file["order"][i]),
            "status": status,
            "iterations": int(file["iterations"][i]),
            "message": str(file["message"][i]),
            "errors": {name: float(file[f"error_{name}"][i]) for name in ERRORS},
            "estimate": {name: float(file[f"estimate_{name}"][i]) for name in ESTIMATES},
        }
        row |= {name: float(file[name][i]) for name in NUMBERS}
        if status != "ok":
            row |= {"t1": None, "period": None}
        rows.append(documents.to_row(row))
    return Sweep(_belt(file), tuple(rows), int(file.c1_terms))


def _orbits(path: Path, file: Any) -> Any:
    groups = list(file.groups.values())
    check_mathematics(path, file.mathematics, [group.method for group in groups])
    found = []
    for group in groups:
        unknowns = np.array(group["unknowns"][:])
        unknowns.flags.writeable = False
        outcome = Outcome(
            unknowns,
            bool(group.converged),
            int(group.iterations),
            float(group.correction),
            float(group.residual_norm),
            group.reason,
        )
        names = (group.method, int(group.order), outcome, int(group.total_iterations))
        found.append(Orbit(_belt(group), *names, int(group.c1_terms)))
    return found[0] if len(found) == 1 else found
