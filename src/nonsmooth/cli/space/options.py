"""The flags of a structure, and what they and a case file describe."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..case_files import read_case
from ..problems import Problem

if TYPE_CHECKING:
    from nonsmooth.solver.space.attached import Attached
    from nonsmooth.solver.space.structure import Structure

#: Before the names of a structure's parameters among the arguments of a command.
PREFIX = "of_structure_"


class CommandOfStructure(click.Command):
    """A command built for a structure: an unknown option may be a parameter misspelled."""

    def __init__(self, structure: "Structure", **options: Any) -> None:
        super().__init__(**options)
        self.structure = structure

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Parse arguments; say which parameters there are where one is unknown."""
        try:
            return super().parse_args(ctx, args)
        except click.NoSuchOption as error:
            flags = ["--position", *map(flag, (q.name for q in self.structure.parameters))]
            given = str(error.option_name)
            close = get_close_matches(given, [*flags, *(error.possibilities or ())], 1)
            hint = f"Did you mean {close[0]}?" if close else f"It has {', '.join(flags)}."
            raise click.UsageError(
                f"{self.structure.name} has no {given}. {hint}", ctx
            ) from error


def command_of(
    structure: "Structure", callback: Callable[..., int], options: list[click.Parameter],
    help_: str, epilog: str,
) -> click.Command:  # fmt: skip
    """Return a command of a structure: its own options, then ``--case`` and the parameters."""
    return CommandOfStructure(
        structure,
        name=structure.name,
        callback=callback,
        params=[*options[:-2], *_parameter_options(structure), *options[-2:]],
        help=help_,
        epilog=epilog,
    )


def flag(name: str) -> str:
    """Return the flag of a parameter."""
    return f"--{name.replace('_', '-')}"


def _parameter_options(structure: "Structure") -> list[click.Parameter]:
    table = structure.name.replace("-", "_")
    help_ = f"Case file with a table [{table}]; flags override it."
    file = click.Option(["--case"], type=click.Path(path_type=Path), help=help_)
    place = click.Option(
        ["--position", f"{PREFIX}position"],
        help="a: place of the attachment as a part of the length, a fraction or a decimal; of "
        "a fraction nodes are recognised exactly.  [default: 3/10]",
    )
    flags = [
        click.Option(
            [flag(q.name), PREFIX + q.name],
            type=float,
            help=f"{q.symbol} in {q.unit}: {q.what}, {_range(structure, q.name)}.  "
            f"[default: {q.default:g}]",
        )
        for q in structure.parameters
    ]
    return [file, place, *flags]


def _range(structure: "Structure", name: str) -> str:
    spring = structure.kind == "stiffness" and name == structure.attached.name
    return "above the critical one, not 0" if spring else "above 0"


def attached_from(
    structure: "Structure", file: Path | None, flags: Mapping[str, Any]
) -> "Attached":
    """Return the structure that the command line describes.

    What neither a flag nor the case file gives has its default.

    Raises
    ------
    Problem
        With all mistakes at once.
    """
    from nonsmooth.solver.scenes.parameter_error import ParameterError
    from nonsmooth.solver.space.attached import attach

    given = {
        name.removeprefix(PREFIX): value for name, value in flags.items() if value is not None
    }
    tables = (structure.name.replace("-", "_"), structure.name)
    table: dict[str, Any] = {} if file is None else dict(read_case(file, tables))
    try:
        return attach(structure, **(table | given))
    except ParameterError as error:
        where = f"{file}: " if file else ""
        said = (_as_flag(each) if file is None else each for each in error.errors)
        raise Problem(where + "; ".join(said)) from error


def _as_flag(error: str) -> str:
    name, colon, rest = error.partition(": ")
    return f"{flag(name)}{colon}{rest}" if colon and " " not in name else error


@contextmanager
def as_problems(names: Mapping[str, str] | None = None) -> Iterator[None]:
    """Turn a wrong argument into the problem of its option; `names` where that is another."""
    try:
        yield
    except ValueError as error:
        name, _, rest = str(error).partition(": ")
        raise Problem(f"--{(names or {}).get(name, name)}: {rest}") from error
