"""The words beside an equation: plain in a terminal, with mathematics in LaTeX and HTML.

Input: a title as a record has it.  Output: its words and its mathematics, apart.
"""

import re

_MATHEMATICS = re.compile(
    r"""(
      \|K\ x\|\ <=\ mu_s\ F_N
    | \w+\ <=\ t\ <\ \w+
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

_TO_LATEX = (
    (r"<=", r"\\le"),
    (r"!=", r"\\ne"),
    (r"\.\.\.", r"\\ldots"),
    (r"\*\*", "^"),
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
    words = _MATHEMATICS.split(title)
    return list(zip(words[::2], [*map(_latex, words[1::2]), ""], strict=True))


def _latex(mathematics: str) -> str:
    for pattern, replacement in _TO_LATEX:
        mathematics = re.sub(pattern, replacement, mathematics)
    return mathematics
