"""The equations as a reader is shown them, in every format: reference files."""

from collections.abc import Iterator

from nonsmooth.codegen.shortcuts.document import html_document, latex_document, text_document

METHODS = ("hb", "hb-c1", "c1", "hb-symmetric", "c1-reduced")


def shown() -> Iterator[tuple[str, str]]:
    """Yield the name of a reference file and what the program prints today."""
    for method in METHODS:
        yield f"{method}.txt", text_document([method], None, unicode=True)
        yield f"{method}.ascii.txt", text_document([method], None, unicode=False)
        yield f"{method}.tex", latex_document([method], None)
        yield f"{method}.html", html_document([method], None)
    for method in METHODS[:3]:
        yield f"{method}-expanded.txt", text_document([method], 2, unicode=True)
        yield f"{method}-expanded.tex", latex_document([method], 2)
