"""The condensed conditions of a record as lines of a kernel."""

from collections.abc import Sequence

import sympy as sp

from ...galerkin import Block, GalerkinConditions
from ..loops import Lines, Row, combined, indented, residual_lines
from ..terms import Term
from .bands import Band, Condensed


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
