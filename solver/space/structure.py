"""Structures that were generated, in numbers."""

import types
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache
from importlib import import_module
from pathlib import Path

_GENERATED = f"{__package__.rpartition('.solver')[0]}.generated.space"


class UnknownStructure(ValueError):  # noqa: N818  (named like the other errors of the package)
    """There is no structure of the name that was given."""


@dataclass(frozen=True)
class Parameter:
    """A parameter of a structure, in SI units."""

    name: str
    symbol: str
    unit: str
    default: float
    what: str


class Structure:
    """A bare structure with one thing attached, from its generated module.

    Parameters
    ----------
    module : module
        Of ``generated/space``.

    Attributes
    ----------
    name, title, source, bare, kind : str
        ``kind`` is ``"stiffness"``, ``"inertia"`` or ``"compliance"``.
    m : int
        Half the order of its equation.
    felt, broken : int
        The derivative that the attachment feels, and the one that jumps.
    k : int
        The class of its modes.
    jump : int
        Of the broken derivative under a unit load: 1 or -1.
    rates : tuple of int
        Powers of 1/N of the error of an eigenvalue, for 0, 1, ... forced modes.
    parameters : tuple of Parameter
        The last is what is attached.
    """

    def __init__(self, module: types.ModuleType) -> None:
        self.module = module
        self.name: str = module.NAME
        self.title: str = module.TITLE
        self.source: str = module.SOURCE
        self.bare: str = module.BARE
        self.kind: str = module.KIND
        self.m: int = module.HALF_ORDER
        self.felt: int = module.FELT
        self.broken: int = module.BROKEN
        self.k: int = module.CLASS
        self.jump: int = module.JUMP
        self.rates: tuple[int, ...] = module.RATES
        self.parameters = tuple(Parameter(*row) for row in module.PARAMETERS)

    def __repr__(self) -> str:
        return f"<{self.name}: {self.title} (C{self.k})>"

    @property
    def attached(self) -> Parameter:
        """The parameter that is attached."""
        return self.parameters[-1]

    @property
    def most_forced(self) -> int:
        """How many forced modes there are."""
        return len(self.rates) - 1


def names() -> tuple[str, ...]:
    """Return the names of the structures: the modules of ``generated/space``.

    Examples
    --------
    >>> "beam-mass" in names()
    True
    """
    folders = import_module(_GENERATED).__path__
    found = {path.stem for folder in folders for path in Path(folder).glob("[a-z]*.py")}
    return tuple(sorted(name.replace("_", "-") for name in found))


def load(name: str) -> Structure:
    """Return a structure by its name.

    Raises
    ------
    UnknownStructure
        Naming the nearest structure that there is.
    """
    known = names()
    wanted = name.replace("_", "-") if isinstance(name, str) else ""
    if wanted not in known:
        close = get_close_matches(wanted, known, 1)
        hint = f"; did you mean {close[0]}?" if close else ""
        raise UnknownStructure(
            f"structure: got {name!r}, expected one of {', '.join(known)}{hint}"
        )
    return _loaded(wanted)


@cache
def _loaded(name: str) -> Structure:
    return Structure(import_module(f"{_GENERATED}.{name.replace('-', '_')}"))
