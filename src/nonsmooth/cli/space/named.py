"""The structure that a text on the command line names."""

from typing import TYPE_CHECKING

import click

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

    A `UsageError` names the nearest structure that there is.
    """
    from nonsmooth.solver.space.structure import UnknownStructure, load

    try:
        return load(name)
    except UnknownStructure as error:
        context = click.get_current_context(silent=True)
        raise click.UsageError(str(error), context) from error
