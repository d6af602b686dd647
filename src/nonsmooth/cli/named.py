"""Commands whose first argument names a scene or a structure, and become commands of that."""

from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from .about import BehindName, Kind
from .case_files import said_first
from .problems import Problem

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene
    from nonsmooth.solver.space.structure import Structure

#: The scene of a command without one.
DEFAULT = "stick-slip"


def scene_names() -> tuple[str, ...]:
    """Return the names of the shipped scenes."""
    from nonsmooth.solver.kernels.registry import names

    return names()


def scene_named(text: str) -> "LoadedScene":
    """Return a scene by its name or by the path of its file, derived first if it is new.

    A `UsageError` is raised if there is none, a `Problem` if its file is not as it must be.
    """
    from nonsmooth.scene_files.error import SceneFileError
    from nonsmooth.scene_files.find import find_scene
    from nonsmooth.solver.scenes.loaded import UnknownScene

    try:
        return find_scene(text)
    except UnknownScene as error:
        hint = ", or the path of a scene file" if "did you mean" not in str(error) else ""
        if Path(f"{text}.py").is_file():
            hint = f"; did you mean {text}.py?"
        if text in structure_names():
            hint = f"; {text} is a structure, of `nonsmooth modes`"
        context = click.get_current_context(silent=True)
        raise click.UsageError(f"{error}{hint}", context) from error
    except SceneFileError as error:
        raise Problem(str(error)) from error


def structure_names() -> tuple[str, ...]:
    """Return the names of the structures."""
    from nonsmooth.solver.space.structure import names

    return names()


def structure_named(name: str) -> "Structure":
    """Return a structure by its name.

    A `UsageError` names the nearest structure that there is.
    """
    from nonsmooth.solver.space.structure import UnknownStructure, load

    try:
        return load(name)
    except UnknownStructure as error:
        context = click.get_current_context(silent=True)
        raise click.UsageError(str(error), context) from error


SCENES = Kind("scenes", "[SCENE]", scene_names, scene_named)
STRUCTURES = Kind("space", "[STRUCTURE]", structure_names, structure_named)


class NamedCommand(BehindName):
    """A command that hands over to the command of the scene or structure it is given.

    `kinds` are what its first argument may name, if anything; `default` is meant where nothing
    is named, or without one this command itself.
    """

    def __init__(
        self, *arguments: Any, kinds: tuple[Kind, ...] = (SCENES,),
        default: str | None = DEFAULT, **options: Any,
    ) -> None:  # fmt: skip
        super().__init__(*arguments, **options)
        self.kinds, self.default = kinds, default

    def chosen(self, arguments: list[str]) -> tuple[click.Command, str, list[str]]:
        """Return the command for the named scene or structure, its name, other arguments.

        That is the first argument, or what the table of a case file names; errors are those of
        `Kind.named`.
        """
        named = said_first(arguments, lambda: {*self.names()} - {self.default})
        said, remaining = named if self.kinds else (None, arguments)
        name = self.default if said is None else said
        if name is None:
            return self, "", remaining
        dashed = name.replace("_", "-")
        kinds = self.kinds or (SCENES,)
        kind = next((q for q in kinds if dashed in q.names()), kinds[0])
        module = import_module(f".{kind.package}.commands", __package__)
        command: click.Command = module.command(self.name, kind.named(name), said or "")
        return command, said or "", remaining
