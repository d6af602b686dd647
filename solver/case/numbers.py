"""A generated scene as an object: what it is, and the parameters that make it a case."""

import types
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .case import Case


@dataclass(frozen=True)
class Parameter:
    """One parameter of a scene.

    Parameters
    ----------
    name, symbol, unit, what : str
        What flags call it, what equations call it, its SI unit, what it is.
    default : float
        In SI units.
    bound : {"positive", "nonnegative", ""}
        What its sign must be.
    most : float or None
        The largest value allowed.
    """

    name: str
    symbol: str
    unit: str
    default: float
    what: str
    bound: str
    most: float | None

    @property
    def expected(self) -> str:
        """What a value must be, in words."""
        words = {"positive": "a positive number", "nonnegative": "a number not below 0"}
        low = words.get(self.bound, "a finite number")
        return low if self.most is None else f"{low}, at most {self.most:g}"

    def allows(self, value: float) -> bool:
        """Whether a finite value is within the bounds."""
        low = value > 0 if self.bound == "positive" else self.bound == "" or value >= 0
        return low and (self.most is None or value <= self.most)


@dataclass(frozen=True, eq=False, repr=False)
class SceneNumbers:
    """A scene in numbers: its generated module ``scene.py``, and the folder of its kernels.

    Calling it makes a case: ``scene(mass=2.0)``; what is not given has its default.

    Parameters
    ----------
    module : module
        The generated module.
    folder : Path
        Where the modules of the methods lie.
    """

    module: types.ModuleType
    folder: Path

    def __call__(self, **values: object) -> "Case":
        """Return the case of these parameters, in SI units.

        Raises
        ------
        ParameterError
            Naming everything that is wrong with them.
        """
        from .case import Case  # noqa: PLC0415  (NumPy: a list of scenes needs none)

        return Case(self, values)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SceneNumbers) and self._identity == other._identity

    def __hash__(self) -> int:
        return hash(self._identity)

    def __repr__(self) -> str:
        return f"<scene {self.name}: {self.title} (C{self.k})>"

    @property
    def _identity(self) -> tuple[str, str]:
        return self.name, self.module.BODY

    @property
    def name(self) -> str:
        """What users call it."""
        return str(self.module.NAME)

    @property
    def title(self) -> str:
        """What it is."""
        return str(self.module.TITLE)

    @property
    def k(self) -> int:
        """Class C^k of its motion: the least over its switches."""
        return int(self.module.CLASS)

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """Its parameters, in order."""
        return tuple(Parameter(*row) for row in self.module.PARAMETERS)

    @property
    def powers(self) -> tuple[tuple[float, float, float], ...]:
        """Powers of mass, length and time in the unit of each parameter."""
        return tuple(self.module.POWERS)

    @property
    def phases(self) -> tuple[str, ...]:
        """The names of the phases of its cell."""
        return tuple(name for name, _ in self.module.PHASES)

    @property
    def frequency(self) -> str | None:
        """The parameter that is the angular frequency of the forcing, if it is forced."""
        name: str | None = self.module.FREQUENCY
        return name

    def numbers(self, function: str, values: Sequence[float]) -> Any:
        """Return what a function of the module says of parameters, in order."""
        return getattr(self.module, function)(*values)
