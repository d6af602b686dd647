"""What documents of orbits have, and printed tables of them read back.

Each cell of a table stands under the heading that it ends below.
"""

from collections.abc import Callable, Sequence
from typing import Any

Document = dict[str, Any]

#: The keys of `solve --json` of a scene, as they are fixed, and those of every file.
KEYS = [
    "schema", "scene", "class", "classes", "motion", "cycles", "method", "order", "functions",
    "parameters", "converged", "iterations", "residual_norm", "phases", "period",
    "forcing_phase", "memory", "extremes", "coefficients", "admissible", "violations", "exact",
    "errors", "estimate", "multipliers", "stable", "others", "outcome", "units", "version",
    "mathematics", "sha256",
]  # fmt: skip

#: For each heading, what of a row of the JSON it shows, and how.  None leaves a cell empty.
Columns = dict[str, tuple[Callable[[Document], Any], str]]


def read(out: str, columns: Sequence[str]) -> list[dict[str, str]]:
    """Return the rows of the one table that has these headings, in any order.

    The first column is flush left and has no spaces in it; all others are flush right.
    """
    lines, wanted = out.splitlines(), sorted(columns)
    (top,) = (i for i, line in enumerate(lines) if sorted(_words(line, wanted)) == wanted)
    ends: dict[str, int] = {}
    place = 0
    for name in _words(lines[top], wanted):
        place = lines[top].index(name, place) + len(name)
        ends[name] = place
    found = []
    for line in lines[top + 1 :]:
        if not _is_row(line, list(ends.values())[1:]):
            break
        first, *rest = ends
        cells = {first: line.split()[0]}
        before = len(cells[first])
        for name in rest:
            cells[name] = line[before : ends[name]].strip()
            before = ends[name]
        found.append(cells)
    return found


def compare(table: list[dict[str, str]], rows: list[Document], columns: Columns) -> None:
    """Hold the cells of a table against the rows of its JSON."""
    assert len(table) == len(rows)
    for cells, row in zip(table, rows, strict=True):
        for heading, (value, shape) in columns.items():
            of_row = value(row)
            expected = "" if of_row is None else format(of_row, shape)
            assert cells[heading] == expected, (heading, cells)


def _is_row(line: str, ends: list[int]) -> bool:
    """Whether nothing reaches beyond the end of its column, as a sentence would."""
    return bool(line.strip()) and all(line[end : end + 1] in {"", " "} for end in ends)


def _words(line: str, headings: Sequence[str]) -> list[str]:
    """Return the headings that a line consists of, in its order; none if it has other words."""
    found, rest = [], line.strip()
    while rest:
        fits = [name for name in headings if rest.startswith(name)]
        if not fits:
            return []
        found.append(max(fits, key=len))
        rest = rest[len(found[-1]) :].strip()
    return found
