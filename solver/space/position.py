"""The place of the attachment as an exact fraction of the length, and sines there."""

import math
import numbers
from decimal import Decimal
from fractions import Fraction
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from ..arrays import Vector

#: Numbers of modes.
Integers: TypeAlias = npt.NDArray[np.int_]


def as_fraction(text: str) -> Fraction:
    """Return a fraction or a decimal, exactly.

    Raises
    ------
    ValueError, ZeroDivisionError, OverflowError
        If it is neither, or too large for a float.
    """
    if "/" not in text and (rough := float(text)) in (0, math.inf):
        return Fraction(rough)  # not with all the digits that a huge exponent asks for
    return Fraction(text.replace(" ", ""))


def as_position(value: object) -> Fraction:
    """Return a position relative to the length as the exact fraction that was meant.

    Parameters
    ----------
    value : str, float, Decimal or Fraction
        ``"3/10"``, ``"0.3"``, ``0.3`` and ``Fraction(3, 10)`` are the same; a float is the
        shortest decimal that rounds to it.

    Raises
    ------
    ValueError
        If it is not a number, or not between 0 and 1: at an end nothing can be attached.

    Examples
    --------
    >>> as_position("3/10") == as_position(0.3)
    True
    """
    expected = "expected a fraction or a decimal above 0 and below 1, such as 3/10"
    try:
        if isinstance(value, str | Decimal):
            fraction = as_fraction(str(value))
        elif isinstance(value, numbers.Rational):  # a bool, too, which is an end
            fraction = Fraction(value)
        elif isinstance(value, numbers.Real):
            fraction = Fraction(repr(float(value)))
        else:
            raise TypeError
    except (ValueError, TypeError, ZeroDivisionError, OverflowError):
        raise ValueError(f"position: got {value!r:.60}, {expected}") from None
    if not 0 < fraction < 1 or not 0 < float(fraction) < 1:
        text = str(value) if isinstance(value, Fraction) else repr(value)
        raise ValueError(f"position: got {text:.60}, {expected}")
    return fraction


def sines(numbers_: Integers, a: Fraction) -> tuple[Vector, Vector]:
    """Return ``sin(n pi a)`` and ``cos(n pi a)``, with exact zeros.

    The multiples ``pi p/Q`` are reduced in integers to the first eighth of a turn.
    """
    P, Q = a.numerator, a.denominator
    p = np.asarray(numbers_).astype(object) * P % (2 * Q)
    sign, p = np.where(p >= Q, -1.0, 1.0), p % Q
    flipped = 2 * p > Q
    p = np.where(flipped, Q - p, p)
    beyond = 4 * p > Q  # there the sine of the rest of a quarter is the cosine
    angle = np.pi * np.where(beyond, (Q - 2 * p) / (2 * Q), p / Q).astype(float)
    pair = np.sin(angle), np.cos(angle)
    sine, cosine = np.where(beyond, pair[::-1], pair)
    return sign * sine, sign * np.where(flipped, -cosine, cosine)
