"""What must hold of the numbers of a file, whatever else was changed in it.

Each check raises a `NotRightError` that names the number.
"""

import math
from collections.abc import Iterable, Mapping
from typing import Any

from .file_errors import NotRightError

#: Largest part by which numbers of a file may be off what others of them say.
SAME = 1e-9


def check(right: bool, problem: str) -> None:
    """Raise a `NotRightError` with the words `problem` unless `right`."""
    if not right:
        raise NotRightError(problem)


def positive(name: str, value: Any) -> None:
    """Check that a number is finite and above 0."""
    right = is_real(value) and math.isfinite(value) and value > 0
    check(right, f"{name} is {value!r}, expected a positive number")


def not_negative(name: str, value: Any) -> None:
    """Check that a number is not negative; None stands for one that is not known."""
    right = value is None or (is_real(value) and value >= 0)
    check(right, f"{name} is {value!r}, expected a number not below 0")


def same(name: str, value: Any, expected: float, of: str) -> None:
    """Check that a number agrees with others in the file."""
    right = is_real(value) and abs(value - expected) <= SAME * abs(expected)
    check(right, f"{name} is {value!r}, but {of} give {expected!r}")


def times(row: Mapping[str, Any], durations: Iterable[Any]) -> None:
    """Check that the durations of a row add up to its period."""
    positive("period", row["period"])
    parts = list(durations)
    for index, duration in enumerate(parts, 1):
        positive(f"duration {index}", duration)
    same("period", row["period"], math.fsum(parts), "its durations")


def is_real(value: Any) -> bool:
    """Return whether a value of a document is a number."""
    return isinstance(value, int | float) and not isinstance(value, bool)
