"""Tokens, taken one after the other."""

from collections.abc import Sequence

from .tokens import ReadingError, Token


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
