"""What no test of a phase sees of its residual: rows above the tests say it for all others."""

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from math import prod

import numpy as np

from ..arrays import Matrix
from ..compiling import rebuilt


def _rising(x: int, k: int) -> Fraction:
    return Fraction(prod(range(x, x + k)))


@cache
def combinations(
    unseen: Callable[[int, int, int], float], rows: int, k: int, count: int
) -> Matrix:
    """Return Z: what coefficients from `rows` on of the residual make of those before.

    A residual that is orthogonal to all tests of a phase that begins C^k is a combination of as
    many polynomials as `count`; their weights by degree, ``unseen(m, l, k)`` of a generated
    module, are a triangle at the top.  Shape (rows, count), each to rounding.

    Examples
    --------
    >>> from nonsmooth.generated.ck import unseen
    >>> combinations(unseen, 2, 0, 1).tolist()
    [[0.2], [-0.6]]
    """
    weight = rebuilt(unseen, {"rising": _rising})
    above = range(rows, rows + count)
    found = np.empty((rows, count))
    for l in range(rows):
        row: list[Fraction] = []
        for m in above:
            pairs = zip(row, above, strict=False)
            taken = sum(q * Fraction(weight(m, degree, k)) for q, degree in pairs)
            row.append((Fraction(weight(m, l, k)) - taken) / Fraction(weight(m, m, k)))
        found[l] = [float(q) for q in row]
    found.flags.writeable = False
    return found
