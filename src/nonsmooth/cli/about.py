"""Commands about one scene or one structure, whose parameters are flags or stand in a file."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import click
from click.shell_completion import CompletionItem

from ..nearest import nearest
from .case_files import read_case, tables_of
from .output import check_target

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene
    from nonsmooth.solver.space.structure import Structure

#: Before what flags give of a scene or a structure, among the arguments of a command.
PREFIX = "given_"


About = TypeVar("About", "LoadedScene", "Structure")


@dataclass(frozen=True)
class Given(Generic[About]):
    """What the command line gives of a scene or a structure.

    Parameters
    ----------
    about : scene or structure
        Which it is.
    file : Path or None
        Its case file.
    flags : mapping
        What its flags give, by the names of parameters.
    """

    about: About
    file: Path | None
    flags: Mapping[str, Any]

    def table(self) -> dict[str, object]:
        """Return what the case file gives; nothing without one.

        A `Problem` is raised if it cannot be read, or is not of this scene or structure.
        """
        return {} if self.file is None else read_case(self.file, tables_of(self.about.name))

    @property
    def where(self) -> str:
        """The case file, before what is wrong with its content."""
        return "" if self.file is None else f"{self.file}: "


def given(about: About, file: Path | None, arguments: Mapping[str, Any]) -> Given[About]:
    """Return what the arguments of a command give of a scene or a structure."""
    flags = {
        name.removeprefix(PREFIX): value
        for name, value in arguments.items()
        if name.startswith(PREFIX) and value is not None
    }
    return Given(about, file, flags)


@dataclass(frozen=True)
class Output:
    """What ``-o`` writes: a file that ends in one of the suffixes, else a folder.

    A command that makes a folder has no ``--json``, and makes it always.
    """

    help: str
    suffixes: tuple[str, ...] = ()

    def options(self) -> list[click.Parameter]:
        """Return ``--json`` and ``-o``."""
        file = bool(self.suffixes)
        json = click.Option(["--json", "json_"], is_flag=True, help="Print one JSON document.")
        output = click.Option(
            ["-o", "--output"], type=click.Path(path_type=Path), required=not file,
            help=self.help,
        )  # fmt: skip
        return [json, output] if file else [output]


class CommandAbout(click.Command):
    """A command about one scene or structure.

    Parameters
    ----------
    about : scene or structure
        What it is about.
    run : callable
        Takes what is given of it, then the other options by their names; the exit status.
    options : list of click.Parameter
        Those before ``--case``.
    parameters : list of click.Parameter
        Those of the scene or structure, and what stands below them.
    output : Output
        What it writes.
    help, epilog : str
        As click has them, with places for `words`.
    words : mapping
        What stands there, beside the name and the title.
    """

    def __init__(
        self, about: "LoadedScene | Structure", run: Callable[..., int],
        options: Iterable[click.Parameter], parameters: Iterable[click.Parameter],
        output: Output, help: str, epilog: str, words: Mapping[str, object],
    ) -> None:  # fmt: skip
        self.about, parameters = about, [*parameters]
        self.flags = [q.opts[0] for q in parameters if (q.name or "").startswith(PREFIX)]
        table = tables_of(about.name)[0]
        file = click.Option(
            ["--case"], type=click.Path(path_type=Path),
            help=f"Case file with a table [{table}]; flags override it.",
        )  # fmt: skip
        suffixes = output.suffixes

        def callback(case: Path | None, output: Path | None, **arguments: Any) -> int:
            if suffixes:
                check_target(output, suffixes)
            own = {q: arguments[q] for q in arguments if not q.startswith(PREFIX)}
            return run(given(about, case, arguments), **own, output=output)

        title = about.title[0].upper() + about.title[1:]
        words = {"name": about.name, "title": title, **words}
        super().__init__(
            name=about.name,
            callback=callback,
            params=[*options, file, *parameters, *output.options()],
            help=help.format(**words),
            epilog=epilog.format(**words).replace("  --", " --"),  # where nothing is named
        )


def flag(name: str) -> str:
    """Return the flag of a parameter."""
    return f"--{name.replace('_', '-')}"


def completed(names: Sequence[str], incomplete: str) -> list[CompletionItem]:
    """Return the names that what was typed can become."""
    return [CompletionItem(name) for name in names if name.startswith(incomplete)]


#: Flags of earlier versions, and what is asked in their place.
RENAMED = {"--c1-terms": "--functions K, with --method hb-ck,"}


def no_such_option(error: click.NoSuchOption) -> str:
    """Return what to say of a flag that a command does not have."""
    if error.option_name in RENAMED:
        return f"{error.option_name}: expected {RENAMED[error.option_name]} in its place"
    command = error.ctx.command if error.ctx else click.Command(None)
    flags = [name for q in command.params for name in q.opts if name.startswith("--")]
    meant = nearest(error.option_name.replace("_", "-"), [*flags, "--help"])
    about = command if isinstance(command, CommandAbout) else None
    of_what = f"{about.about.name} has no {error.option_name}." if about else error.message
    if meant:
        *others, last = meant
        return f"{of_what} Did you mean {', '.join(others)}{' or ' * bool(others)}{last}?"
    return f"{of_what} It has {', '.join(about.flags)}." if about else of_what
