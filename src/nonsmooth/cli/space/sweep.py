"""``nonsmooth sweep STRUCTURE``: how fast the expansions of one mode converge."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..about import Given, Output
from ..output import PICTURES, drawn_by, write_result
from ..problems import PLURAL, Problem, as_problems
from ..progress import progress
from ..values import parse_orders
from .options import attached_from, command_of

if TYPE_CHECKING:
    from nonsmooth.solver.space.convergence import Line
    from nonsmooth.solver.space.structure import Structure

#: Orders of a sweep that names none.
ORDERS = "1-20"

OUTPUT = Output(
    "Write the rows: .csv, .json; or a picture .png, .svg, .pdf.", (".json", ".csv", *PICTURES)
)

HELP = """Compute one mode of {name} for many orders and compare it with the exact one.

{title}; its modes are of class C{k}."""

EPILOG = """\b
Examples:
  nonsmooth sweep {structure}
  nonsmooth sweep {structure} --methods ritz,ritz-c{k} --forced 1,2 --orders 4,8,16,32
  nonsmooth sweep {structure} --mode 3 -o convergence.png
"""


def command(structure: "Structure", said: str) -> click.Command:
    """Return ``nonsmooth sweep`` of a structure, which the user called so."""
    k, most = structure.k, structure.most_forced
    options: list[click.Parameter] = [
        click.Option(["--methods"], help=f"By commas.  [default: ritz,ritz-c{k},c{k}]"),
        click.Option(
            ["--orders"], help=f"Numbers, ranges, 10,20,...,80.  [default: {ORDERS}]"
        ),
        click.Option(
            ["--forced"], metavar="K,K",
            help=f"Numbers of forced modes of ritz-c{k}, 1 to {most}.  [default: 1]",
        ),
        click.Option(["--mode"], type=int, help="Number of the mode.  [default: 1]"),
    ]  # fmt: skip
    return command_of(structure, said, run, options, OUTPUT, HELP, EPILOG)


def lines_of(structure: "Structure", methods: str | None, forced: str | None) -> "list[Line]":
    """Return the expansions that ``--methods`` and ``--forced`` name.

    A `Problem` is raised if one of them is unknown.
    """
    from nonsmooth.solver.space.convergence import Line
    from nonsmooth.solver.space.expansions.methods import METHODS, check_forced, generic_method

    said = list(METHODS) if methods is None else [part.strip() for part in methods.split(",")]
    with as_problems(PLURAL):
        names = list(dict.fromkeys(generic_method(structure, name) for name in said))
        if forced is not None and "ritz-ck" not in names:
            raise ValueError(f"forced: got {forced!r}, {', '.join(names)} has no forced modes")
        parts = ["1"] if forced is None else [part.strip() for part in forced.split(",")]
        numbers = [int(part) if part.isdecimal() else part for part in parts]
        found = []
        for name in names:
            if name == "ritz-ck":
                checked = [check_forced(structure, name, K) for K in numbers]  # type: ignore[arg-type]
                found += [Line(name, K) for K in dict.fromkeys(checked)]
            else:
                found.append(Line(name))
    return found


def run(
    given: "Given[Structure]", methods: str | None, orders: str | None, forced: str | None,
    mode: int | None, json_: bool, output: Path | None,
) -> int:  # fmt: skip
    """Sweep, show it, write it; the exit status."""
    from nonsmooth.files import csv_rows, documents
    from nonsmooth.solver.space.convergence import convergence

    from . import mode_tables

    attached = attached_from(given)
    lines = lines_of(given.about, methods, forced)
    numbers = parse_orders(ORDERS if orders is None else orders)
    number = 1 if mode is None else mode
    with as_problems(PLURAL), progress(len(lines) * len(numbers), "sweep") as done:
        study = convergence(attached, lines, numbers, number, done)
    text = documents.text_of_modes(attached.structure, study.as_dict())
    if json_:
        click.echo(text, nl=False)
    else:
        click.echo(mode_tables.caption(attached))
        click.echo(f"mode {number}\n")
        mode_tables.convergence(study)
    figure = drawn_by("modes.convergence_figure", study)
    write_result(output, text, figure, rows=lambda: csv_rows.of_convergence(study))
    if all(row.beta is None for row in study.rows):
        raise Problem(f"--mode: got {number}, no order has so many modes", 1)
    return 0
