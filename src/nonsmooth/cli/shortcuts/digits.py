"""``nonsmooth digits``: digits kept at the extremes, by the stable and the printed forms."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nonsmooth.files.json_text import as_json

from ..flint import need_flint
from ..output import PICTURES, check_target, write_text, write_whole
from ..progress import progress
from ..scenes.command import SceneCommand
from .by_scene import digits_generic

if TYPE_CHECKING:
    from nonsmooth.shortcuts.digits import Cell, Form

EPILOG = """\b
Examples:
  nonsmooth digits --quick
  nonsmooth digits -o digits.png
  nonsmooth digits impact --orders 10,20
"""


@click.command(cls=SceneCommand, module="digits", epilog=EPILOG)
@click.option("--no-shortcuts", is_flag=True, help="The kernels of every scene instead.")
@click.option("--quick", is_flag=True, help="A small grid: seconds instead of minutes.")
@click.option("--json", "json_", is_flag=True, help="Print one JSON document.")
@click.option(
    "-o", "--output", type=click.Path(path_type=Path),
    help="Write the cells: .json, or a picture .png, .svg, .pdf.",
)  # fmt: skip
def digits(quick: bool, no_shortcuts: bool, json_: bool, output: Path | None) -> int:
    """Measure the digits of t1 and T against high precision, on this machine.

    The stable forms that the kernels use stand beside the equations as the paper prints
    them: raw g1, monomials, SI units, no scaling. SCENE is a name of 'nonsmooth scenes', or
    the path of a scene file, which is Python and is run: its extremes are those that it names.
    """
    check_target(output, (".json", *PICTURES))
    need_flint("digits")
    if no_shortcuts:
        return digits_generic(quick, json_, output)
    from nonsmooth.shortcuts.digits import cells, measure  # noqa: PLC0415

    grid = cells(quick)
    with progress(len(grid), "digits") as advance:
        found = measure(
            grid, lambda c: advance(f"{c.method}, alpha = {c.alpha:g}, N = {c.order}")
        )
    if json_:
        click.echo(as_json(document(found)))
    else:
        from . import tables  # noqa: PLC0415

        tables.digits(found)
    if output is not None:
        _write(output, found)
    return 0 if all(cell.met for cell in found) else 1


def _old_name(**options: Any) -> int:
    words = "it is now `nonsmooth digits`; whether an orbit is stable is said by `solve`"
    click.echo(f"nonsmooth: stability: {words}", err=True)
    status: int = digits.callback(**options)  # type: ignore[misc]
    return status


#: What the command was called before orbits had multipliers.
stability = click.Command(
    "stability", params=digits.params, callback=_old_name, epilog=digits.epilog, hidden=True,
    help="The old name of `nonsmooth digits`.",
)  # fmt: skip


def document(found: "list[Cell]") -> dict[str, Any]:
    """Return the measurements as JSON has them."""
    from nonsmooth.shortcuts.digits import MOST_ITERATIONS, TARGETS  # noqa: PLC0415

    rows = [
        {"method": cell.method, "alpha": cell.alpha, "order": cell.order, "met": cell.met}
        | {name: _form(getattr(cell, name)) for name in ("stable", "printed")}
        for cell in found
    ]
    targets = {"error": TARGETS, "iterations": MOST_ITERATIONS}
    return {"targets": targets, "met": all(cell.met for cell in found), "rows": rows}


def _form(form: "Form") -> dict[str, Any]:
    finite = form.condition is not None and form.condition < float("inf")
    return asdict(form) | {
        "condition": form.condition if finite else None,
        "digits": form.digits,
    }


def _write(output: Path, found: "list[Cell]") -> None:
    if output.suffix.lower() == ".json":
        write_text(output, as_json(document(found)) + "\n")
        return
    from .heat_maps import digits_picture  # noqa: PLC0415

    write_whole(output, lambda target: digits_picture(found, target))
