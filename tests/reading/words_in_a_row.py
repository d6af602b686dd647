"""One row of a drawing as tokens: names, numbers, operators, what is set high or low."""

import re
import unicodedata

from .tokens import ReadingError, Sub, Sup, Token, letter

_LOW = "₀-₉₊₋₌₍₎ₐ-ₜᵢᵣᵤᵥⱼ"
_HIGH = "⁰¹²³⁴-⁹⁺⁻⁽⁾ⁿⁱᶜˢʲ-ˡᵏᵐᴺ"

_TOKEN = re.compile(
    rf"""\ *(?:
      (?P<low>[{_LOW}]+(?:[\ ,][{_LOW}]+)*)
    | (?P<high>[{_HIGH}]+)
    | (?P<name>P\*(?=[\[{_LOW}]) | [^\W\d_{_LOW}{_HIGH}](?:[A-Za-z0-9_]|\^(?=[a-z]))*)
    | (?P<number>\d+)
    | (?P<operator>\*\*|['*⋅+/,=()\[\]⟨⟩<>∂-])
    )""",
    re.VERBOSE,
)

_OPERATORS = {"*": "⋅", "<": "⟨", ">": "⟩"}


def _small(text: str) -> tuple[Token, ...]:
    """Return what is set high or low in full size; its letters are names of their own."""
    full = "".join(unicodedata.normalize("NFKC", character) for character in text)
    return tuple(re.findall(r"\d+|\S", full.replace("\N{MINUS SIGN}", "-")))


def tokens(row: str) -> list[Token]:
    """Return the tokens of a row, without the blanks between them."""
    found: list[Token] = []
    place, text = 0, row.rstrip()
    while place < len(text):
        match = _TOKEN.match(text, place)
        if match is None:
            raise ReadingError(f"{text[place:]!r} in {row!r}")
        place = match.end()
        part = match[match.lastgroup]
        if match.lastgroup == "low":
            found.append(Sub(_small(part)))
        elif match.lastgroup == "high":
            found.append(Sup(_small(part)))
        elif match.lastgroup == "name":
            found.append("".join(map(letter, part)))
        else:
            found.append(_OPERATORS.get(part, part))
    return found
