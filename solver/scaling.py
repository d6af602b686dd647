"""Products of powers of units, which may pass beyond float64 on the way to their value."""

import math


def product_of_powers(value: float, *factors: tuple[float, int]) -> float:
    """Return `value` times ``base**exponent`` of each factor, without overflow on the way.

    Parameters
    ----------
    value : float
        Any finite number.
    factors : (float, int)
        Positive bases, and whole exponents up to a few hundred.

    Returns
    -------
    float
        Infinite, or zero, only where the product itself is beyond float64.

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
