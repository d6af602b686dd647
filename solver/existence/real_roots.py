"""The positive roots of a polynomial with integer coefficients, isolated and refined.

By Descartes' rule of signs with bisection (G. E. Collins and A. G. Akritas, Proc. SYMSAC
1976, 272-275), in exact arithmetic.
"""

from fractions import Fraction
from itertools import pairwise

#: Coefficients from the constant up.
Polynomial = list[int]

#: Bisections after which an interval counts as a multiple root.
DEEPEST = 150

#: Bits to which a root is refined; more than a float holds.
BITS = 64


def _sign_changes(p: Polynomial) -> int:
    signs = [c > 0 for c in p if c]
    return sum(a != b for a, b in pairwise(signs))


def _shift(p: Polynomial) -> Polynomial:
    """Return the coefficients of ``p(x + 1)``."""
    q = list(p)
    for i in range(len(q) - 1):
        for k in range(len(q) - 2, i - 1, -1):
            q[k] += q[k + 1]
    return q


def _in_unit_interval(p: Polynomial) -> int:
    """Return Descartes' bound on the roots of `p` in (0, 1); exact if 0 or 1."""
    return _sign_changes(_shift(p[::-1]))


def _root_bound(p: Polynomial) -> int:
    """Return a power of two above every root: Fujiwara's bound, rounded up."""
    lead, degree = abs(p[-1]).bit_length() - 1, len(p) - 1
    exponents = (
        -(-(abs(c).bit_length() - lead) // (degree - i)) for i, c in enumerate(p[:-1]) if c
    )
    return 1 << (max(0, *exponents) + 1)


def isolate(p: Polynomial) -> list[tuple[Fraction, Fraction]]:
    """Return disjoint intervals with one positive root of `p` each, and all of them.

    An interval ``(a, a)`` is the root ``a`` itself.

    Raises
    ------
    ArithmeticError
        If `p` has a multiple root.
    """
    bound = _root_bound(p)
    intervals: list[tuple[Fraction, Fraction]] = []
    work = [([c * bound**i for i, c in enumerate(p)], Fraction(0), Fraction(bound), 0)]
    while work:
        q, left, width, depth = work.pop()
        if depth > DEEPEST:
            raise ArithmeticError(f"multiple root near s = {float(left)}")
        roots = _in_unit_interval(q)
        if roots == 1:
            intervals.append((left, left + width))
        if roots <= 1:
            continue
        degree = len(q) - 1
        lower = [c << (degree - i) for i, c in enumerate(q)]
        upper = _shift(lower)
        middle = left + width / 2
        if upper[0] == 0:
            if upper[1] == 0:
                raise ArithmeticError(f"multiple root at s = {float(middle)}")
            intervals.append((middle, middle))
            upper = upper[1:]
        work.append((lower, left, width / 2, depth + 1))
        work.append((upper, middle, width / 2, depth + 1))
    return sorted(intervals)


def _value(p: Polynomial, x: Fraction) -> int:
    """Return the sign of ``p(x)``, from integers alone."""
    total, power = 0, 1
    for c in p[::-1]:
        total = total * x.numerator + c * power
        power *= x.denominator
    return (total > 0) - (total < 0)


def refine(p: Polynomial, left: Fraction, right: Fraction) -> Fraction:
    """Return the root of `p` in an isolating interval to `BITS` bits."""
    if left == right:
        return left
    ahead = _value(p, right)
    if ahead == 0:  # the neighbour's root stands on this end: step inside
        ahead = -_value(p, left)
    while right - left > right / (1 << BITS):
        middle = (left + right) / 2
        sign = _value(p, middle)
        if sign == 0:
            return middle
        left, right = (left, middle) if sign == ahead else (middle, right)
    return (left + right) / 2
