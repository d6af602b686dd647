"""What the formats have in common: a line of mathematics as a list of tokens."""

import unicodedata
from dataclasses import dataclass


class ReadingError(Exception):
    """What is printed is not mathematics."""


@dataclass(frozen=True)
class Fraction:
    """What stands above and below a bar."""

    above: tuple
    below: tuple


@dataclass(frozen=True)
class Sub:
    """What is set low behind the token before: an index, or where a sum begins."""

    inside: tuple


@dataclass(frozen=True)
class Sup:
    """What is set high behind the token before: an exponent, or where a sum ends."""

    inside: tuple


@dataclass(frozen=True)
class Root:
    """What stands under a square root."""

    inside: tuple


@dataclass(frozen=True)
class Cases:
    """The lines behind a brace, each a value and its condition."""

    rows: tuple


#: A token: one of the above, or a name, a number, an operator or a bracket.
Token = Fraction | Sub | Sup | Root | Cases | str


def letter(character: str) -> str:
    """Return a letter in plain ASCII, a Greek one by its name."""
    name = unicodedata.name(character, "")
    if not name.startswith("GREEK"):
        return unicodedata.normalize("NFKC", character)
    word = name.removesuffix(" SYMBOL").split()[-1].lower()
    return {"lamda": "lambda"}.get(word, word)
