"""Commands of a structure: the structure is the first argument, or a case file names it."""

from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.shell_completion import CompletionItem

from ..case_files import read_toml
from ..problems import Problem

if TYPE_CHECKING:
    from nonsmooth.solver.space.structure import Structure


def known() -> tuple[str, ...]:
    """Return the names of the structures."""
    from nonsmooth.solver.space.structure import names

    return names()


def is_structure(name: str | None) -> bool:
    """Whether a text is the name of a structure."""
    return name is not None and name.replace("_", "-") in known()


def structure_named(name: str) -> "Structure":
    """Return a structure by its name.

    Raises
    ------
    UsageError
        Naming the nearest structure that there is.
    """
    from nonsmooth.solver.space.structure import UnknownStructure, load

    try:
        return load(name)
    except UnknownStructure as error:
        context = click.get_current_context(silent=True)
        raise click.UsageError(str(error), context) from error


class StructureCommand(click.Command):
    """A command that takes a structure as its first argument, and lists them without one."""

    def collect_usage_pieces(self, ctx: click.Context) -> list[str]:
        """Return what the usage line has behind the name of the command."""
        return ["[STRUCTURE]", *super().collect_usage_pieces(ctx)]

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Complete structures beside options."""
        names = [CompletionItem(name) for name in known() if name.startswith(incomplete)]
        return [*names, *super().shell_complete(ctx, incomplete)]


def resolved(
    name: str | None, command: click.Command | None, arguments: list[str], *, quiet: bool
) -> tuple[str | None, click.Command | None, list[str]]:
    """Return a command of the command line as its arguments mean it, with its whole name.

    Parameters
    ----------
    name, command, arguments
        As click has them.
    quiet : bool
        Whether a structure that is not there is passed over, as for completion.
    """
    ours = isinstance(command, StructureCommand)
    if not ours and name != "sweep":
        return name, command, arguments
    named = bool(arguments) and not arguments[0].startswith("-")
    said = arguments[0] if named else _of_case_file(arguments)
    if said is None or (not is_structure(said) and (quiet or not ours)):
        return name, command, arguments
    build = import_module(f".{name}", __package__).command
    chosen: click.Command = build(structure_named(said), said)
    return f"{name} {said}", chosen, arguments[1:] if named else arguments


def _of_case_file(arguments: Sequence[str]) -> str | None:
    """Return the structure that a case file is of; what is wrong with it is said later."""
    path = None
    for argument, value in zip(arguments, [*arguments[1:], ""], strict=False):
        if argument == "--case":
            path = value
        elif argument.startswith("--case="):
            path = argument.removeprefix("--case=")
    if not path:
        return None
    try:
        content: dict[str, Any] = read_toml(Path(path))
    except Problem:
        return None
    found = [name for name in content if is_structure(name)]
    return found[0].replace("_", "-") if len(content) == 1 and found else None
