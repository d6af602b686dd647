"""Numbers and lists as texts for readers: few digits, raised powers of ten."""

import math

#: Relative errors below this are rounding.
ROUNDING = 1e-13

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def number(value: float, digits: int = 3) -> str:
    """Return `value` to so many significant digits.

    Examples
    --------
    >>> number(343.21), number(4000.0), number(5.2573e-4), number(0.0), number(1e7)
    ('343', '4000', '5.26×10⁻⁴', '0', '1.00×10⁷')
    """
    if value == 0 or not math.isfinite(value):
        return f"{value:g}"
    head, _, exponent = f"{value:.{digits - 1}e}".partition("e")
    power = int(exponent)
    if -3 <= power < 5:
        places = max(digits - 1 - power, 0)
        return signed(f"{round(value, digits - 1 - power):.{places}f}")
    return signed(f"{head}×10{str(power).translate(_RAISED)}")


def signed(text: str) -> str:
    """Return the text of a number with typographic minus signs."""
    return text.replace("-", "−")


def percent(part: float, digits: int = 3) -> str:
    """Return a fraction in percent; "rounding" if it is not zero, but below `ROUNDING`.

    Examples
    --------
    >>> percent(0.0852), percent(-0.022), percent(3e-15)
    ('8.52 %', '−2.20 %', 'rounding')
    """
    return "rounding" if 0 < abs(part) < ROUNDING else f"{number(100 * part, digits)} %"


def power_of_order(rate: float) -> str:
    """Return a rate of convergence as a power of N.

    Examples
    --------
    >>> power_of_order(0.953)
    'N⁻⁰·⁹⁵'
    """
    return "N" + f"{-rate:.2f}".translate(_RAISED).replace(".", "·")


def listed(words: list[str]) -> str:
    """Return words joined by commas, with "and" before the last.

    Examples
    --------
    >>> listed(["5"]), listed(["5", "15", "22"])
    ('5', '5, 15 and 22')
    """
    return " and ".join(part for part in (", ".join(words[:-1]), *words[-1:]) if part)
