"""Results of stroboscopic simulation: bifurcation diagrams and basins of attraction."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...nearest import counted
from ..arrays import Integers, Matrix, Vector
from ..presentation.table import Table, Tabular
from ..scenes.case import Case

#: Units of the states.
UNITS = {"displacement": "m", "velocity": "m/s"}


@dataclass(frozen=True, eq=False, repr=False)
class Diagram(Tabular):
    """A bifurcation diagram: states once a period of the forcing, along a parameter.

    Parameters
    ----------
    case : Case
        The oscillator; its own value of the parameter does not matter.
    parameter : str
        Name of the parameter that varies.
    values : tuple of float
        Its values, in SI units.
    states : tuple of ndarray, shape (n, 2) or more columns
        Displacement, velocity and memories, for each value; fewer states than asked for, or
        none, if the motion ends.
    """

    case: Case
    parameter: str
    values: tuple[float, ...]
    states: tuple[Matrix, ...]

    def __len__(self) -> int:
        return len(self.values)

    def plot(self, ax: Any = None, quantity: str = "displacement", **style: Any) -> Any:
        """Draw ``displacement`` or ``velocity`` over the parameter and return the axes.

        Needs matplotlib, the extra ``plot``.
        """
        from ...plots.simulations import draw_diagram  # noqa: PLC0415  (an extra)

        return draw_diagram(self, ax, quantity, **style)

    def table(self) -> Table:
        """Return a row for each state; the column of values has the name of the parameter."""
        counts = [len(each) for each in self.states]
        columns: dict[str, Any] = {self.parameter: np.repeat(self.values, counts).tolist()}
        for j, name in enumerate(UNITS):
            columns[name] = [float(row[j]) for each in self.states for row in each]
        fixed = {n: q for n, q in self.case.values.items() if n != self.parameter}
        units = UNITS | {q.name: q.unit for q in self.case.scene.parameters if q.unit}
        return Table((self.parameter,), columns, units, {"scene": self.case.scene.name} | fixed)

    def as_dict(self) -> dict[str, Any]:
        """Return the document that ``simulate --vary --json`` writes."""
        return {
            "scene": self.case.scene.name,
            "parameters": dict(self.case.values),
            "vary": self.parameter,
            "values": list(self.values),
            "states": [each[:, :2].tolist() for each in self.states],
        }

    def __repr__(self) -> str:
        span = f"{self.parameter} = {self.values[0]:g} to {self.values[-1]:g}"
        values = counted(len(self), "value")
        return f"<diagram of {self.case.scene.name} along {span}: {values}>"


@dataclass(frozen=True)
class Attractor:
    """A periodic motion on which other motions settle.

    Parameters
    ----------
    cycles : int
        Periods of the forcing in its period.
    states : tuple of (float, float)
        Displacement in m and velocity in m/s where the phase of the forcing is 0, in order.
    """

    cycles: int
    states: tuple[tuple[float, ...], ...]


@dataclass(frozen=True, eq=False, repr=False)
class Basins(Tabular):
    """The attractor on which the motion from each state of a grid settles.

    Parameters
    ----------
    x, v : ndarray
        Displacements in m and velocities in m/s at the start, where the phase of the forcing
        is 0.
    index : ndarray of int, shape (len(v), len(x))
        The index of the attractor from each start; -1 if the motion has not become periodic,
        -2 if no phase can begin with the start or the motion ends.
    """

    case: Case
    x: Vector
    v: Vector
    attractors: tuple[Attractor, ...]
    index: Integers

    def plot(self, ax: Any = None) -> Any:
        """Draw the starts, coloured by attractor, and the attractors; return the axes.

        Needs matplotlib, the extra ``plot``.
        """
        from ...plots.simulations import draw_basins  # noqa: PLC0415  (an extra)

        return draw_basins(self, ax)

    def table(self) -> Table:
        """Return a row for each start."""
        x, v = np.meshgrid(self.x, self.v)
        starts = {"displacement": x.ravel().tolist(), "velocity": v.ravel().tolist()}
        columns: dict[str, Any] = starts | {"attractor": self.index.ravel().tolist()}
        about = {"scene": self.case.scene.name} | dict(self.case.values)
        return Table(("velocity", "displacement"), columns, UNITS, about)

    def as_dict(self) -> dict[str, Any]:
        """Return the document that ``simulate --grid --json`` writes."""
        return {
            "scene": self.case.scene.name,
            "parameters": dict(self.case.values),
            "x": self.x.tolist(),
            "v": self.v.tolist(),
            "attractors": [
                {"cycles": each.cycles, "states": [list(q) for q in each.states]}
                for each in self.attractors
            ],
            "index": self.index.tolist(),
        }

    def __repr__(self) -> str:
        starts = counted(self.index.size, "start")
        attractors = counted(len(self.attractors), "attractor")
        return f"<basins of {self.case.scene.name}: {starts}, {attractors}>"

    def __str__(self) -> str:
        lines = [f"{'starts':>8}  attractor"]
        for number, each in enumerate(self.attractors):
            part = int((self.index == number).sum())
            x, v = each.states[0]
            every = "each period" if each.cycles == 1 else f"every {each.cycles} periods"
            lines.append(f"{part:8}  x = {x:.6g} m, x' = {v:.6g} m/s, {every}")
        for number, words in ((-1, "not settled"), (-2, "no motion from there")):
            part = int((self.index == number).sum())
            lines += [f"{part:8}  {words}"] if part else []
        return "\n".join(lines)
