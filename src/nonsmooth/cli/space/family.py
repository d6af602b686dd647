"""``nonsmooth modes STRUCTURE --vary``: modes along a parameter, or the position."""

from fractions import Fraction
from typing import Any

from nonsmooth.files import csv_rows, documents
from nonsmooth.solver.space.attached import Attached, attach
from nonsmooth.solver.space.modes import Modes
from nonsmooth.solver.space.position import as_fraction
from nonsmooth.solver.space.structure import Structure

from ..about import Given
from ..output import Destination, drawn_by
from ..problems import Problem, wrong_values
from ..progress import progress
from ..values import Vary, parse_vary, values_of
from . import mode_tables
from .wanted import ALL, compute

#: Points of a family.
MOST_POINTS = 10_000

EXAMPLE = "position=1/20:1/2:10"


def vary_of(text: str, log: bool, attached: Attached) -> Vary[Fraction]:
    """Return what ``--vary`` asks for, of a structure."""
    names = ("position", *attached.values)
    return parse_vary(text, log, names, MOST_POINTS, EXAMPLE, as_fraction)


def structures_of(vary: Vary[Fraction], attached: Attached) -> list[Attached]:
    """Return the structure with each of the values; a `Problem` if one of them cannot be."""
    found = []
    for value in values_of(vary):
        given: dict[str, Any] = {"position": attached.a, **attached.values}
        given[vary.parameter] = value if vary.parameter == "position" else float(value)
        with wrong_values("--vary: "):
            found.append(attach(attached.structure, **given))
    return found


def labels_of(vary: Vary[Fraction]) -> list[str]:
    """Return the values for a reader: positions as fractions where these are short."""
    place = vary.parameter == "position"
    return [
        str(value) if place and value.denominator < 1000 else f"{float(value):.6g}"
        for value in values_of(vary)
    ]


def run(
    given: Given[Structure], attached: Attached, to: Destination, wanted: dict[str, Any],
    text: str, log: bool,
) -> int:  # fmt: skip
    """Compute the modes along a parameter, show them, write them; the exit status."""
    if wanted["method"] == ALL:
        raise Problem("--vary: got --method all with it, expected one method")
    vary = vary_of(text, log, attached)
    given.check_varies(vary.parameter)
    values, labels = [float(value) for value in values_of(vary)], labels_of(vary)
    structures = structures_of(vary, attached)
    found: list[Modes] = []
    with progress(vary.count, "sweep") as advance:
        for label, each in zip(labels, structures, strict=True):
            found += compute(each, wanted)
            advance(f"{vary.flag} = {label}")
    document = documents.of_varied_modes(vary.flag, values, found)
    text = documents.text_of_modes(attached.structure, document)
    how = f"{found[0].shown}, N = {found[0].order}"
    how = how if wanted["tol"] is None else "to a tolerance"
    to.show(text, mode_tables.family(attached, vary, how, labels, found))
    figure = drawn_by("modes.family_figure", vary.flag, values, found, log)
    to.write(text, figure, found, rows=lambda: csv_rows.of_modes(found, vary.flag, values))
    return 0
