"""The equations as the paper has them: the methods, and a document of them."""

METHODS = ("hb", "hb-c1", "c1")

#: What is solved in place of the first two and of the third.
SOLVED = ("hb-symmetric", "c1-reduced")


def document(
    method: str | None, order: int | None, format_: str, fragment: bool, unicode: bool
) -> str:
    """Return the equations of a method, or of all, as a document.

    Parameters
    ----------
    method, order : str, int, optional
        One of `METHODS` or `SOLVED`; the order for which it is written out.
    format_ : str
        ``"text"``, ``"html"``, or else LaTeX.
    fragment : bool
        Of LaTeX, without a preamble.
    unicode : bool
        Of text, with other characters than ASCII.
    """
    from nonsmooth.codegen.shortcuts import document as documents  # noqa: PLC0415

    names = [method] if method else METHODS
    if format_ == "html":
        return documents.html_document(names, order)
    if format_ == "text":
        return documents.text_document(names, order, unicode=unicode)
    made = documents.latex_fragment if fragment else documents.latex_document
    return made(names, order)
