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

from ..galerkin import Block, GalerkinConditions
from .loops import Lines, Row, combined, indented, residual_lines
from .terms import Term


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
class Condensed:
    """The bands of a record, in the sequence of its unknowns, and what remains."""

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


def condensed(system: GalerkinConditions, rows: Sequence[Row]) -> Condensed | None:
    """Return bands and joints of a record; None if a family has no band."""
    families = [block for block in system.blocks if block.count != 1]
    found = [_band(block, rows) for block in families]
    bands = tuple(band for band in found if band is not None)
    if not families or len(bands) < len(families):
        return None
    banded = [row for band in bands for row in band.rows]
    return Condensed(bands, tuple(row for row in rows if row not in banded))


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
    found = {band.offset(q, row): q.coefficient for q in row.parts[0].found if q.block}
    main = found.pop(0, sp.Integer(0))

    def degree(value: sp.Expr) -> int:
        above, below = sp.fraction(sp.together(value))
        return int(sp.degree(above, index) - sp.degree(below, index))

    return main != 0 and all(degree(value) < degree(main) for value in found.values())


class Writer:
    """Writes the condensed conditions of a record.

    Parameters
    ----------
    system : GalerkinConditions
    parts : Condensed
    """

    def __init__(self, system: GalerkinConditions, parts: Condensed) -> None:
        self.system = system
        self.parts = parts
        self.diagonal = parts.below + parts.above
        self.band_of = {band.block: number for number, band in enumerate(parts.bands)}
        self.places: dict[object, int] = {}
        at = 0
        for q in (*system.blocks, *system.times.unknown):
            self.places[q] = at
            at += parts.bands[self.band_of[q]].left if q in self.band_of else 1
        self.kept = at

    def constants(self) -> Lines:
        """Return the constants of the module."""
        return [
            f"KEPT = {self.kept}  # unknowns that remain where each band is solved",
            f"BELOW, ABOVE = {self.parts.below}, {self.parts.above}  # diagonals of the bands",
        ]

    def kept_places(self) -> Lines:
        """Return the statement with the places in z of the unknowns that remain."""
        places = []
        for q in (*self.system.blocks, *self.system.times.unknown):
            name = q.name if isinstance(q, Block) else str(q)
            if q in self.band_of:
                band = self.parts.bands[self.band_of[q]]
                places += [f"at_{name} + {sp.expand(band.size + i)}" for i in range(band.left)]
            else:
                places.append(f"at_{name}")
        return [f"return {', '.join(places)}"]

    def band_places(self) -> Lines:
        """Return the statement that says of each band where it stands, and its sizes."""
        rows = (
            f"(at_{band.block.name}, {band.size}, {self.places[band.block]}, {band.left}, "
            f"{self._reach(band)})"
            for band in self.parts.bands
        )
        return [f"return ({', '.join(rows)},)"]

    def _reach(self, band: Band) -> sp.Expr:
        """Return how many of the lowest unknowns of a band the joints see."""
        terms = [
            q
            for row in self.parts.joints
            for part in row.parts
            for q in part.found
            if q.block == band.block
        ]
        if any(q.over is not None for q in terms):
            return band.size
        return max((q.index - band.block.first + 1 for q in terms), default=sp.Integer(0))

    def bands(self) -> Lines:
        """Return the lines that fill the band matrices and their right sides."""
        lines = ["diagonals[:] = 0.0", "right[:] = 0.0"]
        for number, band in enumerate(self.parts.bands):
            lines.append(f"row = {self.diagonal}")
            for row in band.rows:
                found = row.parts[0].found
                body = [row.parts[0].form.assigned(len(found))]
                for i, term in enumerate(found):
                    if term.block == band.block:
                        slot = self.diagonal + band.offset(term, row)
                        body.append(f"diagonals[{number}, row, {slot}] = q{i}")
                rest = combined(found, row.condition, without=band.block)
                if rest:
                    body.append(f"right[{number}, row] = -({rest})")
                lines += row.loop(body)
        return lines

    def band_rates(self) -> Lines:
        """Return the lines that fill `slopes`."""
        lines = ["slopes[:] = 0.0"]
        for number, band in enumerate(self.parts.bands):
            lines.append(f"row = {self.diagonal}")
            for row in band.rows:
                (part,) = row.parts
                wanted = [q.block not in (None, band.block) for q in part.found]
                body = [part.form.assigned(wanted)] if any(wanted) else []
                for i, term in enumerate(part.found):
                    if wanted[i]:
                        body.append(f"slopes[{number}, row, {self.places[term.block]}] = -q{i}")
                for time, rate, changing in part.rates:
                    body.append(rate.assigned(len(changing)))
                    change = self._change(number, row, changing)
                    body.append(f"slopes[{number}, row, {self.places[time]}] = -({change})")
                lines += row.loop(body)
        return lines

    def _change(self, number: int, row: Row, found: Sequence[Term]) -> str:
        """Return the sum of coefficients times unknowns, those of the band from `right`."""
        band = self.parts.bands[number]
        texts = []
        for i, term in enumerate(found):
            if term.block == band.block:
                offset = band.offset(term, row)
                place = (
                    "row" if offset == 0 else f"row {'-' if offset < 0 else '+'} {abs(offset)}"
                )
                texts.append(f"q{i}*right[{number}, {place}]")
            else:
                texts.append(combined([term], row.condition).replace("q0", f"q{i}", 1))
        return " + ".join(texts)

    def joints(self) -> Lines:
        """Return the lines that fill R with what remains."""
        return residual_lines(self.parts.joints)

    def joint_rates(self) -> Lines:
        """Return the lines that fill J with its derivatives."""
        lines: Lines = ["J[:] = 0.0"]
        for row in self.parts.joints:
            body: Lines = []
            for part in row.parts:
                inner: Lines = []
                if any(term.block for term in part.found):
                    wanted = [term.block is not None for term in part.found]
                    inner.append(part.form.assigned(wanted))
                    for i, term in enumerate(part.found):
                        if term.block:
                            inner += self._put(term, f"q{i}")
                for time, rate, changing in part.rates:
                    inner.append(rate.assigned(len(changing)))
                    change = combined(changing, row.condition)
                    inner.append(f"J[row, {self.places[time]}] += {change}")
                body += indented(part.sum, inner)
            lines += row.loop(body)
        return lines

    def _put(self, term: Term, value: str) -> Lines:
        """Return the lines that add what one term adds."""
        assert term.block is not None
        place = self.places[term.block]
        if term.block not in self.band_of:
            return [f"J[row, {place}] += {value}"]
        number = self.band_of[term.block]
        index = sp.expand(term.index - term.block.first)
        inside = (
            f"follow(J, row, slopes, {number}, {sp.expand(index + self.diagonal)}, {value})"
        )
        if term.over is None or not self.parts.bands[number].left:
            return [inside]
        size = self.parts.bands[number].size
        return [
            f"if {index} < {size}:",
            f"    {inside}",
            "else:",
            f"    J[row, {sp.expand(index - size + place)}] += {value}",
        ]
