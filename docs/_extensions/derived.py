"""The directive ``derived``: the equations of the paper's oscillator by a method."""

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from nonsmooth.codegen import derive


class Derived(SphinxDirective):
    """``derived:: METHOD``: what each equation of the record of the method says, and itself."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return the equations, in the order of the record."""
        shown: list[nodes.Node] = []
        for equation in derive(self.arguments[0]).equations:
            words = equation.words.replace("`", "")
            shown.append(nodes.paragraph("", words))
            latex = equation.latex()
            shown.append(nodes.math_block("", latex, nowrap=True, number=None, label=None))
        return shown


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive."""
    app.add_directive("derived", Derived)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
