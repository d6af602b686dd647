"""``nonsmooth simulate SCENE``: the motion from a given state, from event to event."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..output import PICTURES, check_target, write_picture, write_text, write_whole
from ..problems import Problem
from ..progress import busy
from .options import case_from, command_of

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene
    from nonsmooth.solver.simulation.record import Simulation

#: What a motion can be written as.
SUFFIXES = (".json", ".csv", *PICTURES)

HELP = """Simulate {name} from a given state, from event to event.

{title}. Each phase is the exact flow of its equation, and no event can be stepped over. Which
phase follows is decided by what each demands."""

EPILOG = """\b
Examples:
  nonsmooth simulate {scene} --cycles 50
  nonsmooth simulate {scene} --state 0,0.1 -o transient.png
  nonsmooth simulate {scene} --{flag} {value:g} --json
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
        click.Option(["--json", "json_"], is_flag=True, help="Print one JSON document."),
        click.Option(
            ["-o", "--output"], type=click.Path(path_type=Path),
            help="Write the motion: .json, .csv; or a picture .png, .svg, .pdf.",
        ),
    ]  # fmt: skip


def command(scene: "LoadedScene", said: str) -> click.Command:
    """Return ``nonsmooth simulate`` of a scene, which the user called so."""

    def callback(
        state: str | None, cycles: float | None, time: float | None, forcing_phase: float,
        case: Path | None, json_: bool, output: Path | None, **flags: Any,
    ) -> int:  # fmt: skip
        check_target(output, SUFFIXES)
        start = None if state is None else _parsed(state)
        wanted = {"cycles": cycles, "time": time, "forcing_phase": forcing_phase}
        return run(case_from(scene, case, flags), start, wanted, json_, output)

    words = {"name": scene.name, "title": scene.title[0].upper() + scene.title[1:]}
    last = scene.parameters[-1]
    examples = {"flag": last.name.replace("_", "-"), "value": last.default}
    epilog = EPILOG.format(scene=said, **examples).replace("simulate  ", "simulate ")
    return command_of(scene, callback, options(), HELP.format(**words), epilog)


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
    case: "Case", state: tuple[float, float] | None, wanted: dict[str, Any], json_: bool,
    output: Path | None,
) -> int:  # fmt: skip
    """Simulate, show it, write it; the exit status."""
    from nonsmooth.solver.simulation.simulate import simulate

    try:
        with busy(f"simulating {case.scene.name}"):
            motion = simulate(case, state, **wanted)
    except ValueError as error:
        name, _, rest = str(error).partition(": ")
        raise Problem(f"--{name.replace('_', '-')}: {rest}") from error
    text = _text(motion)
    if json_:
        click.echo(text, nl=False)
    else:
        from .shown import captions, transient

        click.echo(captions.caption(case))
        transient.table(motion)
    if motion.ended:
        click.echo(f"nonsmooth: ended at t = {motion.time:.6g} s: {motion.ended}", err=True)
    if output is not None:
        _write(output, text, motion)
    return 1 if motion.ended else 0


def _text(motion: "Simulation") -> str:
    from nonsmooth.files import documents

    return documents.text(motion.case, motion.as_dict(), ())


def _write(output: Path, text: str, motion: "Simulation") -> None:
    suffix = output.suffix.lower()
    if suffix == ".json":
        write_text(output, text)
    elif suffix == ".csv":
        from nonsmooth.files import csv_rows

        rows = csv_rows.of_simulation(motion)
        write_whole(output, lambda target: csv_rows.write(target, rows))
    else:
        from nonsmooth.plots.simulations import simulation_figure

        write_picture(output, lambda: simulation_figure(motion))
