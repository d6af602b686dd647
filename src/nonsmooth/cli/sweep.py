"""``nonsmooth sweep``: how period and acceleration converge with the order."""

import csv
import io
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from .equations import METHODS
from .orders import parse_methods, parse_orders
from .output import PICTURES, as_json, check_target, write_text, write_whole
from .parameters import belt_from, caption, parameter_options
from .problems import Problem
from .progress import progress

if TYPE_CHECKING:
    from nonsmooth.solver.sweep import Row, Sweep

EPILOG = """\b
Examples:
  nonsmooth sweep
  nonsmooth sweep --methods hb,c1 --orders 1-10,20,40 -o convergence.csv
  nonsmooth sweep --orders 1-40 --json > convergence.json
  nonsmooth sweep --orders 10,100,...,1000000
"""


@click.command(epilog=EPILOG)
@click.option("--methods", help="Methods, by commas.  [default: hb,hb-c1,c1]")
@click.option(
    "--orders",
    default="1-40",
    show_default=True,
    help="Orders: numbers, ranges, 10,100,...,1000.",
)
@click.option(
    "--c1-terms", type=int, default=1, show_default=True, help="C1 functions of hb-c1, 1 to 6."
)
@parameter_options
@click.option("--json", "json_", is_flag=True, help="Print one JSON document.")
@click.option(
    "-o", "--output", type=click.Path(path_type=Path),
    help="Write the rows: .csv, .json, or a picture .png, .svg, .pdf.",
)  # fmt: skip
def sweep(
    methods: str | None,
    orders: str,
    c1_terms: int,
    case: Path | None,
    json_: bool,
    output: Path | None,
    **flags: float | None,
) -> int:
    """Compute the orbit for many orders and compare period and acceleration with the exact."""
    check_target(output, (".csv", ".json", *PICTURES))
    names = None if methods is None else parse_methods(methods)
    numbers = parse_orders(orders)
    belt = belt_from(case, flags)
    from nonsmooth.solver.belt import ParameterError  # noqa: PLC0415
    from nonsmooth.solver.sweep import sweep as compute  # noqa: PLC0415

    try:
        with progress(len(names or METHODS) * len(numbers), "sweep") as advance:

            def done(row: "Row") -> None:
                advance(_name(row))

            result = compute(belt, names, numbers, c1_terms=c1_terms, progress=done)
    except ParameterError as error:
        raise Problem(str(error)) from error
    except ValueError as error:
        text = str(error)
        about = "--c1-terms" + text[8:] if text.startswith("c1_terms") else f"--orders: {text}"
        raise Problem(about) from error
    if json_:
        click.echo(as_json(document(result)))
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


def document(result: "Sweep") -> dict[str, Any]:
    """Return a sweep as JSON has it."""
    return {
        "parameters": asdict(result.belt),
        "rows": [row.as_dict() for row in result.rows],
        "c1_terms": result.c1_terms,
        "rates": {name: asdict(rate) for name, rate in result.rates().items()},
    }


def as_csv(result: "Sweep") -> str:
    """Return a sweep as CSV, one row a method and order, with a header."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    names = ["method", "order", "status", "t1", "period", "iterations", "seconds"]
    errors = ["period", "t1", "acceleration", "acceleration_aligned"]
    estimates = ["period", "t1", "acceleration"]
    header = [f"error_{name}" for name in errors] + [f"estimate_{name}" for name in estimates]
    writer.writerow(names + header)
    for row in result.rows:
        values = row.as_dict()
        found: Any = values["errors"]
        judged: Any = values["estimate"]
        writer.writerow(
            [values[name] for name in names]
            + [found[name] for name in errors]
            + [judged[name] for name in estimates]
        )
    return text.getvalue()


def _write(output: Path, result: "Sweep") -> None:
    suffix = output.suffix.lower()
    if suffix == ".csv":
        write_text(output, as_csv(result))
    elif suffix == ".json":
        write_text(output, as_json(document(result)) + "\n")
    else:
        from .pictures import convergence_picture  # noqa: PLC0415

        write_whole(output, lambda target: convergence_picture(result, target))
