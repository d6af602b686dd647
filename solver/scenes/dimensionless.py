"""Units in which the parameters of a case are numbers of moderate size."""

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..scaling import product_of_powers

if TYPE_CHECKING:
    from .loaded import LoadedScene


class UnitsError(ValueError):
    """A unit of a case, or a parameter in it, is out of range of float64."""


@dataclass(frozen=True)
class Units:
    """Units of a case: mass in kg, time in s, length in m."""

    mass: float
    time: float
    length: float

    def of_motion(self, derivative: int) -> float:
        """Return the unit of a derivative of the displacement by time."""
        return product_of_powers(self.length, (self.time, -derivative))

    def of_parameter(self, powers: "Powers") -> float:
        """Return the unit of a parameter with these powers of mass, length and time."""
        return _in_units(1.0, tuple(-p for p in powers), (self.mass, self.length, self.time))


#: Powers of mass, length and time in a parameter's unit.
Powers = tuple[float, float, float]


def units_of(
    scene: "LoadedScene", values: tuple[float, ...]
) -> tuple[Units, tuple[float, ...]]:
    """Return the units of a case, and its parameters in them.

    The scene's formulas for its units may overflow on the way.  So they are evaluated in units
    that are powers of 4 in which the parameters are near 1: integer powers of these and their
    square roots change no digit.

    Raises
    ------
    UnitsError
        Naming the unit or the parameter, and its value.
    """
    try:
        rough, near, own = _scales(scene, values)
    except UnitsError as error:
        raise UnitsError(f"{error}; {_blamed(scene, values)}") from None
    mass, length, time = own
    units = Units(mass * rough[0], time * rough[2], length * rough[1])
    numbers = tuple(map(lambda v, p: _in_units(v, p, (mass, length, time)), near, scene.powers))
    for parameter, number in zip(scene.parameters, numbers, strict=True):
        if not math.isfinite(number):
            raise UnitsError(f"{parameter.name} in their units is {number!r}, beyond float64")
    return units, numbers


def _scales(
    scene: "LoadedScene", values: tuple[float, ...]
) -> tuple[Powers, tuple[float, ...], Powers]:
    """Return rough units of mass, length and time, parameters in them, and the units in them.

    Raises
    ------
    UnitsError
        If a unit is out of range.
    """
    rough: Powers = (1.0, 1.0, 1.0)  # of a body, whose formulas have matrices in SI units
    if not scene.has_body:
        rough = _powers_of_four(scene.powers, values)
    near = tuple(map(lambda v, p: _in_units(v, p, rough), values, scene.powers))
    try:
        mass, time, length = map(float, scene.numbers("scales", near))
    except (ZeroDivisionError, OverflowError, ValueError):
        raise UnitsError("their units are beyond float64") from None
    own = mass, length, time
    for name, one, other in zip(("mass", "length", "time"), own, rough, strict=True):
        unit = one * other
        if not (math.isfinite(unit) and unit >= np.finfo(float).tiny):
            raise UnitsError(f"their unit of {name} is {unit!r}, beyond float64")
    return rough, near, own


def _blamed(scene: "LoadedScene", values: tuple[float, ...]) -> str:
    """Return in words a parameter whose default alone would give units.

    Of several that which is farthest from it; if there is none, the farthest of all.
    """

    def off(i: int) -> float:
        ratio = abs(values[i]) / abs(scene.parameters[i].default or 1.0)
        return abs(math.log(ratio)) if ratio else math.inf

    for i in sorted(range(len(values)), key=off, reverse=True):
        parameter, value = scene.parameters[i], values[i]
        with suppress(UnitsError, ArithmeticError, ValueError):
            if value != parameter.default:
                _scales(scene, (*values[:i], parameter.default, *values[i + 1 :]))
                name = parameter.name
                return (
                    f"{name} = {value!r} makes it so, {name} = {parameter.default!r} does not"
                )
    return _farthest(scene, values)


def _farthest(scene: "LoadedScene", values: tuple[float, ...]) -> str:
    """Return in words which parameter is farthest from its default, by a factor."""
    _, name, value = max(
        (abs(math.log(abs(value)) - math.log(abs(q.default or 1.0))), q.name, value)
        for q, value in zip(scene.parameters, values, strict=True)
        if value
    )
    return f"{name} = {value!r} is farthest from its default"


def _powers_of_four(powers: tuple[Powers, ...], values: tuple[float, ...]) -> Powers:
    """Return powers of 4 as units of mass, length and time in which values are nearest to 1."""
    nonzero = [(p, math.log2(abs(v))) for p, v in zip(powers, values, strict=True) if v]
    rows = np.array([p for p, _ in nonzero], dtype=float).reshape(-1, 3)
    exponents, *_ = np.linalg.lstsq(rows, np.array([size for _, size in nonzero]))
    mass, length, time = (2.0 ** float(np.clip(2 * round(e / 2), -500, 500)) for e in exponents)
    return mass, length, time


def _in_units(value: float, powers: Sequence[float], units: Powers) -> float:
    """Return a value divided by the powers of mass, length and time in its unit."""
    whole = [math.floor(power) for power in powers]
    factors = [(unit, -power) for unit, power in zip(units, whole, strict=True)]
    for unit, power, below in zip(units, powers, whole, strict=True):
        if power != below:  # a fractional power does not overflow
            factors.append((unit ** (power - below), -1))
    return product_of_powers(value, *factors)
