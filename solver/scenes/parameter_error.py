"""What parameters must be, whatever the scene: finite numbers, and the error that says so."""

import math
import numbers


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
