"""Print the derived equations as LaTeX: a document, or a fragment of one.

Input: the records.  Output: one string.
"""

import re
from collections.abc import Iterable
from typing import TYPE_CHECKING

import sympy as sp
from sympy.printing.pretty.stringpict import prettyForm

from .drawing import drawn, with_word
from .pieces import Piece, bracket_of, filled, pieces, signed
from .typeset import latex
from .words import words_and_mathematics

if TYPE_CHECKING:
    from ..system import Equation, Section

#: Widest line of mathematics, in characters of the drawing, and of a part not to be cut.
LINE = 70

#: What a sign between two terms, or a bracket, adds to it.
SIGN = 3

PREAMBLE = r"""\documentclass[a4paper]{article}
\usepackage{amsmath}
\usepackage{amssymb}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\title{<title>}
\author{derived by \texttt{nonsmooth} after Kim and Perkins (2003)}
\date{}
\begin{document}
\maketitle
\noindent Equation numbers are those of W.-J.~Kim and N.~C.~Perkins, Harmonic
balance/Galerkin method for non-smooth dynamic systems, \emph{Journal of Sound and
Vibration} 261 (2003) 213--224.  What has no number there has none here.
"""

FRAGMENT = r"""% Needs \usepackage{amsmath,amssymb} in the preamble; long equations may break
% across pages with \allowdisplaybreaks.  Numbers are those of Kim and Perkins (2003),
% set by \tag: they do not disturb the numbers of your own equations.
"""


def latex_piece(piece: Piece) -> list[str]:
    r"""Return a piece as LaTeX, what opens before the term and the term, signs included.

    Brackets that open in one piece and close in another have a fixed size: there a line may
    be broken, and TeX refuses a ``\left`` without its ``\right`` on a line.
    """
    parts = []
    first = piece.first
    for before in piece.opens:
        sign, factor = signed(before, first)
        parts.append(f"{sign} {_opening(factor)}".lstrip())
        first = True
    closing = "".join(rf" \biggr{bracket}" for bracket in piece.closes)
    if piece.times:
        return [rf"\cdot ({latex(piece.term)}){closing}"]
    sign, term = signed(piece.term, first)
    return [*parts, f"{sign} {latex(term)}{closing}".lstrip()]


def _opening(before: sp.Expr) -> str:
    bracket = bracket_of(before)
    opening = rf"\biggl{bracket}" if bracket else ""
    if isinstance(before, sp.Sum):
        index, start, end = map(latex, before.limits[0])
        return rf"\sum_{{{index}={start}}}^{{{end}}} {opening}".rstrip()
    return opening if before == 1 else f"{latex(before)} {opening}"


def _lines(side: sp.Expr, limit: int) -> list[str]:
    """Return one side as lines of LaTeX, as many pieces on each as fit."""
    parts = pieces(side, lambda term: _measured(term).width() + SIGN > limit)
    lines = filled(list(map(width, parts)), limit)
    return [" ".join(" ".join(latex_piece(part)) for part in parts[line]) for line in lines]


def width(piece: Piece) -> int:
    """Return roughly how wide a piece is, in characters of the drawing."""
    before = (_measured(part, sign=isinstance(part, sp.Sum)) for part in piece.opens)
    return sum(SIGN + form.width() for form in (*before, _measured(piece.term)))


def _measured(expression: sp.Expr, sign: bool = False) -> prettyForm:
    """Return a drawing in which words in names are as short as small type makes them."""
    names = {str(name): name for name in expression.atoms(sp.Symbol)}
    shortened = {
        name: sp.Symbol(f"{head}_{word[: len(word) // 2 + 1]}", **name.assumptions0)
        for label, name in names.items()
        for head, word in [with_word(label)]
        if word
    }
    return drawn(expression.xreplace(shortened), sign=sign)


def aligned(equation: "Equation") -> str:
    """Return the mathematics of one equation, a line a side or more."""
    left, *right = equation.sides
    if not right:  # a relation by itself
        return f"\\begin{{aligned}}\n& {latex(left)}\n\\end{{aligned}}"
    head, widest = _measured(left).width(), max(_measured(side).width() for side in right)
    narrow = head <= max(LINE // 4, LINE - widest - SIGN)
    # A wide first side has lines to itself; the others stand beside one that leaves them room.
    rows = [] if narrow else _rows("&", left, LINE)
    limit = LINE - head if narrow else LINE
    rows += [row for side in right for row in _rows("&=", side, limit)]
    if narrow:
        rows[0] = f"{latex(left)} {rows[0]}"
    body = " \\\\\n".join(rows)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


def _rows(begin: str, side: sp.Expr, limit: int) -> list[str]:
    head, *continued = _lines(side, limit)
    return [f"{begin} {head}", *(rf"&\quad {line}" for line in continued)]


def displayed(equation: "Equation") -> str:
    """Return one equation as a displayed environment with its number, without words."""
    tag = rf"\tag{{{equation.number}}}" if equation.number else r"\notag"
    return f"\\begin{{equation}}\n{aligned(equation)}\n{tag}\n\\end{{equation}}\n"


def equation_latex(equation: "Equation") -> str:
    """Return one equation as a displayed environment under its words."""
    return f"\\paragraph{{}}{_prose(equation.words)}\n{displayed(equation)}"


def in_notebook(equations: "Iterable[Equation]") -> str:
    """Return equations under their words as MathJax reads them, and LaTeX, too."""
    return "\n\n".join(f"{_prose(e.words)}\n{displayed(e)}" for e in equations)


#: What stands for the characters that mean something to TeX.
_ESCAPED = {mark: rf"\{mark}" for mark in "_&%#$"} | {"^": r"\textasciicircum{}"}
_SPECIAL = re.compile(r"[_&%#$^]")


def _prose(title: str) -> str:
    """Return a title as text, with the mathematics in it set as such."""
    parts = []
    for words, mathematics in words_and_mathematics(title):
        parts.append(_SPECIAL.sub(lambda match: _ESCAPED[match[0]], words))
        if mathematics:
            parts.append(f"${mathematics}$")
    return "".join(parts)


def _body(shown: "Iterable[Section]") -> str:
    parts = []
    for section in shown:
        parts.append(f"\\section*{{{_prose(section.heading)}}}\n")
        if section.note:
            parts.append(f"{_prose(section.note)}\n")
        parts.extend(map(equation_latex, section.equations))
    return "\n".join(parts)


def document_of(shown: "Iterable[Section]", title: str) -> str:
    """Return a LaTeX document, complete, with these sections under a title."""
    preamble = PREAMBLE.replace("<title>", _prose(title))
    return f"{preamble}\n{_body(shown)}\n\\end{{document}}\n"


def fragment_of(shown: "Iterable[Section]") -> str:
    """Return the same without a preamble."""
    return f"{FRAGMENT}\n{_body(shown)}"
