"""Whether the numbers of a CSV file agree: it has no digest, and is easily edited.

Some of its columns follow from others, and from the parameters: where one of them was
changed, which of the two that is cannot be known, and both are named.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from nonsmooth.solver.shortcuts.orbit.motion import exact
from nonsmooth.solver.shortcuts.orbit.oscillator import PARAMETERS, StickSlip
from nonsmooth.solver.shortcuts.search.sweep import Sweep

from ..errors import FileError, damaged

#: Relative difference that rounding may make between a number and what it follows from.
ROUNDING = 1e-12


def check_rows(path: Path, sweep: Sweep) -> None:
    """Check the times of a sweep against their errors and the parameters.

    Raises
    ------
    FileError
        Naming the first row and columns that do not agree.
    """
    reference = exact(sweep.belt)
    for number, row in enumerate(sweep.rows, start=2):
        if row.errors is None:
            continue
        for name in ("t1", "period"):
            found, error = getattr(row, name), getattr(row.errors, name)
            right = getattr(reference, name) * (1 + error)
            if found is None or not _agree(found, right, found):
                raise _differs(path, number, name, found, f"error_{name}, parameters", right)


def check_points(path: Path, parameter: str, rows: Sequence[Mapping[str, str]]) -> None:
    """Check alpha, the times and the part of stick of each point of families.

    Raises
    ------
    FileError
        Naming the first row and columns that do not agree.
    """
    first = StickSlip(**{name: float(rows[0][name]) for name in PARAMETERS})
    for number, row in enumerate(rows, start=2):
        value, alpha = float(row[parameter]), float(row["alpha"])
        changed = {parameter: value}
        right = replace(first, **changed).alpha
        if not _agree(alpha, right, alpha):
            raise _differs(path, number, "alpha", alpha, parameter, right)
        if row["status"] == "ok":
            t1, T, part = (float(row[name]) for name in ("t1", "period", "stick_fraction"))
            if not _agree(t1, part * T, t1):
                raise _differs(path, number, "t1", t1, "stick_fraction, period", part * T)


def _agree(found: float, right: float, scale: float) -> bool:
    return abs(found - right) <= ROUNDING * abs(scale)


def _differs(
    path: Path, line: int, name: str, found: float | None, others: str, right: float
) -> FileError:
    return damaged(
        path, f"line {line}: {name} is {found!r}, which by {others} would be {right!r}"
    )
