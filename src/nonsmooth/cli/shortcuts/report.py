"""``nonsmooth report``: the paper recomputed for one oscillator, as a page to read."""

from pathlib import Path

import click

from ..folders import check_folder, write_folder
from ..output import PICTURES, check_target, need, write_whole
from ..problems import Problem
from ..progress import progress
from ..scenes.command import SceneCommand
from .parameters import belt_from, parameter_options

#: The figures of the paper.
FIGURES = ("1", "2", "3", "4", "5", "6")

EPILOG = """\b
Examples:
  nonsmooth report -o report
  nonsmooth report --normal-force 98.1 -o report
  nonsmooth report --figure 5 -o fig5.pdf
  nonsmooth report impact --gap 0.2 -o impact
"""


@click.command(cls=SceneCommand, module="report", epilog=EPILOG)
@parameter_options
@click.option(
    "--figure", type=click.Choice(FIGURES),
    help="Draw only this figure of the paper, into the file -o.",
)  # fmt: skip
@click.option(
    "-o", "--output", type=click.Path(path_type=Path), required=True,
    help="Folder to make: index.html, and every figure as .svg and .pdf; with --figure a "
    "picture: .png, .svg, .pdf.",
)  # fmt: skip
def report(case: Path | None, figure: str | None, output: Path, **flags: float | None) -> None:
    """Recompute figures, equations and claims of the paper, on one page.

    For the oscillator given: Figs. 2 to 6, the equations with their numbers, and the claims
    one by one, each with the normal forces for which it holds.  The page needs nothing from
    outside.  Of another SCENE: how it moves, and how fast each expansion finds its orbit.
    """
    for library in ("matplotlib", "jinja2"):
        need(library, "report", "report")
    if figure is not None:
        check_target(output, PICTURES)
    belt = belt_from(case, flags)
    from nonsmooth.report.build import FILES, STEPS, build, write_plate  # noqa: PLC0415
    from nonsmooth.solver.case.parameters import ParameterError  # noqa: PLC0415
    from nonsmooth.solver.shortcuts.orbit.methods import check_alpha  # noqa: PLC0415

    try:
        check_alpha(belt.alpha)
    except ParameterError as error:
        raise Problem(str(error)) from error
    if figure is not None:
        write_whole(output, lambda target: write_plate(belt, int(figure), target))
        return
    check_folder(output, FILES)
    with progress(STEPS, "report") as done:
        write_folder(output, lambda folder: build(belt, folder, done))
