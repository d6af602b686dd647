"""What numbers must be, whatever the scene: finite, or whole; and errors that say so."""

import math
import numbers
from typing import Any


class ParameterError(ValueError):
    """Parameters that are not those of an oscillator; `errors` names each one."""

    def __init__(self, errors: list[str]) -> None:
        super().__init__("; ".join(errors))
        self.errors = tuple(errors)

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (list(self.errors),), vars(self)


def is_number(value: object) -> bool:
    """Whether `value` is a finite real number that a float can hold; a bool is not."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        return False
    try:
        return math.isfinite(float(value))
    except OverflowError:
        return False


def whole(
    name: str, value: object, least: int = 1, most: float = math.inf, of: str = ""
) -> int:
    """Return a whole number from the least to the most that is `of` something; no bool.

    Raises
    ------
    ValueError
        With its name, if it is not one.
    """
    right = isinstance(value, numbers.Integral) and not isinstance(value, bool)
    if not (right and least <= value <= most):  # type: ignore[operator]
        last = f" to {most}" if math.isfinite(most) else ""
        expected = f"a whole number from {least}{last}{of}"
        raise ValueError(f"{name}: got {value!r}, expected {expected}")
    return int(value)  # type: ignore[call-overload, no-any-return]


def plain(number: Any) -> Any:
    """Return a whole number of any type, such as NumPy's, as Python has it; else as it is."""
    return int(number) if isinstance(number, numbers.Integral) else number
