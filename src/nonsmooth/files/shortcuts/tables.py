"""CSV files: the rows of a sweep or a family, or the motion of orbits.

Each row is complete: what is the same in all of them, the oscillator, the number of rows,
version and mathematics, stands in the last columns.
"""

import csv
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.solver.shortcuts.accuracy.errors import Errors
from nonsmooth.solver.shortcuts.accuracy.estimate import Estimate
from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
from nonsmooth.solver.shortcuts.orbit.oscillator import PARAMETERS, StickSlip
from nonsmooth.solver.shortcuts.search.family_points import COLUMNS
from nonsmooth.solver.shortcuts.search.sweep import Sweep

from ..errors import FileError, damaged
from ..json_text import SCHEMA
from ..schema import check_schema
from .consistent import check_points, check_rows
from .documents import to_row
from .origin import origin
from .points import Head, Points, to_families

#: Times over one period at which the motion of an orbit is written.
SAMPLES = 1000

ERRORS = tuple(field.name for field in fields(Errors))
ESTIMATES = tuple(field.name for field in fields(Estimate))

#: Columns of a sweep before the constant ones.
SWEEP = (
    *("method", "order", "status", "t1", "period", "iterations", "seconds"),
    *(f"error_{name}" for name in ERRORS),
    *(f"estimate_{name}" for name in ESTIMATES),
    "message",
)


def write_sweep(result: Sweep, target: Path) -> None:
    """Write one row a method and order."""
    more = {"c1_terms": result.c1_terms, "rows": len(result.rows)}
    constants = asdict(result.belt) | more | _origin(list(result.rates()))
    _write(target, SWEEP, _sweep_rows(result), constants)


def write_points(points: Points, target: Path) -> None:
    """Write families, a chunk at a time."""
    head = points.head
    constants = asdict(head.belt)
    del constants[head.parameter]  # a column of its own
    constants |= {"c1_terms": head.c1_terms, "parameter": head.parameter}
    constants["rows"] = head.count * len(head.methods)
    columns = [head.parameter if name == "value" else name for name in COLUMNS]
    rows = (row for chunk in points.rows() for row in chunk)
    _write(
        target, ("method", "order", "status", *columns), rows, constants | _origin(head.methods)
    )


def write_orbits(orbits: Sequence[Orbit], target: Path) -> None:
    """Write the motion of orbits over a period: s, m, m/s, m/s**2."""
    columns = ("method", "t", "displacement", "velocity", "acceleration")

    def rows() -> Iterator[tuple[Any, ...]]:
        for orbit in orbits:
            t = orbit.period * np.arange(SAMPLES) / SAMPLES
            motion = (orbit.displacement(t), orbit.velocity(t), orbit.acceleration(t))
            numbers = zip(*(column.tolist() for column in (t, *motion)), strict=True)
            yield from ((orbit.method, *row) for row in numbers)

    _write(target, columns, rows(), {})


def _origin(methods: Iterable[str]) -> dict[str, Any]:
    return {"schema": SCHEMA} | origin(methods)


def _sweep_rows(result: Sweep) -> Iterator[tuple[Any, ...]]:
    for row in result.rows:
        values: dict[str, Any] = row.as_dict()
        values |= {f"error_{name}": value for name, value in values.pop("errors").items()}
        values |= {f"estimate_{name}": value for name, value in values.pop("estimate").items()}
        yield tuple(values[name] for name in SWEEP)


def _write(
    target: Path,
    columns: Sequence[str],
    rows: Iterable[tuple[Any, ...]],
    constants: dict[str, Any],
) -> None:
    tail = tuple(constants.values())
    with target.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([*columns, *constants])
        writer.writerows((*row, *tail) for row in rows)


def read(path: Path) -> Any:
    """Return what a CSV file holds; see `load`."""
    try:
        with path.open(encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file, strict=True))
        return _restored(path, rows)
    except FileError:
        raise
    except (KeyError, TypeError, ValueError, csv.Error) as error:
        raise damaged(path, f"{type(error).__name__} {error}") from error


def _restored(path: Path, rows: list[dict[str, str]]) -> Any:
    for what in ("scene", "structure"):
        if rows and what in rows[0]:
            words = f"rows of the {what} {rows[0][what]}, for other programs"
            raise FileError(path, f"{words}; save as .json to load it")
    if not rows or "schema" not in rows[0]:
        if rows and "displacement" in rows[0]:
            if "phase" in rows[0]:
                raise FileError(path, "the motion of a simulation, which cannot be loaded")
            raise FileError(path, "the motion of an orbit; save the orbit as .json to load it")
        raise FileError(path, "not a file of nonsmooth: it has no rows with a schema")
    check_schema(path, int(rows[0]["schema"]))
    family = "parameter" in rows[0]
    names = list(rows[0])
    constant = names[len(COLUMNS) + 3 if family else len(SWEEP) :]
    for row in rows:
        if None in row or None in row.values():
            raise damaged(path, "a row with too many or too few columns")
        if any(row[name] != rows[0][name] for name in constant):
            raise damaged(path, "rows of different sweeps")
    if len(rows) != int(rows[0]["rows"]):
        raise damaged(path, f"{len(rows)} rows of {rows[0]['rows']}")
    if family:
        return _families(path, rows)
    swept = _sweep(rows)
    check_rows(path, swept)
    return swept


def _sweep(rows: list[dict[str, str]]) -> Sweep:
    belt = StickSlip(**{name: float(rows[0][name]) for name in PARAMETERS})
    found = [
        {
            "method": row["method"],
            "order": int(row["order"]),
            "status": row["status"],
            "t1": _number(row["t1"]),
            "period": _number(row["period"]),
            "iterations": int(row["iterations"]),
            "seconds": float(row["seconds"]),
            "message": row["message"],
            "errors": {name: _number(row[f"error_{name}"]) for name in ERRORS},
            "estimate": {name: _number(row[f"estimate_{name}"]) for name in ESTIMATES},
        }
        for row in rows
    ]
    return Sweep(belt, tuple(map(to_row, found)), int(rows[0]["c1_terms"]))


def _families(path: Path, rows: list[dict[str, str]]) -> Any:
    parameter = rows[0]["parameter"]
    methods = tuple(dict.fromkeys(row["method"] for row in rows))
    count = len(rows) // len(methods)
    belt = StickSlip(**{name: float(rows[0][name]) for name in PARAMETERS})
    check_points(path, parameter, rows)
    head = Head(
        belt, parameter, methods, int(rows[0]["order"]), int(rows[0]["c1_terms"]), count
    )
    columns = [parameter if name == "value" else name for name in COLUMNS]
    found = to_families(
        path,
        head,
        [
            (row["method"], row["status"], *(_number(row[name]) for name in columns))
            for row in rows
        ],
    )
    return found[0] if len(found) == 1 else found


def _number(text: str) -> float | None:
    return float(text) if text else None
