"""The paper's equations as documents: Section 2, then each method.

Input: the names of methods and, to write them out, an order.  Output: sections, or a whole
document of them as text, LaTeX or HTML.
"""

import re
from collections.abc import Iterable

from ..printing import html, latex, text
from ..printing.sections import Section
from ..system import GalerkinSystem
from .methods import of_the_paper as derive
from .paper import section2
from .written_out import abbreviations, check_order, conditions, unknowns


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


TITLE = "Harmonic balance and Galerkin equations of the stick-slip oscillator"


def text_document(
    methods: Iterable[str], order: int | None = None, *, unicode: bool = True
) -> str:
    """Return the equations of `methods` as text for a terminal; see `sections`."""
    return text.text_of(sections(methods, order), unicode)


def latex_document(methods: Iterable[str], order: int | None = None) -> str:
    """Return a LaTeX document, complete, with the equations of `methods`; see `sections`."""
    return latex.document_of(sections(methods, order), TITLE.replace("stick-", "stick--"))


def latex_fragment(methods: Iterable[str], order: int | None = None) -> str:
    r"""Return the same without a preamble, for another document to ``\input``."""
    return latex.fragment_of(sections(methods, order))


def html_document(methods: Iterable[str], order: int | None = None) -> str:
    """Return a page, complete, with the equations of `methods`; see `sections`."""
    return html.page_of(sections(methods, order), TITLE)


def equations_html(methods: Iterable[str], order: int | None = None) -> str:
    """Return headings and equations of `methods` as a fragment; see `sections`.

    Its page has `html.STYLE` in a ``style`` element.  Equation (14) has the anchor
    ``eq-14``; the second of the same number, in another phase or method, ``eq-14-2``.
    """
    return html.fragment_of(sections(methods, order))
