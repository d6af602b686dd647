"""What is written for a reader on stdout: texts and tables, their columns, width, digits."""

import math
import re
import textwrap
from collections.abc import Iterable
from typing import TypeAlias

import click
from rich.console import Console
from rich.table import Table
from rich.text import Text

#: Estimated error of the period below which the digits of a column are not all.
MORE_DIGITS = 1e-9

#: Columns of text, and of tables where stdout is not a terminal.
WIDTH = 80

#: Columns of a line where stdout is not a terminal: more than a table takes.
WIDEST = 500

#: How many of the last columns stand in a table of their own, where all do not fit.
BEHIND = 4

#: Part of the largest number of its kind up to which one is printed as 0.
ROUNDING = 1e-14

#: What is printed one below the other.
Piece: TypeAlias = str | Table


def print_pieces(pieces: Iterable[Piece]) -> None:
    """Print texts and tables one below the other."""
    for piece in pieces:
        if isinstance(piece, Table):
            click.echo(_drawn(piece), nl=False, color=True)
        else:
            click.echo(piece)


def _drawn(table: Table) -> str:
    """Return a table as text; where stdout is not a terminal, plain and in 80 columns.

    On a narrow terminal a cell goes on in the next line: no digit is left out.
    """
    console, parts = Console(), [table]
    if not console.is_terminal:
        console = Console(width=WIDEST)
        parts = _parts(table, console)
    with console.capture() as drawn:
        for place, part in enumerate(parts):
            if place:
                console.print()
            console.print(part)
    return drawn.get()


def _parts(table: Table, console: Console) -> list[Table]:
    """Return a table that fits the width: with smaller gaps, two-line headings, or in parts."""

    def width() -> int:
        return console.measure(table).maximum

    if width() <= WIDTH:
        return [table]
    table.padding = (0, 1, 0, 0)
    if width() <= WIDTH:
        return [table]
    for column in table.columns[1:]:
        column.header = Text(str(column.header).replace(" [", "\n["))
    full = width()
    beside = full - console.measure(_only(table, [0])).maximum - 1
    longest = max(map(len, " ".join(map(str, table.columns[0].cells)).split()), default=0)
    if full > WIDTH and longest + 1 + beside <= WIDTH:
        table.columns[0].width = WIDTH - 1 - beside
    if width() <= WIDTH:
        return [table]
    heads = 2 if str(table.columns[1].header) == "N" else 1
    columns, cut = range(len(table.columns)), len(table.columns) - BEHIND
    if cut <= heads:
        return [table]
    parts = _only(table, columns[:cut]), _only(table, [*columns[:heads], *columns[cut:]])
    return [fitting for part in parts for fitting in _parts(part, console)]


def _only(table: Table, which: Iterable[int]) -> Table:
    """Return some of the columns of a table."""
    columns = [table.columns[i] for i in which]
    part = table_of(*(str(column.header) for column in columns))
    part.padding = table.padding
    for cells in zip(*(column.cells for column in columns), strict=True):
        part.add_row(*cells)
    return part


def table_of(*columns: str) -> Table:
    """Return a table with these headings: words to the left, numbers to the right."""
    table = Table(box=None, padding=(0, 2, 0, 0), pad_edge=False)
    for index, column in enumerate(columns):
        table.add_column(
            Text(column), justify="left" if index == 0 else "right", overflow="fold"
        )
    return table


def filled(text: str, indent: str = "") -> str:
    """Return a text in lines, all but the first indented."""
    return textwrap.fill(text, WIDTH, subsequent_indent=indent)


def filled_parameters(words: str) -> str:
    """Return parameters in lines, broken between parameters only."""
    glued = re.sub(r"(?<![,;]) ", "\0", words)
    return textwrap.fill(glued, WIDTH).replace("\0", " ")


def certain_digits(value: float, error: float) -> str:
    """Return a number by the digits that a relative error leaves.

    Examples
    --------
    >>> certain_digits(0.1999999999876, 3e-10), certain_digits(2e-20, 0.0)
    ('0.200000000', '2.000000000000000e-20')
    """
    digits = min(16, max(1, math.floor(-math.log10(error)))) if error > 0 else 16
    return f"{value:#.{digits}g}"


def without_rounding(values: Iterable[float]) -> list[float]:
    """Return numbers of one kind for a table: 0 where one is rounding beside the largest.

    Examples
    --------
    >>> without_rounding([-2.5, -1e-16]), without_rounding([-1e-16, 1e-17])
    ([-2.5, 0.0], [-1e-16, 1e-17])
    """
    numbers = list(values)
    least = ROUNDING * max(map(abs, numbers), default=0.0)
    return [value if abs(value) > least else 0.0 for value in numbers]
