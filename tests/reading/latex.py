"""Read LaTeX mathematics."""

import re
from collections.abc import Iterator

from .tokens import Cases, Cursor, Fraction, ReadingError, Root, Sub, Sup, Token

_TOKEN = re.compile(r"\\[A-Za-z]+|\\[^A-Za-z]|[A-Za-z]+|\d+|\S")

#: What only sets space or size.
SPACING = {r"\,", r"\ ", r"\:", "&"}
SPACING |= {rf"\{name}" for name in ("left", "right", "biggl", "biggr", "limits", "quad")}

SIGNS = {r"\sum": "∑", r"\int": "∫", r"\partial": "∂", r"\langle": "⟨", r"\rangle": "⟩"}
GREEK = "pi alpha gamma lambda eta mu omega phi psi rho tau xi zeta"
NAMES = {rf"\{name}": name for name in f"sin cos max {GREEK}".split()}

#: Words of several letters; all others would be products of letters.
WORDS = {"dt", "du"}


def _unknown(piece: str) -> bool:
    """Whether a piece is a command without a meaning here, or a product of letters."""
    return piece.startswith("\\") or (len(piece) > 1 and piece.isalpha() and piece not in WORDS)


class _Source(Cursor):
    """The pieces of a line of LaTeX, taken one after the other."""

    def __init__(self, source: str) -> None:
        super().__init__(_TOKEN.findall(source))

    def group(self) -> tuple[Token, ...]:
        """Return the tokens of the next group in braces, or of a single piece."""
        if self.next() != "{":
            return tuple(self.token())
        self.take("{")
        found = self.until("}")
        self.take("}")
        return found

    def word(self) -> str:
        """Return the next group as one word."""
        return "".join(map(str, self.letters()))

    def letters(self) -> Iterator[str]:
        self.take("{")
        while self.next() != "}":
            yield self.take()
        self.take("}")

    def until(self, *ends: str | None) -> tuple[Token, ...]:
        found: list[Token] = []
        while self.next() not in ends:
            found += self.token()
        return tuple(found)

    def token(self) -> list[Token]:
        piece = self.take()
        found: list[Token] = [SIGNS.get(piece) or NAMES.get(piece, piece)]
        match piece:
            case "{":
                found = list(self.until("}"))
                self.take("}")
            case "_":
                found = [Sub(self.group())]
            case "^":
                found = [Sup(self.group())]
            case r"\frac":
                found = [Fraction(self.group(), self.group())]
            case r"\sqrt":
                found = [Root(self.group())]
            case r"\dot" | r"\ddot":
                found = [*self.group(), *"'" * (len(piece) - len(r"\ot"))]
            case r"\operatorname" | r"\mathrm" | r"\mathcal":
                found = [self.word()]
            case r"\begin":
                found = self.cases()
            case _ if piece in SPACING:
                found = []
            case _ if found == [piece] and _unknown(piece):
                raise ReadingError(f"unknown: {piece}")
        return found

    def cases(self) -> list[Token]:
        if self.word() != "cases":
            raise ReadingError("an environment that is not expected")
        rows = []
        while self.next() != r"\end":
            value = self.until("&")
            self.take("&")
            self.take(r"\text")
            condition: tuple[Token, ...] = (self.word(),)
            if condition == ("for",):
                condition = self.until(r"\\", r"\end")
            rows.append((value, condition))
            if self.next() == r"\\":
                self.take()
        self.take(r"\end")
        self.word()
        return [Cases(tuple(rows))]


def tokens(source: str) -> list[Token]:
    """Return the tokens of a line of mathematics."""
    return list(_Source(source).until(None))
