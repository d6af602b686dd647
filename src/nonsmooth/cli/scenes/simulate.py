"""``nonsmooth simulate SCENE``: the motion from a given state, from event to event."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..about import Given, Output
from ..output import PICTURES, drawn_by, write_result
from ..problems import Problem, as_problems
from ..progress import busy, progress
from ..values import parse_vary, values_of
from .options import case_from, command_of, vary_from

if TYPE_CHECKING:
    from nonsmooth.solver.results.strobe import Basins, Diagram
    from nonsmooth.solver.scenes.loaded import LoadedScene

#: Periods that a diagram leaves out and keeps, and that a motion from a grid is followed.
TRANSIENT, KEPT, FOLLOWED = 200, 50, 100

#: Most values of a diagram, and of an axis of a grid.
MOST = 10_000

OUTPUT = Output(
    "Write the motion: .json, .csv; or a picture .png, .svg, .pdf.",
    (".json", ".csv", *PICTURES),
)

HELP = """Simulate {name} from a given state, from event to event.

{title}. Each phase is the exact flow of its equation, and no event can be stepped over. Which
phase follows is decided by what each demands."""

EPILOG = """\b
Examples:
  nonsmooth simulate {scene} --cycles 50
  nonsmooth simulate {scene} --state 0,0.1 -o transient.png
  nonsmooth simulate {scene} {flag} {value:g} --json
"""

#: Of scenes that something forces.
FORCED = """  nonsmooth simulate {scene} --vary {vary}:200 -o diagram.png
  nonsmooth simulate {scene} --grid x=-2:2:50 --grid v=-2:2:50
"""


def options(forced: bool = True) -> list[click.Parameter]:
    """Return the options of the command for a scene that something forces, or nothing."""
    return [
        click.Option(
            ["--state"], metavar="X,V",
            help="Displacement in m and velocity in m/s at the start, of a body those of its "
            "first contact.  [default: at rest at 0 or, where the scene does not admit that, "
            "near it]",
        ),
        click.Option(
            ["--cycles"], type=float,
            help="How many periods of the forcing; without forcing, how many times 2 pi of the "
            "scene's unit of time.  [default: 20]",
        ),
        click.Option(["--time"], type=float, help="How long in s, in place of --cycles."),
        *(_strobed() if forced else ()),
        click.Option(
            ["--forcing-phase"], type=float, default=0.0,
            help="Phase of the forcing at the start in rad.  [default: 0]",
        ),
    ]  # fmt: skip


def _strobed() -> list[click.Parameter]:
    """Return the options that look at motions once a period of the forcing."""
    return [
        click.Option(
            ["--vary"], metavar="NAME=FROM:TO:COUNT",
            help="Draw a bifurcation diagram: the states once a period of the forcing, behind "
            "a transient, as a parameter takes so many values.",
        ),
        click.Option(
            ["--transient"], type=int, metavar="CYCLES",
            help=f"Periods that --vary leaves out.  [default: {TRANSIENT}]",
        ),
        click.Option(
            ["--grid"], multiple=True, metavar="x=FROM:TO:COUNT",
            help="Draw basins of attraction: given twice, for x and v, where to start from.",
        ),
    ]  # fmt: skip


def command(scene: "LoadedScene", said: str) -> click.Command:
    """Return ``nonsmooth simulate`` of a scene, which the user called so."""
    forced = scene.frequency is not None
    epilog = EPILOG + FORCED if forced else EPILOG
    return command_of(scene, said, run, options(forced), OUTPUT, HELP, epilog)


def _parsed(text: str) -> tuple[float, float]:
    """Return displacement and velocity from ``X,V``."""
    try:
        x, v = (float(part) for part in text.split(","))
    except ValueError:
        raise Problem(
            f"--state: got {text!r}, expected displacement and velocity as X,V"
        ) from None
    return x, v


def run(
    given: "Given[LoadedScene]", json_: bool, output: Path | None, vary: str | None = None,
    transient: int | None = None, grid: tuple[str, ...] = (), **wanted: Any,
) -> int:  # fmt: skip
    """Simulate one motion, or many; the exit status."""
    if vary is not None and grid:
        raise Problem(f"--grid: got {grid[0]} beside --vary, expected one of them")
    if transient is not None and vary is None:
        raise Problem(f"--transient: got {transient}, expected beside --vary")
    if vary is None and not grid:
        return _one(given, json_, output, **wanted)
    other = "--vary" if grid == () else "--grid"
    cycles = wanted.pop("cycles")
    for name, value in wanted.items():
        if value not in (None, 0.0):
            raise Problem(f"--{name.replace('_', '-')}: got {value} beside {other}")
    if cycles is not None and not float(cycles).is_integer():
        raise Problem(f"--cycles: got {cycles:g} beside {other}, expected a whole number")
    count = None if cycles is None else int(cycles)
    if vary is None:
        return _basins(given, grid, FOLLOWED if count is None else count, json_, output)
    left = TRANSIENT if transient is None else transient
    return _diagram(given, vary, left, KEPT if count is None else count, json_, output)


def _one(
    given: "Given[LoadedScene]", json_: bool, output: Path | None, state: str | None,
    **wanted: Any,
) -> int:  # fmt: skip
    """Simulate one motion, show it, write it; the exit status."""
    from nonsmooth.files import csv_rows, documents
    from nonsmooth.solver.simulation.simulate import simulate

    start = None if state is None else _parsed(state)
    case = case_from(given)
    with as_problems(), busy(f"simulating {case.scene.name}"):
        motion = simulate(case, start, **wanted)
    text = documents.text(motion.case, motion.as_dict(), ())
    if json_:
        click.echo(text, nl=False)
    else:
        from .shown import captions, tables

        click.echo(captions.caption(case))
        tables.transient(motion)
    if motion.ended:
        click.echo(f"nonsmooth: ended at t = {motion.time:.6g} s: {motion.ended}", err=True)
    figure = drawn_by("simulations.simulation_figure", motion)
    write_result(output, text, figure, rows=lambda: csv_rows.of_simulation(motion))
    return 1 if motion.ended else 0


def _diagram(
    given: "Given[LoadedScene]", vary: str, transient: int, cycles: int, json_: bool,
    output: Path | None,
) -> int:  # fmt: skip
    """Draw a bifurcation diagram, write it; the exit status."""
    from nonsmooth.solver.scenes.parameter_error import ParameterError
    from nonsmooth.solver.strobe import diagram

    along = vary_from(given, vary, MOST, ":200")
    case = case_from(given, **{along.parameter: along.first})
    with as_problems(), progress(along.count, "simulate") as advance:

        def seen(value: float) -> None:
            advance(f"{along.flag} = {value:g}")

        try:
            result = diagram(case, along.parameter, values_of(along), transient, cycles, seen)
        except ParameterError as error:
            raise Problem(f"--vary: {error}") from error
    ended = sum(not len(each) for each in result.states)
    said = f"{result!r}, {sum(map(len, result.states))} states"
    said += f"; at {ended} the motion ends before" if ended else ""
    return _written(result, said, "strobe.diagram_figure", json_, output)


def _basins(
    given: "Given[LoadedScene]", grid: tuple[str, ...], cycles: int, json_: bool,
    output: Path | None,
) -> int:  # fmt: skip
    """Draw basins of attraction, write them; the exit status."""
    from nonsmooth.report.workers import pool
    from nonsmooth.solver.strobe import basins

    axes = {}
    for text in grid:
        along = parse_vary(text, False, ("x", "v"), MOST, "x=-2:2:50", float, "--grid")
        axes[along.parameter] = values_of(along)
    if len(axes) != 2 or len(grid) != 2:
        raise Problem(f"--grid: got {' and '.join(grid)}, expected one for x and one for v")
    case = case_from(given)
    with as_problems(), progress(len(axes["v"]), "simulate") as advance, pool() as executor:

        def seen(value: float) -> None:
            advance(f"v = {value:g}")

        result = basins(case, axes["x"], axes["v"], cycles, executor, seen)
    return _written(result, str(result), "strobe.basins_figure", json_, output)


def _written(
    result: "Basins | Diagram", said: str, figure: str, json_: bool, output: Path | None
) -> int:
    """Show what is found of many motions, write it; the exit status."""
    from nonsmooth.files import documents

    text = documents.text(result.case, result.as_dict(), ())
    if json_:
        click.echo(text, nl=False)
    else:
        from .shown import captions

        click.echo(captions.caption(result.case))
        click.echo(said)
    write_result(output, text, drawn_by(figure, result), rows=lambda: result.table().rows())
    return 0
