"""The place of the attachment, exactly: a fraction of the length, and sines at it."""

import numbers
from fractions import Fraction
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from ..arrays import Vector

#: Numbers of modes.
Integers: TypeAlias = npt.NDArray[np.int_]

#: Multiples of the place up to which the sines of modes are reduced in whole numbers.
EXACTLY = 5000


def as_position(value: object) -> Fraction:
    """Return a place between the ends, as a part of the length, as the fraction that was meant.

    Parameters
    ----------
    value : str, float or Fraction
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
        if isinstance(value, str):
            found = Fraction(value.replace(" ", ""))
        elif isinstance(value, numbers.Rational):  # a bool, too, which is an end
            found = Fraction(value)
        elif isinstance(value, numbers.Real):
            found = Fraction(repr(float(value)))
        else:
            raise TypeError
    except (ValueError, TypeError, ZeroDivisionError, OverflowError):
        raise ValueError(f"position: got {value!r:.60}, {expected}") from None
    if not 0 < found < 1 or not 0 < float(found) < 1:
        said = str(value) if isinstance(value, Fraction) else repr(value)
        raise ValueError(f"position: got {said:.60}, {expected}")
    return found


def sines(numbers_: Integers, a: Fraction) -> tuple[Vector, Vector]:
    """Return ``sin(n pi a)`` and ``cos(n pi a)``; zero where they are zero exactly.

    Up to `EXACTLY` the multiples are reduced in whole numbers.
    """
    P, Q = a.numerator, a.denominator
    n = np.asarray(numbers_)
    if n.size and int(n.max()) > EXACTLY:
        # 2 n a loses n eps of itself: from the nearer end
        angle = np.pi * np.fmod(n * float(min(a, 1 - a)), 2.0)
        sign = np.where((n % 2 == 0) | (2 * a <= 1), 1.0, -1.0)
        return np.where(2 * a > 1, -sign, 1.0) * np.sin(angle), sign * np.cos(angle)
    found = [_exact(int(k) * P % (2 * Q), Q) for k in n.ravel()]
    both = np.array(found, dtype=float).reshape((*n.shape, 2))
    return both[..., 0], both[..., 1]


def _exact(p: int, Q: int) -> tuple[float, float]:
    """Return sine and cosine of ``pi p/Q``, ``0 <= p < 2 Q``, from the first eighth."""
    sign = 1.0
    if p >= Q:
        p, sign = p - Q, -1.0
    flipped = 2 * p > Q
    if flipped:
        p = Q - p
    if 4 * p <= Q:
        sine, cosine = np.sin(np.pi * (p / Q)), np.cos(np.pi * (p / Q))
    else:
        rest = np.pi * ((Q - 2 * p) / (2 * Q))
        sine, cosine = np.cos(rest), np.sin(rest)
    return sign * sine, sign * (-cosine if flipped else cosine)
