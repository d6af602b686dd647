"""``nonsmooth sweep SCENE``: how fast the methods of a scene converge with the order."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..about import Given, Output
from ..aliases import Aliased, split_methods
from ..output import DATA, PICTURES, drawn_by, write_result
from ..problems import PLURAL, Problem, as_problems
from ..progress import progress
from ..values import parse_orders
from . import family
from .options import case_from, command_of, method_names, motion_options
from .solve import FUNCTIONS

if TYPE_CHECKING:
    from nonsmooth.solver.results.sweep import SweepRow
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene

#: Orders of a sweep that names none.
ORDERS = "1-20"

OUTPUT = Output(
    "Write the rows: .csv, .json, .nc; or a picture .png, .svg, .pdf.", (*DATA, *PICTURES)
)

HELP = """Compute the orbit of {name} for many orders and compare it with the exact one.

{title}."""

EPILOG = """\b
Examples:
  nonsmooth sweep {scene}
  nonsmooth sweep {scene} --methods hb,{best} --orders 1-10,20,40 -o rows.csv
  nonsmooth sweep {scene} --orders 2-16 -o convergence.png
  nonsmooth sweep {scene} --vary {vary}:40 -o along.png
"""


def command(scene: "LoadedScene", said: str) -> click.Command:
    """Return ``nonsmooth sweep`` of a scene, which the user called so."""
    names = method_names(scene)
    options: list[click.Parameter] = [
        Aliased(
            ["--methods"], alias="--method",
            help=f"By commas.  [default: {','.join(names)}]",
        ),
        Aliased(
            ["--orders"], alias="--order",
            help=f"Numbers, ranges, 10,20,...,80.  [default: {ORDERS}]",
        ),
        click.Option(["--functions"], type=int, metavar="K", help=FUNCTIONS),
        *motion_options(scene),
        click.Option(
            ["--vary"], metavar="NAME=FROM:TO:POINTS",
            help="Follow the orbit along a parameter instead, by one method at one order.",
        ),
        click.Option(["--log"], is_flag=True, help="Space the values by a constant factor."),
    ]  # fmt: skip
    return command_of(scene, said, run, options, OUTPUT, HELP, EPILOG)


def run(given: "Given[LoadedScene]", vary: str | None, log: bool, **wanted: Any) -> int:
    """Sweep along a parameter or over orders; the exit status."""
    if vary is not None:
        along = family.vary_of(given, vary, log)
        case = case_from(given, **{along.parameter: along.first})
        return family.run(case, along, **wanted)
    if log:
        raise Problem("--log: expected beside --vary")
    return _over_orders(case_from(given), **wanted)


def _over_orders(
    case: "Case", methods: str | None, orders: str | None, functions: int | None,
    json_: bool, output: Path | None,
) -> int:  # fmt: skip
    """Sweep over orders, show it, write it; the exit status."""
    from nonsmooth.files import documents
    from nonsmooth.solver.scenes.methods import shown
    from nonsmooth.solver.sweep import sweep_case

    numbers = parse_orders(ORDERS if orders is None else orders)
    with as_problems(PLURAL):
        names = None if methods is None else _methods(case.scene, methods)
        total = len(names or method_names(case.scene)) * len(numbers)
        with progress(total, "sweep") as advance:

            def done(row: "SweepRow") -> None:
                advance(f"{shown(case.scene, row.method)}, N = {row.order}")

            result = sweep_case(case, names, numbers, functions, done)
    text = documents.text(result.case, result.as_dict(), result.rates())
    case = result.case
    if json_:
        click.echo(text, nl=False)
    else:
        from .shown import captions, tables

        click.echo(captions.caption(case))
        tables.convergence(result)
        click.echo(captions.legend(case.scene, durations=False))
    write_result(output, text, drawn_by("sweeps.convergence_figure", result), result)
    return 0 if all(row.status == "ok" for row in result.rows) else 1


def _methods(scene: "LoadedScene", text: str) -> list[str]:
    from nonsmooth.solver.kernels.registry import generic_method

    names = [generic_method(scene, name) for name in split_methods(text)]
    return list(dict.fromkeys(names))
