"""Checks of numbers that hold for every scene (finite, whole), and their errors."""

import math
import numbers
from collections.abc import Iterable
from typing import Any

#: Figures or letters of a value that messages repeat in full.
LONG = 80


class ParameterError(ValueError):
    """Parameters of a scene that are not allowed; `errors` has a message for each."""

    def __init__(self, errors: list[str]) -> None:
        super().__init__("; ".join(errors))
        self.errors = tuple(errors)

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (list(self.errors),), vars(self)


def is_number(value: object) -> bool:
    """Return whether `value` is a finite real number that a float can hold, and no bool."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        return False
    try:
        return math.isfinite(float(value))
    except OverflowError:
        return False


def repeated(value: object) -> str:
    """Return a value as messages repeat it: of a long one the begin and the end.

    Examples
    --------
    >>> repeated(1.5), repeated(10**99)
    ('1.5', '10000000000000000000...00000000000000000000')
    """
    try:
        text = repr(value)
    except ValueError:
        return "a number of more figures than Python prints"
    return text if len(text) <= LONG else f"{text[: LONG // 4]}...{text[-LONG // 4 :]}"


def whole(
    name: str, value: object, least: int = 1, most: float = math.inf, of: str = ""
) -> int:
    """Return `value` as an int if it is a whole number from `least` to `most`, and no bool.

    Raises
    ------
    ValueError
        If it is not, with `name`, and with `of` behind the range expected.
    """
    right = isinstance(value, numbers.Integral) and not isinstance(value, bool)
    if not (right and least <= value <= most):  # type: ignore[operator]
        last = f" to {most}" if math.isfinite(most) else ""
        expected = f"a whole number from {least}{last}{of}"
        raise ValueError(f"{name}: got {repeated(value)}, expected {expected}")
    return int(value)  # type: ignore[call-overload, no-any-return]


def whole_or_none(name: str, value: object) -> int | None:
    """Return a whole number from 1 as an int, and None as it is; else see `whole`."""
    return None if value is None else whole(name, value)


def several(name: str, values: object, expected: str) -> list[Any]:
    """Return values as a list; raise a `ValueError` if they are no sequence, or empty."""
    is_text = isinstance(values, str | bytes)
    items = [*values] if isinstance(values, Iterable) and not is_text else []
    if not items:
        raise ValueError(f"{name}: got {values!r:.80}, expected {expected} in a sequence")
    return items
