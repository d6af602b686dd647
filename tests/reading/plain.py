"""The plain words in which what was read and what was meant are compared.

Every index is written out the same way: ``x_s``, ``t1``, ``a[n]`` and the column ``C1[k]`` are
functions of their indices, ``"x_"(s)``, ``"t_"(1)``, ``"a_"(n)``, ``"C^1_"(k)``; a function
that is applied ends in ``()``; sums, integrals and derivatives are functions of their parts.
"""

import re
from collections.abc import Iterable
from functools import cache

import sympy as sp

from nonsmooth.codegen.system import Inner, ShiftedLegendre, TwiceIntegrated


@cache
def _function(name: str) -> type[sp.Expr]:
    return sp.Function(name)


def made(name: str, *parts: sp.Expr) -> sp.Expr:
    """Return a function of its parts that nothing is known about."""
    return _function(name)(*parts)


def _part(text: str) -> sp.Expr:
    return sp.Integer(text) if text.isdigit() else sp.Symbol(text)


def named(
    name: str,
    indices: Iterable[sp.Expr] = (),
    primes: int = 0,
    arguments: Iterable[sp.Expr] | None = None,
) -> sp.Expr:
    """Return a name with its indices; applied, if it has arguments.

    A name may hold indices itself, as ``omega_n``, ``t1``, ``even_0_o`` and ``S1`` do.
    """
    name, *lowered = name.split("_")
    base, digits = re.fullmatch(r"(.*?)(\d*)", name).groups()
    raised = digits and base in {"C", "S"} and tuple(indices)
    parts = [_part(text) for text in [*([digits] if digits and not raised else ()), *lowered]]
    parts += indices
    base += (f"^{digits}" if raised else "") + "'" * primes + ("_" if parts else "")
    if arguments is None:
        return made(base, *parts) if parts else sp.Symbol(base)
    return made(f"{base}()", *parts, *arguments)


def _applied(expression: sp.Expr, primes: int = 0, at: sp.Expr | None = None) -> sp.Expr:
    name = expression.func.__name__
    if name == "xdot":
        name, primes = "x", 1
    points = expression.args if at is None else (at,)
    return named(name, (), primes, map(plain, points))


def _rate(expression: sp.Derivative, at: sp.Expr | None = None) -> sp.Expr:
    ((variable, order),) = expression.variable_count
    if isinstance(expression.expr, sp.core.function.AppliedUndef):
        return _applied(expression.expr, int(order), at)
    return made("D", plain(expression.expr), plain(variable))


def _special(expression: sp.Basic) -> sp.Expr | None:
    """Return what has a notation of its own in plain words."""
    found = None
    match expression:
        case sp.Symbol():
            found = named(expression.name)
        case sp.Indexed():
            found = named(str(expression.base.label), [*map(plain, expression.indices)])
        case sp.Sum() | sp.Integral():
            ((variable, first, last),) = expression.limits
            sign = "Sum" if isinstance(expression, sp.Sum) else "Int"
            found = made(sign, *map(plain, (expression.function, variable, first, last)))
        case sp.Derivative():
            found = _rate(expression)
        case sp.Subs():
            found = _rate(expression.expr, expression.point[0])
        case sp.Piecewise():
            found = made(
                "cases", *(part for row in expression.args for part in map(plain, row))
            )
        case sp.Heaviside():
            found = made("H()", plain(expression.args[0]))
        case Inner():
            found = made("inner", *map(plain, expression.args))
        case ShiftedLegendre() | TwiceIntegrated() | sp.jn():
            name = {ShiftedLegendre: "P*", TwiceIntegrated: "Q", sp.jn: "j"}[expression.func]
            index, argument = map(plain, expression.args)
            found = named(name, (index,), 0, (argument,))
        case sp.Eq():
            found = made("equal", *map(plain, expression.args))
        case sp.Max():
            found = made("max()", *sorted(map(plain, expression.args), key=str))
        case sp.Function():
            found = _applied(expression)
    return found


def plain(expression: sp.Basic) -> sp.Expr:
    """Return an expression of a record in plain words."""
    if expression in (sp.true, sp.pi):
        return sp.Symbol("pi" if expression is sp.pi else "otherwise")
    found = _special(expression)
    if found is None and expression.args:
        return expression.func(*map(plain, expression.args))
    return expression if found is None else found
