"""``nonsmooth modes STRUCTURE``: the lowest modes by one expansion, or by all three."""

from pathlib import Path
from typing import Any

import click

from nonsmooth.files import documents
from nonsmooth.files.json_text import sealed
from nonsmooth.solver.scenes.parameter_error import whole
from nonsmooth.solver.space.attached import Attached
from nonsmooth.solver.space.modes import MOST_POINTS, Modes
from nonsmooth.solver.space.structure import Structure

from ..about import Given
from ..output import DATA, PICTURES, Destination, drawn_by
from ..problems import Problem, as_problems
from . import family, mode_tables
from .wanted import ALL, attached_from, compute


def run(
    given: Given[Structure], to: Destination, vary: str | None, log: bool, shapes: int | None,
    **wanted: Any,
) -> int:  # fmt: skip
    """Compute the modes, or those over a parameter; the exit status."""
    attached = attached_from(given)
    if vary is None and log:
        raise Problem("--log: expected --vary with it")
    if shapes is not None:
        _check_shapes(shapes, vary, wanted["method"], to.json, to.file)
    if vary is not None:
        return family.run(given, attached, to, wanted, vary, log)
    return _run_once(attached, to, wanted, shapes)


def _check_shapes(
    points: int, vary: str | None, method: str | None, json: bool, file: Path | None
) -> None:
    with as_problems():
        whole("shapes", points, 2, MOST_POINTS)
    if vary is not None:
        raise Problem("--shapes: got --vary with it, expected one structure")
    if method == ALL:
        raise Problem("--shapes: got --method all with it, expected one method")
    if not json and (file is None or file.suffix.lower() in PICTURES):
        raise Problem(f"--shapes: expected -o FILE that ends in one of {', '.join(DATA)}")


def _run_once(
    attached: Attached, to: Destination, wanted: dict[str, Any], shapes: int | None
) -> int:
    """Compute the modes, show them, write them; the exit status."""
    found = compute(attached, wanted)
    kind, data = ("modes", found) if shapes is None else ("shapes", [found[0].shapes(shapes)])
    text = sealed(documents.document_of(kind, data))
    to.show(text, mode_tables.modes(found))
    _warn(found)
    with as_problems():
        written = found if shapes is None else data[0]
        to.write(text, drawn_by("modes.modes_figure", found), written)
    return 0


def _warn(found: list[Modes]) -> None:
    for expansion in found:
        if expansion.structure.kind == "compliance" and expansion.method == "ritz":
            words = "sines have no jump: these are the modes of the sound beam"
            click.echo(f"nonsmooth: ritz: {words}", err=True)
