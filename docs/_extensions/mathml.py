"""Mathematics as MathML, written when the pages are: a browser shows it without a script.

Sphinx's own way is a script from the network.  docutils translates LaTeX to MathML; what it
does not know is a warning, and so stops the build.
"""

import re

from docutils import nodes
from docutils.utils.math import MathError
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.application import Sphinx
from sphinx.util import logging
from sphinx.writers.html5 import HTML5Translator

logger = logging.getLogger(__name__)

#: A named function before its argument, to which a browser adds no space.
NAMED = re.compile(
    r"(<mi[^>]*>\w{2,}</mi>)\s*<mo>&ApplyFunction;</mo>(\s*<mo[^>]*>\(|\s*<mrow>)?"
)
THIN = '<mspace width="0.1667em"></mspace>'

#: A large bracket.  docutils takes it for one of a pair, which a new line cuts in two.
LARGE = re.compile(r"\\bigg[lr]\s*([\[\]()])")
LARGE_WORD = re.compile(r"<mtext>bigg(.)</mtext>")
LARGE_SIGN = r'<mo minsize="2.047em" maxsize="2.047em" symmetric="true">\1</mo>'

#: What LaTeX needs around an equation, and a page does not.
AROUND = re.compile(r"\\(?:begin|end)\{equation\}|\\notag")

#: Number of an equation, as ``\tag{5}`` gives it.
TAG = re.compile(r"\\tag\{([^}]*)\}")


def spaced(found: re.Match[str]) -> str:
    """Return a named function with the space that TeX gives it: none before a bracket."""
    name, bracket = found.groups()
    return f"{THIN}{name}{bracket or THIN}"


def translated(latex: str, node: nodes.Element, *, as_block: bool) -> str:
    """Return `latex` as MathML; what cannot be translated, as it stands."""
    try:
        mathml = str(tex2mathml(LARGE.sub(r"\\text{bigg\1}", latex), as_block=as_block))
        return LARGE_WORD.sub(LARGE_SIGN, NAMED.sub(spaced, mathml))
    except (MathError, ValueError) as error:
        logger.warning("mathematics: %s: %s", error, latex, location=node)
        return nodes.unescape(latex)


def visit_math(self: HTML5Translator, node: nodes.math) -> None:
    """Write a formula in a line of text."""
    self.body.append(translated(node.astext(), node, as_block=False))
    raise nodes.SkipNode


def visit_displaymath(self: HTML5Translator, node: nodes.math_block) -> None:
    """Write a formula on a line of its own, and its number in the paper beside it."""
    latex = node.astext()
    number = TAG.search(latex)
    self.body.append(self.starttag(node, "div", CLASS="math"))
    self.body.append(
        translated(AROUND.sub("", TAG.sub("", latex)).strip(), node, as_block=True)
    )
    if number:
        self.body.append(f'<span class="number">({number[1]})</span>')
    self.body.append("</div>\n")
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the renderer ``mathml``."""
    app.add_html_math_renderer("mathml", (visit_math, None), (visit_displaymath, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
