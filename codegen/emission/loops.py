"""Residual and Jacobian as loops, written from the conditions of a record."""

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from ..galerkin import Block, Condition, GalerkinConditions
from ..galerkin.condition import N
from .orthogonal import with_known
from .terms import ClosedFunction, Term, closed_function, known, rates, terms

Lines = list[str]


def _index_text(index: sp.Expr) -> str:
    return str(sp.expand(index)).replace(" ", "")


#: A time on which some coefficients depend: it, their derivatives by it, the terms.
Rate = tuple[sp.Symbol, ClosedFunction, tuple[Term, ...]]


@dataclass(frozen=True)
class Part:
    """Terms of a condition whose coefficients one closed form has.

    Parameters
    ----------
    found : tuple of Term
        Single terms, or those of one sum.
    form : ClosedFunction
        Their coefficients.
    rates : tuple of Rate
        For each time on which some depend.
    over : tuple or None
        Index and limits of the sum.
    """

    found: tuple[Term, ...]
    form: ClosedFunction
    rates: tuple[Rate, ...]
    over: tuple[sp.Symbol, sp.Expr, sp.Expr] | None = None

    @property
    def sum(self) -> str | None:
        """The head of the loop over a sum."""
        if self.over is None:
            return None
        return f"for {self.over[0]} in range({self.over[1]}, {sp.expand(self.over[2] + 1)}):"


@dataclass(frozen=True)
class Row:
    """A condition, as the parts that are added in its row, or rows."""

    condition: Condition
    parts: tuple[Part, ...]

    def loop(self, body: Sequence[str]) -> Lines:
        """Return the lines of a row: in a loop if the condition has an index."""
        c = self.condition
        return indented(
            f"for {c.index} in range({c.first}, {sp.expand(c.first + c.count)}):"
            if c.index is not None
            else None,
            [*body, "row += 1"],
        )


def indented(head: str | None, body: Sequence[str]) -> Lines:
    """Return lines as the body of a loop, or as they are if there is none."""
    return list(body) if head is None else [head, *("    " + line for line in body)]


def rows_of(system: GalerkinConditions) -> list[Row]:
    """Return the conditions of a record as the rows of a kernel."""
    return [_row(system, with_known(c, system.tables)) for c in system.conditions]


def _row(system: GalerkinConditions, condition: Condition) -> Row:
    found = terms(condition, system.blocks)
    groups = sorted({term.over for term in found if term.over is not None}, key=str)
    indices = [] if condition.index is None else [condition.index]
    parts = [_part(system, condition.name, condition.title, indices, found, None)]
    for number, over in enumerate(groups):
        name = condition.name + (f"_sum{number}" if len(groups) > 1 else "_sum")
        inner = [*indices, over[0]]
        parts.append(_part(system, name, condition.title, inner, found, over))
    return Row(condition, tuple(part for part in parts if part is not None))


def _part(
    system: GalerkinConditions,
    name: str,
    title: str,
    indices: Sequence[sp.Expr],
    everything: Sequence[Term],
    over: tuple[sp.Symbol, sp.Expr, sp.Expr] | None,
) -> Part | None:
    """Return the part of terms that stand in one sum, or in none; None if there are none."""
    found = [term for term in everything if term.over == over]
    if not found:
        return None
    order = [*indices, *known(system)]
    values = [q.coefficient for q in found]
    form = closed_function(name, f"Coefficients: {title}.", values, order)
    by_times = []
    for time in system.times.unknown:
        pairs = rates(found, time, system.tables)
        if pairs:
            what = f"Their derivatives by {time}, of those that depend on it."
            values = [value for _, value in pairs]
            rate = closed_function(f"{name}_by_{time}", what, values, order)
            by_times.append((time, rate, tuple(term for term, _ in pairs)))
    return Part(tuple(found), form, tuple(by_times), over)


def forms(rows: Sequence[Row]) -> list[ClosedFunction]:
    """Return the closed forms of rows, in the sequence of a kernel."""
    parts = [part for row in rows for part in row.parts]
    return [
        form for part in parts for form in (part.form, *(rate for _, rate, _ in part.rates))
    ]


def residual_lines(rows: Sequence[Row]) -> Lines:
    """Return the lines that fill R."""
    lines: Lines = []
    for row in rows:
        single = [part for part in row.parts if part.over is None]
        body = [] if single else ["R[row] = 0.0"]
        for part in row.parts:
            sign = "=" if part.over is None else "+="
            value = combined(part.found, row.condition)
            inner = [part.form.assigned(len(part.found)), f"R[row] {sign} {value}"]
            body += indented(part.sum, inner)
        lines += row.loop(body)
    return lines


def jacobian_lines(rows: Sequence[Row]) -> Lines:
    """Return the lines that add to J, which is zero."""
    lines: Lines = []
    for row in rows:
        body: Lines = []
        for part in row.parts:
            inner: Lines = []
            if any(term.block for term in part.found):
                inner.append(
                    part.form.assigned([term.block is not None for term in part.found])
                )
                for i, term in enumerate(part.found):
                    if term.block:
                        inner += _put(term, f"q{i}", row.condition)
            for time, rate, changing in part.rates:
                inner.append(rate.assigned(len(changing)))
                change = combined(changing, row.condition)
                inner.append(f"J[row, at_{time}] += {change}")
            body += indented(part.sum, inner)
        lines += row.loop(body)
    return lines


def combined(found: Sequence[Term], condition: Condition, without: Block | None = None) -> str:
    """Return the sum of coefficients ``q0, q1, ...`` times unknowns, as Python.

    The terms of the family `without`, if there is one, are left out.
    """
    return " + ".join(
        f"q{i}" if term.block is None else f"q{i}*{_read(term, condition)}"
        for i, term in enumerate(found)
        if without is None or term.block != without
    )


def _within(term: Term, condition: Condition) -> str:
    """Return when the index of an unknown is within its block; empty where it always is.

    Raises
    ------
    ValueError
        If it may be below the block.
    """
    assert term.block is not None
    if term.over is not None or term.block.count == 1:
        return ""
    index = term.index - term.block.first
    below = f"number_{term.block.name} > {_index_text(index)}"
    if index.is_Integer:
        return "" if int(index) < 2 else below
    if condition.index is None:  # near the end of the family, counted from its beginning
        return "" if index.is_nonnegative else f"{_index_text(index)} >= 0"
    last = condition.first + condition.count - 1
    low, high = (index.subs(condition.index, end) for end in (condition.first, last))
    if not sp.expand(low).is_nonnegative:
        raise ValueError(f"{condition.name}: {term.index} may be below those of {term.block}")
    room = sp.expand(term.block.count - 1 - high)
    return "" if room.is_nonnegative else below


def _place(term: Term) -> str:
    assert term.block is not None
    name, index = term.block.name, term.index - term.block.first
    return f"at_{name}" if index == 0 else f"at_{name} + {_index_text(index)}"


def _read(term: Term, condition: Condition) -> str:
    value, within = f"z[{_place(term)}]", _within(term, condition)
    return f"({value} if {within} else 0.0)" if within else value


def _put(term: Term, value: str, condition: Condition) -> Lines:
    line, within = f"J[row, {_place(term)}] += {value}", _within(term, condition)
    return indented(f"if {within}:" if within else None, [line])


def places(system: GalerkinConditions) -> Lines:
    """Return the lines that say where each unknown stands, from `N`."""
    lines, at = [], sp.Integer(0)
    for block in system.blocks:
        lines.append(f"at_{block.name} = {sp.expand(at)}")
        if block.count != 1:
            lines.append(f"number_{block.name} = {sp.expand(block.count)}")
        at = at + block.count
    for time in system.times.unknown:
        lines.append(f"at_{time} = {sp.expand(at)}")
        at = at + 1
    return lines


def start_of(system: GalerkinConditions, name: str) -> sp.Expr:
    """Return where the unknowns of a block begin, in `N`."""
    names = [block.name for block in system.blocks]
    before = system.blocks[: names.index(name)]
    return sp.expand(sum((block.count for block in before), sp.Integer(0)))


def size(system: GalerkinConditions) -> sp.Expr:
    """Return the number of unknowns, in `N`."""
    counts = sum((block.count for block in system.blocks), sp.Integer(0))
    return sp.expand(counts + len(system.times.unknown))


def per_order(system: GalerkinConditions) -> tuple[int, int]:
    """Return how many unknowns each order adds, and how many there are besides."""
    slope, rest = sp.Poly(size(system), N).all_coeffs()
    return int(slope), int(rest)
