"""Commands of a structure: the structure is the first argument, or a case file names it."""

from importlib import import_module
from typing import TYPE_CHECKING

import click

from ..about import CommandOfAny
from ..case_files import said_first

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


class StructureCommand(CommandOfAny):
    """A command that takes a structure as its first argument, and lists them without one."""

    def chosen(self, arguments: list[str]) -> tuple[click.Command, str, list[str]]:
        """Return the command that arguments mean, the structure as it is named, and the rest.

        Raises
        ------
        UsageError
            If there is no such structure.
        """
        said, rest = said_first(arguments, known)
        if said is None:
            return self, "", rest
        module = import_module(f".{self.name}", __package__)
        command: click.Command = module.command(structure_named(said), said)
        return command, said, rest

    def collect_usage_pieces(self, ctx: click.Context) -> list[str]:
        """Return what the usage line has behind the name of the command."""
        return ["[STRUCTURE]", *super().collect_usage_pieces(ctx)]

    def names(self) -> tuple[str, ...]:
        """Return the structures."""
        return known()
