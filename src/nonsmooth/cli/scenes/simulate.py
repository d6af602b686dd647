"""``nonsmooth simulate SCENE``: the motion from a given state, from event to event."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..about import Given, Output
from ..output import PICTURES, drawn_by, write_result
from ..problems import Problem, as_problems
from ..progress import busy
from .options import case_from, command_of

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene

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


def options() -> list[click.Parameter]:
    """Return the options that the command has for every scene."""
    return [
        click.Option(
            ["--state"], metavar="X,V",
            help="Displacement in m and velocity in m/s at the start.  [default: at rest at 0 "
            "or, where the scene does not admit that, near it]",
        ),
        click.Option(
            ["--cycles"], type=float,
            help="How many periods of the forcing; without forcing, how many times 2 pi of the "
            "scene's unit of time.  [default: 20]",
        ),
        click.Option(["--time"], type=float, help="How long in s, in place of --cycles."),
        click.Option(
            ["--forcing-phase"], type=float, default=0.0,
            help="Phase of the forcing at the start in rad.  [default: 0]",
        ),
    ]  # fmt: skip


def command(scene: "LoadedScene", said: str) -> click.Command:
    """Return ``nonsmooth simulate`` of a scene, which the user called so."""
    return command_of(scene, said, run, options(), OUTPUT, HELP, EPILOG)


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
    given: "Given[LoadedScene]", state: str | None, json_: bool, output: Path | None,
    **wanted: Any,
) -> int:  # fmt: skip
    """Simulate, show it, write it; the exit status."""
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
        from .shown import captions, transient

        click.echo(captions.caption(case))
        transient.table(motion)
    if motion.ended:
        click.echo(f"nonsmooth: ended at t = {motion.time:.6g} s: {motion.ended}", err=True)
    figure = drawn_by("simulations.simulation_figure", motion)
    write_result(output, text, figure, rows=lambda: csv_rows.of_simulation(motion))
    return 1 if motion.ended else 0
