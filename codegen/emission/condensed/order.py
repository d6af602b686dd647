"""Which of the conditions that join the phases give an unknown by themselves.

A condition that sees one unknown, and is linear in it, gives that before anything else is
known: an event that says in which state the next phase begins.  An unknown that one condition
alone sees, and linearly, follows once everything else is known.  What is left in between has to
be solved together, by Newton's method.  (The block triangular form of a sparse system, of which
the blocks of size one at both ends are split off.)

Either way an unknown whose coefficient vanishes is one for which the whole system is singular:
nothing is lost.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy as sp

from ...galerkin import GalerkinConditions
from ...galerkin.tables import by_time
from ..loops import Row
from ..terms import factored
from .bands import Band


@dataclass(frozen=True)
class Assignment:
    """An unknown, what it is by those that are given before, and the row that says so."""

    unknown: sp.Expr
    value: sp.Expr
    row: Row


@dataclass(frozen=True)
class Order:
    """What is assigned before Newton's method, what it solves, and what is assigned after.

    Parameters
    ----------
    before, after : tuple of Assignment
        In their sequence.
    rows : tuple of Row
        Of what is solved together.
    unknowns : tuple of Expr
        Those, as many, in their sequence.
    """

    before: tuple[Assignment, ...]
    rows: tuple[Row, ...]
    unknowns: tuple[sp.Expr, ...]
    after: tuple[Assignment, ...]


def remaining(system: GalerkinConditions, bands: Sequence[Band]) -> tuple[sp.Expr, ...]:
    """Return the unknowns that no band determines, in their sequence."""
    by_block = {band.block: band for band in bands}
    found: list[sp.Expr] = []
    for block in system.blocks:
        band = by_block.get(block)
        found += [block.symbol] if band is None else band.others
    return (*found, *system.times.unknown)


def order(system: GalerkinConditions, bands: Sequence[Band], joints: Sequence[Row]) -> Order:
    """Return the order in which joints and unknowns are solved; at least one is left."""
    sight = _Sight(system, bands)
    rows, unknowns = list(joints), list(remaining(system, bands))
    before: list[Assignment] = []
    after: list[Assignment] = []
    while len(rows) > 1 and (found := _first(rows, unknowns, sight)) is not None:
        before.append(found)
        rows.remove(found.row)
        unknowns.remove(found.unknown)
    while len(rows) > 1 and (found := _last(rows, unknowns, sight)) is not None:
        after.insert(0, found)
        rows.remove(found.row)
        unknowns.remove(found.unknown)
    return Order(tuple(before), tuple(rows), tuple(unknowns), _put_in(after))


def _put_in(assigned: Sequence[Assignment]) -> tuple[Assignment, ...]:
    """Return assignments with the values of those before put in: what cancels is not formed."""
    found: dict[sp.Expr, sp.Expr] = {}
    for each in assigned:
        value = sp.expand_mul(each.value.subs(found, simultaneous=True))
        found[each.unknown] = factored(value)
    return tuple(replace(each, value=found[each.unknown]) for each in assigned)


class _Sight:
    """Which of the unknowns that remain a condition sees, itself and through the bands."""

    def __init__(self, system: GalerkinConditions, bands: Sequence[Band]) -> None:
        self.system = system
        self.band_of = {band.block: band for band in bands}

    def itself(self, row: Row) -> set[sp.Expr]:
        """Return the single unknowns and the times that stand in a row."""
        blocks = (term.block for part in row.parts for term in part.found)
        single = {block.symbol for block in blocks if block is not None and block.count == 1}
        return single | {time for part in row.parts for time, _, _ in part.rates}

    def through(self, row: Row) -> set[sp.Expr]:
        """Return what the bands depend on whose unknowns stand in a row."""
        families = {term.block for part in row.parts for term in part.found}
        found: set[sp.Expr] = set()
        for band in (self.band_of[q] for q in families if q in self.band_of):
            found |= set(band.others)
            for inner in band.rows:
                found |= self.itself(inner)
        return found


def _first(
    rows: Sequence[Row], unknowns: Sequence[sp.Expr], sight: _Sight
) -> Assignment | None:
    """Return what a row gives that sees one of `unknowns` alone."""
    for row in rows:
        seen = sight.itself(row).intersection(unknowns)
        if len(seen) == 1 and not sight.through(row):
            (unknown,) = seen
            found = _solved(sight.system, row, unknown)
            if found is not None:
                return found
    return None


def _last(rows: Sequence[Row], unknowns: Sequence[sp.Expr], sight: _Sight) -> Assignment | None:
    """Return what the only row gives that sees one of `unknowns`."""
    for unknown in unknowns:
        seeing = [row for row in rows if unknown in sight.itself(row) | sight.through(row)]
        if len(seeing) == 1 and unknown not in sight.through(seeing[0]):
            found = _solved(sight.system, seeing[0], unknown)
            if found is not None:
                return found
    return None


def _solved(system: GalerkinConditions, row: Row, unknown: sp.Expr) -> Assignment | None:
    """Return what a row says of an unknown; None if it has sums, or is not linear in it.

    None as well if parameters for which it says nothing are allowed: there it cannot be
    divided by what multiplies the unknown.
    """
    expression = sp.expand_mul(row.condition.expression)
    if expression.has(sp.Sum):
        return None
    slope = by_time(expression, unknown, system.tables)
    if by_time(slope, unknown, system.tables) != 0:
        return None
    if slope.free_symbols.issubset(system.parameters) and not slope.is_nonzero:
        return None
    rest = sp.expand_mul(expression.subs(unknown, 0))
    return Assignment(unknown, factored(-rest / slope), row)
