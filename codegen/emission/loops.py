"""Residual and Jacobian as loops, written from the conditions of a record."""

from collections.abc import Iterator, Sequence

import sympy as sp

from ..galerkin import Condition, GalerkinConditions
from ..galerkin.condition import N
from .orthogonal import with_known
from .terms import ClosedFunction, Term, closed_function, known, rates, terms

Lines = list[str]


def _index_text(index: sp.Expr) -> str:
    return str(sp.expand(index)).replace(" ", "")


class Writer:
    """Writes one condition at a time: its closed forms, and its rows in both loops.

    Parameters
    ----------
    system : GalerkinConditions
    """

    def __init__(self, system: GalerkinConditions) -> None:
        self.system = system
        self.functions: list[ClosedFunction] = []
        self.residual: Lines = []
        self.jacobian: Lines = []
        for condition in system.conditions:
            self._write(with_known(condition, system.tables))

    def _write(self, condition: Condition) -> None:
        found = terms(condition, self.system.blocks)
        groups = sorted({term.over for term in found if term.over is not None}, key=str)
        indices = [] if condition.index is None else [condition.index]
        single = [term for term in found if term.over is None]
        body_R: Lines = []
        body_J: Lines = []
        self._add(condition, "", single, indices, body_R, body_J)
        if body_R:
            body_R[-1] = body_R[-1].replace("+=", "=", 1)
        else:
            body_R = ["R[row] = 0.0"]
        for number, over in enumerate(groups):
            group = [term for term in found if term.over == over]
            tail = f"_sum{number}" if len(groups) > 1 else "_sum"
            inner_R: Lines = []
            inner_J: Lines = []
            self._add(condition, tail, group, [*indices, over[0]], inner_R, inner_J)
            head = f"for {over[0]} in range({over[1]}, {sp.expand(over[2] + 1)}):"
            body_R += [head, *("    " + line for line in inner_R)]
            body_J += [head, *("    " + line for line in inner_J)]
        for target, body in ((self.residual, body_R), (self.jacobian, body_J)):
            target += list(self._rows(condition, [*body, "row += 1"]))

    def _rows(self, condition: Condition, body: Lines) -> Iterator[str]:
        """Yield the lines of a condition, in a loop if it has an index."""
        if condition.index is None:
            yield from body
            return
        last = sp.expand(condition.first + condition.count)
        yield f"for {condition.index} in range({condition.first}, {last}):"
        yield from ("    " + line for line in body)

    def _add(
        self,
        condition: Condition,
        tail: str,
        found: Sequence[Term],
        indices: Sequence[sp.Expr],
        body_R: Lines,
        body_J: Lines,
    ) -> None:
        if not found:
            return
        order = [*indices, *known(self.system)]
        name = condition.name + tail
        what = f"Coefficients: {condition.title}."
        form = closed_function(name, what, [q.coefficient for q in found], order)
        self.functions.append(form)
        values = [f"q{i}" for i in range(len(found))]
        assign = f"{', '.join(values)} = {form.call}"
        body_R += [assign, f"R[row] += {_combined(values, found, condition)}"]
        unknown = [
            (value, term) for value, term in zip(values, found, strict=True) if term.block
        ]
        if unknown:
            names = [
                value if term.block else "_" for value, term in zip(values, found, strict=True)
            ]
            body_J.append(f"{', '.join(names)} = {form.call}")
            body_J += [_put(term, value, condition) for value, term in unknown]
        for time in self.system.times.unknown:
            pairs = rates(found, time, self.system.tables)
            if not pairs:
                continue
            rate = closed_function(
                f"{name}_by_{time}",
                f"Their derivatives by {time}, of those that depend on it.",
                [value for _, value in pairs],
                order,
            )
            self.functions.append(rate)
            names = values[: len(pairs)]
            body_J.append(f"{', '.join(names)} = {rate.call}")
            change = _combined(names, [term for term, _ in pairs], condition)
            body_J.append(f"J[row, at_{time}] += {change}")


def _combined(values: Sequence[str], found: Sequence[Term], condition: Condition) -> str:
    """Return the sum of coefficients times unknowns, as Python."""
    return " + ".join(
        value if term.block is None else f"{value}*{_read(term, condition)}"
        for value, term in zip(values, found, strict=True)
    )


def _inside(term: Term, condition: Condition) -> bool:
    """Whether the index of an unknown is within its block by construction."""
    assert term.block is not None
    if term.over is not None or term.block.count == 1:
        return True
    if term.index.is_Integer:
        return int(term.index) < 2
    last = condition.first + condition.count - 1
    ends = (term.index.subs(condition.index, end) for end in (condition.first, last))
    low, high = (sp.expand(end - term.block.first) for end in ends)
    room = sp.expand(term.block.count - 1 - high)
    return all(q.is_Integer and int(q) >= 0 for q in (low, room))


def _place(term: Term) -> str:
    assert term.block is not None
    name, index = term.block.name, term.index - term.block.first
    return f"at_{name}" if index == 0 else f"at_{name} + {_index_text(index)}"


def _family(term: Term) -> str:
    assert term.block is not None
    name, index = term.block.name, term.index - term.block.first
    return f"at_{name}, number_{name}, {_index_text(index)}"


def _read(term: Term, condition: Condition) -> str:
    inside = _inside(term, condition)
    return f"z[{_place(term)}]" if inside else f"entry(z, {_family(term)})"


def _put(term: Term, value: str, condition: Condition) -> str:
    if _inside(term, condition):
        return f"J[row, {_place(term)}] += {value}"
    return f"put(J, row, {_family(term)}, {value})"


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
