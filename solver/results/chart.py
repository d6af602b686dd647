"""A map over two parameters as a result: motions, their stability, curves of events."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...nearest import in_short
from ..arrays import Integers, Matrix, Vector
from ..presentation.table import Table, Tabular
from ..scenes.case import Case

#: Whether an orbit is stable, by its code in arrays.
STABLE = {1: True, 0: False, -1: None}


@dataclass(frozen=True, eq=False)
class EventCurve:
    """A curve of an event of orbits in the plane of two parameters.

    Parameters
    ----------
    kind : str
        As in `BranchEvent`.
    motion : str
        The motion of the orbits on it.
    points : ndarray, shape (m, 2)
        Both parameters, in SI units, from one end to the other.
    why_it_ended : (str, str)
        Why it ends at its start, and at its end.
    """

    kind: str
    motion: str
    points: Matrix
    why_it_ended: tuple[str, str]


@dataclass(frozen=True, eq=False, repr=False)
class Chart(Tabular):
    """The motions of an oscillator over two of its parameters.

    Parameters
    ----------
    case : Case
        The oscillator; its own values of the two parameters do not matter.
    parameters : (str, str)
        Names of the parameters that vary along the columns, and along the rows.
    values : (ndarray, ndarray)
        Their values, in SI units.
    motions : tuple of str
        The motions that occur: names of the scene, or phases joined by commas; ``only`` and a
        phase if it never ends.
    index, stable : ndarray of int, shape (rows, columns)
        The index of the motion, -1 if none is found; 1 if it is stable, 0 if it is not, -1 if
        unknown.
    curves : tuple of EventCurve
        Curves of events.
    """

    case: Case
    parameters: tuple[str, str]
    values: tuple[Vector, Vector]
    motions: tuple[str, ...]
    index: Integers
    stable: Integers
    curves: tuple[EventCurve, ...]

    @property
    def axes(self) -> dict[str, list[float]]:
        """The values of each parameter, in SI units."""
        pairs = zip(self.parameters, self.values, strict=True)
        return {name: values.tolist() for name, values in pairs}

    @property
    def motion(self) -> list[list[str | None]]:
        """The motion at each point, row by row; None where none is found."""
        names = [*self.motions, None]
        return [[names[i] for i in row] for row in self.index.tolist()]

    def plot(self, ax: Any = None) -> Any:
        """Draw the regions of motions and the curves between them, and return the axes.

        Regions without a stable orbit are hatched, those without an orbit white.  Needs
        matplotlib, the extra ``plot``.
        """
        from ...plots.charts import draw  # noqa: PLC0415  (an extra)

        return draw(self, ax)

    def rows(self) -> Iterator[dict[str, Any]]:
        """Yield a row for each point, as in files."""
        fixed = {"scene": self.case.scene.name, "cycles": self.case.cycles} | self._others
        columns, rows = self.axes.values()
        for b, motion, stable in zip(rows, self.motion, self.stable.tolist(), strict=True):
            for a, name, stability in zip(columns, motion, stable, strict=True):
                point = dict(zip(self.parameters, (a, b), strict=True))
                yield point | {"motion": name, "stable": STABLE[stability]} | fixed

    def table(self) -> Table:
        """Return a row for each point: both parameters, the motion, whether it is stable."""
        a, b = np.meshgrid(*self.values)
        coordinates = dict(zip(self.parameters, (a.ravel(), b.ravel()), strict=True))
        names = np.array([*self.motions, ""])
        stable = np.where(self.stable < 0, np.nan, self.stable).ravel()
        columns = coordinates | {"motion": names[self.index.ravel()], "stable": stable}
        units = {q.name: q.unit for q in self.case.scene.parameters if q.unit}
        about = {"scene": self.case.scene.name, "cycles": self.case.cycles} | self._others
        return Table(self.parameters[::-1], columns, units, about)

    def as_dict(self) -> dict[str, Any]:
        """Return the document that ``map --json`` writes."""
        return {
            "scene": self.case.scene.name,
            "cycles": self.case.cycles,
            "parameters": dict(self.case.values),
            "vary": list(self.parameters),
            "axes": self.axes,
            "motions": list(self.motions),
            "motion": self.motion,
            "stable": [[STABLE[i] for i in row] for row in self.stable.tolist()],
            "curves": [
                {
                    "kind": curve.kind,
                    "motion": curve.motion,
                    "points": curve.points.tolist(),
                    "why_it_ended": dict(
                        zip(("start", "end"), curve.why_it_ended, strict=True)
                    ),
                }
                for curve in self.curves
            ],
        }

    @property
    def _others(self) -> dict[str, float]:
        """The parameters that do not vary."""
        return {n: q for n, q in self.case.values.items() if n not in self.parameters}

    def __repr__(self) -> str:
        count = " by ".join(str(len(each)) for each in self.values)
        over = " and ".join(self.parameters)
        return f"<map of {self.case.scene.name} over {over}: {count} points>"

    def __str__(self) -> str:
        lines = [f"{'points':>8}  {'stable':>8}  motion"]
        for i, name in enumerate([*self.motions, "none found"]):
            mask = self.index == (i if i < len(self.motions) else -1)
            count = int(mask.sum())
            stable = int((mask & (self.stable == 1)).sum())
            lines += [f"{count:8}  {stable:8}  {in_short(name)}"] if count else []
        first, second = self.parameters
        for curve in self.curves:
            ends = (f"({a:.6g}, {b:.6g})" for a, b in curve.points[[0, -1]])
            lines.append(f"{curve.kind} of {in_short(curve.motion)}: {' to '.join(ends)}")
        return "\n".join([*lines, f"({first}, {second})"] if self.curves else lines)
