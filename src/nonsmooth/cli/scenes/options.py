"""The flags of a scene, and the case that they and a case file describe."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.shell_completion import CompletionItem

from ..case_files import read_case
from ..problems import Problem, Verbose, as_problems
from .named import known

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene, Parameter

#: Before the names of a scene's parameters among the arguments of a command.
PREFIX = "of_scene_"


class CommandOfScene(click.Command):
    """A command built for a scene."""

    def __init__(self, scene: "LoadedScene", **options: Any) -> None:
        super().__init__(**options)
        self.scene = scene

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Complete options, and scenes where none is named."""
        found = super().shell_complete(ctx, incomplete)
        if " " in (ctx.info_name or "") or incomplete[:1] == "-":
            return found
        return [CompletionItem(name) for name in known() if name.startswith(incomplete)] + found


def motion_options(scene: "LoadedScene") -> list[click.Parameter]:
    """Return the options that say which motion of a scene is meant."""
    found: list[click.Parameter] = []
    if scene.motions:
        words = f"{', '.join(scene.motions)}; without it, the one that there is."
        found.append(click.Option(["--motion"], help=words))
    if scene.frequency is not None:
        odd = ", an odd number" if scene.module.HALF_PERIOD else ""
        words = f"Periods of the forcing in one of the motion{odd}.  [default: 1]"
        found.append(click.Option(["--cycles"], type=int, metavar="n", help=words))
    return found


def command_of(
    scene: "LoadedScene", callback: Callable[..., int], options: list[click.Parameter],
    help_: str, epilog: str,
) -> click.Command:  # fmt: skip
    """Return a command of a scene: its own options, then ``--case`` and the parameters."""
    return CommandOfScene(
        scene,
        name=scene.name,
        callback=callback,
        params=[*options[:-2], *_parameter_options(scene), Verbose(), *options[-2:]],
        help=help_,
        epilog=epilog,
    )


def flag(parameter: "Parameter") -> str:
    """Return the flag of a parameter."""
    return f"--{parameter.name.replace('_', '-')}"


def _parameter_options(scene: "LoadedScene") -> list[click.Parameter]:
    table = _tables(scene)[0]
    file = click.Option(
        ["--case"],
        type=click.Path(path_type=Path),
        help=f"Case file with a table [{table}]; flags override it.",
    )
    flags = [
        click.Option([flag(q), PREFIX + q.name], type=float, help=_help(q))
        for q in scene.parameters
    ]
    return [file, *flags]


def _help(q: "Parameter") -> str:
    unit = f" in {q.unit}" if q.unit else ""
    return f"{q.symbol}{unit}: {q.what}; {q.expected}.  [default: {q.default:g}]"


def _tables(scene: "LoadedScene") -> tuple[str, str]:
    return scene.name.replace("-", "_"), scene.name


def case_from(scene: "LoadedScene", file: Path | None, flags: Mapping[str, Any]) -> "Case":
    """Return the case that the command line describes, of the motion that it names if any.

    Without a case file, what no flag gives has its default.

    Raises
    ------
    Problem
        With all mistakes at once.
    """
    from nonsmooth.kim_perkins import as_in_paper
    from nonsmooth.solver.scenes.parameter_error import ParameterError

    given = {
        name.removeprefix(PREFIX): value
        for name, value in flags.items()
        if value is not None and name.startswith(PREFIX)
    }
    cycles, motion = flags.get("cycles"), flags.get("motion")
    table = {} if file is None else read_case(file, _tables(scene))
    missing = [
        f"{q.name}: missing, expected {q.what}{f' in {q.unit}' if q.unit else ''}"
        for q in scene.parameters
        if file is not None and q.name not in table and q.name not in given
    ]
    wrong: list[str] = []
    try:
        case = as_in_paper(scene(**(table | given), cycles=1 if cycles is None else cycles))
    except ParameterError as error:
        wrong = [_as_flag(line) for line in error.errors]
    where = f"{file}: " if file else ""
    if wrong or missing:  # a name that is misspelled before that which it should have been
        first, *others = wrong + missing
        raise Problem(where + first, below=others)
    with as_problems():
        return case if motion is None else case.of_motion(motion)


def _as_flag(line: str) -> str:
    """Return what is wrong with a case; the cycles, which no table has, by their flag."""
    return f"--{line}" if line.startswith("cycles: ") else line
