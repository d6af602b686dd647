"""``nonsmooth modes STRUCTURE``: modes by one expansion or all, or along a parameter."""

from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

from nonsmooth.files import csv_rows, documents
from nonsmooth.files.json_text import sealed
from nonsmooth.solver.scenes.parameter_error import ParameterError, whole
from nonsmooth.solver.space.attached import Attached, attach
from nonsmooth.solver.space.expansions.methods import METHODS
from nonsmooth.solver.space.modes import MOST_POINTS, Modes, ToleranceNotMet, modes
from nonsmooth.solver.space.position import as_fraction
from nonsmooth.solver.space.structure import Structure

from ..about import Given, flag
from ..output import DATA, PICTURES, Destination, drawn_by
from ..problems import Problem, as_problems, say
from ..progress import progress
from ..values import Vary, parse_vary, values_of
from . import mode_tables

#: What asks for every expansion.
ALL = "all"

#: Most values of what varies, and an example.
MOST_VALUES, EXAMPLE = 10_000, "position=1/20:1/2:10"


def run(
    given: Given[Structure], to: Destination, vary: str | None, log: bool, shapes: int | None,
    **options: Any,
) -> int:  # fmt: skip
    """Compute the modes, or those over a parameter; the exit status."""
    attached = attached_from(given)
    if vary is None and log:
        raise Problem("--log: expected --vary with it")
    if shapes is not None:
        _check_shapes(shapes, vary, options["method"], to.json, to.file)
    if vary is not None:
        if options["method"] == ALL:
            raise Problem("--vary: got --method all with it, expected one method")
        along = vary_of(vary, log, attached)
        given.check_varies(along.parameter)
        return _along(attached, to, options, along)
    return _once(attached, to, options, shapes)


def attached_from(given: Given[Structure]) -> Attached:
    """Return the structure that the command line describes.

    What neither a flag nor the case file gives has its default.  A `Problem` has all mistakes
    at once.
    """
    values: dict[str, Any] = {**given.table(), **given.flags}
    try:
        return attach(given.about, **values)
    except ParameterError as error:
        messages = (_as_flag(line) if given.file is None else line for line in error.errors)
        raise Problem(given.where + "; ".join(messages)) from error


def _as_flag(error: str) -> str:
    name, colon, message = error.partition(": ")
    return f"{flag(name)}{colon}{message}" if colon and " " not in name else error


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


def _once(
    attached: Attached, to: Destination, options: dict[str, Any], points: int | None
) -> int:
    """Compute the modes, show them, write them; the exit status."""
    expansions = compute(attached, options)
    kind, data = (
        ("modes", expansions) if points is None else ("shapes", [expansions[0].shapes(points)])
    )
    text = cache(lambda: sealed(documents.document_of(kind, data)))
    to.show(text, mode_tables.modes(expansions))
    for expansion in expansions:
        if expansion.structure.kind == "compliance" and expansion.method == "ritz":
            words = "sines have no jump: these are the modes of the sound beam"
            say(f"ritz: {words}")
    with as_problems():
        results = expansions if points is None else data[0]
        to.write(text, drawn_by("modes.modes_figure", expansions), results)
    return 0


def compute(attached: Attached, options: dict[str, Any]) -> list[Modes]:
    """Return the modes by the method that is wanted, or by each.

    A `Problem` is raised if there are none such; with status 1 if no order is within the
    tolerance.
    """
    arguments = {name: value for name, value in options.items() if value is not None}
    method, forced = arguments.pop("method", None), arguments.pop("forced", None)
    expansions = []
    for name in METHODS if method == ALL else (method,):
        choice: dict[str, Any] = {} if name is None else {"method": name}
        if forced is not None and (method != ALL or name == "ritz-ck"):
            choice["forced"] = forced
        try:
            with as_problems():
                expansions.append(modes(attached, **arguments, **choice))
        except Problem as problem:
            if isinstance(problem.__cause__, ToleranceNotMet):
                raise Problem(str(problem), 1) from problem
            if str(problem).startswith("--method"):
                raise Problem(f"{problem}; or {ALL}") from problem
            raise
    return expansions


def vary_of(text: str, log: bool, attached: Attached) -> Vary[Fraction]:
    """Return what ``--vary`` asks for, of a structure."""
    names = ("position", *attached.values)
    return parse_vary(text, log, names, MOST_VALUES, EXAMPLE, as_fraction)


def structures_of(vary: Vary[Fraction], attached: Attached) -> list[Attached]:
    """Return the structure with each of the values; a `Problem` if one of them cannot be."""
    structures = []
    for value in values_of(vary):
        settings: dict[str, Any] = {"position": attached.a, **attached.values}
        settings[vary.parameter] = value if vary.parameter == "position" else float(value)
        with as_problems(of="--vary: "):
            structures.append(attach(attached.structure, **settings))
    return structures


def _label(vary: Vary[Fraction], value: Fraction) -> str:
    """Return a value for a reader: a position as a fraction where that is short."""
    is_short = vary.parameter == "position" and value.denominator < 1000
    return str(value) if is_short else f"{float(value):.6g}"


def _along(
    attached: Attached, to: Destination, options: dict[str, Any], vary: Vary[Fraction]
) -> int:
    """Compute the modes along a parameter, show them, write them; the exit status."""
    values, labels = zip(*((float(q), _label(vary, q)) for q in values_of(vary)), strict=True)
    structure, expansions = attached.structure, list[Modes]()
    with progress(vary.count, "sweep") as advance:
        for label, each in zip(labels, structures_of(vary, attached), strict=True):
            expansions += compute(each, options)
            advance(f"{vary.flag} = {label}")

    @cache
    def text() -> str:
        pairs = zip(values, expansions, strict=True)
        points = [{"value": value} | expansion.as_dict() for value, expansion in pairs]
        head = {"structure": structure.name, "class": f"C{structure.k}", "vary": vary.flag}
        return documents.text_of_modes(structure, head | {"points": points})

    how = f"{expansions[0].shown}, N = {expansions[0].order}"
    how = how if options["tol"] is None else "to a tolerance"
    to.show(text, mode_tables.family(attached, vary, how, labels, expansions))
    figure = drawn_by("modes.family_figure", vary.flag, values, expansions, vary.log)
    to.write(
        text, figure, expansions, rows=lambda: csv_rows.of_modes(expansions, vary.flag, values)
    )
    return 0
