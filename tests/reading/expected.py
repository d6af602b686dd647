"""What a document has to show: headings and equations, from the records themselves."""

from collections.abc import Iterator
from functools import cache

from nonsmooth.codegen import METHODS, SOLVED, derive
from nonsmooth.codegen.shortcuts.paper import section2
from nonsmooth.codegen.shortcuts.written_out import abbreviations, conditions
from nonsmooth.codegen.system import Equation

#: The records that are shown for any order; those of the paper are written out for one, too.
RECORDS = (*METHODS, *SOLVED)


def methods(order: int | None) -> tuple[str, ...]:
    """Return the methods that can be shown."""
    return RECORDS if order is None else tuple(METHODS)


@cache
def rows(order: int | None) -> tuple[tuple[str, Equation], ...]:
    """Return the heading and the equation of each row, in the order of the document."""
    return tuple(_any_order() if order is None else _one_order(order))


def _any_order() -> Iterator[tuple[str, Equation]]:
    for equation in section2.equations():
        yield "Section 2: The oscillator", equation
    for method in RECORDS:
        record = derive(method)
        name = (
            "Sections 3.1 and 3.2" if method == "hb-symmetric" else f"Section {record.section}"
        )
        for equation in record.equations:
            yield f"{name}: {record.title} ({method})", equation
        for equation in record.jacobian:
            yield f"Jacobian of {name}", equation


def _one_order(order: int) -> Iterator[tuple[str, Equation]]:
    for method in METHODS:
        record = derive(method)
        solved = conditions(record, order)
        for equation in (*solved, *abbreviations(record, order, solved)):
            yield f"Section {record.section} ({method}) written out for N = {order}", equation


def notes(order: int) -> Iterator[str]:
    """Yield the sentence below each heading of one order."""
    for method in METHODS:
        *names, last = map(str, derive(method).unknown_symbols(order))
        yield f"{len(names) + 1} equations for {', '.join(names)} and {last}."
