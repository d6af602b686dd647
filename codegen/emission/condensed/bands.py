"""Conditions solved phase by phase: bands, and the few equations that join what they leave.

The rows of some conditions are banded in one family of unknowns, the acceleration of a phase,
and see besides only the state in which the phase begins, memory and times.  Where all other
unknowns are given, such a family follows from a band matrix.  What remains are the conditions
that are not banded, in as many unknowns: their number does not depend on the order.

Which conditions are banded is read off their terms.  A band is taken only if its diagonal
outweighs the rest as the index grows; then elimination from the highest index down is stable
where the index is high, and only where it is low are rows exchanged.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from ...galerkin import Block, GalerkinConditions
from ..loops import Row
from ..terms import Term


@dataclass(frozen=True)
class Band:
    """A family of unknowns, and the conditions that determine all of it but the last few.

    Parameters
    ----------
    block : Block
    rows : tuple of Row
        Single ones for the lowest indices, then one with an index.
    """

    block: Block
    rows: tuple[Row, ...]

    @property
    def size(self) -> sp.Expr:
        """How many unknowns are determined, in the order."""
        last = self.rows[-1].condition
        return sp.expand(last.first + last.count)

    @property
    def left(self) -> int:
        """How many of the last are not."""
        return int(sp.expand(self.block.count - self.size))

    @property
    def others(self) -> list[sp.Expr]:
        """The last of the family."""
        first = self.block.first + self.size
        return [self.block.symbol[sp.expand(first + i)] for i in range(self.left)]

    def offset(self, term: Term, row: Row) -> int:
        """Return the diagonal on which a term of the family stands."""
        index = row.condition.index
        number = sp.Integer(self.rows.index(row)) if index is None else index
        return int(sp.expand(term.index - self.block.first - number))

    def offsets(self) -> Iterator[int]:
        """Yield the diagonals of all terms."""
        for row in self.rows:
            for term in row.parts[0].found:
                if term.block == self.block:
                    yield self.offset(term, row)


@dataclass(frozen=True)
class Bands:
    """The bands of a record, in the sequence of its unknowns, and the rows that remain."""

    bands: tuple[Band, ...]
    joints: tuple[Row, ...]

    @property
    def below(self) -> int:
        """How many diagonals there are below the main one, in any band."""
        return -min(q for band in self.bands for q in band.offsets())

    @property
    def above(self) -> int:
        """How many there are above."""
        return max(q for band in self.bands for q in band.offsets())


def bands_of(system: GalerkinConditions, rows: Sequence[Row]) -> Bands | None:
    """Return bands and joints of a record; None if a family has no band."""
    families = [block for block in system.blocks if block.count != 1]
    found = [_band(block, rows) for block in families]
    bands = tuple(band for band in found if band is not None)
    if not families or len(bands) < len(families):
        return None
    banded = [row for band in bands for row in band.rows]
    return Bands(bands, tuple(row for row in rows if row not in banded))


def _band(block: Block, rows: Sequence[Row]) -> Band | None:
    """Return the band of a family, if there is one that can be eliminated."""
    for at, row in enumerate(rows):
        first = row.condition.first
        if row.condition.index is None or not _sees_only(block, row) or not first.is_Integer:
            continue
        lowest = tuple(rows[at - int(first) : at])
        single = all(low.condition.index is None and _sees_only(block, low) for low in lowest)
        band = Band(block, (*lowest, row))
        left = sp.expand(block.count - band.size)
        if single and left.is_Integer and left >= 0 and _outweighs(band):
            return band
    return None


def _sees_only(block: Block, row: Row) -> bool:
    """Whether a row has no sums, and terms of this family, on fixed diagonals, and no other."""
    (part, *more) = row.parts
    families = [term for term in part.found if term.block is not None and term.block.count != 1]
    index = row.condition.index or sp.Integer(0)
    fixed = all((term.index - index).is_Integer for term in families)
    return not more and bool(families) and fixed and {q.block for q in families} == {block}


def _outweighs(band: Band) -> bool:
    """Whether the main diagonal outweighs all others as the index grows."""
    row = band.rows[-1]
    index = row.condition.index
    terms = (q for q in row.parts[0].found if q.block == band.block)
    found = {band.offset(q, row): q.coefficient for q in terms}
    main = found.pop(0, sp.Integer(0))

    def degree(value: sp.Expr) -> int:
        above, below = sp.fraction(sp.together(value))
        return int(sp.degree(above, index) - sp.degree(below, index))

    return main != 0 and all(degree(value) < degree(main) for value in found.values())
