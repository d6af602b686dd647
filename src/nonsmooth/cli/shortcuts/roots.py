"""``nonsmooth roots``: all real solutions of the C1 series at one order."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nonsmooth.files.json_text import as_json

from ..problems import Problem
from ..progress import busy
from .parameters import belt_from, caption, parameter_options

if TYPE_CHECKING:
    from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip

EPILOG = """\b
Examples:
  nonsmooth roots --order 7
  nonsmooth roots --order 4 --normal-force 100
"""


@click.command(epilog=EPILOG)
@click.option("--order", type=int, required=True, help="N of the C1 series (15).")
@parameter_options
@click.option("--json", "json_", is_flag=True, help="Print one JSON document.")
def roots(order: int, case: Path | None, json_: bool, **flags: float | None) -> int:
    """List every real solution of (18) to (20), and say which one is the orbit.

    With the coefficients eliminated they are the positive roots of one polynomial in the
    slip duration, alpha D(s**2) = s E(s**2), isolated in exact arithmetic.
    """
    belt = belt_from(case, flags)
    with busy(f"all solutions of order {order}"):
        rows = _rows(belt, order)
    if json_:
        click.echo(as_json({"order": order, "parameters": asdict(belt), "roots": rows}))
    else:
        from .tables import all_roots  # noqa: PLC0415

        click.echo(caption(belt))
        all_roots(rows)
    return 0 if any(row["admissible"] for row in rows) else 1


def _rows(belt: "StickSlip", order: int) -> list[dict[str, Any]]:
    from nonsmooth.solver.case.parameters import ParameterError  # noqa: PLC0415
    from nonsmooth.solver.shortcuts.orbit.admissible import violations  # noqa: PLC0415
    from nonsmooth.solver.shortcuts.orbit.methods import METHODS, check_alpha, check_order  # noqa: PLC0415
    from nonsmooth.solver.shortcuts.polynomials import c1_roots  # noqa: PLC0415

    method = METHODS["c1"]
    try:
        solutions = c1_roots.solutions(check_order(order, method), check_alpha(belt.alpha))
    except ParameterError as error:
        raise Problem(str(error)) from error
    except ValueError as error:
        raise Problem(f"--{error}") from error
    rows = []
    for z in solutions:
        t1, T = (float(time) * belt.time_unit for time in z[-2:])
        travel = (float(z[-2]) / (2 * belt.alpha) - 1) * 2 * (1 - belt.mu_k / belt.mu_s)
        broken = list(violations(method, order, belt, z))
        row = {"slip": T - t1, "t1": t1, "period": T, "transition_mismatch": travel}
        rows.append(row | {"admissible": not broken, "violations": broken})
    return rows
