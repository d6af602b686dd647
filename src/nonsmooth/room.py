"""Rooms that the house stands without: what is quicker or more for one scene, and no more.

A generic module that uses such a room asks here for it, and goes on without it where it was
left out.
"""

from importlib import import_module
from importlib.util import find_spec
from types import ModuleType

#: The name of every such room: ``nonsmooth.solver.shortcuts``, ``nonsmooth.cli.shortcuts``.
SHORTCUTS = "shortcuts"


def room(package: str, module: str) -> ModuleType | None:
    """Return a module of the room of shortcuts in a package; None where the room is left out.

    Parameters
    ----------
    package : str
        Whole name of the package that the room is in.
    module : str
        Name of the module within the room.

    Raises
    ------
    ImportError
        If the room is there and the module is not, or cannot be imported.

    Examples
    --------
    >>> room("nonsmooth.cli.scenes", "anything") is None
    True
    """
    if find_spec(f"{package}.{SHORTCUTS}") is None:
        return None
    return import_module(f"{package}.{SHORTCUTS}.{module}")
