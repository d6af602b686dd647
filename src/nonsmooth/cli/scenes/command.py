"""A command of the default scene that becomes one of another where that is named first."""

from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

import click
from click.shell_completion import CompletionItem

from ..case_files import read_toml
from ..problems import Problem
from .default import DEFAULT
from .named import known, scene_named


class SceneCommand(click.Command):
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
    """

    def __init__(
        self, *arguments: Any, module: str, all_without: bool = False, own: bool = True,
        **options: Any,
    ) -> None:  # fmt: skip
        super().__init__(*arguments, **options)
        self.module, self.all_without, self.own = module, all_without, own

    def chosen(self, arguments: list[str]) -> tuple[click.Command, str, list[str]]:
        """Return the command that arguments mean, the scene as it is named, and the rest.

        The scene is the first argument, or the one that the table of a case file names.

        Raises
        ------
        UsageError, Problem
            If there is no such scene, or its file is not as it must be.
        """
        named = bool(arguments) and not arguments[0].startswith("-")
        scene = arguments[0] if named else _of_case_file(arguments)
        rest = arguments[1:] if named else arguments
        if scene is None and (self.own or self.all_without):
            return self, "", rest
        name = DEFAULT if scene is None else scene
        if self.own and not self.all_without and name.replace("_", "-") == DEFAULT:
            return self, DEFAULT if named else "", rest
        module = import_module(f".{self.module}", __package__)
        found = getattr(module, "named", scene_named)(name)
        command: click.Command = module.command(found, "" if scene is None else name)
        return command, scene or "", rest

    def collect_usage_pieces(self, ctx: click.Context) -> list[str]:
        """Return what the usage line has behind the name of the command."""
        pieces = super().collect_usage_pieces(ctx)
        named = (ctx.info_name or "").endswith(f" {DEFAULT}")
        return pieces if named else ["[SCENE]", *pieces]

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Complete scenes beside options."""
        scenes = [CompletionItem(name) for name in known() if name.startswith(incomplete)]
        return [
            *(scenes if incomplete[:1] != "-" else []),
            *super().shell_complete(ctx, incomplete),
        ]


def resolved(
    name: str | None, command: click.Command | None, arguments: list[str], *, quiet: bool
) -> tuple[str | None, click.Command | None, list[str]]:
    """Return a command of the command line as its arguments mean it, with its whole name.

    Parameters
    ----------
    name, command, arguments
        As click has them.
    quiet : bool
        Whether a scene that is not there is passed over, as for completion.
    """
    if not isinstance(command, SceneCommand):
        return name, command, arguments
    try:
        chosen, scene, rest = command.chosen(arguments)
    except (click.UsageError, Problem):
        if quiet:
            return name, command, arguments
        raise
    return f"{name} {scene}".strip(), chosen, rest


def _of_case_file(arguments: Sequence[str]) -> str | None:
    """Return the shipped scene that a case file is of; what is wrong with it is said later."""
    path = None
    for argument, value in zip(arguments, [*arguments[1:], ""], strict=False):
        if argument == "--case":
            path = value
        elif argument.startswith("--case="):
            path = argument.removeprefix("--case=")
    if not path:
        return None
    try:
        content = read_toml(Path(path))
    except Problem:
        return None
    tables = {str(key).replace("_", "-") for key in content} - {DEFAULT}
    found = sorted(tables & set(known()))
    return found[0] if found and len(content) == 1 else None
