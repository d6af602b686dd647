"""Commands about one scene or one structure, whose parameters are flags or stand in a file."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import click
from click.shell_completion import CompletionItem

from ..extras import require
from ..nearest import nearest
from .case_files import read_case, tables_of
from .output import Destination, check_target
from .problems import Problem

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
    said : str
        What the user called it; empty where nothing is named.
    file : Path or None
        Its case file.
    flags : mapping
        What its flags give, by the names of parameters.
    """

    about: About
    said: str
    file: Path | None
    flags: Mapping[str, Any]

    def table(self) -> dict[str, object]:
        """Return what the case file gives; nothing without one.

        A `Problem` is raised if it cannot be read, or is not of this scene or structure.
        """
        return {} if self.file is None else read_case(self.file, tables_of(self.about.name))

    def check_varies(self, name: str) -> None:
        """Check that no flag gives a parameter that varies; a `Problem` if one does."""
        if name in self.flags:
            said = flag(name)
            raise Problem(f"{said}: given beside --vary {said[2:]}, which sets it")

    @property
    def where(self) -> str:
        """The case file, before what is wrong with its content."""
        return "" if self.file is None else f"{self.file}: "


def given(
    about: Any, file: Path | None, arguments: Mapping[str, Any], said: str = ""
) -> Given[Any]:
    """Return what the arguments of a command give of a scene or a structure."""
    flags = {
        name.removeprefix(PREFIX): value
        for name, value in arguments.items()
        if name.startswith(PREFIX) and value is not None
    }
    return Given(about, said, file, flags)


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


@dataclass(frozen=True)
class Verb(Generic[About]):
    """What a command does with the scene or structure that is named.

    Parameters
    ----------
    module : str
        Which has ``run(given, to, **options)``: it takes what is given of the scene or
        structure and where the result goes, and returns the exit status.
    options : callable
        Returns the options of a scene or structure that stand before ``--case``.
    output : Output
        What is written.
    help, epilog : str
        As click has them, with places for words.
    needs : tuple
        Libraries of extras without which it does nothing; see `require`.
    """

    module: str
    options: Callable[[About], list[click.Parameter]]
    output: Output
    help: str
    epilog: str
    needs: tuple[tuple[str, ...], ...] = ()


class CommandAbout(click.Command):
    """A command about one scene or structure.

    Parameters
    ----------
    about : scene or structure
        What it is about.
    said : str
        What the user called it.
    verb : Verb
        What is done with it; the module is imported when it runs.
    parameters : list of click.Parameter
        Those of the scene or structure, and what stands below them.
    words : mapping
        What stands in help and epilog, beside the name, the title and what it was called.
    """

    def __init__(
        self, about: "LoadedScene | Structure", said: str, verb: Verb[Any],
        parameters: Iterable[click.Parameter], words: Mapping[str, object],
    ) -> None:  # fmt: skip
        self.about, parameters = about, [*parameters]
        self.flags = [q.opts[0] for q in parameters if (q.name or "").startswith(PREFIX)]
        table = tables_of(about.name)[0]
        file = click.Option(
            ["--case"], type=click.Path(path_type=Path),
            help=f"Case file with a table [{table}]; flags override it.",
        )  # fmt: skip

        def callback(
            case: Path | None, output: Path | None, json_: bool = False, **arguments: Any
        ) -> int:
            if verb.output.suffixes:
                check_target(output, verb.output.suffixes)
            for library in verb.needs:
                require(*library)
            own = {q: arguments[q] for q in arguments if not q.startswith(PREFIX)}
            run = import_module(verb.module, __package__).run
            status: int = run(
                given(about, case, arguments, said), Destination(json_, output), **own
            )
            return status

        title = about.title[0].upper() + about.title[1:]
        words = {"name": about.name, "title": title, "said": said, **words}
        super().__init__(
            name=about.name,
            callback=callback,
            params=[*verb.options(about), file, *parameters, *verb.output.options()],
            help=verb.help.format(**words),
            epilog=_without_gaps(verb.epilog.format(**words)),
        )


def _without_gaps(examples: str) -> str:
    """Return examples without the spaces that are left where nothing is named."""
    lines = examples.replace("  --", " --").split("\n")
    return "\n".join(line.rstrip() for line in lines)


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
    if getattr(command, "default", "") is None:  # it is about nothing as yet
        expected = "expected STRUCTURE before it, or a case file with a table of one"
        return f"{error.option_name}: {expected}"
    of_what = f"{about.about.name} has no {error.option_name}." if about else error.message
    if meant:
        *others, last = meant
        return f"{of_what} Did you mean {', '.join(others)}{' or ' * bool(others)}{last}?"
    return f"{of_what} It has {', '.join(about.flags)}." if about else of_what
