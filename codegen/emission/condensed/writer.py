"""The condensed conditions of a record as lines of a kernel."""

from collections.abc import Sequence

import sympy as sp

from ...galerkin import GalerkinConditions
from ...python_text import python
from ..functions import prologue
from ..loops import Lines, Rate, Row, combined, indented, residual_lines
from ..terms import Term
from .bands import Band, Bands
from .order import Assignment, Order


def _named(unknown: sp.Expr) -> str:
    """Return the statement that gives an unknown its name in a function."""
    return f"{unknown} = z[at_{unknown}]"


class Writer:
    """Writes the condensed conditions of a record.

    Parameters
    ----------
    system : GalerkinConditions
    bands : Bands
    order : Order
    """

    def __init__(self, system: GalerkinConditions, bands: Bands, order: Order) -> None:
        self.system = system
        self.parts = bands
        self.order = order
        self.diagonal = bands.below + bands.above
        self.band_of = {band.block: number for number, band in enumerate(bands.bands)}
        self.places = {unknown: place for place, unknown in enumerate(order.unknowns)}

    def constants(self) -> Lines:
        """Return the constants of the module."""
        times = self.system.times
        durations = sum(time in self.places for time in times.durations)
        forced = len(times.unknown) > len(times.durations) and times.unknown[-1] in self.places
        return [
            f"KEPT = {len(self.places)}  # unknowns that are solved for together",
            f"KEPT_DURATIONS, KEPT_FORCED = {durations}, {forced}  # which of them are times",
            f"BELOW, ABOVE = {self.parts.below}, {self.parts.above}  # diagonals of the bands",
        ]

    def named(self, what: Sequence[Assignment]) -> Lines:
        """Return the lines that give names to what may stand in assignments."""
        new = {each.unknown for each in what}
        lines = [line for line in prologue(self.system) if line not in map(_named, new)]
        single = (block.symbol for block in self.system.blocks if block.count == 1)
        return [*lines, *(_named(q) for q in single if q not in new)]

    def assigned(self, what: Sequence[Assignment]) -> Lines:
        """Return the lines of assignments."""
        lines = [f"{each.unknown} = {python(self._read(each.value))}" for each in what]
        return [*lines, *(f"z[at_{each.unknown}] = {each.unknown}" for each in what)]

    def _read(self, value: sp.Expr) -> sp.Expr:
        """Return an expression in which unknowns of the bands stand as they are read."""
        families = [block.symbol for block in self.band_of]
        indexed = [q for q in value.atoms(sp.Indexed) if q.base in families]
        return value.xreplace({q: sp.Symbol(f"z[{self._place(q)}]") for q in indexed})

    def kept_places(self) -> Lines:
        """Return the statement with the places in z of what is solved for together."""
        places = ", ".join(self._place(unknown) for unknown in self.order.unknowns)
        return [f"return {places}" if len(self.places) > 1 else f"return ({places},)"]

    def _place(self, unknown: sp.Expr) -> str:
        if not isinstance(unknown, sp.Indexed):
            return f"at_{unknown}"
        (block,) = (q for q in self.band_of if q.symbol == unknown.base)
        index = sp.expand(unknown.indices[0] - block.first)
        return f"at_{block.name}" if index == 0 else f"at_{block.name} + {index}"

    def band_places(self) -> Lines:
        """Return the statement that says of each band where it stands, and its sizes."""
        rows = (
            f"(at_{band.block.name}, {band.size}, {self._first(band)}, {band.left}, "
            f"{self._reach(band)})"
            for band in self.parts.bands
        )
        return [f"return ({', '.join(rows)},)"]

    def _first(self, band: Band) -> int:
        """Return the place of the first unknown of a band that it does not determine, or 0."""
        return self.places[band.others[0]] if band.left else 0

    def _reach(self, band: Band) -> sp.Expr:
        """Return how many of the lowest unknowns of a band the joints see."""
        terms = [
            q
            for row in self.order.rows
            for part in row.parts
            for q in part.found
            if q.block == band.block
        ]
        if any(q.over is not None or not q.index.is_Integer for q in terms):
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
                wanted = [self._is_kept(q) for q in part.found]
                body = [part.form.assigned(wanted)] if any(wanted) else []
                for i, term in enumerate(part.found):
                    if wanted[i]:
                        assert term.block is not None
                        place = self.places[term.block.symbol]
                        body.append(f"slopes[{number}, row, {place}] = -q{i}")
                for time, rate, changing in self._kept(part.rates):
                    body.append(rate.assigned(len(changing)))
                    change = self._change(number, row, changing)
                    body.append(f"slopes[{number}, row, {self.places[time]}] = -({change})")
                lines += row.loop(body)
        return lines

    def _is_kept(self, term: Term) -> bool:
        """Whether a term has one of the single unknowns that are solved for together."""
        return term.block is not None and term.block.symbol in self.places

    def _kept(self, rates: Sequence[Rate]) -> list[Rate]:
        """Return the derivatives by those times that are solved for together."""
        return [rate for rate in rates if rate[0] in self.places]

    def _change(self, number: int, row: Row, found: Sequence[Term]) -> str:
        """Return the sum of coefficients times unknowns, those of the band from `found`."""
        band = self.parts.bands[number]
        texts = []
        for i, term in enumerate(found):
            if term.block == band.block:
                offset = band.offset(term, row)
                place = (
                    "row" if offset == 0 else f"row {'-' if offset < 0 else '+'} {abs(offset)}"
                )
                texts.append(f"q{i}*found[{number}, {place}]")
            else:
                texts.append(combined([term], row.condition).replace("q0", f"q{i}", 1))
        return " + ".join(texts)

    def joints(self) -> Lines:
        """Return the lines that fill R with what remains."""
        return residual_lines(self.order.rows)

    def joint_rates(self) -> Lines:
        """Return the lines that fill J with its derivatives."""
        lines: Lines = ["J[:] = 0.0"]
        for row in self.order.rows:
            body: Lines = []
            for part in row.parts:
                inner: Lines = []
                wanted = [self._is_kept(q) or q.block in self.band_of for q in part.found]
                if any(wanted):
                    inner.append(part.form.assigned(wanted))
                    for i, term in enumerate(part.found):
                        if wanted[i]:
                            inner += self._put(term, f"q{i}")
                for time, rate, changing in self._kept(part.rates):
                    inner.append(rate.assigned(len(changing)))
                    change = combined(changing, row.condition)
                    inner.append(f"J[row, {self.places[time]}] += {change}")
                body += indented(part.sum, inner)
            lines += row.loop(body)
        return lines

    def _put(self, term: Term, value: str) -> Lines:
        """Return the lines that add what one term adds."""
        assert term.block is not None
        if term.block not in self.band_of:
            return [f"J[row, {self.places[term.block.symbol]}] += {value}"]
        number = self.band_of[term.block]
        band = self.parts.bands[number]
        index = sp.expand(term.index - term.block.first)
        inside = (
            f"follow(J, row, slopes, {number}, {sp.expand(index + self.diagonal)}, {value})"
        )
        if index.is_Integer or not band.left:
            return [inside]
        size, place = band.size, self._first(band)
        return [
            f"if {index} < {size}:",
            f"    {inside}",
            "else:",
            f"    J[row, {sp.expand(index - size + place)}] += {value}",
        ]
