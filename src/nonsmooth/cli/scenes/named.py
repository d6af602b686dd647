"""The scene that a text on the command line names, and that of a command without one."""

from typing import TYPE_CHECKING

import click

from ..problems import Problem

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene


#: The scene of a command without one.
DEFAULT = "stick-slip"

#: A scene, a parameter of it and a value, for the help of a command that takes any.
EXAMPLE = {"scene": "impact", "flag": "--gap", "value": 0.2, "vary": "frequency=1.5:3"}


def scene_named(text: str) -> "LoadedScene":
    """Return a scene by its name or by the path of its file, derived first if it is new.

    Raises
    ------
    UsageError
        If there is none of this name.
    Problem
        If its file is not as it must be.
    """
    from nonsmooth.scene_files.error import SceneFileError
    from nonsmooth.scene_files.find import find_scene
    from nonsmooth.solver.scenes.loaded import UnknownScene

    try:
        return find_scene(text)
    except UnknownScene as error:
        hint = ", or the path of a scene file" if "did you mean" not in str(error) else ""
        context = click.get_current_context(silent=True)
        raise click.UsageError(f"{error}{hint}", context) from error
    except SceneFileError as error:
        raise Problem(str(error)) from error


def known() -> tuple[str, ...]:
    """Return the names of the shipped scenes."""
    from nonsmooth.solver.kernels.registry import names

    return names()
