"""The same oscillator in grams, millimetres and milliseconds: every number that is written."""

import csv
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import units
from saved_things import needs_netcdf
from units import (
    BELT,
    COEFFICIENTS,
    GRAM_MILLIMETRE_MILLISECOND,
    POWERS,
    SCALARS,
    Units,
    flags,
    leaves,
)

import nonsmooth as ns

pytestmark = pytest.mark.parametrize(
    "other", [POWERS, GRAM_MILLIMETRE_MILLISECOND], ids=["powers", "g, mm, ms"]
)

#: What differs between two runs anyway.
ANYWAY = {"seconds", "sha256"}

#: Parts of a document without a unit, whatever the names in them.
WITHOUT = {"errors", "estimate", "outcome", "rates", "trials", "transition_mismatch", "units"}

#: Columns of CSV that are not numbers, and those that are the ends of a motion.
TEXTS = {"method", "status", "message", "scene", "motion", "followed", "stable"}
ENDS = {
    f"{end}_{x}": SCALARS[x]
    for end in ("least", "largest")
    for x in ("displacement", "velocity")
}

#: A number in a text, such as why a solution is not an orbit: of three figures or more.
NUMBER = r"(-?\d\S*) (s|m/s|m)\b"


def unit_of(path: tuple[Any, ...], method: str) -> tuple[str, int]:
    """Return the unit of a number in a document, and its place in its list."""
    number = path[-1] if isinstance(path[-1], int) else 0
    if WITHOUT & set(path):
        return "1", number
    if "coefficients" in path:
        return COEFFICIENTS[method][path[path.index("coefficients") + 1]], number
    name = next(part for part in reversed(path) if isinstance(part, str))
    return SCALARS.get(name, "1"), number


def assert_scaled(
    here: Any, there: Any, factor: float, other: Units, what: tuple[Any, ...]
) -> None:
    """Check one number; that powers of two are changed by does not even round."""
    if isinstance(here, str):
        numbers = [re.findall(NUMBER, text) for text in (here, there)]
        for (one, unit), (two, _) in zip(*numbers, strict=True):
            assert float(two) == pytest.approx(float(one) * other.of(unit), rel=1e-2), what
        assert re.sub(NUMBER, r"\2", there) == re.sub(NUMBER, r"\2", here), what
    elif not isinstance(here, float):
        assert there == here, what
    elif other is POWERS:
        assert there == here * factor, what
    else:  # (22) has the root of what the times are off by, which is rounding
        # and of switches that are exact the estimate is what Newton's method left
        least = {"acceleration": 1e-9, "switches": 1e-12}.get(what[-1], 1e-13 * factor)
        assert there == pytest.approx(here * factor, rel=1e-9, abs=least), what


def assert_arrays_scaled(here: Any, there: Any, factor: float, other: Units, what: str) -> None:
    if other is POWERS:
        assert np.array_equal(there, here * factor, equal_nan=True), what
    else:  # velocity is zero somewhere
        np.testing.assert_allclose(there, here * factor, 1e-9, 1e-10 * factor, err_msg=what)


def printed_and_scaled(
    run, other: Units, arguments: Callable[[ns.StickSlip], tuple[Any, ...]], vary: str = ""
) -> dict[str, Any]:
    """Return what a command prints of an oscillator, checked against it in other units."""
    first, second = (
        json.loads(run(*arguments(belt), "--json")[1]) for belt in (BELT, other.belt(BELT))
    )
    for each in (first, second):  # Newton's corrections at rounding, not results
        each.pop("outcome", None)
        each.pop("residual_norm", None)
    here, there = leaves(first), leaves(second)
    assert here.keys() == there.keys()
    methods = {path[:-1]: leaf for path, leaf in here.items() if path[-1] == "method"}
    moved = 0
    for path, leaf in here.items():
        if ANYWAY & set(path) or (path[-1] == "iterations" and other is not POWERS):
            continue  # a correction at rounding may be one more
        method = methods.get((), methods.get(path[:2], ""))
        unit, n = unit_of(path, method)
        if path[-1] == "value":
            unit = units.PARAMETERS[vary]
        assert_scaled(leaf, there[path], other.of(unit, n), other, path)
        moved += unit != "1" and isinstance(leaf, float)
    assert moved > 3
    return first


COMMANDS = [
    *(("solve", "--method", method, "--order", 7) for method in COEFFICIENTS),
    ("sweep", "--orders", "4-6"),
    ("roots", "--order", 6),
]


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: " ".join(map(str, command)))
def test_the_document_of_a_command(other: Units, command: tuple[Any, ...], run) -> None:
    first = printed_and_scaled(run, other, lambda belt: (*command, *flags(belt)))
    assert command[0] != "solve" or first["coefficients"]


@pytest.mark.parametrize("parameter", units.PARAMETERS)
def test_the_document_of_a_family(other: Units, parameter: str, run) -> None:
    def swept(belt: ns.StickSlip) -> tuple[object, ...]:
        value = getattr(belt, parameter)
        ends = f"{parameter}={value!r}:{1.125 * value!r}:2"
        flags_left = flags(belt, parameter)
        return ("sweep", "--vary", ends, *flags_left, "--methods", "c1", "--orders", 7)

    assert len(printed_and_scaled(run, other, swept, vary=parameter)["rows"]) == 2


MAKERS = {
    "orbits": lambda belt: [ns.solve(belt, method, 7) for method in ("hb", "hb-c1", "c1")],
    "sweep": lambda belt: ns.sweep(belt, orders=[5, 6]),
    "family": lambda belt: ns.family(
        belt, "stiffness", [belt.stiffness, 1.125 * belt.stiffness], "c1", 7
    ),
}


def files(kind: str, other: Units, folder: Path, suffix: str) -> list[Path]:
    """Return the files of an oscillator, and of the same in other units."""
    paths = [folder / f"here{suffix}", folder / f"there{suffix}"]
    for belt, path in zip((BELT, other.belt(BELT)), paths, strict=True):
        ns.save(MAKERS[kind](belt), path)
    return paths


@pytest.mark.parametrize("kind", MAKERS)
def test_the_columns_of_a_csv(other: Units, kind: str, tmp_path: Path) -> None:
    tables = [
        list(csv.DictReader(path.read_text().splitlines()))
        for path in files(kind, other, tmp_path, ".csv")
    ]
    for column in tables[0][0].keys() - ANYWAY:
        here, there = ([row[column] for row in table] for table in tables)
        if column == "iterations" and other is not POWERS:
            continue  # a correction at rounding may be one more
        if column in TEXTS:
            assert there == here, column
            continue
        numbers = [
            np.array([complex(q) for text in texts for q in text.split()])
            for texts in (here, there)
        ]
        factor = other.of((SCALARS | ENDS).get(column, "1"))
        assert_arrays_scaled(*numbers, factor, other, column)


@needs_netcdf
@pytest.mark.parametrize("kind", MAKERS)
def test_the_variables_of_a_netcdf(other: Units, kind: str, tmp_path: Path) -> None:
    import xarray as xr

    first, second = (xr.load_dataset(path) for path in files(kind, other, tmp_path, ".nc"))
    assert first.variables.keys() == second.variables.keys()
    numbers = {q for q, v in first.variables.items() if v.dtype == "f8"} - ANYWAY
    assert len(numbers) >= 4
    for name in numbers:
        unit = first[name].attrs["units"]
        assert second[name].attrs["units"] == unit
        here, there = first[name].values, second[name].values
        assert_arrays_scaled(here, there, other.of(unit), other, name)
