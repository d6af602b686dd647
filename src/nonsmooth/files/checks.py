"""What must hold of the numbers of a file, whatever else was changed in it."""

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

#: Largest part by which numbers of a file may be off what others of them say.
SAME = 1e-9

#: Largest residual of an orbit, without units, as a part of its largest unknown.
RESIDUAL = 1e-8


class NotRightError(ValueError):
    """A number that cannot be right; the message names it."""


def positive(name: str, value: Any) -> None:
    """Check that a number is finite and above 0.

    Raises
    ------
    NotRightError
        If it is not.
    """
    if not (is_real(value) and math.isfinite(value) and value > 0):
        raise NotRightError(f"{name} is {value!r}, expected a positive number")


def not_negative(name: str, value: Any) -> None:
    """Check that a number is not below 0; one that is not known is None.

    Raises
    ------
    NotRightError
        If it is.
    """
    if value is not None and not (is_real(value) and value >= 0):
        raise NotRightError(f"{name} is {value!r}, expected a number not below 0")


def same(name: str, value: Any, expected: float, of: str) -> None:
    """Check that a number is what others say.

    Raises
    ------
    NotRightError
        If it is not.
    """
    if not (is_real(value) and abs(value - expected) <= SAME * abs(expected)):
        raise NotRightError(f"{name} is {value!r}, but {of} give {expected!r}")


def times(row: Mapping[str, Any], durations: Iterable[Any]) -> None:
    """Check the period of a row, and that its durations are its parts.

    Raises
    ------
    NotRightError
        If one of them is not positive, or they are not the period.
    """
    positive("period", row["period"])
    parts = list(durations)
    for index, duration in enumerate(parts, 1):
        positive(f"duration {index}", duration)
    same("period", row["period"], math.fsum(parts), "its durations")


def unknowns(z: Any, size: int) -> None:
    """Check that there are as many unknowns as equations, all of them numbers.

    Raises
    ------
    NotRightError
        If there are not.
    """
    if len(z) != size:
        raise NotRightError(f"{len(z)} unknowns, expected {size}")
    if not np.isfinite(z).all():
        raise NotRightError("unknowns that are not finite")


def residual(R: Any, z: Any) -> None:
    """Check that unknowns satisfy their equations.

    Raises
    ------
    NotRightError
        If they do not.
    """
    largest = float(np.abs(R).max())
    if not largest <= RESIDUAL * max(1.0, float(np.abs(z).max())):
        raise NotRightError(f"an orbit that does not satisfy its equations, by {largest:.1e}")


def is_real(value: Any) -> bool:
    """Return whether a value of a document is a number."""
    return isinstance(value, int | float) and not isinstance(value, bool)
