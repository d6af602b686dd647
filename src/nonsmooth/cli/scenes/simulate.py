"""``nonsmooth simulate SCENE``: the motion from a given state, from event to event."""

from functools import cache
from typing import Any

from nonsmooth.files import csv_rows, documents
from nonsmooth.nearest import counted
from nonsmooth.solver.results.strobe import Basins, Diagram
from nonsmooth.solver.scenes.loaded import LoadedScene
from nonsmooth.solver.simulation.simulate import simulate
from nonsmooth.solver.strobe import basins, diagram

from ..about import Given, flag
from ..output import Destination, drawn_by
from ..problems import Problem, as_problems, say
from ..progress import busy, progress
from ..values import parse_vary, values_of
from . import captions, tables
from .case import case_from, vary_from
from .options import FOLLOWED, KEPT, TRANSIENT

#: Most values of a diagram, and of an axis of a grid.
MOST = 10_000


def run(
    given: Given[LoadedScene], to: Destination, vary: str | None = None,
    transient: int | None = None, grid: tuple[str, ...] = (), **options: Any,
) -> int:  # fmt: skip
    """Simulate one motion, or many; the exit status."""
    if vary is not None and grid:
        raise Problem(f"--grid: got {grid[0]} beside --vary, expected one of them")
    if transient is not None and vary is None:
        raise Problem(f"--transient: got {transient}, expected beside --vary")
    if vary is None and not grid:
        return _one(given, to, **options)
    option = "--grid" if vary is None else "--vary"
    cycles = options.pop("cycles")
    for name, value in options.items():
        if value not in (None, 0.0):
            raise Problem(f"{flag(name)}: got {value} beside {option}")
    if cycles is not None and not float(cycles).is_integer():
        raise Problem(f"--cycles: got {cycles:g} beside {option}, expected a whole number")
    count = None if cycles is None else int(cycles)
    if vary is None:
        return _basins(given, to, grid, FOLLOWED if count is None else count)
    skipped = TRANSIENT if transient is None else transient
    return _diagram(given, to, vary, skipped, KEPT if count is None else count)


def _one(given: Given[LoadedScene], to: Destination, state: str | None, **options: Any) -> int:
    """Simulate one motion, show it, write it; the exit status."""
    start = None if state is None else _parsed(state)
    case = case_from(given)
    with as_problems(), busy(f"simulating {case.scene.name}"):
        motion = simulate(case, start, **options)
    text = cache(lambda: documents.text(motion.case, motion.as_dict(), ()))
    to.show(text, tables.transient(case, motion))
    if motion.ended:
        say(f"ended at t = {motion.time:.6g} s: {motion.ended}")
    figure = drawn_by("simulations.simulation_figure", motion)
    to.write(text, figure, rows=lambda: csv_rows.of_simulation(motion))
    return 1 if motion.ended else 0


def _parsed(text: str) -> tuple[float, float]:
    """Return displacement and velocity from ``X,V``."""
    try:
        x, v = (float(part) for part in text.split(","))
    except ValueError:
        raise Problem(
            f"--state: got {text!r}, expected displacement and velocity as X,V"
        ) from None
    return x, v


def _diagram(
    given: Given[LoadedScene], to: Destination, vary: str, transient: int, cycles: int
) -> int:
    """Draw a bifurcation diagram, write it; the exit status."""
    along = vary_from(given, vary, MOST, ":200")
    given.check_varies(along.parameter)
    case = case_from(given, **{along.parameter: along.first})
    with as_problems(of="--vary: "), progress(along.count, "simulate") as advance:
        arguments = transient, cycles, lambda value: advance(f"{along.flag} = {value:g}")
        result = diagram(case, along.parameter, values_of(along), *arguments)
    ended = sum(not len(states) for states in result.states)
    summary = f"{result!r}, {counted(sum(map(len, result.states)), 'state')}"
    at = f"; at {counted(ended, 'value')} the motion ends before they are seen"
    summary += at if ended else ""
    head = captions.caption(result.case, along)
    return _written(to, result, (head, summary), "simulations.diagram_figure")


def _basins(
    given: Given[LoadedScene], to: Destination, grid: tuple[str, ...], cycles: int
) -> int:
    """Draw basins of attraction, write them; the exit status."""
    from nonsmooth.workers import pool

    axes = {}
    for text in grid:
        along = parse_vary(text, False, ("x", "v"), MOST, "x=-2:2:50", float, "--grid")
        axes[along.parameter] = values_of(along)
    if len(axes) != 2 or len(grid) != 2:
        raise Problem(f"--grid: got {' and '.join(grid)}, expected one for x and one for v")
    case = case_from(given)
    with as_problems(), progress(len(axes["v"]), "simulate") as advance, pool() as executor:
        arguments = cycles, executor, lambda value: advance(f"v = {value:g}")
        result = basins(case, axes["x"], axes["v"], *arguments)
    longer = f"\nMore --cycles than {cycles} may settle what has not."
    found = str(result) + longer * bool((result.index == -1).any())
    said = captions.caption(result.case), found
    return _written(to, result, said, "simulations.basins_figure")


def _written(
    to: Destination, result: Basins | Diagram, said: tuple[str, str], figure: str
) -> int:
    """Show what is found of many motions, write it; the exit status."""
    text = cache(lambda: documents.text(result.case, result.as_dict(), ()))
    to.show(text, said)
    to.write(text, drawn_by(figure, result), rows=lambda: result.table().rows())
    return 0
