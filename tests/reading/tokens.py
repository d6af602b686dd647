"""What the formats have in common: a line of mathematics as a list of tokens, read in turn."""

import unicodedata
from collections.abc import Sequence
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


class Cursor:
    """A place in a line of tokens."""

    def __init__(self, tokens: Sequence[Token]) -> None:
        self.tokens, self.at = tokens, 0

    def next(self) -> Token | None:
        """Return the next token, if there is one, and leave it."""
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def take(self, *wanted: str) -> Token:
        """Return the next token, which has to be one of these, if any are given."""
        token = self.next()
        if token is None or (wanted and token not in wanted):
            raise ReadingError(f"{token!r} where {' or '.join(wanted) or 'more'} is due")
        self.at += 1
        return token

    def passes(self, *wanted: str) -> bool:
        """Take the next token if it is one of these."""
        found = self.next() in wanted
        self.at += found
        return found

    def primes(self) -> int:
        """Take all primes that follow and return how many they are."""
        count = 0
        while self.passes("'"):
            count += 1
        return count

    def end(self) -> None:
        """Check that nothing is left."""
        if self.next() is not None:
            raise ReadingError(f"{self.next()!r} where the end is due")
