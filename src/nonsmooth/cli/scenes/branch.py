"""``nonsmooth branch SCENE`` and ``map``: orbits followed along a parameter, and over two."""

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.files import documents
from nonsmooth.files.api import load
from nonsmooth.files.file_errors import FileError
from nonsmooth.solver import chart as maps
from nonsmooth.solver.branches import branch, branches
from nonsmooth.solver.existence.known import are_one
from nonsmooth.solver.orbit.exact_orbit import ExactOrbit
from nonsmooth.solver.results.branch import Branch
from nonsmooth.solver.results.interrupted import Interrupted
from nonsmooth.solver.results.orbit import Orbit
from nonsmooth.solver.results.strobe import Diagram
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.loaded import LoadedScene
from nonsmooth.solver.strobe import diagram
from nonsmooth.workers import pool

from ..about import Given
from ..output import PICTURES, Destination, drawn_by
from ..problems import Problem, as_problems
from ..progress import busy, progress
from ..values import Vary
from . import tables
from .captions import caption
from .case import case_from, vary_from

#: Values of a diagram below a branch.
VALUES = 121


def run(
    given: Given[LoadedScene], to: Destination, vary: str, from_orbit: Path | None, every: bool,
    attractors: bool = False, **expansion: Any,
) -> int:  # fmt: skip
    """Follow the branch, show it, write it; the exit status."""
    along = vary_from(given, vary, None)
    if every and from_orbit is not None:
        raise Problem(f"--from-orbit: got {from_orbit} beside --all, expected one of them")
    suffix = "" if to.file is None else to.file.suffix.lower()
    if every and suffix in {".csv", ".nc"}:
        raise Problem(f"--output: got {to.file} beside --all, expected .json or a picture")
    if attractors and suffix not in PICTURES:
        raise Problem("--attractors: expected beside --output and a picture")
    case, start = _start(given, from_orbit)
    interrupt = None
    arguments = case, along.parameter, along.first, along.last
    try:
        with as_problems({"start": "from-orbit"}), busy(f"following {case.scene.name}") as say:
            expansion["progress"] = lambda value: say(f"{along.flag} = {value:g}")
            if every:
                followed = branches(*arguments, **expansion)
            else:
                followed = [branch(*arguments, start=start, **expansion)]
    except Interrupted as error:
        interrupt, followed = error, error.done

    @cache
    def text() -> str:
        several = {"branches": [q.as_dict() for q in followed]}
        document = several if every else followed[0].as_dict()
        used = [followed[0].method] if followed[0].order else []
        return documents.text(case, {"scene": case.scene.name} | document, used)

    to.show(text, tables.branches(case, along, followed))
    below = _diagrams(case, followed[0], along) if attractors and not interrupt else ()
    to.write(text, drawn_by("families.branch_figure", followed, below), followed[0])
    if interrupt:
        raise Problem(f"interrupted: {interrupt}", 130)
    return 0


def _start(
    given: Given[LoadedScene], from_orbit: Path | None
) -> tuple[Case, ExactOrbit | None]:
    """Return the case, and the exact orbit next to one in a file, if one is named.

    The file may have the same orbit by several methods.  A `Problem` is raised if it holds no
    orbit or different ones, or has parameters beside it.
    """
    if from_orbit is None:
        return case_from(given), None
    if given.flags or given.file is not None:
        name = next(iter(given.flags), "case")
        raise Problem(f"--{name}: given beside --from-orbit, which says it")
    try:
        content = load(from_orbit, scene=given.about)
    except OSError as error:
        raise Problem(f"--from-orbit: cannot read {from_orbit}: {error.strerror}") from error
    except FileError as error:
        raise Problem(f"--from-orbit: {error}") from error
    orbits = content if isinstance(content, list) else [content]
    exact = [q.exact for q in orbits if isinstance(q, Orbit) and q.exact is not None]
    if not exact or not all(are_one(exact[0], other) for other in exact[1:]):
        holds = f"{len(exact)} different orbits" if exact else "no orbit next to an exact one"
        raise Problem(f"--from-orbit: {from_orbit}: holds {holds}, expected one")
    return exact[0].case, exact[0]


def _diagrams(case: Case, followed: Branch, along: Vary[float]) -> tuple[Diagram, ...]:
    """Return what simulations settle on along a parameter, upwards and downwards."""
    low, high = sorted((along.first, along.last))
    upwards = np.linspace(low, high, VALUES)
    directions = (values.tolist() for values in (upwards, upwards[::-1]))
    with busy(f"simulating {case.scene.name}"):
        return tuple(diagram(followed.case, along.parameter, values) for values in directions)


def chart(given: Given[LoadedScene], to: Destination, vary: tuple[str, ...]) -> int:
    """Compute the map, show it, write it; the exit status."""
    first, second = _axes(given, vary)
    axes = {each.parameter: (each.first, each.last, each.count) for each in (first, second)}
    case = case_from(given)
    interrupt = None
    tasks = maps.number_of_tasks(first.count, second.count)
    with as_problems(), progress(tasks, "map") as advance, pool() as executor:
        try:
            result = maps.chart(case, axes, executor, advance)
        except Interrupted as error:
            interrupt, result = error, error.done
    text = cache(lambda: documents.text(case, result.as_dict(), ()))
    to.show(text, (caption(case, first, second), str(result)))
    to.write(text, drawn_by("charts.chart_figure", result), result)
    if interrupt:
        raise Problem(f"interrupted: {interrupt}", 130)
    return 0


def _axes(given: Given[LoadedScene], texts: tuple[str, ...]) -> list[Vary[float]]:
    """Return the two parameters that vary.

    A `Problem` is raised if there are not two, or one is given by a flag as well.
    """
    axes = [vary_from(given, text, maps.MOST_VALUES, ":40") for text in texts]
    if len({axis.parameter for axis in axes}) != 2 or len(axes) != 2:
        raise Problem(f"--vary: got {' and '.join(texts)}, expected two parameters")
    for axis in axes:
        given.check_varies(axis.parameter)
    return axes
