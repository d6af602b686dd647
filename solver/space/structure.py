"""Generated structures: their facts and closed forms."""

import types
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from ...nearest import one_of
from ..scenes.loaded import Parameter

_GENERATED = f"{__package__.rpartition('.solver')[0]}.generated.space"


class UnknownStructure(ValueError):  # noqa: N818  (named like the other errors of the package)
    """No structure has the name that was given."""


@dataclass(frozen=True)
class Structure:
    """A bare structure with one attachment, as generated.

    Parameters
    ----------
    name, title, source : str
    bare : str
        ``"beam"`` or ``"string"``.
    m : int
        Half the order of its equation.
    felt, broken : int
        Orders of the derivative that the attachment acts on, and of the first that jumps.
    kind : str
        ``"stiffness"``, ``"inertia"`` or ``"compliance"``.
    jump : int
        Jump of the broken derivative under a unit load: 1 or -1.
    rates : tuple of int
        Powers of 1/N in the error of an eigenvalue, for 0, 1, ... forced modes.
    parameters : tuple of Parameter
        The last is that of the attachment.
    """

    name: str
    title: str
    source: str
    bare: str
    m: int
    felt: int
    broken: int
    kind: str
    jump: int
    rates: tuple[int, ...]
    parameters: tuple[Parameter, ...]

    @property
    def k(self) -> int:
        """The class of its modes."""
        return self.broken - 1

    @property
    def lowest_sum(self) -> int:
        """The lowest `q` for which the sum of ``r_n^2/mu_n^q`` over all modes converges."""
        return 2 if self.kind == "compliance" else 1

    @property
    def attached(self) -> Parameter:
        """The parameter of the attachment."""
        return self.parameters[-1]

    @property
    def most_forced(self) -> int:
        """Number of forced modes available."""
        return len(self.rates) - 1

    @property
    def module(self) -> types.ModuleType:
        """The generated module of its closed forms."""
        return import_module(f"{_GENERATED}.{self.name.replace('-', '_')}")


def names() -> tuple[str, ...]:
    """Return the names of the structures."""
    return tuple(_records())


def load(name: str) -> Structure:
    """Return a structure by its name.

    Raises
    ------
    UnknownStructure
        Naming the structures with the nearest names.
    """
    valid = names()
    hyphenated = name.replace("_", "-") if isinstance(name, str) else ""
    if hyphenated not in valid:
        raise UnknownStructure(f"structure: got {name!r}, expected {one_of(hyphenated, valid)}")
    record = dict(_records()[hyphenated])
    parameters = tuple(Parameter(*row) for row in record.pop("parameters"))
    return Structure(name=hyphenated, parameters=parameters, **record)


def _records() -> dict[str, dict[str, Any]]:
    """Return the generated facts of all structures, by name."""
    records: dict[str, dict[str, Any]] = import_module(f"{_GENERATED}.structures").STRUCTURES
    return records
