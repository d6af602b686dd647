"""The flags of a scene, and the case that they and a case file describe."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import click
from click.shell_completion import CompletionItem

from ..about import PREFIX, CommandAbout, Given, Output, completed, flag
from ..problems import Problem, Verbose, as_problems
from ..values import Vary, parse_vary
from .named import known

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.loaded import LoadedScene, Parameter


class CommandOfScene(CommandAbout):
    """A command built for a scene."""

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Complete options, and scenes where none is named."""
        scenes = () if " " in (ctx.info_name or "") else known()
        return [*completed(scenes, incomplete), *super().shell_complete(ctx, incomplete)]


def command_of(
    scene: "LoadedScene", said: str, run: Callable[..., int], options: list[click.Parameter],
    output: Output, help_: str, epilog: str,
) -> click.Command:  # fmt: skip
    """Return a command of a scene, which the user called so; see `CommandAbout`."""
    last = scene.parameters[-1]
    words = {
        "scene": said,
        "best": method_names(scene)[-1],
        "flag": flag(last.name),
        "value": last.default,
        "vary": f"{flag(last.name)[2:]}={last.default / 2:g}:{last.default:g}",
    }
    parameters = [
        *(click.Option([flag(q.name), PREFIX + q.name], type=float, help=_help(q))
          for q in scene.parameters),
        Verbose(),
    ]  # fmt: skip
    return CommandOfScene(scene, run, options, parameters, output, help_, epilog, words)


def motion_options(scene: "LoadedScene") -> list[click.Parameter]:
    """Return the options that say which motion of a scene is meant."""
    found: list[click.Parameter] = []
    if scene.motions:
        words = f"{', '.join(scene.motions)}; without it, the one that there is."
        found.append(click.Option(["--motion", f"{PREFIX}motion"], help=words))
    words = "An order of phases: names joined by commas, a minus before a mirrored one."
    found.append(click.Option(["--phases", f"{PREFIX}phases"], metavar="NAMES", help=words))
    if scene.frequency is not None:
        odd = ", an odd number" if scene.half_period else ""
        words = f"Periods of the forcing in one of the motion{odd}.  [default: 1]"
        names = ["--cycles", f"{PREFIX}cycles"]
        found.append(click.Option(names, type=int, metavar="n", help=words))
    return found


def method_names(scene: "LoadedScene") -> list[str]:
    """Return the methods of a scene as they are shown, in their order."""
    from nonsmooth.solver.kernels.registry import methods
    from nonsmooth.solver.scenes.methods import in_order, shown

    return [shown(scene, method) for method in in_order(methods(scene))]


def vary_from(
    given: "Given[LoadedScene]",
    text: str,
    most: int | None,
    points: str = "",
    log: bool = False,
) -> Vary[float]:
    """Return what ``--vary`` asks for, of a scene; see `parse_vary`."""
    names, last = [q.name for q in given.about.parameters], given.about.parameters[-1]
    example = f"{flag(last.name)[2:]}={last.default / 2:g}:{last.default or 1:g}{points}"
    return parse_vary(text, log, names, most, example, float)


def check_not_given(given: "Given[LoadedScene]", vary: Vary[float]) -> None:
    """Check that no flag gives a parameter that varies; a `Problem` if one does."""
    if vary.parameter in given.flags:
        raise Problem(f"--{vary.flag}: given beside --vary {vary.flag}, which sets it")


def _help(q: "Parameter") -> str:
    unit = f" in {q.unit}" if q.unit else ""
    return f"{q.symbol}{unit}: {q.what}; {q.expected}.  [default: {q.default:g}]"


def case_from(given: "Given[LoadedScene]", **others: float) -> "Case":
    """Return the case that the command line describes, of the motion that it names if any.

    Without a case file, what no flag gives has its default; `others` is given beside them.  A
    `Problem` has all mistakes at once.
    """
    from nonsmooth.kim_perkins import as_in_paper
    from nonsmooth.solver.scenes.case import Case
    from nonsmooth.solver.scenes.parameter_error import ParameterError
    from nonsmooth.solver.solve import with_order

    scene, flags = given.about, {**given.flags, **others}
    motion, phases = (flags.pop(name, None) for name in ("motion", "phases"))
    if motion is not None and phases is not None:
        raise Problem(f"--phases: got {phases} beside --motion {motion}, expected one of them")
    cycles = flags.pop("cycles", 1)
    table = given.table()
    missing = [
        f"{q.name}: missing, expected {q.what}{f' in {q.unit}' if q.unit else ''}"
        for q in scene.parameters
        if given.file is not None and q.name not in table and q.name not in flags
    ]
    wrong: list[str] = []
    try:
        own = 1 if phases is not None else cycles  # those of its order
        case = as_in_paper(Case(scene, table | flags, own))
    except ParameterError as error:
        wrong = [_as_flag(line) for line in error.errors]
    if wrong or missing:  # a name that is misspelled before that which it should have been
        first, *more = wrong + missing
        raise Problem(given.where + first, below=more)
    with as_problems():
        if phases is not None:
            return with_order(case, str(phases), cycles)
        return case if motion is None else case.of_motion(motion)


def _as_flag(line: str) -> str:
    """Return what is wrong with a case; the cycles, which no table has, by their flag."""
    return f"--{line}" if line.startswith("cycles: got") else line
