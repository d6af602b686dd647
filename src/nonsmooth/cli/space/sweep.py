"""``nonsmooth sweep STRUCTURE``: how fast the expansions of one mode converge."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..output import PICTURES, check_target, write_picture, write_text, write_whole
from ..problems import Problem
from ..progress import progress
from ..values.orders import parse_orders
from .options import as_problems, attached_from, command_of

if TYPE_CHECKING:
    from nonsmooth.solver.space.attached import Attached
    from nonsmooth.solver.space.convergence import Line
    from nonsmooth.solver.space.structure import Structure

#: Orders of a sweep that names none.
ORDERS = "1-20"

#: What a sweep can be written as.
SUFFIXES = (".json", ".csv", *PICTURES)

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
        click.Option(["--json", "json_"], is_flag=True, help="Print one JSON document."),
        click.Option(
            ["-o", "--output"], type=click.Path(path_type=Path),
            help="Write the rows: .csv, .json; or a picture .png, .svg, .pdf.",
        ),
    ]  # fmt: skip

    def callback(
        methods: str | None, orders: str | None, forced: str | None, mode: int | None,
        case: Path | None, json_: bool, output: Path | None, **flags: Any,
    ) -> int:  # fmt: skip
        check_target(output, SUFFIXES)
        attached = attached_from(structure, case, flags)
        lines = lines_of(structure, methods, forced)
        numbers = parse_orders(ORDERS if orders is None else orders)
        return run(attached, lines, numbers, 1 if mode is None else mode, json_, output)

    words = {"name": structure.name, "k": k, "title": structure.title.capitalize()}
    epilog = EPILOG.format(structure=said, k=k)
    return command_of(structure, callback, options, HELP.format(**words), epilog)


def lines_of(structure: "Structure", methods: str | None, forced: str | None) -> "list[Line]":
    """Return the expansions that ``--methods`` and ``--forced`` name.

    Raises
    ------
    Problem
        If one of them is unknown.
    """
    from nonsmooth.solver.space.convergence import Line
    from nonsmooth.solver.space.expansions.methods import METHODS, check_forced, generic_method

    said = list(METHODS) if methods is None else [part.strip() for part in methods.split(",")]
    with as_problems({"method": "methods"}):
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
    attached: "Attached", lines: "list[Line]", orders: list[int], mode: int, json_: bool,
    output: Path | None,
) -> int:  # fmt: skip
    """Sweep, show it, write it; the exit status."""
    from nonsmooth.files import csv_rows, documents
    from nonsmooth.solver.space.convergence import convergence

    from . import shown

    with as_problems({"order": "orders"}), progress(len(lines) * len(orders), "sweep") as done:
        study = convergence(attached, lines, orders, mode, done)
    text = documents.text_of_modes(attached.structure, study.as_dict())
    if json_:
        click.echo(text, nl=False)
    else:
        click.echo(shown.caption(attached))
        click.echo(f"mode {mode}\n")
        shown.convergence(study)
    if output is not None:
        suffix = output.suffix.lower()
        if suffix == ".json":
            write_text(output, text)
        elif suffix == ".csv":
            rows = csv_rows.of_convergence(study)
            write_whole(output, lambda target: csv_rows.write(target, rows))
        else:
            from nonsmooth.plots.modes import convergence_figure

            write_picture(output, lambda: convergence_figure(study))
    if all(row.beta is None for row in study.rows):
        raise Problem(f"--mode: got {mode}, no order has so many modes", 1)
    return 0
