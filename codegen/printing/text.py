"""Print the derived equations in a terminal, in 80 columns.

Input: the records.  Output: text, in Unicode or in plain ASCII.
"""

from collections.abc import Iterable, Sequence
from itertools import pairwise
from textwrap import fill
from typing import TYPE_CHECKING

import sympy as sp
from sympy.printing.pretty.stringpict import prettyForm, stringPict

from .drawing import drawn
from .pieces import Piece, bracket_of, filled, pieces, signed
from .words import KEPT, spoken

if TYPE_CHECKING:
    from ..system import Equation, Section

#: Columns for the mathematics, and of the margin left of it.
COLUMNS, MARGIN = 73, 7

#: What a line begins with: a side, and what is left of a long one.
EQUALS, CONTINUED = "= ", "    "

#: The sign between two factors, in Unicode or not.
TIMES = {True: "⋅", False: "*"}

#: Columns that a sign between two terms takes.
SIGN = 3

#: Columns by which a term is made narrower as long as the brackets about it do not fit.
STEP = 8


def _drawn_piece(piece: Piece, unicode: bool) -> prettyForm:
    """Return a piece drawn, with the sign and the brackets about it."""
    parts: list[str | prettyForm] = []
    first = piece.first
    for before in piece.opens:
        sign, factor = signed(before, first)
        parts += _with_sign(sign, first, *_opening(factor, unicode))
        first = True
    if piece.times:
        factor = prettyForm(*drawn(piece.term, unicode).parens())
        return prettyForm(*stringPict.next(TIMES[unicode], factor, piece.closes))
    sign, term = signed(piece.term, first)
    parts += [*_with_sign(sign, first, drawn(term, unicode)), piece.closes]
    return prettyForm(*stringPict.next(*parts))


def _opening(before: sp.Expr, unicode: bool) -> Sequence[str | prettyForm]:
    bracket = bracket_of(before)
    if isinstance(before, sp.Sum):
        return drawn(before, unicode, sign=True), bracket
    return (bracket,) if before == 1 else (drawn(before, unicode), TIMES[unicode] + bracket)


def _with_sign(sign: str, first: bool, *parts: str | prettyForm) -> Sequence[str | prettyForm]:
    """Return `parts` behind `sign`; before a fraction it would pass for a part of the bar."""
    tall = isinstance(parts[0], prettyForm) and parts[0].height() > 1
    return (
        f"{'' if first else ' '}{sign}{' ' if sign and (tall or not first) else ''}",
        *parts,
    )


def _rows(side: sp.Expr, columns: int, unicode: bool) -> list[prettyForm]:
    """Return one side as lines of drawings, as many pieces on each as fit."""
    forms = _forms(side, columns, unicode)
    for limit in range(columns - STEP, columns // 3, -STEP):
        if max(form.width() for form in forms) <= columns:
            break  # with the sign of a sum and the brackets about it, each term fits
        forms = _forms(side, limit, unicode)
    lines = filled([form.width() for form in forms], columns)
    return [prettyForm(*stringPict.next(*forms[line])) for line in lines]


def _forms(side: sp.Expr, limit: int, unicode: bool) -> list[prettyForm]:
    """Return the drawings of the pieces of a side, no term wider than a limit."""
    parts = pieces(side, lambda term: drawn(term, unicode).width() + SIGN > limit)
    return [_drawn_piece(piece, unicode) for piece in parts]


def _stacked(rows: Sequence[prettyForm]) -> list[str]:
    """Return the rows below each other, with a blank line about those that are high."""
    lines = list(rows[0].picture)
    for above, below in pairwise(rows):
        if above.height() > 1 or below.height() > 1:
            lines.append("")
        lines.extend(below.picture)
    return [line.rstrip() for line in lines]


def _prefixed(rows: Sequence[prettyForm], first: str) -> list[prettyForm]:
    """Return the rows, the first behind `first`, the others as its continuation."""
    head, *continued = rows
    return [prettyForm(*head.left(first)), *(prettyForm(*r.left(CONTINUED)) for r in continued)]


def _mathematics(sides: Sequence[sp.Expr], unicode: bool) -> list[str]:
    """Return the lines of a chain of sides: beside each other if they fit, else stacked."""
    if len(sides) == 1:  # a relation by itself
        return _stacked(_rows(sides[0], COLUMNS, unicode))
    head = drawn(sides[0], unicode)
    room = COLUMNS - head.width() - 1 - len(EQUALS)
    beside = [_rows(side, room, unicode) for side in sides[1:]]
    if room > 0 and all(len(rows) == 1 and rows[0].width() <= room for rows in beside):
        margin = " " * (head.width() + 1)
        lines = [prettyForm(*rows[0].left(EQUALS)) for rows in beside]
        lines[:1] = [prettyForm(*stringPict.next(head, " ", lines[0]))]
        return _stacked([lines[0], *(prettyForm(*line.left(margin)) for line in lines[1:])])
    rows: list[prettyForm] = []
    for side in sides:
        wrapped = _rows(side, COLUMNS - len(CONTINUED), unicode)
        rows += _prefixed(wrapped, EQUALS if rows else "")
    return _stacked(rows)


def equation_text(equation: "Equation", unicode: bool = True) -> str:
    """Return one equation as text for a terminal."""
    number = f"({equation.number})" if equation.number else "-"
    lines = _mathematics(equation.sides, unicode)
    indented = (" " * MARGIN + line if line else "" for line in lines)
    words = f"{number:>5}  {spoken(equation.words, unicode)}"
    return "\n".join([_filled(words, " " * MARGIN), *indented])


def _filled(words: str, indent: str = "") -> str:
    """Return words as lines that do not break within mathematics."""
    return fill(words, COLUMNS + MARGIN, subsequent_indent=indent).replace(KEPT, " ")


def text_of(shown: "Iterable[Section]", unicode: bool = True) -> str:
    """Return sections as text for a terminal."""
    parts = []
    for section in shown:
        heading = _filled(spoken(section.heading, unicode))
        parts.append(f"{heading}\n{'=' * max(map(len, heading.splitlines()))}\n")
        if section.note:
            parts.append(_filled(spoken(section.note, unicode)) + "\n")
        parts.extend(f"{equation_text(e, unicode)}\n" for e in section.equations)
    return "\n".join(parts)
