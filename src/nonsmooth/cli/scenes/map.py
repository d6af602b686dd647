"""``nonsmooth map SCENE --vary ... --vary ...``: motions over two parameters."""

from nonsmooth.files import documents
from nonsmooth.report.workers import pool
from nonsmooth.solver.chart import MOST_VALUES, chart, number_of_tasks
from nonsmooth.solver.results.chart import ChartInterrupted
from nonsmooth.solver.scenes.loaded import LoadedScene

from ..about import Given
from ..output import Destination, drawn_by
from ..problems import Problem, as_problems
from ..progress import progress
from ..values import Vary
from . import captions
from .case import case_from, vary_from


def run(
    given: Given[LoadedScene], to: Destination, vary: tuple[str, ...], cycles: int | None = None
) -> int:
    """Compute the map, show it, write it; the exit status."""
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
    to.show(text, (captions.caption(case), str(result)))
    to.write(text, drawn_by("charts.chart_figure", result), result)
    if interrupt is not None:
        raise Problem(f"interrupted: {interrupt.rows} of {second.count} rows are done", 130)
    return 0


def _axes(given: Given[LoadedScene], texts: tuple[str, ...]) -> list[Vary[float]]:
    """Return the two parameters that vary.

    A `Problem` is raised if there are not two, or one is given by a flag as well.
    """
    found = [vary_from(given, text, MOST_VALUES, ":40") for text in texts]
    if len({each.parameter for each in found}) != 2 or len(found) != 2:
        raise Problem(f"--vary: got {' and '.join(texts)}, expected two parameters")
    for each in found:
        given.check_varies(each.parameter)
    return found
