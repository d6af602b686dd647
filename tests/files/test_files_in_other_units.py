"""The same oscillator in grams, millimetres and milliseconds: every number in a file."""

import csv
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from units import BELT, GRAM_MILLIMETRE_MILLISECOND, POWERS, SCALARS, Units

import nonsmooth as ns

OTHER = pytest.mark.parametrize(
    "other", [POWERS, GRAM_MILLIMETRE_MILLISECOND], ids=["powers", "g, mm, ms"]
)

#: What differs between two runs anyway, and columns that are not numbers.
ANYWAY = {"seconds"}
TEXTS = {"method", "status", "message", "scene", "motion", "followed"}
ENDS = {
    f"{end}_{x}": SCALARS[x]
    for end in ("least", "largest")
    for x in ("displacement", "velocity")
}


def results(belt: ns.StickSlip) -> dict[str, object]:
    family = ns.family(belt, "stiffness", [belt.stiffness, 1.125 * belt.stiffness], "c1", 7)
    orbits = [ns.solve(belt, method, 7) for method in ("hb", "hb-c1", "c1")]
    return {"orbits": orbits, "sweep": ns.sweep(belt, orders=[5, 6]), "family": family}


KINDS = pytest.mark.parametrize("kind", ["orbits", "sweep", "family"])


def assert_arrays_scaled(here: Any, there: Any, factor: float, other: Units, what: str) -> None:
    if other is POWERS:
        assert np.array_equal(there, here * factor, equal_nan=True), what
    else:  # velocity is zero somewhere
        np.testing.assert_allclose(there, here * factor, 1e-9, 1e-10 * factor, err_msg=what)


@OTHER
@KINDS
def test_the_columns_of_a_csv(other: Units, kind: str, tmp_path: Path) -> None:
    tables = []
    for belt in (BELT, other.belt(BELT)):
        path = tmp_path / f"{len(tables)}.csv"
        ns.save(results(belt)[kind], path)
        with path.open(newline="") as file:
            tables.append(list(csv.DictReader(file)))
    for column in tables[0][0].keys() - ANYWAY:
        here, there = ([row[column] for row in table] for table in tables)
        if column == "iterations" and other is not POWERS:
            continue  # a correction at rounding may be one more
        if column in TEXTS:
            assert there == here, column
            continue
        numbers = [
            np.array([float(q) for text in texts for q in text.split()])
            for texts in (here, there)
        ]
        factor = other.of((SCALARS | ENDS).get(column, "1"))
        assert_arrays_scaled(*numbers, factor, other, column)


@OTHER
@KINDS
def test_the_variables_of_a_netcdf(other: Units, kind: str, tmp_path: Path) -> None:
    netcdf4 = pytest.importorskip("netCDF4")
    found: list[dict[str, Any]] = []
    for belt in (BELT, other.belt(BELT)):
        path = tmp_path / f"{len(found)}.nc"
        ns.save(results(belt)[kind], path)
        with netcdf4.Dataset(path) as file:
            every = [v for g in (file, *file.groups.values()) for v in g.variables.values()]
            numbers = [v for v in every if v.dtype == "f8" and v.name not in ANYWAY]
            found.append({v.group().name + v.name: (v.units, v[:].data) for v in numbers})
    first, second = found
    assert first.keys() == second.keys()
    for name, (unit, here) in first.items():
        assert second[name][0] == unit
        assert_arrays_scaled(here, second[name][1], other.of(unit), other, name)
