"""``nonsmooth tradeoff SCENE``: time against error, measured on this machine for one case."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..about import Given, Output
from ..output import PICTURES, drawn_by, write_result
from ..problems import no_orbit
from ..progress import progress
from .options import case_from, command_of

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene

OUTPUT = Output("Write the points: .json, or a picture .png, .svg, .pdf.", (".json", *PICTURES))

HELP = """Measure time against error of the times: each method of {name}, and its exact flow.

{title}. A time is that of a whole solve: from rough times, with its checks, and not the first.
A point on the front (marked *) is the best in its time."""

EPILOG = """\b
Examples:
  nonsmooth tradeoff {scene}
  nonsmooth tradeoff {scene} {flag} {value:g} -o tradeoff.png
"""

LEGEND = """times: largest error of a duration{and_phase}, as a part of T;
estimate: the same, {estimated}; exact: by the flow of each phase,
from its own times."""


def command(scene: "LoadedScene", said: str) -> click.Command:
    """Return ``nonsmooth tradeoff`` of a scene, which the user called so."""
    return command_of(scene, said, run, [], OUTPUT, HELP, EPILOG)


def run(given: "Given[LoadedScene]", json_: bool, output: Path | None) -> int:
    """Measure, show, write; the exit status."""
    from nonsmooth.files import documents
    from nonsmooth.solver.no_orbit import NoOrbit
    from nonsmooth.solver.trade.measured import trade, ways

    case = case_from(given)
    try:
        with progress(1 + len(ways(case)), "tradeoff") as advance:
            result = trade(case, advance)
    except NoOrbit as finding:
        raise no_orbit(finding) from finding
    methods = dict.fromkeys(method for method, _ in ways(case))
    text = documents.text(case, result.as_dict(), methods)
    if json_:
        click.echo(text, nl=False)
    else:
        from .shown import captions, tables

        click.echo(captions.caption(case))
        tables.trade(result)
        also = " or of the phase of the forcing" if case.scene.frequency else ""
        click.echo(
            "\n" + LEGEND.format(and_phase=also, estimated=captions.estimated(case.scene))
        )
    write_result(output, text, drawn_by("sweeps.trade_figure", result))
    return 0
