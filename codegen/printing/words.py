"""The words beside an equation: plain in a terminal, with mathematics in LaTeX and HTML.

Input: a title as a record has it.  Output: its words and its mathematics, apart.  What stands
between backquotes is mathematics.
"""

import re

import sympy as sp

from .drawing import SUPERSCRIPTS, drawn
from .typeset import latex

_SIGNS = {"<=": r"\le", "!=": r"\ne", "...": r"\ldots", "**": "^"}


def words_and_mathematics(title: str) -> list[tuple[str, str]]:
    r"""Return pairs of plain words and the LaTeX of the mathematics that follows them.

    Examples
    --------
    >>> words_and_mathematics("residual in stick; `0 <= t < t1` (stick)")
    [('residual in stick; ', '0 \\le t < t_{1}'), (' (stick)', '')]
    """
    parts = _MARKED.split(title)
    return [
        (words, _latex(mathematics))
        for words, mathematics in zip(parts[::2], [*parts[1::2], ""], strict=True)
    ]


def spoken(title: str, unicode: bool) -> str:
    """Return a title for a terminal: what is marked as mathematics by the signs of a drawing.

    The blanks in it are such that no line is broken there.

    Examples
    --------
    >>> spoken("acceleration `d_slip[n]`, `n = 0`", unicode=False).replace(KEPT, " ")
    'acceleration d_slip[n], n = 0'
    """
    parts = _MARKED.split(title)
    for place in range(1, len(parts), 2):
        parts[place] = parts[place].replace(" ", KEPT)
        if not unicode:
            continue
        named = _NAME.sub(lambda name: str(drawn(_symbol(name))), parts[place])
        parts[place] = _POWER.sub(lambda power: power[1].translate(SUPERSCRIPTS), named)
    return "".join(parts)


#: A blank at which no line is broken.
KEPT = "\N{NO-BREAK SPACE}"

_MARKED = re.compile(r"`([^`]*)`")

#: A name, with an index or without.
_NAME = re.compile(r"[A-Za-z]\w*(?:\[(\w+)\])?")

#: A digit that is set high, as in ``C^1``.
_POWER = re.compile(r"\^(\d)")


def _symbol(name: re.Match[str]) -> sp.Expr:
    label = name[0].partition("[")[0]
    return sp.IndexedBase(label)[sp.Symbol(name[1])] if name[1] else sp.Symbol(label)


def _latex(mathematics: str) -> str:
    named = _NAME.sub(lambda name: latex(_symbol(name)), mathematics)
    for sign, command in _SIGNS.items():
        named = named.replace(sign, command)
    return named
