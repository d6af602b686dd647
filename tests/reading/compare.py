"""What an expression that was read is worth, to hold it against that of a record.

Both are evaluated, exactly, modulo a prime: each name has a value of its own, and so has each
function at each value of its arguments.  Sums, integrals and derivatives are such functions, of
their limits and their variable, too.  Two different expressions have the same value once in
2**127 times.
"""

import hashlib
import math
from fractions import Fraction
from functools import cache

import sympy as sp

from .tokens import ReadingError

PRIME = 2**127 - 1


def _drawn(*parts: object) -> int:
    """Return a number that depends on all the parts."""
    return int(hashlib.sha256(repr(parts).encode()).hexdigest(), 16)


def _symbol(symbol: sp.Symbol) -> int:
    """Return a whole number, as an index and an exponent need one."""
    return _drawn(symbol.name) % 10**9


def _exponent(expression: sp.Expr) -> Fraction:
    if expression.is_Rational:
        return Fraction(int(expression.p), int(expression.q))
    if expression.is_Symbol:
        return Fraction(_symbol(expression))
    parts = [_exponent(part) for part in expression.args]
    if expression.is_Add:
        return sum(parts, Fraction())
    if expression.is_Mul:
        product = Fraction(1)
        for part in parts:
            product *= part
        return product
    raise ReadingError(f"the exponent {expression}")


def _power(base: int, exponent: Fraction) -> int:
    if exponent.denominator != 1:
        base = _drawn("root", base, exponent.denominator)
    return pow(base, exponent.numerator, PRIME)


@cache
def value(expression: sp.Expr) -> int:
    """Return the value of an expression in plain words."""
    if expression.is_Symbol:
        return _symbol(expression)
    if expression.is_Rational:
        return int(expression.p) * pow(int(expression.q), -1, PRIME) % PRIME
    if expression.is_Pow:  # of positive numbers, as all here are: of a product, by its factors
        inside = (q.as_base_exp() for q in sp.Mul.make_args(expression.base))
        powers = [(value(base), _exponent(exp * expression.exp)) for base, exp in inside]
        return math.prod(_power(*power) for power in powers) % PRIME
    parts = [value(part) for part in expression.args]
    if expression.is_Add:
        return sum(parts) % PRIME
    if expression.is_Mul:
        return math.prod(parts) % PRIME
    return _drawn(expression.func.__name__, *parts) % PRIME
