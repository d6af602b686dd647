"""From a case to a folder: the orbits, the pictures, the page."""

from collections.abc import Callable
from pathlib import Path

import matplotlib as mpl

from nonsmooth.solver.exact import ExactOrbit
from nonsmooth.solver.scenes.case import Case
from nonsmooth.style import save

from ..build import SUFFIXES
from ..figures import LOOK
from .collected import Collected, collect, steps
from .equations import equations_of
from .figures import FIGURES, figure, figures_of
from .page import page

#: Every file that there may be in a report on a scene.
FILES = {"index.html", *(name + suffix for name in FIGURES for suffix in SUFFIXES)}


def count(case: Case) -> int:
    """Return how often progress is told: the orbits, the equations, the pictures, the page."""
    return steps(case) + 1 + len(FIGURES) + 1


def build(
    case: Case, exact: ExactOrbit, source: str, folder: Path, done: Callable[[str], None]
) -> None:
    """Write the report on a case into an empty folder.

    Parameters
    ----------
    case : Case
        The oscillator.
    source : str
        The name of its scene, or the path of its file: its equations are derived from it.
    exact : ExactOrbit
        Its exact orbit.
    folder : Path
        An empty folder.
    done : callable
        Called with what has just been done, in words.
    """
    found = collect(case, exact, done)
    equations = equations_of(source)
    done("equations")
    pictures = draw(found, folder, done)
    (folder / "index.html").write_text(page(found, pictures, equations), "utf-8")
    done("index.html")


def draw(found: Collected, folder: Path, done: Callable[[str], None]) -> dict[str, str]:
    """Write every picture into a folder, in each format; return the SVG by name."""
    for name, (drawn, _) in figures_of(found).items():
        with mpl.rc_context(LOOK):
            made = figure(drawn, found)
            for suffix in SUFFIXES:
                save(made, folder / (name + suffix))
        done(name)
    return {name: (folder / f"{name}.svg").read_text("utf-8") for name in figures_of(found)}
