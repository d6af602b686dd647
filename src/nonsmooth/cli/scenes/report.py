"""``nonsmooth report SCENE``: one oscillator and its expansions on a page to read."""

from nonsmooth.report.scenes.scene_page import FILES, build, count
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.scenes.loaded import LoadedScene

from ..about import Given
from ..output import Destination, check_folder, write_folder
from ..problems import no_orbit
from ..progress import progress
from .case import case_from


def run(given: Given[LoadedScene], to: Destination) -> int:
    """Compute and write; the exit status."""
    case = case_from(given)
    folder = to.file
    assert folder is not None
    check_folder(folder, FILES)
    try:
        exact = exact_orbit(case)
    except NoOrbit as finding:
        raise no_orbit(finding) from finding
    case = exact.case  # of the motion that occurs, where the scene has several
    with progress(count(case), "report") as done:
        write_folder(folder, lambda made: build(case, exact, given.said, made, done))
    return 0
