"""Print the derived equations as a page for a browser: MathML, no script, nothing fetched.

Input: the records.  Output: a document, or a fragment of one and the style it needs.
"""

import re
from collections import Counter
from collections.abc import Iterable
from html import escape
from typing import TYPE_CHECKING

import sympy as sp
from latex2mathml.converter import convert

from .drawing import drawn
from .latex import latex_piece, width
from .pieces import pieces
from .words import words_and_mathematics

if TYPE_CHECKING:
    from ..system import Equation, Section

#: A term that is wider, in characters of the drawing, is cut at its brackets: for a phone.
WIDEST = 30

#: A function behind a factor, where TeX puts a space of its own and MathML none.
_AFTER_A_FACTOR = re.compile(r"(?<=[\w})]) (\\(?:sin|cos)\b)")

STYLE = """\
.equation { margin: 1.2em 0; display: grid; grid-template-columns: minmax(0, 1fr) auto;
  column-gap: 0.5em; align-items: center; }
.equation figcaption { grid-column: 1 / -1; }
.equation .sides { overflow-x: auto; padding-left: 0.5em; }
.equation .side { padding-left: 2em; text-indent: -1em; }
.equation .side:first-child { text-indent: -2em; }
.equation math { padding: 0.25em 0; text-indent: 0; }
math { font-family: "Latin Modern Math", "STIX Two Math", "Cambria Math",
  "DejaVu Math TeX Gyre", math; } /* in these brackets and sums grow */
.equation mtd[columnalign="left"] { text-align: left; }
details > summary { cursor: pointer; margin: 1em 0; }
.equation .number { text-decoration: none; color: inherit; }
"""

PAGE = """\
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
:root {{ color-scheme: light dark; }}
body {{ font: 1rem/1.5 system-ui, sans-serif; max-width: 56rem; margin: 0 auto;
  padding: 1rem; }}
h1, h2 {{ line-height: 1.25; }}
:target {{ outline: 2px solid; outline-offset: 0.4em; }}
{style}</style>
</head>
<body>
<h1>{title}</h1>
<p>Equation numbers are those of W.-J. Kim and N. C. Perkins, Harmonic balance/Galerkin
method for non-smooth dynamic systems, <cite>Journal of Sound and Vibration</cite> 261 (2003)
213–224. What has no number there has none here.</p>
{body}</body>
</html>
"""


def mathml(mathematics: str) -> str:
    """Return LaTeX mathematics as MathML, fractions and sums in their full size."""
    spaced = _AFTER_A_FACTOR.sub(r" \\,\1", mathematics)
    block = str(convert(spaced, display="block"))
    return block.replace('display="block"', 'displaystyle="true"', 1)


def _prose(title: str) -> str:
    """Return a title as text, with the mathematics in it as MathML."""
    return "".join(
        escape(words) + (convert(mathematics) if mathematics else "")
        for words, mathematics in words_and_mathematics(title)
    )


def _sides(equation: "Equation") -> str:
    """Return the sides, a block each, in pieces between which the browser may wrap."""
    left, *right = map(_in_pieces, equation.sides)
    for side in right:
        side[0] = f"{{}} = {side[0]}"
    lines = [left + right[0], *right[1:]] if right else [left]
    blocks = ("<wbr>\n".join(map(mathml, line)) for line in lines)
    return "\n".join(f'<div class="side">{block}</div>' for block in blocks)


def _in_pieces(side: sp.Expr) -> list[str]:
    """Return one side as pieces; an empty group makes a sign one between two operands."""
    parts: list[str] = []
    for piece in pieces(side, lambda term: drawn(term).width() > WIDEST):
        texts = latex_piece(piece)
        if width(piece) <= WIDEST:
            texts = [" ".join(texts)]
        parts.extend(f"{{}} {text}" for text in texts)
    return [parts[0].removeprefix("{} "), *parts[1:]]


def _equation(equation: "Equation", anchor: str) -> str:
    number = f'<a class="number" href="#{anchor}">({equation.number})</a>\n' if anchor else ""
    place = f' id="{anchor}"' if anchor else ""
    return (
        f'<figure class="equation"{place}>\n'
        f"<figcaption>{_prose(equation.words)}</figcaption>\n"
        f'<div class="sides">\n{_sides(equation)}\n</div>\n'
        f"{number}</figure>\n"
    )


def _section(section: "Section", counts: Counter[str]) -> str:
    """Return a section; a number that was seen before gets an anchor of its own."""
    parts = [f"<h2>{_prose(section.heading)}</h2>\n"]
    if section.note:
        parts.append(f"<p>{_prose(section.note)}</p>\n")
    for equation in section.equations:
        anchor = f"eq-{equation.number}" if equation.number else ""
        counts[anchor] += 1
        again = f"-{counts[anchor]}" if anchor and counts[anchor] > 1 else ""
        parts.append(_equation(equation, anchor + again))
    return "".join(parts)


def fragment_of(shown: "Iterable[Section]") -> str:
    """Return sections as a fragment of a page."""
    counts: Counter[str] = Counter()
    return "\n".join(_section(section, counts) for section in shown)


def page_of(shown: "Iterable[Section]", title: str) -> str:
    """Return a page, complete, with these sections under a title."""
    return PAGE.format(title=escape(title), style=STYLE, body=fragment_of(shown))
