"""Read a drawing in lines of characters: what stands above, below and beside each other.

A drawing is read from left to right.  What begins in a column is the bar of a fraction, a
bracket several lines high, the sign of a sum, a root, or else one character, on the row that
all of them share.
"""

from collections.abc import Callable, Sequence

from .signs import Sign, signs
from .tokens import Cases, Fraction, ReadingError, Root, Sub, Sup, Token
from .words_in_a_row import tokens

#: The characters of a high bracket: above, between, below; and of the one that closes it.
OPENING = {"⎛": ("⎜", "⎝"), "/": ("|", "\\")}
CLOSING = {"⎛": "⎞⎠", "/": "\\/"}

#: A brace about cases, the same way.
BRACE = {"⎧": ("⎨", "⎩"), "/": ("<", "\\")}

Part = tuple[int, list[Token]]


class Drawing:
    """Equally long rows, and the signs in them."""

    def __init__(self, rows: Sequence[str]) -> None:
        width = max(map(len, rows))
        self.rows = [row.ljust(width) for row in rows]
        self.signs: dict[tuple[int, int], Sign] = {(s.row, s.left): s for s in signs(self.rows)}

    def read(self) -> list[Token]:
        """Return the tokens of the whole drawing."""
        return self.region(0, len(self.rows), 0, len(self.rows[0]))[1]

    def cell(self, row: int, column: int) -> str:
        inside = 0 <= row < len(self.rows) and 0 <= column < len(self.rows[0])
        return self.rows[row][column] if inside else " "

    def region(self, top: int, bottom: int, left: int, right: int) -> Part:
        """Return the row that a part of the drawing stands on, and its tokens."""
        found: list[Token] = []
        baseline, text, column = None, "", left

        while column < right:
            filled = [row for row in range(top, bottom) if self.cell(row, column) != " "]
            if not filled:
                text += " "
                column += 1
                continue
            end, row, part = self.item(filled, (top, bottom), column)
            if baseline not in (None, row):
                raise ReadingError(f"rows {baseline} and {row} beside each other")
            baseline = row
            if isinstance(part, str):
                text += part
            else:
                found += [*tokens(text), *part]
                text = ""
            column = end
        if baseline is None:
            raise ReadingError("nothing where something is due")
        return baseline, found + tokens(text)

    def item(
        self, filled: list[int], within: tuple[int, int], column: int
    ) -> tuple[int, int, str | list[Token]]:
        """Return where the next item ends, its row, and what it is."""
        readers: tuple[Callable, ...] = (self.fraction, self.sign, self.bracket, self.root)
        for reader in readers:
            item = reader(filled, within, column)
            if item is not None:
                return item
        if len(filled) > 1:
            characters = "".join(self.cell(row, column) for row in filled)
            raise ReadingError(f"{characters!r} above each other in column {column}")
        return column + 1, filled[0], self.cell(filled[0], column)

    def fraction(self, filled, within, column):
        top, bottom = within
        bars = []
        for row in filled:
            mark = self.cell(row, column)
            line = self.rows[row][column:]
            length = len(line) - len(line.lstrip(mark))
            beside = [
                top <= near < bottom and self.rows[near][column : column + length].strip()
                for near in (row - 1, row + 1)
            ]
            if mark in "─-" and all(beside):
                bars.append((length, row))
        if not bars:
            return None
        length, row = max(bars)
        _, above = self.region(top, row, column, column + length)
        _, below = self.region(row + 1, bottom, column, column + length)
        return column + length, row, [_quotient(above, below)]

    def sign(self, filled, within, column):
        for row in range(*within):
            sign = self.signs.get((row, column))
            if sign is not None:
                limits = [Sub(tuple(tokens(sign.below))), Sup(tuple(tokens(sign.above)))]
                return sign.right, row, [sign.token, *limits]
        return None

    def bracket(self, filled, within, column):
        for marks in (OPENING, BRACE):
            for top in filled:
                between, end = marks.get(self.cell(top, column), ("", ""))
                bottom = top + 1
                while end and self.cell(bottom, column) == between:
                    bottom += 1
                if not end or bottom == within[1] or self.cell(bottom, column) != end:
                    continue
                if marks is BRACE:
                    return self.cases(top, bottom, column)
                right = self.closing(top, bottom, column)
                row, inside = self.region(top, bottom + 1, column + 1, right)
                return right + 1, row, ["(", *inside, ")"]
        return None

    def closing(self, top: int, bottom: int, column: int) -> int:
        """Return the column of the bracket that closes the one in `column`."""
        opening = self.cell(top, column), self.cell(bottom, column)
        closing = tuple(CLOSING[opening[0]])
        depth = 0
        for place in range(column, len(self.rows[0])):
            ends = self.cell(top, place), self.cell(bottom, place)
            depth += (ends == opening) - (ends == closing)
            if depth == 0:
                return place
        raise ReadingError(f"a bracket in column {column} that does not close")

    def cases(self, top: int, bottom: int, column: int):
        rows = []
        for row in range(top, bottom + 1):
            line = self.rows[row][column + 1 :]
            if not line.strip():
                continue
            value, _, condition = line.partition(" for ")
            if not condition:
                value, _, condition = line.partition("  otherwise")
                condition = "otherwise"
            rows.append((tuple(tokens(value)), tuple(tokens(condition))))
        return len(self.rows[0]), (top + bottom) // 2, [Cases(tuple(rows))]

    def root(self, filled, within, column):
        row = filled[-1]
        if self.cell(row, column) == "√":
            return column + 2, row, [Root(tuple(tokens(self.cell(row, column + 1))))]
        if self.cell(row, column) + self.cell(row, column + 1) not in {"\\/", "╲╱"}:
            return None
        high = 1  # rows of what is under the root: so long is the slope of its sign
        while self.cell(row - high, column + 1 + high) == self.cell(row, column + 1):
            high += 1
        left = column + 1 + high
        bar = self.rows[row - high][left:]
        right = left + len(bar) - len(bar.lstrip("_"))
        baseline, inside = self.region(row + 1 - high, row + 1, left, right)
        return right, baseline, [Root(tuple(inside))]


def _quotient(above: list[Token], below: list[Token]) -> Fraction:
    """Return a fraction; in ASCII the differentials of a derivative are written with a d."""

    def opened(part: list[Token]) -> tuple[Token, ...]:
        first = part[0]
        return ("∂", *([first[1:]] if first[1:] else ()), *part[1:])

    if all(isinstance(part[0], str) and part[0].startswith("d") for part in (above, below)):
        return Fraction(opened(above), opened(below))
    return Fraction(tuple(above), tuple(below))
