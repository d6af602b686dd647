"""A case: a scene with checked numbers for its parameters, and units that scale them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

from ...nearest import nearest, one_of
from .cell import Cell
from .dimensionless import Units, UnitsError, units_of
from .parameter_error import ParameterError, is_number, repeated, whole

if TYPE_CHECKING:
    from ..exact import ExactOrbit
    from ..no_orbit import NoOrbit
    from .loaded import LoadedScene

# A periodic motion of a case.
_Motion = TypeVar("_Motion")

#: Most periods of the forcing in one of the motion: kernels of feasible order resolve no more.
MOST_CYCLES = 100


@dataclass(frozen=True, eq=False, repr=False)
class Case:
    """A scene and a value for each of its parameters.

    Parameters
    ----------
    scene : LoadedScene
        The scene.
    values : mapping of str to float
        Parameters by name, in SI units; defaults for those that are missing.
    cycles : int
        Periods of the forcing in one period of the motion.

    Attributes
    ----------
    units : Units
        Units of mass, time and length in which the parameters are of moderate size.
    numbers : tuple of float
        The parameters in these units, in the order of the scene.

    Raises
    ------
    ParameterError
        A `ValueError`: every problem of the parameters, a line each.
    """

    scene: "LoadedScene"
    values: Mapping[str, Any]
    cycles: int = 1
    units: Units = field(init=False)
    numbers: tuple[float, ...] = field(init=False)

    #: Further keys in documents of its orbits, for subclasses: times in s, and errors.
    own_numbers: ClassVar[tuple[str, ...]] = ()
    own_errors: ClassVar[tuple[str, ...]] = ()

    def __post_init__(self) -> None:
        checked, errors = _checked(self.scene, self.values)
        errors += _wrong_cycles(self.scene, self.cycles)
        if not errors:
            errors = _unmet(self.scene, checked)
        if errors:
            raise ParameterError(errors)
        object.__setattr__(self, "values", MappingProxyType(checked))
        object.__setattr__(self, "cycles", int(self.cycles))
        try:
            units, numbers = units_of(self.scene, tuple(checked.values()))
        except UnitsError as error:
            raise ParameterError([f"parameters: {error}"]) from None
        object.__setattr__(self, "units", units)
        object.__setattr__(self, "numbers", numbers)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Case) and self._identity == other._identity

    def __hash__(self) -> int:
        return hash(self._identity)

    def __repr__(self) -> str:
        words = ", ".join(f"{name}={value!r}" for name, value in self.values.items())
        cycles = f", cycles={self.cycles}" if self.cycles != 1 else ""
        return f"<case of {self.scene.label}: {words}{cycles}>"

    def __reduce__(self) -> tuple[object, tuple[object, ...]]:
        return Case, (self.scene, dict(self.values), self.cycles)

    @property
    def _identity(self) -> tuple[object, ...]:
        return self.scene, self.cycles, *self.values.values()

    def with_cycles(self, cycles: int) -> "Case":
        """Return the case for motions whose period is `cycles` periods of the forcing."""
        return Case(self.scene, self.values, cycles)

    def of_motion(self, name: object) -> "Case":
        """Return the case of one of the motions of the scene.

        Raises
        ------
        UnknownScene
            A `ValueError`: if the scene has no motion of this name.
        """
        return Case(self.scene.of_motion(name), self.values, self.cycles)

    @property
    def each_motion(self) -> "tuple[Case, ...]":
        """The case of each motion of the scene; itself if it has only one."""
        if not self.scene.motions:
            return (self,)
        return tuple(Case(q, self.values, self.cycles) for q in self.scene.each_motion)

    def with_value(self, name: str, value: Any) -> "Case":
        """Return the case with another value of a parameter."""
        return Case(self.scene, dict(self.values) | {name: value}, self.cycles)

    def called(self, method: str) -> str:
        """Return the name of a method in documents: its generic one, but in subclasses."""
        return method

    def presented(self, motion: _Motion) -> _Motion:
        """Return a motion as users get it: unchanged.  Subclasses add properties."""
        return motion

    def completed(self, document: dict[str, Any], exact: "ExactOrbit | None") -> dict[str, Any]:
        """Return the document of a missing orbit with all keys of one that is found."""
        errors = dict.fromkeys(self.own_errors) | document["errors"]
        return document | dict.fromkeys(self.own_numbers) | {"errors": errors}

    def none(self, method: str, order: int, tried: Sequence[str]) -> "NoOrbit | None":
        """Return a proof that a method has no orbit at an order: None, but in subclasses."""
        return None

    @cached_property
    def cell(self) -> Cell:
        """The equations of its cell, in the case's units.

        Raises
        ------
        ValueError
            If the scene has several motions: each has a cell of its own.
        """
        if self.scene.motions:
            motions = ", ".join(self.scene.motions)
            raise ValueError(f"motion: got none, expected one of {motions}")
        return self.scene.cell(self.numbers, self.cycles, self.units)

    @property
    def description(self) -> str:
        """Parameters, by their symbols, and cycles, in one line for captions."""
        return self.described()

    def described(self, *but: str) -> str:
        """Return the parameters but some, by their symbols, and cycles, in one line."""
        text = ", ".join(
            f"{q.symbol} = {self.values[q.name]:.4g} {q.unit}".rstrip()
            for q in self.scene.parameters
            if q.name not in but
        )
        return text if self.cycles == 1 else f"{text}; {self.cycles} cycles of the forcing"


def check_case(case: object) -> None:
    """Check that the argument of a solver is a case.

    Raises
    ------
    TypeError
        If it is no `Case`.
    """
    if not isinstance(case, Case):
        raise TypeError(f"case: got {case!r:.80}, expected a case, such as ns.scene(...)()")


def index_of(case: Case, parameter: str) -> int:
    """Return the index of the parameter of a case that has a name.

    Raises
    ------
    ParameterError
        If none has it.
    """
    names = [q.name for q in case.scene.parameters]
    if parameter not in names:
        got = f"got {repeated(parameter)}, expected {one_of(parameter, names)}"
        raise ParameterError([f"parameter: {got}"])
    return names.index(parameter)


def _wrong_cycles(scene: "LoadedScene", cycles: object) -> list[str]:
    """Return the error in the number of periods of the forcing, if there is one."""
    try:
        count = whole("cycles", cycles, 1, MOST_CYCLES)
    except ValueError as error:
        return [str(error)]
    if scene.frequency is None and count != 1:
        expected = f"1: nothing forces {scene.name}"
    elif scene.half_period and count % 2 == 0:
        expected = f"an odd number: x(t + T/2) = -x(t) in {scene.name}, unless phases are given"
    else:
        return []
    return [f"cycles: got {repeated(cycles)}, expected {expected}"]


def _checked(
    scene: "LoadedScene", numbers: Mapping[str, object]
) -> tuple[dict[str, float], list[str]]:
    """Return all parameters by name, in order, and the errors in those that are given."""
    names = tuple(parameter.name for parameter in scene.parameters)
    errors = []
    for name in numbers:
        if name not in names:
            meant = " or ".join(nearest(name, names))
            hint = f"did you mean {meant}?" if meant else f"expected {', '.join(names)}"
            errors.append(f"{name}: not a parameter of {scene.name}; {hint}")
    checked = {}
    for parameter in scene.parameters:
        value = numbers.get(parameter.name, parameter.default)
        if is_number(value) and parameter.allows(float(value)):  # type: ignore[arg-type]
            checked[parameter.name] = float(value)  # type: ignore[arg-type]
        else:
            got = f"got {repeated(value)}, expected {parameter.expected}"
            errors.append(f"{parameter.name}: {got}")
    return checked, errors


def _unmet(scene: "LoadedScene", values: Mapping[str, float]) -> list[str]:
    """Return the errors of parameters that violate the scene's conditions on them."""
    conditions = scene.numbers("requires", tuple(values.values()))
    errors = []
    for i, (text, value) in enumerate(zip(scene.module.REQUIRES, conditions, strict=True)):
        if not value >= 0:
            names = (name for name in values if _depends(scene, values, i, name))
            got = ", ".join(f"{name} = {values[name]!r}" for name in names)
            errors.append(f"parameters: got {got}, expected that {text}")
    return errors


def _depends(scene: "LoadedScene", values: Mapping[str, float], i: int, name: str) -> bool:
    """Whether one of the scene's conditions on its parameters depends on a parameter."""
    other = dict(values) | {name: 1.5 * values[name] or 1.0}
    try:
        one, two = (scene.numbers("requires", tuple(q.values()))[i] for q in (values, other))
    except (ArithmeticError, ValueError):  # beyond what the condition is defined for
        return True
    return bool(one != two)
