"""What the program prints of all methods, in each format: printed once in a process."""

from functools import cache

from nonsmooth.codegen.shortcuts.document import html_document, latex_fragment, text_document
from reading.expected import methods


@cache
def text_of(order: int | None, unicode: bool = True) -> str:
    """Return the document for a terminal."""
    return text_document(methods(order), order, unicode=unicode)


@cache
def html_of(order: int | None) -> str:
    """Return the page."""
    return html_document(methods(order), order)


@cache
def fragment_of(order: int | None) -> str:
    """Return the LaTeX that another document reads in."""
    return latex_fragment(methods(order), order)
