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
from ..solver.no_orbit import NoOrbit
from .case_files import read_case, tables_of
from .output import DATA, PICTURES, Destination, check_target
from .problems import Problem, tell

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene
    from nonsmooth.solver.space.structure import Structure

#: What a file is given as.
PATH = click.Path(path_type=Path)

#: Before what flags give of a scene or a structure, among the arguments of a command.
PREFIX = "given_"


About = TypeVar("About", "LoadedScene", "Structure")


@dataclass(frozen=True)
class Given(Generic[About]):
    """What the command line says of a scene or structure: case file, and flags of parameters.

    `said` is what the user called it; empty where nothing is named.
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
        """The case file, as the beginning of a message on its content."""
        return "" if self.file is None else f"{self.file}: "


@dataclass(frozen=True)
class Verb:
    """A command of a scene or structure: its function, help and options.

    Parameters
    ----------
    run : str
        A function and its module, which is imported to run.  It takes what is given of the
        scene or structure, where the result goes, and options; it returns the exit status, or
        raises a `NoOrbit`, which is told: that is status 1.
    help, examples : str
        As click has them, with places for words.
    options : callable
        Returns the options of a scene or structure that stand before ``--case``.
    file : str
        What ``-o`` writes, with the suffixes of data; a picture as well.
    folder : str
        What ``-o`` makes, always: there is no ``--json`` then.
    needs : tuple
        Libraries of extras without which it does nothing; see `require`.
    """

    run: str
    help: str
    examples: str
    options: Callable[[Any], list[click.Parameter]] = lambda about: []
    file: str = ""
    folder: str = ""
    needs: tuple[tuple[str, ...], ...] = ()

    @property
    def suffixes(self) -> tuple[str, ...]:
        """The endings of a file."""
        return (*(each for each in DATA if each in self.file), *PICTURES)

    @property
    def written(self) -> list[click.Parameter]:
        """The options ``--json`` and ``-o``."""
        json = option("--json json_", None, "Print one JSON document.")
        words = self.folder or f"Write {self.file}; or a picture {', '.join(PICTURES)}."
        output = option("-o --output", PATH, words, required=bool(self.folder))
        if self.folder:
            return [output]
        return [json, output] if self.file else [json]


@dataclass(frozen=True)
class Kind:
    """What a name stands for: scenes, or structures.

    The module ``commands`` of the package has ``command(verb, about, said)``, which makes the
    command; `word` stands for a name in the usage line.  `named` returns what a text names; a
    `UsageError` or `Problem` if there is no such thing.
    """

    package: str
    word: str
    names: Callable[[], tuple[str, ...]]
    named: Callable[[str], Any]


class BehindName(click.Command):
    """A command whose first argument may name something of one of these `kinds`."""

    kinds: tuple[Kind, ...] = ()

    def names(self) -> tuple[str, ...]:
        """Return the names of all shipped scenes or structures that may follow the command."""
        return tuple(name for kind in self.kinds for name in kind.names())

    def collect_usage_pieces(self, ctx: click.Context) -> list[str]:
        """Return what the usage line has behind the name of the command."""
        return [*(kind.word for kind in self.kinds[:1]), *super().collect_usage_pieces(ctx)]

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Complete names beside options."""
        return [*completed(self.names(), incomplete), *super().shell_complete(ctx, incomplete)]


class CommandAbout(BehindName):
    """What a verb does with one scene or structure, which the user called `said`, as a command.

    `parameters` are those of the scene or structure, and what stands below them; `words` are in
    help and epilog, beside the name, the title and what it was called.  Of `kinds` is what may
    be named in its place.
    """

    def __init__(
        self, about: Any, said: str, verb: Verb, parameters: Iterable[click.Parameter],
        words: Mapping[str, object], kinds: tuple[Kind, ...] = (),
    ) -> None:  # fmt: skip
        self.about, self.kinds, parameters = about, kinds, [*parameters]
        self.flags = [q.opts[0] for q in parameters if (q.name or "").startswith(PREFIX)]
        words_of_case = (
            f"Case file with a table [{tables_of(about.name)[0]}]; flags override it."
        )
        file = option("--case", PATH, words_of_case)

        def callback(
            case: Path | None, output: Path | None = None, json_: bool = False, **arguments: Any
        ) -> int:
            if verb.file:
                check_target(output, verb.suffixes)
            for library in verb.needs:
                require(*library)
            options = {q: arguments[q] for q in arguments if not q.startswith(PREFIX)}
            flags = {
                name.removeprefix(PREFIX): value
                for name, value in arguments.items()
                if name.startswith(PREFIX) and value is not None
            }
            module, _, name = verb.run.rpartition(".")
            run = getattr(import_module(module, __package__), name)
            given, to = Given(about, said, case, flags), Destination(json_, output)
            try:
                status: int = run(given, to, **options)
            except NoOrbit as finding:
                tell(finding)
                return 1
            return status

        title = about.title[0].upper() + about.title[1:]
        called = f" {said}" if said else ""
        words = {"name": about.name, "title": title, "said": called, **words}
        super().__init__(
            name=about.name,
            callback=callback,
            params=[*verb.options(about), file, *parameters, *verb.written],
            help=verb.help.format(**words),
            epilog="\b\nExamples:\n" + verb.examples.format(**words),
        )


def option(
    names: str, type_: Any, help_: str, kind: type[click.Option] = click.Option, **settings: Any
) -> click.Option:
    """Return an option from its flags and name; without a type it is a switch."""
    how = {"is_flag": True} if type_ is None else {"type": type_}
    return kind(names.split(), help=help_, **how, **settings)


def flag(name: str) -> str:
    """Return the flag of a parameter."""
    return f"--{name.replace('_', '-')}"


def completed(names: Sequence[str], incomplete: str) -> list[CompletionItem]:
    """Return the names that what was typed can become."""
    return [CompletionItem(name) for name in names if name.startswith(incomplete)]


#: Flags of commands that look once a period of the forcing, where something forces.
OF_FORCED = "--vary", "--grid", "--transient", "--cycles", "--attractors"

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
    if error.option_name == "--motion" and about and not getattr(about.about, "motions", True):
        return f"--motion: {about.about.name} has one motion, which needs no name"
    of_forced = error.option_name in OF_FORCED
    if about and of_forced and getattr(about.about, "frequency", "") is None:
        return f"{error.option_name}: nothing forces {about.about.name}"
    of_what = f"{about.about.name} has no {error.option_name}." if about else error.message
    if meant:
        *others, last = meant
        return f"{of_what} Did you mean {', '.join(others)}{' or ' * bool(others)}{last}?"
    return f"{of_what} It has {', '.join(about.flags)}." if about else of_what
