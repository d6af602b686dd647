"""A command of the default scene that becomes one of another where that is named first."""

from importlib import import_module
from typing import Any

import click

from ..about import CommandOfAny
from ..case_files import said_first
from ..space.named import is_structure, structure_named
from ..space.named import known as known_structures
from .named import DEFAULT, known, scene_named


class SceneCommand(CommandOfAny):
    """A command that takes a scene as its first argument.

    Parameters
    ----------
    module : str
        Of this package: its ``command(scene, said)`` makes the command of another scene; its
        ``named(text)``, if it has one, finds the scene in place of `scene_named`.
    all_without : bool
        Whether the command without a scene is about all of them, and not the default one.
    own : bool
        Whether this is itself the command of the default scene, with more than others have.
    structures : bool
        Whether it takes structures as well, by a module of the same name.
    """

    def __init__(
        self, *arguments: Any, module: str, all_without: bool = False, own: bool = True,
        structures: bool = False, **options: Any,
    ) -> None:  # fmt: skip
        super().__init__(*arguments, **options)
        self.module, self.all_without, self.own = module, all_without, own
        self.structures = structures

    def chosen(self, arguments: list[str]) -> tuple[click.Command, str, list[str]]:
        """Return the command that arguments mean, the scene as it is named, and the rest.

        The scene is the first argument, or the one that the table of a case file names.

        Raises
        ------
        UsageError, Problem
            If there is no such scene, or its file is not as it must be.
        """
        command: click.Command
        scene, rest = said_first(arguments, self._known)
        if scene is not None and self.structures and is_structure(scene):
            module = import_module(f"..space.{self.module}", __package__)
            command = module.command(structure_named(scene), scene)
            return command, scene, rest
        if scene is None and (self.own or self.all_without):
            return self, "", rest
        name = DEFAULT if scene is None else scene
        if self.own and not self.all_without and name.replace("_", "-") == DEFAULT:
            return self, DEFAULT, rest
        module = import_module(f".{self.module}", __package__)
        found = getattr(module, "named", scene_named)(name)
        command = module.command(found, scene or "")
        return command, scene or "", rest

    def _known(self) -> set[str]:
        """Return the names that a table of a case file may have."""
        return {*known(), *(known_structures() if self.structures else ())} - {DEFAULT}

    def collect_usage_pieces(self, ctx: click.Context) -> list[str]:
        """Return what the usage line has behind the name of the command."""
        pieces = super().collect_usage_pieces(ctx)
        named = (ctx.info_name or "").endswith(f" {DEFAULT}")
        return pieces if named else ["[SCENE]", *pieces]

    def names(self) -> tuple[str, ...]:
        """Return the scenes that come with the program."""
        return known()
