"""``nonsmooth sweep``: how period and acceleration converge with the order."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..aliases import Aliased
from ..output import DATA, PICTURES, check_target, write_file, write_picture
from ..problems import Problem, about_option
from ..progress import progress
from ..scenes.command import SceneCommand
from ..values.orders import parse_orders
from .by_scene import (
    FUNCTIONS,
    NO_SHORTCUTS,
    are_generic,
    parse_methods,
    refuse_beside_generic,
    sweep_generic,
)
from .equations import METHODS
from .families import family
from .parameters import belt_from, caption, parameter_options

if TYPE_CHECKING:
    from nonsmooth.solver.shortcuts.search.sweep import Row, Sweep

#: Orders of a sweep that names none.
ORDERS = "1-40"

EPILOG = """\b
Examples:
  nonsmooth sweep
  nonsmooth sweep --methods hb,c1 --orders 1-10,20,40 -o convergence.csv
  nonsmooth sweep --orders 1-40 --json > convergence.json
  nonsmooth sweep --orders 10,100,...,1000000
  nonsmooth sweep --vary belt-speed=0.1:10:200 --log -o family.csv
  nonsmooth sweep impact --orders 2-16
"""


@click.command(cls=SceneCommand, module="sweep", epilog=EPILOG)
@click.option(
    "--methods",
    cls=Aliased,
    alias="--method",
    help="Methods, by commas.  [default: hb,hb-c1,c1; with --vary: c1]",
)
@click.option(
    "--orders",
    cls=Aliased,
    alias="--order",
    help="Orders: numbers, ranges, 10,100,...,1000.  [default: 1-40; with --vary: 24]",
)
@click.option(
    "--c1-terms", type=int, default=1, show_default=True, help="C1 functions of hb-c1, 1 to 6."
)
@click.option("--functions", type=int, help=FUNCTIONS)
@click.option("--no-shortcuts", is_flag=True, help=NO_SHORTCUTS)
@click.option(
    "--vary", metavar="NAME=FROM:TO:POINTS",
    help="Sweep over a parameter instead, at one order: period, amplitude, stick.",
)  # fmt: skip
@click.option("--log", is_flag=True, help="Space the values of --vary by a constant factor.")
@parameter_options
@click.option("--json", "json_", is_flag=True, help="Print one JSON document.")
@click.option(
    "-o", "--output", type=click.Path(path_type=Path),
    help="Write the rows: .csv, .json, .nc; or a picture .png, .svg, .pdf.",
)  # fmt: skip
def sweep(
    methods: str | None,
    orders: str | None,
    c1_terms: int,
    functions: int | None,
    no_shortcuts: bool,
    vary: str | None,
    log: bool,
    case: Path | None,
    json_: bool,
    output: Path | None,
    **flags: float | None,
) -> int:
    """Compute the orbit for many orders and compare period and acceleration with the exact.

    With --vary, follow it along a parameter. SCENE is a name of 'nonsmooth scenes', or the
    path of a scene file, which is Python and is run; without it, the belt of the paper.
    """
    check_target(output, (*DATA, *PICTURES))
    if are_generic(methods, functions, no_shortcuts, "--methods"):
        refuse_beside_generic(
            {
                "--c1-terms": c1_terms if c1_terms != 1 else None,
                "--vary": vary,
                "--log": log or None,
            }
        )
        return sweep_generic(case, flags, methods, orders, functions, json_, output)
    names = None if methods is None else parse_methods(methods)
    if c1_terms != 1 and "hb-c1" not in (names or (("c1",) if vary is not None else METHODS)):
        chosen = ",".join(names or ["c1"])
        raise Problem(f"--c1-terms: got {c1_terms} without hb-c1 among the methods {chosen}")
    if vary is not None:
        belt = belt_from(case, flags)
        job = family.job_from(vary, log, belt, flags, names, orders, c1_terms)
        return family.run(job, json_, output)
    if log:
        raise Problem("--log: expected --vary beside it")
    numbers = parse_orders(ORDERS if orders is None else orders)
    belt = belt_from(case, flags)
    from nonsmooth.solver.case.parameters import ParameterError  # noqa: PLC0415
    from nonsmooth.solver.shortcuts.search.sweep import sweep as compute  # noqa: PLC0415

    try:
        with progress(len(names or METHODS) * len(numbers), "sweep") as advance:

            def done(row: "Row") -> None:
                advance(_name(row))

            result = compute(belt, names, numbers, c1_terms=c1_terms, progress=done)
    except ParameterError as error:
        raise Problem(str(error)) from error
    except ValueError as error:
        raise about_option(error) from error
    if json_:
        from nonsmooth.files.json_text import sealed  # noqa: PLC0415
        from nonsmooth.files.shortcuts.texts import sweep_document  # noqa: PLC0415

        click.echo(sealed(sweep_document(result)), nl=False)
    else:
        from .tables import convergence, rates  # noqa: PLC0415

        click.echo(caption(belt))
        if c1_terms > 1:
            click.echo(f"hb-c1 with {c1_terms} C1 functions.\n")
        convergence(result)
        rates(result)
    if output is not None:
        _write(output, result)
    return 0 if all(row.status == "ok" for row in result.rows) else 1


def _name(row: "Row") -> str:
    return f"{row.method}, N = {row.order}"


def _write(output: Path, result: "Sweep") -> None:
    if output.suffix.lower() in DATA:
        write_file(output, result)
        return
    from nonsmooth.plots.shortcuts.sweeps import convergence_figure  # noqa: PLC0415

    write_picture(output, lambda: convergence_figure(result))
