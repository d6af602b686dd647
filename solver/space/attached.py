"""A structure with numbers: checked parameters in SI units, and dimensionless quantities."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from ..arrays import Vector
from ..scenes.parameter_error import ParameterError, is_number
from .eigenvalues.bracketing import EPS
from .position import Integers, as_position, sines
from .structure import Structure

#: Range of the dimensionless strength in which estimates of rounding hold.
LEAST, MOST = 1e-9, 1e9

#: Least distance of the attachment from an end, relative to the length: nearer, sums over modes
#: would need too many of them.
NEAREST = Fraction(1, 10_000)

#: Margin of stability below which the rounding of the strength decides.
LEAST_MARGIN = 4 * EPS

#: Default position of the attachment.
POSITION = "3/10"


@dataclass(frozen=True)
class Attached:
    """A structure with its attachment in numbers.

    Parameters
    ----------
    values : mapping
        Its parameters in SI units, by name.
    a : Fraction
        The place of the attachment, relative to the length.
    """

    structure: Structure
    values: Mapping[str, float] = field(hash=False)
    a: Fraction

    @cached_property
    def _arguments(self) -> tuple[float, ...]:
        return tuple(self.values[q.name] for q in self.structure.parameters)

    @cached_property
    def s(self) -> float:
        """The dimensionless strength of the attachment."""
        return float(self.structure.module.strength(*self._arguments))

    @cached_property
    def static_sum(self) -> Fraction:
        """The sum of ``r_n^2/mu_n``, or for a compliance ``r_n^2/mu_n^2``, exactly."""
        total: Fraction = self.structure.module.static_sum(self.a)
        return total

    @property
    def raises(self) -> bool:
        """Whether the attachment raises eigenvalues: a spring of positive stiffness."""
        return self.structure.kind == "stiffness" and self.s > 0

    @cached_property
    def margin(self) -> float:
        """``1 + s S_1`` of a spring, rounded once: at 0 and below, the structure is unstable.

        The static compliance at the attachment is ``S_1``, `static_sum`, without the spring,
        and ``S_1/(1 + s S_1)`` with it.
        """
        return float(1 + Fraction(self.s) * self.static_sum)

    @property
    def critical(self) -> float:
        """The stiffness of a spring at which the structure loses its stability, in SI units."""
        name = self.structure.attached.name
        return float(-1 / self.static_sum) * self.values[name] / self.s

    @cached_property
    def frequency_unit(self) -> float:
        """The angular frequency over ``beta**m``, in rad/s."""
        return float(self.structure.module.frequency(*self._arguments))

    @cached_property
    def restoring(self) -> float:
        """The bending stiffness in N m^2, or the tension in N."""
        return float(self.structure.module.restoring(*self._arguments))

    @property
    def length(self) -> float:
        """The length in metres."""
        return self.values["length"]

    def law(self, eigenvalue: float) -> float:
        """Return the factor in ``[u^(broken)] = factor u^(felt)(a)``."""
        factors = {"stiffness": -self.s, "inertia": self.s * eigenvalue, "compliance": self.s}
        return self.structure.jump * factors[self.structure.kind]

    def sines(self, n: Integers) -> tuple[Vector, Vector]:
        """Return ``sin(n pi a)`` and ``cos(n pi a)``."""
        return sines(n, self.a)

    def felt(self, n: Integers) -> Vector:
        """Return ``r_n = phi_n^(j)(a)``: derivative j of each bare mode at the attachment.

        It is exactly zero for modes with a node there (for a rotation, an antinode).
        """
        j = self.structure.felt
        sine, cosine = self.sines(n)
        wave = np.asarray(n, dtype=float) * np.pi
        around = (sine, cosine, -sine)[j]
        return np.asarray(np.sqrt(2.0) * wave**j * around)

    def bare(self, n: Integers) -> Vector:
        """Return ``mu_n = (n pi)^(2m)``, the eigenvalues without the attachment."""
        return (np.asarray(n, dtype=float) * np.pi) ** (2 * self.structure.m)

    def as_dict(self) -> dict[str, Any]:
        """Return the first entries of documents: the structure and its numbers."""
        return {
            "structure": self.structure.name,
            "class": f"C{self.structure.k}",
            "parameters": dict(self.values),
            "position": str(self.a),
            "strength": self.s,
        }

    @property
    def about(self) -> dict[str, Any]:
        """The same without the parameters, for tables."""
        return {name: value for name, value in self.as_dict().items() if name != "parameters"}

    def described(self, varied: str = "") -> str:
        """Return the parameters and the dimensionless strength in one line.

        The parameter `varied`, and numbers that depend on it, are left out.
        """
        listed = ", ".join(
            f"{q.symbol} = {self.values[q.name]:g}{f' {q.unit}' if q.unit else ''}"
            for q in self.structure.parameters
            if q.name != varied
        )
        position = str(self.a) if self.a.denominator <= 10**4 else f"{float(self.a):.12g}"
        derived = [] if varied == "position" else [f"a = {position}"]
        if varied in ("", "position"):
            derived.append(f"s = {self.s:.6g}")
        return f"{listed}; {', '.join(derived)}"


def attach(structure: Structure, position: object = POSITION, **given: float) -> Attached:
    """Return a structure with its parameters; defaults for those not given.

    Raises
    ------
    ParameterError
        With all errors at once.
    """
    errors, a = [], Fraction(1, 2)
    try:
        a = as_position(position)
        if min(a, 1 - a) < NEAREST:
            raise ValueError(
                f"position: got {float(a):g}, expected {NEAREST} from an end or more"
            )
    except ValueError as error:
        errors.append(str(error))
    specs = {q.name: q for q in structure.parameters}
    for name in sorted(given.keys() - specs.keys()):
        expected = ", ".join(("position", *specs))
        errors.append(f"{name}: unknown, expected some of {expected}")
    values = {q.name: given.get(q.name, q.default) for q in structure.parameters}
    for name, value in values.items():
        signed = structure.kind == "stiffness" and name == structure.attached.name
        if not is_number(value) or value == 0 or (value < 0 and not signed):
            expected = f"a number {'other than' if signed else 'above'} 0 in {specs[name].unit}"
            errors.append(f"{name}: got {value!r:.60}, expected {expected}")
            if is_number(value) and value == 0 and name == structure.attached.name:
                what = f"it is the bare {structure.bare}"
                errors[-1] += f" (without the attachment beta L is n pi: {what})"
    if not errors:
        attached = Attached(structure, {name: float(v) for name, v in values.items()}, a)
        errors += _unstable(attached) or _extremes(attached)
        if not errors:
            return attached
    raise ParameterError(errors)


def _unstable(attached: Attached) -> list[str]:
    """Return the error of a negative stiffness at which the structure is unstable, if any."""
    structure, q = attached.structure, attached.structure.attached
    if structure.kind != "stiffness" or not np.isfinite(attached.s):
        return []
    if attached.margin > LEAST_MARGIN:
        return []
    return [
        f"{q.name}: got {attached.values[q.name]!r}, expected more than the critical stiffness "
        f"{attached.critical:.12g} {q.unit}, at which the {structure.bare} loses its stability"
    ]


def _extremes(attached: Attached) -> list[str]:
    """Return the errors of numbers out of the range in which rounding is known."""
    errors = []
    with np.errstate(all="ignore"):
        length, order = np.float64(attached.length), 2 * attached.structure.m
        units = {
            "dimensionless strength": attached.s,
            "unit of frequency": attached.frequency_unit,
            "unit of the highest derivative": 1 / length**order,
            "unit of the internal force": attached.restoring / length ** (order - 1),
            "mass": length * attached.values["mass_per_length"],
        }
        for what, value in units.items():
            if not np.isfinite(value) or value == 0:
                errors.append(f"the {what} of these parameters is {value:g}, beyond float64")
    if not errors and not LEAST <= abs(attached.s) <= MOST:
        name = attached.structure.attached.name
        errors.append(
            f"{name}: got {attached.values[name]:g}, a dimensionless strength of "
            f"{attached.s:.3g}, expected one of a size from {LEAST:g} to {MOST:g}"
        )
    return errors
