"""What a document of equations consists of: headings, and the equations under each.

Input: the names of methods and, to write them out, an order.  Output: sections.
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass

from ..shortcuts.methods import of_the_paper as derive
from ..shortcuts.paper import section2
from ..system import Equation, GalerkinSystem
from .written_out import abbreviations, check_order, conditions, unknowns


@dataclass(frozen=True)
class Section:
    """A heading, its equations, and a sentence between the two."""

    heading: str
    equations: tuple[Equation, ...]
    note: str = ""


def sections(methods: Iterable[str], order: int | None = None) -> list[Section]:
    """Return Section 2, and for each method its equations and, where it is shown, its Jacobian.

    With an `order`, return the conditions of each method written out for it.

    Raises
    ------
    ValueError
        If `order` is not a whole number from 1 to 5, or a method is not the paper's.
    """
    if order is not None:
        check_order(order)
        return [_written_out(derive(method), order) for method in methods]
    found = [Section(f"Section 2: {section2.TITLE}", section2.equations())]
    for system in map(derive, methods):
        several = "s" if " and " in system.section else ""
        heading = f"Section{several} {system.section}: {system.title} ({system.method})"
        found.append(Section(heading, system.equations))
        if system.jacobian:
            found.append(Section(f"Jacobian of Section {system.section}", system.jacobian))
    return found


def _written_out(system: GalerkinSystem, order: int) -> Section:
    heading = f"Section {system.section} ({system.method}) written out for N = {order}"
    rows = conditions(system, order)
    names = [re.sub(r"\[(\d+)\]", r"_\1", str(name)) for name in unknowns(system, order)]
    note = f"{len(rows)} equations for {', '.join(names[:-1])} and {names[-1]}."
    return Section(heading, (*rows, *abbreviations(system, order, rows)), note)
