"""A condition as linear terms: what is multiplied by which unknown, for each time as well."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import sympy as sp

from ..galerkin import Block, Condition, GalerkinConditions, Table
from ..galerkin.condition import N
from ..galerkin.tables import by_time
from ..galerkin.weights import weights
from ..python_text import python


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
    expression = condition.expression
    if expression.has(sp.Sum):
        expression = sp.expand_mul(expression)
    found: list[Term] = []
    for part in sorted(expression.atoms(sp.Sum), key=sp.default_sort_key):
        weight = expression.coeff(part)
        (limits,) = part.limits
        pieces = _by_unknown(condition, weight * sp.expand_mul(part.function), blocks)
        found += [Term(q.coefficient, q.block, q.index, tuple(limits)) for q in pieces]
        expression = expression - weight * part
    if expression.has(sp.Sum):
        raise ValueError(f"{condition.name}: not linear in its sums")
    return found + _by_unknown(condition, expression, blocks)


def _by_unknown(
    condition: Condition, expression: sp.Expr, blocks: Sequence[Block]
) -> list[Term]:
    """Return the terms of an expression that has no sums."""
    pairs = [(block, q) for block in blocks for q in _unknowns(expression, block)]
    try:
        found = weights(expression, {unknown for _, unknown in pairs})
    except ValueError as error:
        raise ValueError(f"{condition.name}: {error} in the unknowns") from None
    rows = []
    for block, unknown in pairs:
        index = unknown.indices[0] if isinstance(unknown, sp.Indexed) else block.first
        rows.append(Term(factored(found[unknown]), block, sp.sympify(index)))
    rows.append(Term(factored(found.get(sp.S.One, sp.S.Zero)), None, sp.S.Zero))
    return [term for term in rows if term.coefficient != 0]


def factored(expression: sp.Expr) -> sp.Expr:
    """Return an expression by the entries of tables in it, what multiplies each in factors."""
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
    """Return what stands of a block in an expression, in a fixed order."""
    if not isinstance(block.symbol, sp.IndexedBase):
        return [block.symbol] if expression.has(block.symbol) else []
    there = [q for q in expression.atoms(sp.Indexed) if q.base == block.symbol]
    return sorted(there, key=lambda q: sp.default_sort_key(q.indices[0]))


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

    def assigned(self, wanted: int | Sequence[bool]) -> str:
        """Return the statement that has its values in ``q0, q1, ...``, or those wanted."""
        flags = [True] * wanted if isinstance(wanted, int) else wanted
        names = [f"q{i}" if flag else "_" for i, flag in enumerate(flags)]
        return f"{', '.join(names)} = {self.call}"


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
    texts = [python(value) for value in values]
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
    return [(term, factored(rate)) for term, rate in derivatives if rate != 0]


def known(system: GalerkinConditions) -> list[sp.Expr]:
    """Return what closed forms may take, in the sequence of their arguments."""
    bases: list[sp.Expr] = [table.base for table in system.tables]
    return [N, *system.parameters, *system.times.unknown, *bases]
