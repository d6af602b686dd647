"""Products of powers of units beyond float64, and matrices with rows and columns scaled."""

import math

import numpy as np

from .arrays import Matrix


def product_of_powers(value: float, *factors: tuple[float, int]) -> float:
    """Return `value` times ``base**exponent`` of each factor, without overflow on the way.

    Bases are positive; infinite, or zero, only where the product is beyond float64 itself.

    Examples
    --------
    >>> product_of_powers(3.0, (2.0**-600, -2), (2.0**600, -2))
    3.0
    >>> product_of_powers(-2.0, (1e-12, -60))
    -inf
    """
    mantissa, exponent = math.frexp(value)
    for base, power in factors:
        part, shift = math.frexp(base)
        raised, more = math.frexp(part ** abs(power))
        sign = 1 if power >= 0 else -1
        mantissa = mantissa * raised if power >= 0 else mantissa / raised
        exponent += sign * (more + shift * abs(power))
    try:
        return math.ldexp(mantissa, exponent)
    except OverflowError:
        return math.copysign(math.inf, mantissa)


def equilibrated(J: Matrix) -> Matrix:
    """Return a matrix with rows and columns scaled to the same size, by Ruiz's method.

    Each of ten passes divides by the roots of their largest elements.

    Examples
    --------
    >>> equilibrated(np.diag([1e-12, 1e9])).round(3)
    array([[1., 0.],
           [0., 1.]])
    """
    scaled = np.array(J, dtype=float)
    for _ in range(10):
        rows, columns = np.abs(scaled).max(axis=1), np.abs(scaled).max(axis=0)
        scaled /= np.sqrt(np.outer(rows, columns))
    return scaled
