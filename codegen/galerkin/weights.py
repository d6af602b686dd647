"""What multiplies each of some symbols in an expression that is linear in them."""

from collections.abc import Collection

import sympy as sp


def weights(expression: sp.Expr, symbols: Collection[sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    """Return what multiplies each symbol that is there, and the rest as that of 1.

    A `ValueError` is raised if the expression is not linear in the symbols.
    """
    found: dict[sp.Expr, list[sp.Expr]] = {}
    for part in sp.Add.make_args(expression):
        for symbol, weight in _of_product(part, symbols).items():
            found.setdefault(symbol, []).append(weight)
    return {symbol: sp.Add(*parts) for symbol, parts in found.items()}


def _of_product(part: sp.Expr, symbols: Collection[sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    if part in symbols:
        return {part: sp.S.One}
    if not part.free_symbols.intersection(symbols):
        return {sp.S.One: part}
    if part.is_Mul:
        linear = [q for q in part.args if q.free_symbols.intersection(symbols)]
        if len(linear) == 1:
            rest = sp.Mul(*(q for q in part.args if q is not linear[0]))
            inner = weights(linear[0], symbols)
            return {symbol: rest * weight for symbol, weight in inner.items()}
    elif part.is_Add:
        return weights(part, symbols)
    raise ValueError(f"{part}: not linear")
