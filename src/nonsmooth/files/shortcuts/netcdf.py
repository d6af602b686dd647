"""netCDF-4 files: arrays with units; by netCDF4, in the extra ``netcdf``."""

import errno
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
from netCDF4 import Dataset

from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
from nonsmooth.solver.shortcuts.orbit.oscillator import PARAMETERS, StickSlip
from nonsmooth.solver.shortcuts.search.family_points import COLUMNS, STATUS
from nonsmooth.solver.shortcuts.search.sweep import Sweep

from ..json_text import SCHEMA
from .netcdf_read import NUMBERS, read, seal_of
from .origin import UNITS, origin
from .points import Points
from .tables import ERRORS, ESTIMATES, SAMPLES

__all__ = ["read", "write_orbits", "write_points", "write_sweep"]


@contextmanager
def _created(
    target: Path, kind: str, belt: StickSlip, methods: Sequence[str]
) -> Iterator[Dataset]:
    """Create a file that says what it holds, and seal it when it is complete."""
    try:
        with Dataset(target, "w", format="NETCDF4") as file:
            title = f"Stick-slip oscillator: {kind}"
            file.setncatts({"title": title, "kind": kind, "schema": SCHEMA})
            file.setncatts(origin(methods) | asdict(belt))
            yield file
    except RuntimeError as error:  # the library's word for a disk that is full
        raise OSError(errno.EIO, f"{os.strerror(errno.EIO)} ({error})") from error
    with target.open("ab") as sealed:
        sealed.write(seal_of(target, target.stat().st_size))


def _variable(where: Any, name: str, dimensions: tuple[str, ...], units: str = "1") -> Any:
    variable = where.createVariable(name, "f8", dimensions)
    variable.units = units
    return variable


def write_points(points: Points, target: Path) -> None:
    """Write families, a chunk at a time: a variable a column, over method and parameter."""
    head, parameter = points.head, points.head.parameter
    with _created(target, "family", head.belt, head.methods) as file:
        file.setncatts({"parameter": parameter, "order": head.order, "c1_terms": head.c1_terms})
        delattr(file, parameter)
        file.createDimension("method", len(head.methods))
        file.createDimension(parameter, head.count)
        file.createVariable("method", str, ("method",))[:] = np.array(head.methods, object)
        status = file.createVariable("status", "i1", ("method", parameter))
        status.flag_values = np.arange(len(STATUS), dtype="i1")
        status.flag_meanings = " ".join(STATUS)
        variables = {}
        for name, unit in COLUMNS.items():
            along = (parameter,) if name in ("value", "alpha") else ("method", parameter)
            if name == "value":
                own = PARAMETERS[parameter][0] or "1"
                variables[name] = _variable(file, parameter, along, own)
            else:
                variables[name] = _variable(file, name, along, unit)
        for i, start, chunk in points.chunks():
            part = slice(start, start + len(chunk))
            status[i, part] = chunk["status"]
            for name, variable in variables.items():
                variable[part if variable.ndim == 1 else (i, part)] = chunk[name]


def write_sweep(result: Sweep, target: Path) -> None:
    """Write a sweep: a variable a column, over its rows."""
    methods = list(result.rates())
    with _created(target, "sweep", result.belt, methods) as file:
        file.c1_terms = result.c1_terms
        file.createDimension("row", len(result.rows))
        for name in ("method", "status", "message"):
            column = np.array([getattr(row, name) for row in result.rows], object)
            file.createVariable(name, str, ("row",))[:] = column
        for name in ("order", "iterations"):
            column = np.array([getattr(row, name) for row in result.rows])
            file.createVariable(name, "i8", ("row",))[:] = column
        for name, numbers in _columns(result).items():
            _variable(file, name, ("row",), UNITS.get(name, "1"))[:] = numbers


def _columns(result: Sweep) -> dict[str, list[float]]:
    """Return the numbers of a sweep by column; NaN where there is no orbit."""
    rows: list[dict[str, Any]] = [row.as_dict() for row in result.rows]
    columns = {name: [row[name] for row in rows] for name in NUMBERS}
    columns |= {f"error_{name}": [row["errors"][name] for row in rows] for name in ERRORS}
    columns |= {
        f"estimate_{name}": [row["estimate"][name] for row in rows] for name in ESTIMATES
    }
    return {
        name: [np.nan if value is None else value for value in column]
        for name, column in columns.items()
    }


def write_orbits(orbits: Sequence[Orbit], target: Path) -> None:
    """Write orbits, a group each: the unknowns, and the motion over a period."""
    methods = [orbit.method for orbit in orbits]
    with _created(target, "orbits", orbits[0].belt, methods) as file:
        for number, orbit in enumerate(orbits):
            group = file.createGroup(f"orbit_{number}")
            numbers = vars(orbit.outcome) | {"converged": int(orbit.converged)}
            group.setncatts({n: value for n, value in numbers.items() if n != "unknowns"})
            group.setncatts(asdict(orbit.belt))
            names = ("method", "order", "c1_terms")
            group.setncatts({name: getattr(orbit, name) for name in names})
            group.total_iterations = orbit.iterations
            group.createDimension("unknown", len(orbit.unknowns))
            _variable(group, "unknowns", ("unknown",))[:] = orbit.unknowns
            group.createDimension("t", SAMPLES)
            t = orbit.period * np.arange(SAMPLES) / SAMPLES
            _variable(group, "t", ("t",), "s")[:] = t
            for name, unit in (
                ("displacement", "m"),
                ("velocity", "m/s"),
                ("acceleration", "m/s**2"),
            ):
                _variable(group, name, ("t",), unit)[:] = getattr(orbit, name)(t)
