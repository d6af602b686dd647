"""Tables for people, on stdout, at most 80 columns wide."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import click
from rich.console import Console
from rich.table import Table
from rich.text import Text

from nonsmooth.solver.motion import exact
from nonsmooth.solver.orbit import Orbit

if TYPE_CHECKING:
    from nonsmooth.solver.belt import StickSlip
    from nonsmooth.solver.no_orbit import NoOrbit
    from nonsmooth.solver.sweep import Sweep
    from nonsmooth.stability import Cell, Form
    from nonsmooth.tradeoff import Point


#: Columns where stdout is no terminal; the tables take what they need, mostly below 80.
WIDEST = 200


def _print(table: Table) -> None:
    """Print a table; where stdout is no terminal, plain and as wide as it is.

    On a narrow terminal a cell goes on in the next line: no digit is left out.
    """
    console = Console()
    if not console.is_terminal:
        console = Console(width=WIDEST)
    console.print(table)


def _table(*columns: str) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0), pad_edge=False)
    for index, column in enumerate(columns):
        table.add_column(
            Text(column), justify="left" if index == 0 else "right", overflow="fold"
        )
    return table


def solutions(belt: "StickSlip", found: "Mapping[str, Orbit | NoOrbit]") -> None:
    """Print the orbit by each method, below the exact one."""
    reference = exact(belt)
    columns = (
        "method",
        "N",
        "T [s]",
        "T/T_ex-1",
        "t1 [s]",
        "(22)",
        "aligned",
        "estimate",
        "it",
    )
    table = _table(*columns)
    table.add_row("exact", "", f"{reference.period:.9g}", "", f"{reference.t1:.7g}")
    for method, orbit in found.items():
        if not isinstance(orbit, Orbit):
            table.add_row(method, "", orbit.status)
            continue
        table.add_row(
            method if orbit.c1_terms == 1 else f"{method}({orbit.c1_terms})",
            str(orbit.order),
            f"{orbit.period:.9g}",
            f"{orbit.errors.period:.2e}",
            f"{orbit.t1:.7g}",
            f"{orbit.errors.acceleration:.2e}",
            f"{orbit.errors.acceleration_aligned:.2e}",
            f"{orbit.estimate.period:.1e}",
            str(orbit.iterations),
        )
    _print(table)


def convergence(result: "Sweep") -> None:
    """Print one row a method and order."""
    table = _table("method", "N", "T [s]", "T/T_ex-1", "t1/t1_ex-1", "(22)", "estimate", "it")
    for row in result.rows:
        head = (row.method, str(row.order))
        if row.errors is None or row.period is None or row.estimate is None:
            table.add_row(*head, row.status, "", "", "", "", str(row.iterations))
            continue
        errors = row.errors
        table.add_row(
            *head,
            f"{row.period:.9g}",
            f"{errors.period:.3e}",
            f"{errors.t1:.3e}",
            f"{errors.acceleration:.3e}",
            f"{row.estimate.period:.1e}",
            str(row.iterations),
        )
    _print(table)


def rates(result: "Sweep") -> None:
    """Print how fast each method converges, where there are orders enough."""
    found = {name: rate for name, rate in result.rates().items() if rate.period is not None}
    if not found:
        return
    click.echo("Convergence, fitted to the upper half of the orders above rounding:\n")
    table = _table("method", "T", "t1", "(22)")
    for name, rate in found.items():
        table.add_row(name, *(rate.text(error) for error in ("period", "t1", "acceleration")))
    _print(table)


def trade(points: "list[Point]") -> None:
    """Print time against error, the front marked."""
    table = _table("method", "N", "digits", "time [s]", "T/T_ex-1", "estimate", "front")
    for point in points:
        table.add_row(
            point.method,
            str(point.order),
            "" if point.digits is None else str(point.digits),
            f"{point.seconds:.1e}",
            f"{point.error:.1e}",
            "" if point.estimate is None else f"{point.estimate:.1e}",
            "*" if point.front else "",
        )
    _print(table)


def all_roots(rows: list[dict[str, Any]]) -> None:
    """Print one row a solution of the C1 series."""
    table = _table("slip [s]", "t1 [s]", "T [s]", "mismatch", "verdict")
    for row in rows:
        numbers = (f"{row[name]:.6g}" for name in ("slip", "t1", "period"))
        verdict = "the orbit" if row["admissible"] else row["violations"][0].split(":")[0]
        mismatch = f"{row['transition_mismatch']:.1e}"
        table.add_row(*numbers, mismatch, _shortened(verdict))
    _print(table)


def _shortened(text: str, width: int = 34) -> str:
    text = text.split(" (", maxsplit=1)[0]
    return text if len(text) <= width else text[: width - 1] + "…"


def digits(cells: "list[Cell]") -> None:
    """Print one row a cell: digits, condition and iterations of both forms."""
    table = _table(
        "method", "alpha", "N", "digits", "cond", "it", "as printed", "cond", "it", "met"
    )
    for cell in cells:
        head = (cell.method, f"{cell.alpha:g}", str(cell.order))
        table.add_row(
            *head, *_form(cell.stable), *_form(cell.printed), "yes" if cell.met else "NO"
        )
    _print(table)
    met = sum(cell.met for cell in cells)
    print(f"{met} of {len(cells)} cells meet their target")


def _form(form: "Form") -> tuple[str, str, str]:
    digits = form.status if form.digits is None else f"{form.digits:.1f}"
    star = "*" if form.status == "helped" else ""
    condition = "" if form.condition is None else f"{form.condition:.0e}"
    return digits + star, condition, str(form.iterations)
