"""The words beside an equation: plain in a terminal, with mathematics in LaTeX and HTML.

Input: a title as a record has it.  Output: its words and its mathematics, apart.  What stands
between backquotes is mathematics; the rest is told by its looks.
"""

import re
from collections.abc import Iterator

import sympy as sp

from .drawing import SUPERSCRIPTS, drawn
from .typeset import latex

_MATHEMATICS = re.compile(
    r"""(
      \w+\ <=\ t\ <\ \w+
    | \w\ !=\ \w
    | [jkN]\ =\ [01],\ \.\.\.,\ N
    | i\ =\ 1,\ \.\.\.,\ K
    | l\ =\ (?:2\ m\ \+\ 1|\d,\ \d,\ \.\.\.)
    | (?<=function\ )i\b
    | P_l\(v\)
    | 1/omega_n
    | (?<=in\ )tau
    | n\ -\ j
    | (?<=derivative\ )[mn]\b
    | \b[jkKNtu]\ =\ \d+
    | (?:sin|cos)\(\w+\ omega_0\ t\)
    | g1/\(T\ s\*\*3\)
    | P_\{-\d\}\ =\ -P_\d
    | q\(k,\ l\)
    | \b[A-Za-z]_\w\b(?:\ =\ \d)?
    | \b[abd]\[[mn]\]
    | (?<![-(\w])[a-zCR]\d\b
    | (?<=by\ )[abT]\b
    | (?<=harmonic\ )k\b
    | (?<=and\ )[KT]\b
    | (?<=where\ )j\b
    | (?<=odd\ )n\b
    | \b[eo](?=[,:])
    )""",
    re.VERBOSE,
)

_SIGNS = ((r"<=", r"\\le"), (r"!=", r"\\ne"), (r"\.\.\.", r"\\ldots"), (r"\*\*", "^"))

_TO_LATEX = (
    (r"(omega|mu|tau|sin|cos)", r"\\\1"),
    (r"C1", "C^1"),
    (r"\b([a-zR])(\d)\b", r"\1_\2"),
    (r"\[([mn])\]", r"_\1"),
)


def words_and_mathematics(title: str) -> list[tuple[str, str]]:
    r"""Return pairs of plain words and the LaTeX of the mathematics that follows them.

    Examples
    --------
    >>> words_and_mathematics("residual in stick; 0 <= t < t1 (stick)")
    [('residual in stick; ', '0 \\le t < t_1'), (' (stick)', '')]
    """
    found: list[tuple[str, str]] = []
    for plain, marked in _marked(title):
        words = _MATHEMATICS.split(plain)
        found += zip(words[::2], [*map(_latex, words[1::2]), marked], strict=True)
    return found


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


def _marked(title: str) -> Iterator[tuple[str, str]]:
    """Yield pairs of words and the LaTeX of the marked mathematics that follows them."""
    parts = _MARKED.split(title)
    for words, mathematics in zip(parts[::2], [*parts[1::2], ""], strict=True):
        named = _NAME.sub(lambda name: latex(_symbol(name)), mathematics)
        yield words, _latex_signs(named)


def _latex(mathematics: str) -> str:
    mathematics = _latex_signs(mathematics)
    for pattern, replacement in _TO_LATEX:
        mathematics = re.sub(pattern, replacement, mathematics)
    return mathematics


def _latex_signs(mathematics: str) -> str:
    for pattern, replacement in _SIGNS:
        mathematics = re.sub(pattern, replacement, mathematics)
    return mathematics
