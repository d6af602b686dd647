"""A family of orbits along a parameter as a result: a row for each value."""

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any, ClassVar, overload

import numpy as np

from ...nearest import counted
from ..arrays import Vector
from ..in_order import motion_of
from ..orbit.errors import Errors
from ..presentation.table import OfRows, Table, flat
from ..scenes.case import Case
from ..scenes.methods import shown
from ..scenes.ordered import ONLY
from .document import errors_of


@dataclass(frozen=True)
class Beside:
    """The orbit of an expansion next to an exact one.

    Parameters
    ----------
    period, forcing_phase : float, float or None
        In s and rad; the second is None without forcing.
    durations : tuple of float
        Durations of the phases of one period, in s.
    errors : Errors
        Errors against the exact orbit.
    """

    period: float
    forcing_phase: float | None
    durations: tuple[float, ...]
    errors: Errors

    @property
    def numbers(self) -> dict[str, float | None]:
        """Its columns in tables."""
        errors = {f"beside_error_{name}": value for name, value in asdict(self.errors).items()}
        times = {"beside_period": self.period, "beside_forcing_phase": self.forcing_phase}
        return times | errors


@dataclass(frozen=True)
class FamilyRow:
    """The orbit at one value of the parameter, or why there is none.

    Parameters
    ----------
    value : float
        Value of the parameter, in SI units.
    status : {"ok", "no-orbit", "not-converged"}
    period, forcing_phase : float or None
        In s and rad; None without an orbit, the second also without forcing.
    durations : tuple of float or None
        Durations of the phases of one period, in s.
    extremes : dict or None
        Least and largest ``displacement`` and ``velocity``.
    estimate : Errors or None
        Estimated errors.
    iterations : int
        Jacobians factorised.
    followed : bool
        Whether it was found from the orbit at the value before.
    message : str
        Why there is no orbit; empty if there is one.
    motion : str or None
        Which of the scene's motions it is; None without an orbit, or if there is only one.
    multipliers : tuple of complex or None
        Floquet multipliers of a whole period, the largest first; None if there are none.
    stable : bool or None
        Whether perturbations decay; None if unknown.
    strobe : (float, float) or None
        Displacement and velocity where the phase of the forcing is 0; None without forcing.
    beside : Beside or None
        On a branch, the orbit of an expansion next to it, if one was asked for and found.
    """

    value: float
    status: str
    period: float | None
    forcing_phase: float | None
    durations: tuple[float, ...] | None
    extremes: dict[str, tuple[float, float]] | None
    estimate: Errors | None
    iterations: int
    followed: bool
    message: str = ""
    motion: str | None = None
    multipliers: tuple[complex, ...] | None = None
    stable: bool | None = None
    strobe: tuple[float, float] | None = None
    beside: Beside | None = None

    @property
    def largest_multiplier(self) -> float | None:
        """The largest modulus of the multipliers; None if there are none."""
        return (
            None if self.multipliers is None else max(map(abs, self.multipliers), default=0.0)
        )

    def as_dict(self) -> dict[str, Any]:
        """Return the row as in JSON documents."""
        ends = self.extremes or dict.fromkeys(("displacement", "velocity"))
        record = asdict(self) | {"estimate": errors_of(self.estimate), "extremes": ends}
        if self.beside is None:
            del record["beside"]
        if self.multipliers is not None:
            record["multipliers"] = [{"re": q.real, "im": q.imag} for q in self.multipliers]
        return record


#: Fields of a row that are a number or None.
NUMBERS = ("value", "period", "forcing_phase", "iterations")

#: Units of the numbers in a row.
UNITS = {
    "period": "s",
    "forcing_phase": "rad",
    **{f"{end}_displacement": "m" for end in ("least", "largest")},
    **{f"{end}_velocity": "m/s" for end in ("least", "largest")},
    "strobe_1": "m",
    "strobe_2": "m/s",
}


@dataclass(frozen=True, repr=False)
class Family(OfRows):
    """The orbits of a case along a parameter, in the order of its values.

    Parameters
    ----------
    case : Case
        The oscillator, with the first value.
    parameter : str
        Name of the parameter that varies.
    method, order, functions : str, int, int or None
        How each orbit was computed.
    rows : tuple of FamilyRow
        One for each value.
    """

    case: Case
    parameter: str
    method: str
    order: int
    functions: int | None
    rows: tuple[FamilyRow, ...]

    #: Whether the rows are successive points of one branch.
    in_turn: ClassVar[bool] = False

    def __len__(self) -> int:
        return len(self.rows)

    def __hash__(self) -> int:
        return hash((self.case, self.parameter, self.method, self.order, len(self)))

    def __iter__(self) -> Iterator[FamilyRow]:
        return iter(self.rows)

    @overload
    def __getitem__(self, index: str) -> Vector: ...

    @overload
    def __getitem__(self, index: int) -> FamilyRow: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[FamilyRow, ...]: ...

    def __getitem__(
        self, index: str | int | slice
    ) -> Vector | FamilyRow | tuple[FamilyRow, ...]:
        """Return a column of numbers by its name, or rows by index.

        The names are ``"value"``, ``"period"``, ``"forcing_phase"`` and ``"iterations"``.

        Raises
        ------
        KeyError
            If there are no numbers of this name.
        """
        if not isinstance(index, str):
            return self.rows[index]
        if index not in NUMBERS:
            raise KeyError(f"got {index!r}, expected one of {', '.join(NUMBERS)}")
        return np.array([getattr(row, index) for row in self.rows], dtype=float)

    @property
    def other_parameters(self) -> str:
        """The parameters that do not vary, by their symbols, in one line."""
        return self.case.described(self.parameter)

    def durations_of(self, row: FamilyRow) -> dict[str, float]:
        """Return the durations of a cell's phases in s, by name; empty without an orbit."""
        scene = self.case.scene
        if row.motion and row.motion.startswith(ONLY):
            names = [row.motion.removeprefix(ONLY)]  # without a forcing it never ends
        else:
            motion = motion_of(scene, row.motion) if row.motion else scene
            names = [name for name, _ in motion.kinds]
        return dict(zip(names, row.durations or (), strict=False))

    def plot(self, ax: Any = None, quantity: str = "displacement", **style: Any) -> Any:
        """Draw one quantity along the parameter and return the axes.

        Needs matplotlib, the extra ``plot``.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Axes to draw in; new ones by default.
        quantity : str
            ``"displacement"``, ``"velocity"``: both extremes; ``"times"``: the durations of the
            phases, or, for a single phase, the phase of the forcing; ``"estimate"``: the
            estimated error of the times; ``"period"``; ``"amplitude"``; ``"multiplier"``: the
            largest modulus; ``"strobe"``: the displacement where the phase of the forcing is 0.
        **style
            Style of the lines, as for `matplotlib.axes.Axes.plot`.

        Raises
        ------
        ValueError
            If `quantity` is none of these.
        MissingExtra
            An `ImportError`: if matplotlib is not installed.
        """
        from ...plots.families import draw  # noqa: PLC0415  (an extra)

        return draw(self, ax, quantity, **style)

    def table(self) -> Table:
        """Return the rows; the column of values has the name of the parameter."""
        rows = [row.as_dict() | {"multipliers": row.largest_multiplier} for row in self.rows]
        for record, row in zip(rows, self.rows, strict=True):
            record.pop("beside", None)
            record.update({} if row.beside is None else row.beside.numbers)
        columns = flat(rows)
        columns["largest_multiplier"] = columns.pop("multipliers")
        columns = {self.parameter: columns.pop("value")} | columns
        units = UNITS | {q.name: q.unit for q in self.case.scene.parameters if q.unit}
        units |= {name: "s" for name in columns if name.startswith("duration_")}
        fixed = {n: value for n, value in self.case.values.items() if n != self.parameter}
        how = {"parameter": self.parameter, "method": self.method, "order": self.order}
        return Table((self.parameter,), columns, units, self.about(**how) | fixed)

    def __repr__(self) -> str:
        scene, values = self.case.scene, self["value"]
        orbits = counted(sum(row.status == "ok" for row in self.rows), "orbit")
        span = f"{self.parameter} = {values[0]:g} to {values[-1]:g}"
        method = f"{shown(scene, self.method)}, N = {self.order}"
        number = counted(len(self), "value")
        return f"<{scene.label} along {span} by {method}: {number}, {orbits}>"

    def __str__(self) -> str:
        ends = f"{'least x':>10}  {'largest x':>10}"
        lines = [f"{self.parameter:>14}  {'T [s]':>15}  {ends}  estimate"]
        for row in self.rows:
            head = f"{row.value:14.8g}  "
            if row.period is None or row.extremes is None or row.estimate is None:
                lines.append(f"{head}{row.status}: {row.message:.60}")
                continue
            low, high = row.extremes["displacement"]
            ends = f"{low + 0.0:10.6g}  {high + 0.0:10.6g}"
            lines.append(f"{head}{row.period:15.10g}  {ends}  {row.estimate.times:8.1e}")
        return "\n".join(lines)

    def as_dict(self) -> dict[str, Any]:
        """Return the family as the document that ``sweep --vary --json`` writes."""
        how = {"method": self.case.called(self.method), "order": self.order}
        varied = {"parameter": self.parameter, "count": len(self.rows)}
        rows = [row.as_dict() for row in self.rows]
        return self.head(**how) | {"vary": varied, "rows": rows}
