"""A scene with numbers: checked parameters, units, and what is left without units."""

from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from .cell import Cell, cell_of
from .parameters import ParameterError, is_number
from .units import Units, UnitsError, units_of

if TYPE_CHECKING:
    from .numbers import SceneNumbers


@dataclass(frozen=True, eq=False, repr=False)
class Case:
    """A scene and a value for each of its parameters.

    Parameters
    ----------
    scene : SceneNumbers
        The scene.
    values : mapping of str to float
        Parameters by name, in SI units; what is missing has its default.

    Raises
    ------
    ParameterError
        A `ValueError`: everything that is wrong with the parameters, a line each.
    """

    scene: "SceneNumbers"
    values: Mapping[str, Any]

    def __post_init__(self) -> None:
        checked, errors = _checked(self.scene, self.values)
        if not errors:
            errors = _unmet(self.scene, checked)
        if errors:
            raise ParameterError(errors)
        object.__setattr__(self, "values", MappingProxyType(checked))
        try:
            units, numbers = units_of(self.scene, tuple(checked.values()))
        except UnitsError as error:
            raise ParameterError([f"parameters: {error}"]) from None
        object.__setattr__(self, "_units", units)
        object.__setattr__(self, "_numbers", numbers)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Case) and self._identity == other._identity

    def __hash__(self) -> int:
        return hash(self._identity)

    def __repr__(self) -> str:
        words = ", ".join(f"{name}={value!r}" for name, value in self.values.items())
        return f"<case of {self.scene.name}: {words}>"

    def __reduce__(self) -> tuple[object, tuple[object, ...]]:
        return _restored, (str(self.scene.folder), dict(self.values))

    @property
    def _identity(self) -> tuple[object, ...]:
        return self.scene, *self.values.values()

    @property
    def units(self) -> Units:
        """The units of mass, time and length in which its numbers are of moderate size."""
        units: Units = self.__dict__["_units"]
        return units

    @property
    def numbers(self) -> tuple[float, ...]:
        """The parameters in these units, in order: what kernels call a case."""
        numbers: tuple[float, ...] = self.__dict__["_numbers"]
        return numbers

    @cached_property
    def cell(self) -> Cell:
        """The equations of its cell, in these units."""
        return cell_of(self.scene, self.numbers)

    @property
    def description(self) -> str:
        """The parameters in one line, by their symbols, for captions."""
        parts = (
            f"{parameter.symbol} = {value:.4g} {parameter.unit}".rstrip()
            for parameter, value in zip(
                self.scene.parameters, self.values.values(), strict=True
            )
        )
        return ", ".join(parts)


def _checked(
    scene: "SceneNumbers", given: Mapping[str, object]
) -> tuple[dict[str, float], list[str]]:
    """Return the parameters in order, and what is wrong with those that are given."""
    names = tuple(parameter.name for parameter in scene.parameters)
    errors = []
    for name in given:
        if name not in names:
            close = get_close_matches(str(name), names, 1)
            hint = f"did you mean {close[0]}?" if close else f"expected {', '.join(names)}"
            errors.append(f"{name}: not a parameter of {scene.name}; {hint}")
    checked = {}
    for parameter in scene.parameters:
        value = given.get(parameter.name, parameter.default)
        if is_number(value) and parameter.allows(float(value)):  # type: ignore[arg-type]
            checked[parameter.name] = float(value)  # type: ignore[arg-type]
        else:
            errors.append(f"{parameter.name}: got {value!r}, expected {parameter.expected}")
    return checked, errors


def _unmet(scene: "SceneNumbers", values: Mapping[str, float]) -> list[str]:
    """Return which of the scene's own conditions on its parameters are not met."""
    found = scene.numbers("requires", tuple(values.values()))
    symbols = {parameter.symbol: parameter.name for parameter in scene.parameters}
    errors = []
    for words, value in zip(scene.module.REQUIRES, found, strict=True):
        if not value >= 0:
            named = [symbols.get(word, word) for word in words.replace(",", " ").split()]
            numbers = [f"{name} = {values[name]!r}" for name in named if name in values]
            got = " and ".join(numbers) or f"{value:.6g} for what must not be negative"
            errors.append(f"parameters: got {got}, expected that {words}")
    return errors


def _restored(folder: str, values: dict[str, float]) -> Case:
    from .registry import load_folder  # noqa: PLC0415  (it imports this module)

    return load_folder(folder)(**values)
