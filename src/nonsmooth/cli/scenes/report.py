"""``nonsmooth report SCENE``: one oscillator and its expansions on a page to read."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..folders import check_folder, write_folder
from ..output import need
from ..problems import no_orbit
from ..progress import progress
from .options import case_from, command_of

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene

HELP = """Write a page on {name}: what it is, its orbit, and how fast each expansion finds it.

{title}. The page needs nothing from outside."""

EPILOG = """\b
Examples:
  nonsmooth report {scene} -o {name}
  nonsmooth report {scene} --{flag} {value:g} -o {name}
"""


def command(scene: "LoadedScene", said: str) -> click.Command:
    """Return ``nonsmooth report`` of a scene, which the user called so."""
    folder = click.Option(
        ["-o", "--output"], type=click.Path(path_type=Path), required=True,
        help="Folder to make: index.html, and every figure as .svg and .pdf.",
    )  # fmt: skip

    def callback(case: Path | None, output: Path, **flags: Any) -> int:
        for library in ("matplotlib", "jinja2"):
            need(library, "report", "report")
        return run(case_from(scene, case, flags), said, output)

    last = scene.parameters[-1]
    words = {"name": scene.name, "title": scene.title.capitalize()}
    examples = {"flag": last.name.replace("_", "-"), "value": last.default}
    epilog = EPILOG.format(scene=said, name=scene.name, **examples)
    return command_of(scene, callback, [folder], HELP.format(**words), epilog)


def run(case: "Case", said: str, output: Path) -> int:
    """Compute and write; the exit status."""
    from nonsmooth.report.scenes.build import FILES, build, count
    from nonsmooth.solver.exact import exact_orbit
    from nonsmooth.solver.no_orbit import NoOrbit

    check_folder(output, FILES)
    try:
        exact = exact_orbit(case)
    except NoOrbit as finding:
        raise no_orbit(finding) from finding
    case = exact.case  # of the motion that occurs, where the scene has several
    with progress(count(case), "report") as done:
        write_folder(output, lambda folder: build(case, exact, said, folder, done))
    return 0
