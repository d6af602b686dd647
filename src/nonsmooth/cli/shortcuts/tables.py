"""Tables for people, on stdout, at most 80 columns wide."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import click
import numpy.typing as npt

from nonsmooth.solver.shortcuts.orbit.methods import name_with_terms
from nonsmooth.solver.shortcuts.orbit.motion import exact
from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
from nonsmooth.solver.shortcuts.search.family_points import STATUS

from ..columns import MORE_DIGITS, certain_digits, print_table, table_of

#: Columns of what is said of a solution: the numbers beside it take at most 46.
VERDICT = 34

if TYPE_CHECKING:
    from nonsmooth.shortcuts.digits import Cell, Form
    from nonsmooth.shortcuts.tradeoff import Point
    from nonsmooth.solver.no_orbit import NoOrbit
    from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip
    from nonsmooth.solver.shortcuts.search.sweep import Sweep


#: What the headings of a table of orbits mean.
LEGEND = """
T, t1: period and end of stick, T_ex exact; (22): L2 error of the acceleration
over normalised time; aligned: the same, phase by phase; estimate: of the error
of T, without the exact orbit; it: iterations."""


def legend(found: "Mapping[str, Orbit | NoOrbit]") -> None:
    """Say what the headings of `solutions` mean, if there is an orbit."""
    if any(isinstance(orbit, Orbit) for orbit in found.values()):
        click.echo(LEGEND)


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
    table = table_of(*columns)
    table.add_row("exact", "", f"{reference.period:.9g}", "", f"{reference.t1:.7g}")
    for method, orbit in found.items():
        if not isinstance(orbit, Orbit):
            table.add_row(method, "", orbit.status)
            continue
        table.add_row(
            name_with_terms(method, orbit.c1_terms),
            str(orbit.order),
            f"{orbit.period:.9g}",
            f"{orbit.errors.period:.2e}",
            f"{orbit.t1:.7g}",
            f"{orbit.errors.acceleration:.2e}",
            f"{orbit.errors.acceleration_aligned:.2e}",
            f"{orbit.estimate.period:.1e}",
            str(orbit.iterations),
        )
    print_table(table)
    for orbit in found.values():
        if isinstance(orbit, Orbit) and orbit.estimate.period < MORE_DIGITS:
            period = certain_digits(orbit.period, orbit.estimate.period)
            t1 = certain_digits(orbit.t1, orbit.estimate.t1)
            name = name_with_terms(orbit.method, orbit.c1_terms)
            click.echo(f"{name}, N = {orbit.order}: T = {period} s, t1 = {t1} s")


def convergence(result: "Sweep") -> None:
    """Print one row a method and order."""
    table = table_of("method", "N", "T [s]", "T/T_ex-1", "t1/t1_ex-1", "(22)", "estimate", "it")
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
    print_table(table)


def rates(result: "Sweep") -> None:
    """Print how fast each method converges, or that there are too few orders to say so."""
    click.echo("Convergence, fitted to the upper half of the orders above rounding:\n")
    table = table_of("method", "T", "t1", "(22)")
    for name, rate in result.rates().items():
        table.add_row(name, *(rate.text(error) for error in ("period", "t1", "acceleration")))
    print_table(table)


def family_points(heading: str, order: int, found: "Mapping[str, npt.NDArray[Any]]") -> None:
    """Print points along a parameter."""
    columns = ("method", "N", heading, "alpha", "T [s]", "amp. [m]", "stick/T", "estimate")
    table = table_of(*columns)
    for method, points in found.items():
        for point in points:
            head = (method, str(order), f"{point['value']:.6g}", f"{point['alpha']:.4g}")
            if point["status"]:
                table.add_row(*head, STATUS[point["status"]])
                continue
            table.add_row(
                *head,
                f"{point['period']:.9g}",
                f"{point['amplitude']:.7g}",
                f"{point['stick_fraction']:.5f}",
                f"{point['estimate_period']:.1e}",
            )
    print_table(table)


def trade(points: "list[Point]") -> None:
    """Print time against error, the front marked."""
    table = table_of("method", "N", "digits", "time [s]", "T/T_ex-1", "estimate", "front")
    for point in points:
        table.add_row(
            name_with_terms(point.method, point.c1_terms),
            str(point.order),
            "" if point.digits is None else str(point.digits),
            f"{point.seconds:.1e}",
            f"{point.error:.1e}",
            "" if point.estimate is None else f"{point.estimate:.1e}",
            "*" if point.front else "",
        )
    print_table(table)


def all_roots(rows: list[dict[str, Any]]) -> None:
    """Print one row a solution of the C1 series; a long verdict goes on in the next line."""
    table = table_of("slip [s]", "t1 [s]", "T [s]", "mismatch")
    table.add_column("verdict", overflow="fold", max_width=VERDICT)
    for row in rows:
        numbers = (f"{row[name]:.6g}" for name in ("slip", "t1", "period"))
        verdict = "the orbit" if row["admissible"] else row["violations"][0]
        table.add_row(*numbers, f"{row['transition_mismatch']:.1e}", verdict)
    print_table(table)


def digits(cells: "list[Cell]") -> None:
    """Print one row a cell: digits, condition and iterations of both forms."""
    table = table_of(
        "method", "alpha", "N", "digits", "cond", "it", "as printed", "cond", "it", "met"
    )
    for cell in cells:
        head = (cell.method, f"{cell.alpha:g}", str(cell.order))
        table.add_row(
            *head, *_form(cell.stable), *_form(cell.printed), "yes" if cell.met else "NO"
        )
    print_table(table)
    met = sum(cell.met for cell in cells)
    print(f"{met} of {len(cells)} cells meet their target")


def _form(form: "Form") -> tuple[str, str, str]:
    digits = form.status if form.digits is None else f"{form.digits:.1f}"
    star = "*" if form.status == "helped" else ""
    condition = "" if form.condition is None else f"{form.condition:.0e}"
    return digits + star, condition, str(form.iterations)
