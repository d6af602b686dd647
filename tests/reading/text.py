"""Read the equations of a terminal: numbers, words, and rows of drawings."""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

from .drawing import Drawing
from .tokens import ReadingError, Token

#: The number of an equation and its words; the mathematics stands further in.
HEAD = re.compile(r" {0,4}(?:-|\((?P<number>\w+)\))  (?P<words>\S.*)")
MARGIN = " " * 7


@dataclass
class Printed:
    """An equation as it was found: the heading it is under, number, words, mathematics."""

    heading: str
    number: str
    words: str
    lines: list[str] = field(default_factory=list)

    def tokens(self) -> list[Token]:
        """Return the tokens of all rows, one after the other."""
        found: list[Token] = []
        for block in "\n".join(self.lines).strip("\n").split("\n\n"):
            found += _row(block.split("\n"))
        return found


def _row(lines: list[str]) -> list[Token]:
    """Return the tokens of one row, or of several, if each is one line high."""
    try:
        return Drawing(lines).read()
    except ReadingError:
        if len(lines) == 1:
            raise
        try:
            return [token for line in lines for token in Drawing([line]).read()]
        except ReadingError:
            pass
        raise


def equations(text: str) -> Iterator[Printed]:
    """Yield the equations of a document."""
    heading, current = "", None
    lines = text.split("\n")
    for line, following in zip(lines, [*lines[1:], ""], strict=True):
        head = HEAD.fullmatch(line)
        if following and set(following) == {"="}:
            if current:
                yield current
            heading, current = line, None
        elif head:
            if current:
                yield current
            current = Printed(heading, head["number"] or "", head["words"])
        elif current and (not line or line.startswith(MARGIN)):
            current.lines.append(line.removeprefix(MARGIN))
        elif current:
            raise ReadingError(f"{line!r} below {current.words}")
    if current:
        yield current
