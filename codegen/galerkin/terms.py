"""A condition or an expression as linear terms: coefficients of unknowns."""

from collections.abc import Collection, Sequence
from functools import cache
from typing import NamedTuple

import sympy as sp

from .condition import Block, Condition


class Term(NamedTuple):
    """One term of a condition: a coefficient times an unknown, or a constant.

    Parameters
    ----------
    coefficient : Expr
    unknown : Expr
        1 for a constant.
    over : tuple or None
        Index and limits of a sum over the unknowns of the block.
    """

    coefficient: sp.Expr
    unknown: sp.Expr
    over: tuple[sp.Symbol, sp.Expr, sp.Expr] | None = None


def terms(condition: Condition, blocks: Sequence[Block]) -> list[Term]:
    """Return the terms of a condition: single unknowns, sums, and the constant.

    Raises
    ------
    ValueError
        If the condition is not linear in the unknowns.
    """
    expression = condition.expression
    if expression.has(sp.Sum):
        expression = sp.expand_mul(expression)
    sum_terms: list[Term] = []
    for part in sorted(expression.atoms(sp.Sum), key=sp.default_sort_key):
        weight = expression.coeff(part)
        (limits,) = part.limits
        pieces = _by_unknown(condition, weight * sp.expand_mul(part.function), blocks)
        sum_terms += [Term(q.coefficient, q.unknown, tuple(limits)) for q in pieces]
        expression = expression - weight * part
    if expression.has(sp.Sum):
        raise ValueError(f"{condition.name}: not linear in its sums")
    return sum_terms + _by_unknown(condition, expression, blocks)


def _by_unknown(
    condition: Condition, expression: sp.Expr, blocks: Sequence[Block]
) -> list[Term]:
    """Return the terms of an expression that has no sums."""
    unknowns = [q for block in blocks for q in _unknowns(expression, block)]
    try:
        coefficients = weights(expression, set(unknowns))
    except ValueError as error:
        raise ValueError(f"{condition.name}: {error} in the unknowns") from None
    rows = [Term(factored(coefficients.get(q, sp.S.Zero)), q) for q in (*unknowns, sp.S.One)]
    return [term for term in rows if term.coefficient != 0]


def factored(expression: sp.Expr) -> sp.Expr:
    """Return an expression as a sum of entries of tables, each with a factored coefficient."""
    entries = expression.atoms(sp.Indexed)
    if entries:
        parts = weights(expression, entries)
        return sp.Add(*(factored(weight) * entry for entry, weight in parts.items()))
    return _factored(expression)


@cache
def _factored(expression: sp.Expr) -> sp.Expr:
    if not expression.has(sp.Add):
        return expression
    rational = not expression.has(sp.Function)
    return sp.factor(expression) if rational else sp.factor_terms(expression)


def _unknowns(expression: sp.Expr, block: Block) -> list[sp.Expr]:
    """Return the unknowns of a block that occur in an expression, in a fixed order."""
    if not isinstance(block.symbol, sp.IndexedBase):
        return [block.symbol] if expression.has(block.symbol) else []
    entries = [q for q in expression.atoms(sp.Indexed) if q.base == block.symbol]
    return sorted(entries, key=lambda q: sp.default_sort_key(q.indices[0]))


def weights(expression: sp.Expr, symbols: Collection[sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    """Return the coefficient of each symbol that occurs, and the constant as that of 1.

    Raises
    ------
    ValueError
        If the expression is not linear in the symbols.
    """
    coefficients: dict[sp.Expr, list[sp.Expr]] = {}
    for part in sp.Add.make_args(expression):
        for symbol, weight in _of_product(part, symbols).items():
            coefficients.setdefault(symbol, []).append(weight)
    return {symbol: sp.Add(*parts) for symbol, parts in coefficients.items()}


def _of_product(part: sp.Expr, symbols: Collection[sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    if part in symbols:
        return {part: sp.S.One}
    if not part.free_symbols.intersection(symbols):
        return {sp.S.One: part}
    if part.is_Mul:
        linear = [q for q in part.args if q.free_symbols.intersection(symbols)]
        if len(linear) == 1:
            factor = sp.Mul(*(q for q in part.args if q is not linear[0]))
            inner = weights(linear[0], symbols)
            return {symbol: factor * weight for symbol, weight in inner.items()}
    elif part.is_Add:
        return weights(part, symbols)
    raise ValueError(f"{part}: not linear")
