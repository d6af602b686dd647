"""Conditions as sums of unknowns, each with its factor, with like terms collected."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

import sympy as sp

from ..galerkin import Block, Condition
from ..galerkin.terms import terms

#: Transforms the factor of an unknown before it is printed.
Spelling = Callable[[sp.Expr], sp.Expr]

#: Kronecker delta of the indices of a sum and of the condition; its part leaves the sum.
SAME = sp.Symbol("same")


def by_unknown(
    condition: Condition,
    blocks: Sequence[Block],
    parameters: Iterable[sp.Symbol],
    spelling: Spelling,
) -> sp.Expr:
    """Return a condition as a sum of unknowns, each times its factor, and a constant.

    Parameters
    ----------
    condition : Condition
    blocks : sequence of Block
        The unknowns.
    parameters : iterable of Symbol
        The parameters of the scene, which are collected in the factors.
    spelling : callable
        Applied to each factor before that.
    """
    symbols = frozenset(parameters)
    plain: list[sp.Expr] = []
    sums: dict[tuple[sp.Expr, ...], list[sp.Expr]] = {}
    for term in terms(condition, blocks):
        factor = spelling(term.coefficient)
        if term.over is None:
            plain.append(neat(factor, symbols, term.unknown))
            continue
        factor = sp.expand(factor)
        alone = {} if condition.index is None else {term.over[0]: condition.index}
        single = factor.coeff(SAME).subs(alone)
        if single != 0:
            plain.append(neat(single, symbols, term.unknown.subs(alone)))
        summand = neat(factor.coeff(SAME, 0), symbols, term.unknown)
        sums.setdefault(term.over, []).append(summand)
    summands = {over: sp.Add(*parts) for over, parts in sums.items()}
    parts = (sp.Sum(total, over) for over, total in summands.items() if total != 0)
    return sp.Add(*plain, *parts)


def neat(
    expression: sp.Expr, parameters: frozenset[sp.Symbol], unknown: sp.Expr = sp.S.One
) -> sp.Expr:
    """Return a sum with like terms collected, times an unknown.

    First, terms that differ only in numbers and indices are added; then those that differ only
    in parameters.
    """
    numbers: dict[tuple[sp.Expr, sp.Expr], sp.Expr] = {}
    for term in sp.Add.make_args(sp.expand(expression)):
        split: tuple[list[sp.Expr], ...] = ([], [], [])
        for factor in sp.Mul.make_args(term):
            split[_kind(factor, parameters)].append(factor)
        number, quantity, other = (sp.Mul(*factors) for factors in split)
        key = quantity, other
        numbers[key] = numbers.get(key, sp.Integer(0)) + number
    like: dict[tuple[sp.Expr, sp.Expr], sp.Expr] = {}
    for (quantity, other), number in numbers.items():
        sign, magnitude = _signed(sp.factor(number))
        like[magnitude, other] = like.get((magnitude, other), sp.Integer(0)) + sign * quantity
    return _multiplied(unknown, _entries_together(like))


#: Four factors: numbers and indices; times and functions; parameters; entries of tables.
Product = tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]


def _entries_together(like: Mapping[tuple[sp.Expr, sp.Expr], sp.Expr]) -> list[Product]:
    """Return products in which entries of tables with the same factor are added."""
    collected: dict[tuple[sp.Expr, sp.Expr, sp.Expr], sp.Expr] = {}
    for (magnitude, other), quantity in like.items():
        parts = sp.Mul.make_args(other)
        entry = sp.Mul(*(part for part in parts if isinstance(part, sp.Indexed)))
        alone = sp.Mul(*(part for part in parts if not isinstance(part, sp.Indexed)))
        sign, plain = _signed(sp.factor_terms(quantity)) if entry != 1 else (1, quantity)
        key = magnitude, alone, plain
        collected[key] = collected.get(key, sp.Integer(0)) + sign * entry
    return [(*key, entries) for key, entries in collected.items()]


def _multiplied(unknown: sp.Expr, products: Sequence[Product]) -> sp.Expr:
    """Return an unknown times a sum of products, with a common factor if that is shorter."""
    if len(products) == 1:
        magnitude, other, quantity, entries = products[0]
        return positive(sp.Mul(unknown, magnitude, other, _factored(quantity), entries))
    parts = (
        positive(sp.Mul(magnitude, other, _factored(quantity), entries))
        for magnitude, other, quantity, entries in products
    )
    total = sp.Add(*parts)
    factored = sp.factor_terms(total)
    if _divided(factored) and any(map(_divided, _brackets(factored))):
        factored = sp.together(total)  # no fraction within a fraction
    shorter = len(str(factored)) <= len(str(total)) or _divided(factored)
    return positive(sp.Mul(unknown, *sp.Mul.make_args(factored if shorter else total)))


def _brackets(product: sp.Expr) -> Iterator[sp.Expr]:
    """Yield the terms in the brackets of a product."""
    for factor in sp.Mul.make_args(product):
        if factor.is_Add:
            yield from factor.args


def _divided(product: sp.Expr) -> bool:
    """Return whether a product has a denominator with symbols."""
    below = (q for q in sp.Mul.make_args(product) if q.is_Pow and q.exp.is_negative)
    return any(q.free_symbols for q in below)


def _kind(factor: sp.Expr, parameters: frozenset[sp.Symbol]) -> int:
    """Return 0 for numbers and indices, 1 for parameters, 2 for times, tables and functions."""
    if factor.atoms(sp.Indexed, sp.Function):
        return 2
    free = factor.free_symbols
    if free <= parameters and free:
        return 1
    return 0 if all(symbol.is_integer for symbol in free) and not factor.has(sp.pi) else 2


def _signed(number: sp.Expr) -> tuple[int, sp.Expr]:
    """Return the sign of an expression, and the expression without it."""
    return (-1, -number) if number.could_extract_minus_sign() else (1, number)


def _factored(quantity: sp.Expr) -> sp.Expr:
    return positive(sp.factor_terms(quantity))


def positive(product: sp.Expr) -> sp.Expr:
    """Return a product with as few minus signs in its brackets as possible.

    Examples
    --------
    >>> a, b, c = sp.symbols("a b c")
    >>> positive(-a * (b - c)), positive(2 * a * (-b - c))
    (a*(-b + c), -2*a*(b + c))
    """
    sign, factors = 1, list(sp.Mul.make_args(product))
    for place, factor in enumerate(factors):
        if factor.is_Add and _negative(factor) == 1:
            sign, factors[place] = -sign, _turned(factor)
    if sign * sp.Mul(*factors).as_coeff_Mul()[0] < 0:
        for place, factor in enumerate(factors):
            if factor.is_Add and 2 * _negative(factor) >= 1 and not _of_indices(factor):
                sign, factors[place] = -sign, _turned(factor)
                break
    return sp.Mul(sign, *factors) if len(factors) > 1 else product


def _negative(total: sp.Add) -> sp.Rational:
    """Return the fraction of the terms of a sum that have a minus sign."""
    count = sum(term.could_extract_minus_sign() for term in total.args)
    return sp.Rational(count, len(total.args))


def _turned(total: sp.Add) -> sp.Add:
    return sp.Add(*(-term for term in total.args))


def _of_indices(total: sp.Add) -> bool:
    return all(symbol.is_integer for symbol in total.free_symbols)


def by_entries(expression: sp.Expr) -> sp.Expr:
    """Return a combination of entries of tables, each with its factor."""
    expanded = sp.expand(expression)
    entries = sorted(expanded.atoms(sp.Indexed), key=sp.default_sort_key)
    return sp.Add(*(entry * sp.factor(expanded.coeff(entry)) for entry in entries))
