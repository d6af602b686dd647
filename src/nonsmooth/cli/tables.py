"""Tables for people, on stdout, at most 80 columns wide."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

from nonsmooth.solver.orbit import Orbit, exact

if TYPE_CHECKING:
    from nonsmooth.solver.belt import StickSlip
    from nonsmooth.solver.solve import NoOrbit
    from nonsmooth.solver.sweep import Sweep


def _print(table: Table) -> None:
    """Print a table; where stdout is no terminal, plain and as wide as it is."""
    console = Console()
    console.print(table, soft_wrap=not console.is_terminal)


def _table(*columns: str) -> Table:
    table = Table(box=box.SIMPLE_HEAD, padding=(0, 1), show_edge=False, pad_edge=False)
    for index, column in enumerate(columns):
        table.add_column(Text(column), justify="left" if index == 0 else "right", no_wrap=True)
    return table


def solutions(belt: "StickSlip", found: "Mapping[str, Orbit | NoOrbit]") -> None:
    """Print the orbit by each method, below the exact one."""
    reference = exact(belt)
    table = _table("method", "N", "T [s]", "T/T_ex-1", "t1 [s]", "error (22)", "mismatch", "it")
    table.add_row("exact", "", f"{reference.period:.9g}", "", f"{reference.t1:.7g}", "", "", "")
    for method, orbit in found.items():
        if not isinstance(orbit, Orbit):
            table.add_row(method, "", orbit.status, *[""] * 5)
            continue
        table.add_row(
            method,
            str(orbit.order),
            f"{orbit.period:.9g}",
            f"{orbit.errors.period:.2e}",
            f"{orbit.t1:.7g}",
            f"{orbit.errors.acceleration:.2e}",
            f"{orbit.transition_mismatch:.1e}",
            str(orbit.iterations),
        )
    _print(table)


def convergence(result: "Sweep") -> None:
    """Print one row a method and order."""
    table = _table("method", "N", "T [s]", "T/T_ex-1", "t1/t1_ex-1", "error (22)", "it")
    for row in result.rows:
        head = (row.method, str(row.order))
        if row.errors is None or row.period is None:
            table.add_row(*head, row.status, "", "", "", str(row.iterations))
            continue
        errors = row.errors
        table.add_row(
            *head,
            f"{row.period:.9g}",
            f"{errors.period:.3e}",
            f"{errors.t1:.3e}",
            f"{errors.acceleration:.3e}",
            str(row.iterations),
        )
    _print(table)
