"""Commands whose first argument names a scene or a structure, and become commands of that."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import click
from click.shell_completion import CompletionItem

from .about import completed
from .case_files import said_first
from .scenes import named as scenes
from .space import named as structures


@dataclass(frozen=True)
class Kind:
    """What can be named: scenes, or structures.

    Parameters
    ----------
    package : str
        Where the commands about one of them are.
    word : str
        What stands for a name in the usage line.
    known : callable
        Returns the names that come with the program.
    named : callable
        Returns what a text names; a `UsageError` or `Problem` if there is no such thing.
    """

    package: str
    word: str
    known: Callable[[], tuple[str, ...]]
    named: Callable[[str], Any]


SCENES = Kind("scenes", "[SCENE]", scenes.known, scenes.scene_named)
STRUCTURES = Kind("space", "[STRUCTURE]", structures.known, structures.structure_named)


class NamedCommand(click.Command):
    """A command that becomes that of the scene or structure that its arguments name.

    Parameters
    ----------
    kinds : tuple of Kind
        What its first argument may name. The module of its name in the package of a kind has
        ``command(about, said)``, which makes the command.
    default : str or None
        What is meant where nothing is named; without it, this command itself.
    own : bool
        Whether this is itself the command of the default, with more than others have.
    """

    def __init__(
        self, *arguments: Any, kinds: tuple[Kind, ...] = (SCENES,),
        default: str | None = scenes.DEFAULT, own: bool = False, **options: Any,
    ) -> None:  # fmt: skip
        super().__init__(*arguments, **options)
        self.kinds, self.default, self.own = kinds, default, own

    def chosen(self, arguments: list[str]) -> tuple[click.Command, str, list[str]]:
        """Return the command that arguments mean, what it is about as named, and the rest.

        That is the first argument, or what the table of a case file names.

        Raises
        ------
        UsageError, Problem
            If there is no such scene or structure, or its file is not as it must be.
        """
        said, rest = said_first(arguments, lambda: {*self.names()} - {self.default})
        name = self.default if said is None else said
        if name is None or (said is None and self.own):
            return self, "", rest
        dashed = name.replace("_", "-")
        if self.own and dashed == self.default:
            return self, dashed, rest
        kind = next((q for q in self.kinds if dashed in q.known()), self.kinds[0])
        module = import_module(f".{kind.package}.{self.name}", __package__)
        command: click.Command = module.command(kind.named(name), said or "")
        return command, said or "", rest

    def names(self) -> tuple[str, ...]:
        """Return what may be named and comes with the program."""
        return tuple(name for kind in self.kinds for name in kind.known())

    def collect_usage_pieces(self, ctx: click.Context) -> list[str]:
        """Return what the usage line has behind the name of the command."""
        pieces = super().collect_usage_pieces(ctx)
        named = (ctx.info_name or "").endswith(f" {self.default}")
        return pieces if named else [self.kinds[0].word, *pieces]

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Complete names beside options."""
        return [*completed(self.names(), incomplete), *super().shell_complete(ctx, incomplete)]
