"""The shapes of modes at places along the structure, as a table and as files."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arrays import Vector
from ..presentation.table import Table, Tabular
from .attached import Attached
from .mode import Mode

#: Columns by the order of the derivative, and their units; the last two of beams alone.
COLUMNS = ("displacement", "slope", "moment", "shear_force")
UNITS = ("kg^(-1/2)", "kg^(-1/2) m^-1", "kg^(-1/2) N", "kg^(-1/2) N m^-1")


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
        """Return a row a mode and place; `moment` and `shear_force` of beams alone."""
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
