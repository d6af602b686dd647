"""The directive ``derived``: the equations of a method, beside the code generated from them."""

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from nonsmooth.codegen import Equation, derive, side_by_side


def heading(equation: Equation) -> str:
    """Return what stands above an equation: its number in the paper and its title."""
    number = f"({equation.number}) " if equation.number else ""
    return f"{number}{equation.title}"


class Derived(SphinxDirective):
    """``derived:: METHOD``: a row for each equation of the record of the method."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return the rows, in the order of the record."""
        method = self.arguments[0]
        sources = {id(row.equation): row.source for row in side_by_side(method)}
        shown: dict[str, str] = {}
        rows: list[nodes.Node] = []
        for equation in derive(method).equations:
            title = heading(equation)
            row = nodes.container(classes=["side-by-side"])
            left, right = nodes.container(), nodes.container()
            left += nodes.paragraph("", "", nodes.strong("", equation.title))
            if equation.where:
                left += nodes.paragraph("", equation.where)
            left += nodes.math_block("", equation.latex(), nowrap=True, number=None, label=None)
            source = sources.get(id(equation))
            if source in shown:
                right += nodes.paragraph("", f"The code of “{shown[source]}”.")
            elif source is not None:
                shown[source] = title
                right += nodes.literal_block(source, source, language="python")
            row += [left, right]
            rows.append(row)
        return rows


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive."""
    app.add_directive("derived", Derived)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
