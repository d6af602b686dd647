"""``nonsmooth tradeoff``: time against error, measured on this machine for one oscillator."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nonsmooth.files.json_text import as_json

from ..output import PICTURES, check_target, write_picture, write_text
from ..problems import Problem
from ..progress import progress
from ..scenes.command import SceneCommand
from .parameters import belt_from, caption, parameter_options

if TYPE_CHECKING:
    from nonsmooth.shortcuts.tradeoff import Point
    from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip

EPILOG = """\b
Examples:
  nonsmooth tradeoff -o tradeoff.png
  nonsmooth tradeoff --belt-speed 0.2 --json
  nonsmooth tradeoff impact --gap 0.2
"""


@click.command(cls=SceneCommand, module="tradeoff", epilog=EPILOG)
@parameter_options
@click.option("--json", "json_", is_flag=True, help="Print one JSON document.")
@click.option(
    "-o", "--output", type=click.Path(path_type=Path),
    help="Write the points: .json, or a picture .png, .svg, .pdf.",
)  # fmt: skip
def tradeoff(case: Path | None, json_: bool, output: Path | None, **flags: float | None) -> int:
    """Measure time against error of the period: the methods, and many digits.

    A point on the front (marked *) is the best in its time.
    """
    check_target(output, (".json", *PICTURES))
    belt = belt_from(case, flags)
    from nonsmooth.shortcuts.tradeoff import count, measure  # noqa: PLC0415
    from nonsmooth.solver.case.parameters import ParameterError  # noqa: PLC0415

    try:
        with progress(count(), "tradeoff") as advance:
            points = measure(belt, advance)
    except ParameterError as error:
        raise Problem(str(error)) from error
    if json_:
        click.echo(as_json(document(belt, points)))
    else:
        from .tables import trade  # noqa: PLC0415

        click.echo(caption(belt))
        trade(points)
    if output is not None:
        _write(output, belt, points)
    return 0


def document(belt: "StickSlip", points: "list[Point]") -> dict[str, Any]:
    """Return the points as JSON has them."""
    return {"parameters": asdict(belt), "points": [asdict(point) for point in points]}


def _write(output: Path, belt: "StickSlip", points: "list[Point]") -> None:
    if output.suffix.lower() == ".json":
        write_text(output, as_json(document(belt, points)) + "\n")
        return
    from nonsmooth.plots.shortcuts.trade import tradeoff_figure  # noqa: PLC0415

    write_picture(output, lambda: tradeoff_figure(points))
