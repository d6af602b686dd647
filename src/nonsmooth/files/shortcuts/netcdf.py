"""Families of the paper's oscillator as netCDF-4, a chunk at a time; by netCDF4."""

from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
from netCDF4 import Dataset

from nonsmooth.solver.shortcuts.orbit.oscillator import PARAMETERS, StickSlip
from nonsmooth.solver.shortcuts.search.family import Family
from nonsmooth.solver.shortcuts.search.family_points import COLUMNS, POINT, STATUS

from ..errors import FileError
from ..netcdf import created
from .origin import origin
from .points import Points, checked

TITLE = "Stick-slip oscillator: family"


def _variable(where: Any, name: str, dimensions: tuple[str, ...], units: str = "1") -> Any:
    variable = where.createVariable(name, "f8", dimensions)
    variable.units = units
    return variable


def write_points(points: Points, target: Path) -> None:
    """Write families, a chunk at a time: a variable a column, over method and parameter."""
    head, parameter = points.head, points.head.parameter
    fixed = {name: value for name, value in asdict(head.belt).items() if name != parameter}
    how = {"parameter": parameter, "order": head.order, "c1_terms": head.c1_terms}
    about = {"title": TITLE, "kind": "family"} | origin(head.methods) | fixed | how
    with created(target, about) as file:
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


def read(path: Path, file: Dataset) -> Any:
    """Return the families of an open file."""
    if getattr(file, "kind", "") != "family":
        raise FileError(path, "holds no orbit, sweep, family or modes")
    parameter = file.parameter
    values = file[parameter][:]
    others = [name for name in PARAMETERS if name != parameter]
    first = {name: float(getattr(file, name)) for name in others}
    belt = StickSlip(**first | {parameter: float(values[0])})
    order, terms = int(file.order), int(file.c1_terms)
    methods = tuple(file["method"][:].tolist())
    found = []
    for i, method in enumerate(methods):
        points = np.empty(len(values), dtype=POINT)
        points["status"] = file["status"][i]
        for name in COLUMNS:
            variable = file[parameter if name == "value" else name]
            points[name] = variable[:] if variable.ndim == 1 else variable[i]
        found.append(Family(belt, parameter, method, order, terms, checked(points)))
    return found[0] if len(found) == 1 else found
