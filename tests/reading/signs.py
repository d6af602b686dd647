"""The signs of sums and integrals in a drawing, three lines high: where they are.

A sign is centred between its limits, with blanks about it.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

#: The widest limit, in characters.
WIDEST = 14


@dataclass(frozen=True)
class Sign:
    """A sign at `row`, its limits included from `left` up to `right`."""

    token: str
    row: int
    left: int
    right: int
    above: str
    below: str


def signs(rows: Sequence[str]) -> Iterator[Sign]:
    """Yield the signs of a drawing whose rows are equally long."""
    for row, line in enumerate(rows):
        for found in re.finditer(r"∑|∫|\bSum\b|\bInt\b", line):
            token = {"Sum": "∑", "Int": "∫"}.get(found[0], found[0])
            if 0 < row < len(rows) - 1:
                yield from _about(rows, row, found.span(), token)


def _about(rows: Sequence[str], row: int, span: tuple[int, int], token: str) -> Iterator[Sign]:
    """Yield the sign with the widest limits that are centred about it."""
    start, end = span
    for width in range(WIDEST, end - start - 1, -1):
        left = start - (width - (end - start)) // 2
        right = left + width
        if left < 0 or rows[row][left:start].strip() or rows[row][end:right].strip():
            continue
        parts = [rows[row + step][left:right] for step in (-1, 1)]
        above, below = (part.strip() for part in parts)
        centred = all(part == f"{part.strip():^{width}}" for part in parts)
        widest = max(len(above), len(below), end - start)
        if centred and above and below and widest == width and _free(rows, row, left, right):
            yield Sign(token, row, left, right, above, below)
            return


def _free(rows: Sequence[str], row: int, left: int, right: int) -> bool:
    """Whether nothing but a bracket touches the limits."""
    for line in (rows[row - 1], rows[row + 1]):
        if line[right : right + 1].strip() or line[max(left - 1, 0) : left].strip(" ⎛⎜⎝/|\\"):
            return False
    return True
