"""``nonsmooth report SCENE``: one oscillator and its expansions on a page to read."""

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..about import Given, Output
from ..folders import check_folder, write_folder
from ..output import need
from ..problems import no_orbit
from ..progress import progress
from .options import case_from, command_of

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene

OUTPUT = Output("Folder to make: index.html, and every figure as .svg and .pdf.")

HELP = """Write a page on {name}: what it is, its orbit, and how fast each expansion finds it.

{title}. The page needs nothing from outside."""

EPILOG = """\b
Examples:
  nonsmooth report {scene} -o {name}
  nonsmooth report {scene} {flag} {value:g} -o {name}
"""


def command(scene: "LoadedScene", said: str) -> click.Command:
    """Return ``nonsmooth report`` of a scene, which the user called so."""
    return command_of(scene, said, partial(run, said), [], OUTPUT, HELP, EPILOG)


def run(said: str, given: "Given[LoadedScene]", output: Path) -> int:
    """Compute and write; the exit status."""
    for library in ("matplotlib", "jinja2"):
        need(library, "report", "report")
    case = case_from(given)
    from nonsmooth.report.scenes.scene_page import FILES, build, count
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
