"""``nonsmooth map SCENE --vary ... --vary ...``: motions over two parameters."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..about import Given, Output
from ..output import DATA, PICTURES, drawn_by, write_result
from ..problems import Problem, as_problems
from ..progress import progress
from ..values import Vary
from .options import case_from, check_not_given, command_of, vary_from

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene

OUTPUT = Output(
    "Write the map: .csv, .json, .nc; or a picture .png, .svg, .pdf.", (*DATA, *PICTURES)
)

HELP = """Map the motions of {name} over two parameters, and the curves between them.

{title}. Each point has an exact orbit, stable or not, or is empty. Curves of folds, flips,
grazings and rests are followed in both parameters. It uses all cores."""

EPILOG = """\b
Examples:
  nonsmooth map {scene} --vary {vary}:60 --vary {other}:40
  nonsmooth map {scene} --json -o map.png \\
    --vary {vary}:60 --vary {other}:40
"""


def command(scene: "LoadedScene", said: str) -> click.Command:
    """Return ``nonsmooth map`` of a scene, which the user called so."""
    first = scene.parameters[-2]
    other = f"{first.name.replace('_', '-')}={first.default / 2:g}:{first.default or 1:g}"
    options: list[click.Parameter] = [
        click.Option(
            ["--vary"], metavar="NAME=FROM:TO:COUNT", required=True, multiple=True,
            help="Given twice: a parameter, its range, and how many values it takes.",
        ),
    ]  # fmt: skip
    if scene.frequency is not None:
        words = "Periods of the forcing in one of the motion.  [default: 1]"
        options.append(click.Option(["--cycles"], type=int, metavar="n", help=words))
    epilog = EPILOG.replace("{other}", other)
    return command_of(scene, said, run, options, OUTPUT, HELP, epilog)


def run(
    given: "Given[LoadedScene]", vary: tuple[str, ...], json_: bool, output: Path | None,
    cycles: int | None = None,
) -> int:  # fmt: skip
    """Compute the map, show it, write it; the exit status."""
    from nonsmooth.files import documents
    from nonsmooth.report.workers import pool
    from nonsmooth.solver.chart import chart, number_of_tasks
    from nonsmooth.solver.results.chart import ChartInterrupted

    first, second = _axes(given, vary)
    axes = {each.parameter: (each.first, each.last, each.count) for each in (first, second)}
    more = {} if cycles is None else {"cycles": cycles}
    case = case_from(given, **more)
    interrupt = None
    tasks = number_of_tasks(first.count, second.count)
    with as_problems(), progress(tasks, "map") as advance, pool() as executor:
        try:
            result = chart(case, axes, executor, advance)
        except ChartInterrupted as error:
            interrupt, result = error, error.done
    text = documents.text(case, result.as_dict(), ())
    if json_:
        click.echo(text, nl=False)
    else:
        from .shown import captions

        click.echo(captions.caption(case))
        click.echo(str(result))
    write_result(output, text, drawn_by("charts.chart_figure", result), result)
    if interrupt is not None:
        raise Problem(f"interrupted: {interrupt.rows} of {second.count} rows are done", 130)
    return 0


def _axes(given: "Given[LoadedScene]", texts: tuple[str, ...]) -> "list[Vary[float]]":
    """Return the two parameters that vary.

    A `Problem` is raised if there are not two, or one is given by a flag as well.
    """
    from nonsmooth.solver.chart import MOST_VALUES

    found = [vary_from(given, text, MOST_VALUES, ":40") for text in texts]
    if len({each.parameter for each in found}) != 2 or len(found) != 2:
        raise Problem(f"--vary: got {' and '.join(texts)}, expected two parameters")
    for each in found:
        check_not_given(given, each)
    return found
