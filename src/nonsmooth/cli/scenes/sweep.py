"""``nonsmooth sweep SCENE``: how fast the methods of a scene converge with the order."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..aliases import Aliased, split_methods
from ..output import DATA, PICTURES, check_target, write_file, write_picture, write_text
from ..problems import Problem, as_problems
from ..progress import progress
from ..values.orders import parse_orders
from . import family
from .options import PREFIX, case_from, command_of, motion_options
from .solve import FUNCTIONS, method_names

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene
    from nonsmooth.solver.sweep import Sweep, SweepRow

#: Orders of a sweep that names none.
ORDERS = "1-20"

#: What a sweep can be written as.
SUFFIXES = (*DATA, *PICTURES)

HELP = """Compute the orbit of {name} for many orders and compare it with the exact one.

{title}."""

EPILOG = """\b
Examples:
  nonsmooth sweep {scene}
  nonsmooth sweep {scene} --methods hb,{best} --orders 1-10,20,40 -o rows.csv
  nonsmooth sweep {scene} --orders 2-16 -o convergence.png
  nonsmooth sweep {scene} --vary {flag}={low:g}:{high:g}:40 -o along.png
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
        click.Option(["--json", "json_"], is_flag=True, help="Print one JSON document."),
        click.Option(
            ["-o", "--output"], type=click.Path(path_type=Path),
            help="Write the rows: .csv, .json, .nc; or a picture .png, .svg, .pdf.",
        ),
    ]  # fmt: skip

    def callback(
        methods: str | None, orders: str | None, functions: int | None, vary: str | None,
        log: bool, case: Path | None, json_: bool, output: Path | None,
        **flags: Any,
    ) -> int:  # fmt: skip
        check_target(output, SUFFIXES)
        if vary is not None:
            given = {name.removeprefix(PREFIX): value for name, value in flags.items()}
            along = family.vary_of(scene, vary, log, given)
            first = flags | {PREFIX + along.parameter: along.first}
            found = case_from(scene, case, first)
            return family.run(found, along, methods, orders, functions, json_, output)
        if log:
            raise Problem("--log: expected beside --vary")
        return run(case_from(scene, case, flags), methods, orders, functions, json_, output)

    words = {"name": scene.name, "title": scene.title.capitalize()}
    last = scene.parameters[-1]
    along = {"low": last.default / 2, "high": last.default, "flag": last.name.replace("_", "-")}
    epilog = EPILOG.format(scene=said, best=names[-1], **along)
    return command_of(scene, callback, options, HELP.format(**words), epilog)


def run(
    case: "Case", methods: str | None, orders: str | None, functions: int | None,
    json_: bool, output: Path | None,
) -> int:  # fmt: skip
    """Sweep, show it, write it; the exit status."""
    from nonsmooth.solver.scenes.method_names import shown
    from nonsmooth.solver.sweep import sweep_case

    numbers = parse_orders(ORDERS if orders is None else orders)
    with as_problems(plural=True):
        names = None if methods is None else _methods(case.scene, methods)
        total = len(names or method_names(case.scene)) * len(numbers)
        with progress(total, "sweep") as advance:

            def done(row: "SweepRow") -> None:
                advance(f"{shown(case.scene, row.method)}, N = {row.order}")

            result = sweep_case(case, names, numbers, functions, done)
    text = _text(result)
    case = result.case
    if json_:
        click.echo(text, nl=False)
    else:
        from .shown import captions, tables

        click.echo(captions.caption(case))
        tables.convergence(result)
        click.echo(captions.legend(case.scene, durations=False))
    if output is not None:
        _write(output, text, result)
    return 0 if all(row.status == "ok" for row in result.rows) else 1


def _methods(scene: "LoadedScene", text: str) -> list[str]:
    from nonsmooth.solver.kernels.registry import generic_method

    names = [generic_method(scene, name) for name in split_methods(text)]
    return list(dict.fromkeys(names))


def _text(result: "Sweep") -> str:
    from nonsmooth.files import documents

    return documents.text(result.case, result.as_dict(), result.rates())


def _write(output: Path, text: str, result: "Sweep") -> None:
    suffix = output.suffix.lower()
    if suffix == ".json":
        write_text(output, text)
    elif suffix in DATA:
        write_file(output, result)
    else:
        from nonsmooth.plots.sweeps import convergence_figure

        write_picture(output, lambda: convergence_figure(result))
