"""From a case to a folder: the orbits, the pictures, the page."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from nonsmooth.solver.exact import ExactOrbit
from nonsmooth.solver.scenes.case import Case

from ..pictures import figure, files, write_all
from .collected import collect, steps
from .scene_figures import FIGURES, figures_of
from .scene_page import equations_of, page

#: Every file that there may be in a report on a scene.
FILES = files(FIGURES)


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
    figures = {name: partial(figure, draw, found) for name, draw in figures_of(found).items()}
    pictures = write_all(figures, folder, done)
    (folder / "index.html").write_text(page(found, pictures, equations), "utf-8")
    done("index.html")
