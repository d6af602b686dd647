"""A condition as linear terms: what is multiplied by which unknown, for each time as well."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from ..galerkin import Block, Condition, GalerkinConditions, Table
from ..galerkin.tables import by_time
from .expressions import python_all


@dataclass(frozen=True)
class Term:
    """One part of a condition: a coefficient times an unknown, or alone.

    Parameters
    ----------
    coefficient : Expr
    block : Block or None
        Of the unknown; None for what stands alone.
    index : Expr
        Of the unknown in its block.
    over : tuple or None
        Index and limits of a sum over the unknowns of the block.
    """

    coefficient: sp.Expr
    block: Block | None
    index: sp.Expr
    over: tuple[sp.Symbol, sp.Expr, sp.Expr] | None = None


def terms(condition: Condition, blocks: Sequence[Block]) -> list[Term]:
    """Return the terms of a condition: single unknowns, sums, and what stands alone.

    Raises
    ------
    ValueError
        If the condition is not linear in the unknowns.
    """
    expression = sp.expand_mul(condition.expression)
    found: list[Term] = []
    for part in sorted(expression.atoms(sp.Sum), key=sp.default_sort_key):
        weight = expression.coeff(part)
        found += _of_sum(part, weight, blocks)
        expression = expression - weight * part
    expression = sp.expand_mul(expression)
    rest = expression
    for block in blocks:
        for unknown in _unknowns(expression, block):
            coefficient = sp.diff(expression, unknown)
            rest = rest.xreplace({unknown: sp.Integer(0)})
            index = unknown.indices[0] if isinstance(unknown, sp.Indexed) else block.first
            found.append(Term(sp.factor_terms(coefficient), block, sp.sympify(index)))
    rest = sp.expand_mul(rest)
    if rest != 0:
        found.append(Term(rest, None, sp.Integer(0)))
    _check_linear(condition, found, blocks)
    return found


def _of_sum(part: sp.Sum, weight: sp.Expr, blocks: Sequence[Block]) -> Iterator[Term]:
    ((index, low, high),) = part.limits
    inside = sp.expand_mul(part.function)
    for block in blocks:
        for unknown in _unknowns(inside, block):
            coefficient = sp.factor_terms(weight * sp.diff(inside, unknown))
            yield Term(coefficient, block, unknown.indices[0], (index, low, high))


def _unknowns(expression: sp.Expr, block: Block) -> list[sp.Expr]:
    """Return what stands of a block in an expression, in a fixed order."""
    if not isinstance(block.symbol, sp.IndexedBase):
        return [block.symbol] if expression.has(block.symbol) else []
    there = [q for q in expression.atoms(sp.Indexed) if q.base == block.symbol]
    return sorted(there, key=lambda q: sp.default_sort_key(q.indices[0]))


def _check_linear(condition: Condition, found: list[Term], blocks: Sequence[Block]) -> None:
    symbols = {block.symbol for block in blocks}
    for term in found:
        bases = {q.base for q in term.coefficient.atoms(sp.Indexed)}
        if (term.coefficient.free_symbols | bases) & symbols:
            raise ValueError(f"{condition.name}: not linear in the unknowns")


@dataclass(frozen=True)
class ClosedFunction:
    """The coefficients of some terms as one function of a kernel."""

    name: str
    arguments: tuple[sp.Expr, ...]
    source: str

    @property
    def call(self) -> str:
        """How it is called, its arguments being there under their names."""
        return f"{self.name}({', '.join(map(str, self.arguments))})"


def closed_function(
    name: str,
    summary: str,
    values: Sequence[sp.Expr],
    order: Sequence[sp.Expr],
) -> ClosedFunction:
    """Return a function that returns `values`; its arguments in the sequence of `order`."""
    there: set[sp.Expr] = set()
    for value in values:
        indexed = value.atoms(sp.Indexed)
        there |= {q.base for q in indexed}
        labels = {q.base.label for q in indexed}
        there |= value.free_symbols - labels - indexed
    arguments = tuple(q for q in order if q in there)
    texts = python_all(values, arguments)
    result = texts[0] if len(texts) == 1 else _tuple(texts)
    signature = ", ".join(map(str, arguments))
    source = f'def {name}({signature}):\n    """{summary}"""\n    return {result}\n'
    return ClosedFunction(name, arguments, source)


def _tuple(texts: Sequence[str]) -> str:
    return "(\n" + "".join(f"        {text},\n" for text in texts) + "    )"


def rates(
    found: Sequence[Term], time: sp.Symbol, tables: Sequence[Table]
) -> list[tuple[Term, sp.Expr]]:
    """Return the terms whose coefficients depend on a time, with their derivatives."""
    derivatives = [(term, by_time(term.coefficient, time, tables)) for term in found]
    return [(term, sp.factor_terms(rate)) for term, rate in derivatives if rate != 0]


def known(system: GalerkinConditions) -> list[sp.Expr]:
    """Return what closed forms may take, in the sequence of their arguments."""
    bases: list[sp.Expr] = [table.base for table in system.tables]
    return [*system.scene.symbols, *system.times.unknown, *bases]
