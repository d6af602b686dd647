"""Hold what was read against a record: as many sides, and each the same.

Both are evaluated, exactly, modulo a prime: each name has a value of its own, and so has each
function at each value of its arguments.  Sums, integrals and derivatives are such functions, of
their limits and their variable, too.  Two different expressions have the same value once in
2**127 times.
"""

import hashlib
import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache

import sympy as sp

from nonsmooth.codegen.system import Equation

from .grammar import expression, sides
from .plain import plain
from .tokens import ReadingError, Token

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


def differences(equation: Equation, tokens: Callable[[], Sequence[Token]], spaced: bool) -> str:
    """Return what is wrong with an equation whose printed tokens are read here, or nothing."""
    name = f"({equation.number or '-'}) {equation.words}"
    meant = [plain(side) for side in equation.sides]
    try:
        printed = [expression(side, spaced) for side in sides(tokens())]
    except (ReadingError, ZeroDivisionError) as error:
        return f"{name}: cannot be read: {error}"
    if len(printed) != len(meant):
        return f"{name}: has {len(meant)} sides, {len(printed)} are printed"
    wrong = [
        f"{name}: {after} is printed for {before}"
        for before, after in zip(meant, printed, strict=True)
        if value(before) != value(after)
    ]
    return "\n".join(wrong)
