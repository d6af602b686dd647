"""Conditions in which integrals that are known in closed form stand in the place of entries.

Where a coefficient of the equation of motion is the same on all phases, harmonics are
orthogonal over the cell: of a sum over all harmonics a single term is left.
"""

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from ..galerkin import Condition, Table


def with_known(condition: Condition, tables: Sequence[Table]) -> Condition:
    """Return a condition without the entries of tables that are known."""
    closed = {}
    known = {table.base: table.known for table in tables if table.known is not None}
    for entry in condition.expression.atoms(sp.Indexed):
        value = known[entry.base](entry.indices[0]) if entry.base in known else None
        if value is not None:
            closed[entry] = value
    if not closed:
        return condition
    sums = condition.expression.atoms(sp.Sum)
    split = {part: _split(part, closed, condition.index) for part in sums}
    return replace(condition, expression=condition.expression.xreplace({**closed, **split}))


def _split(part: sp.Sum, closed: dict[sp.Expr, sp.Expr], index: sp.Symbol | None) -> sp.Expr:
    """Return a sum without what is zero in it, and the one term where indices are equal."""
    ((running, first, last),) = part.limits
    function = sp.expand(part.function.xreplace(closed))
    deltas = {q for q in function.atoms(sp.KroneckerDelta) if q.has(running)}
    if any(delta.free_symbols != {index, running} for delta in deltas):
        raise ValueError(f"{part}: a sum of which more than one term may be left")
    rest = function.xreplace(dict.fromkeys(deltas, sp.Integer(0)))
    equal = sp.expand(function.xreplace(dict.fromkeys(deltas, sp.Integer(1))) - rest)
    single = equal.xreplace({running: index}) if deltas else sp.Integer(0)
    return single + (sp.Sum(rest, (running, first, last)) if rest != 0 else sp.Integer(0))
