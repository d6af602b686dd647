"""One mode: its frequency, its error, and its shape."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from ..arrays import Vector
from ..presentation.table import Table, Tabular
from ..scenes.parameter_error import whole
from .attached import Attached
from .expansions.shapes import Shape

#: Columns by the order of the derivative, and their units; the last two for beams only.
COLUMNS = ("displacement", "slope", "moment", "shear_force")
UNITS = ("kg^(-1/2)", "kg^(-1/2) m^-1", "kg^(-1/2) N", "kg^(-1/2) N m^-1")

#: Names of the first discontinuous derivative, by the class.
QUANTITIES = {0: "slope", 1: "moment", 2: "shear force"}


@dataclass(frozen=True, eq=False)
class Mode:
    """A mode of a structure with an attachment.

    Parameters
    ----------
    number : int
        Number of the exact mode, from 1, the lowest.
    eigenvalue : float
        ``lambda = beta^(2m)``.
    exact_beta : float
        beta of the exact mode of this number.
    error : float
        Frequency over the exact one, less one.
    bounds : tuple of (float or None)
        Proved bounds of the exact eigenvalue; the lower one is None if none is proved.
    node : int or None
        The `n` of an exact mode ``sin(n pi x/L)`` with a node at the attachment (for a
        rotation, an antinode), which does not affect it; else None.
    jump_mismatch : float or None
        The jump at the attachment over that of its law, less one; None for a node.  It needs no
        exact solution, and is -1 if the expansion has no jump.
    """

    number: int
    eigenvalue: float
    exact_beta: float
    error: float
    bounds: tuple[float | None, float]
    node: int | None
    jump_mismatch: float | None
    _attached: Attached = field(repr=False)
    _shape: Shape = field(repr=False)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Mode) and self.as_dict() == other.as_dict()

    def __hash__(self) -> int:
        return hash((self.number, self.eigenvalue))

    @property
    def beta(self) -> float:
        """The wave number times the length."""
        return float(self.eigenvalue ** (1 / (2 * self._attached.structure.m)))

    @property
    def frequency(self) -> float:
        """The frequency in Hz."""
        return self.omega / (2 * math.pi)

    @property
    def omega(self) -> float:
        """The angular frequency in rad/s."""
        return math.sqrt(self.eigenvalue) * self._attached.frequency_unit

    @property
    def exact_frequency(self) -> float:
        """The frequency of the exact mode of this number in Hz."""
        power = self.exact_beta**self._attached.structure.m
        return power * self._attached.frequency_unit / (2 * math.pi)

    @property
    def modal_mass(self) -> float:
        """The modal mass in kg of `shape`, including the attachment.

        ``int rho u^2 dx``, and of a mass ``m_0 u(a)^2``, of a rotary inertia ``J_0 u'(a)^2``.
        """
        attached = self._attached
        mass = attached.values["mass_per_length"] * attached.length
        if attached.structure.kind == "inertia":
            moved = self.shape(float(attached.a) * attached.length, attached.structure.felt)
            mass += attached.values[attached.structure.attached.name] * float(moved) ** 2
        return mass

    @property
    def node_at_attachment(self) -> bool:
        """Whether the attachment does not affect the exact mode."""
        return self.node is not None

    @property
    def proved_within(self) -> float | None:
        """Bound of the relative error of the frequency; None without both bounds."""
        low, high = self.bounds
        return None if low is None else (math.sqrt(high) - math.sqrt(low)) / math.sqrt(low)

    def shape(self, x: npt.ArrayLike, derivative: int = 0) -> Vector:
        """Return the displacement or a derivative of it at places from 0 to the length.

        Parameters
        ----------
        x : array_like
            In metres.
        derivative : int
            From 0 to ``2m``.

        Returns
        -------
        ndarray
            In 1/m^derivative: the mean square of the displacement is one.  At the attachment,
            the mean of both sides.

        Raises
        ------
        ValueError
            If a place is not on the structure, or there is no such derivative.
        """
        points, length = np.asarray(x, dtype=float), self._attached.length
        if not ((points >= 0) & (points <= length)).all():
            raise ValueError(f"x: got {x!r:.60}, expected places from 0 to {length:g} m")
        derivative = whole("derivative", derivative, 0, 2 * self._attached.structure.m)
        values = self._shape.values(points.ravel() / length, derivative)
        return (values / length**derivative).reshape(points.shape)

    def normalised(self, x: npt.ArrayLike, derivative: int = 0) -> Vector:
        """Return `shape` with a modal mass of 1 kg, in 1/(kg^(1/2) m^derivative).

        Parameters and errors are those of `shape`.  ``omega^2`` is then the modal stiffness in
        N/m, and products with forces are modal forces.
        """
        return np.asarray(self.shape(x, derivative) / math.sqrt(self.modal_mass))

    def moment(self, x: npt.ArrayLike) -> Vector:
        """Return the bending moment ``E I u''`` of a beam, in N.

        For the displacement `shape`, which has no unit.

        Raises
        ------
        ValueError
            If it is a string, which has none.
        """
        return self._of_beam("moment", x, 2)

    def shear_force(self, x: npt.ArrayLike) -> Vector:
        """Return the shear force ``E I u'''`` of a beam, in N/m; see `moment`.

        Raises
        ------
        ValueError
            If it is a string, which has none.
        """
        return self._of_beam("shear force", x, 3)

    def _of_beam(self, name: str, x: npt.ArrayLike, derivative: int) -> Vector:
        """Return the bending stiffness of a beam times a derivative."""
        if self._attached.structure.m != 2:
            raise ValueError(f"{name}: a {self._attached.structure.bare} has none")
        return self._attached.restoring * self.shape(x, derivative)

    @property
    def quantity(self) -> str:
        """Name of the quantity that jumps at the attachment: slope, moment or shear force."""
        return QUANTITIES[self._attached.structure.k]

    def discontinuous(self, x: npt.ArrayLike) -> Vector:
        """Return the first discontinuous derivative: slope, moment or shear force."""
        broken = self._attached.structure.broken
        if broken == 1:
            return self.shape(x, 1)
        return self._of_beam(self.quantity, x, broken)

    def as_dict(self) -> dict[str, Any]:
        """Return the mode as plain numbers; bounds are those of the eigenvalue."""
        return {
            "number": self.number,
            "beta": self.beta,
            "frequency": self.frequency,
            "omega": self.omega,
            "eigenvalue": self.eigenvalue,
            "exact": {"beta": self.exact_beta, "frequency": self.exact_frequency},
            "error": self.error,
            "bounds": list(self.bounds),
            "modal_mass": self.modal_mass,
            "jump_mismatch": self.jump_mismatch,
            "node": self.node,
        }


@dataclass(frozen=True, eq=False)
class Shapes(Tabular):
    """The shapes of the lowest modes, each with a modal mass of 1 kg.

    `how` has method, order, forced modes and unknowns; `points` are evenly spaced, the ends
    included.
    """

    attached: Attached
    how: Mapping[str, Any]
    modes: tuple[Mode, ...]
    points: int

    @property
    def x(self) -> Vector:
        """The places in metres."""
        return np.linspace(0.0, self.attached.length, self.points)

    def table(self) -> Table:
        """Return a row for each mode and place; `moment` and `shear_force` for beams only."""
        names = COLUMNS[: 2 * self.attached.structure.m]
        restoring = (1.0, 1.0, self.attached.restoring, self.attached.restoring)
        columns: dict[str, Any] = {
            "number": np.repeat([mode.number for mode in self.modes], self.points),
            "x": np.tile(self.x, len(self.modes)),
        }
        for j, name in enumerate(names):
            values = [restoring[j] * mode.normalised(self.x, j) for mode in self.modes]
            columns[name] = np.concatenate(values)
        units = {"x": "m"} | dict(zip(names, UNITS, strict=False))
        about = self.attached.about | dict(self.how) | dict(self.attached.values)
        return Table(("number", "x"), columns, units, about)

    def as_dict(self) -> dict[str, Any]:
        """Return structure, method and columns as plain numbers."""
        columns = {name: column.tolist() for name, column in self.table().columns.items()}
        return self.attached.as_dict() | dict(self.how) | {"shapes": columns}
