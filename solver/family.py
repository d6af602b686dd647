"""Orbits of a case along one of its parameters: each found from the one before it.

The times of an orbit start the search at the next value.  Where that leads to no orbit, the
search is the one of `solve_case`, and the row says that the orbit was not followed.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import asdict, dataclass, replace
from typing import Any, overload

import numpy as np

from .arrays import Vector
from .kernels import registry
from .no_orbit import NoOrbit
from .orbit.attempt import attempt
from .orbit.errors import Errors
from .presentation.notebook import of_rows
from .presentation.table import Table, Tabular, flat
from .results.document import without_errors
from .results.orbit import Orbit
from .scenes.case import Case
from .scenes.method_names import shown
from .scenes.methods import FIRST
from .scenes.parameter_error import ParameterError
from .solve import check_order, number_of_functions, solve_case

#: Order at which the times of a smooth motion in each phase are at rounding.
ORDER = 20

#: Most values: more than a terminal or a file of rows is for.
MOST_VALUES = 100_000


@dataclass(frozen=True)
class FamilyRow:
    """The orbit at one value of the parameter, or why there is none.

    Parameters
    ----------
    value : float
        Of the parameter, in SI units.
    status : {"ok", "no-orbit", "not-converged"}
    period, forcing_phase : float or None
        In s and rad; None without an orbit, the second also where nothing forces.
    durations : tuple of float or None
        Of the phases of one period, in s.
    extremes : dict or None
        Least and largest ``displacement`` and ``velocity``.
    estimate : Errors or None
        Errors, as estimated.
    iterations : int
        Jacobians factorised.
    followed : bool
        Whether it was found from the orbit at the value before.
    message : str
        Why there is no orbit; empty if there is one.
    motion : str or None
        Which of the scene's motions it is; None without an orbit, or where there is only one.
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

    def as_dict(self) -> dict[str, Any]:
        """Return the row as JSON has it."""
        estimate = without_errors() if self.estimate is None else asdict(self.estimate)
        ends = self.extremes or dict.fromkeys(("displacement", "velocity"))
        return asdict(self) | {"estimate": estimate, "extremes": ends}


#: Numbers of which each row has one, or none.
NUMBERS = ("value", "period", "forcing_phase", "iterations")

#: Units of the numbers in a row.
UNITS = {
    "period": "s",
    "forcing_phase": "rad",
    **{f"{end}_displacement": "m" for end in ("least", "largest")},
    **{f"{end}_velocity": "m/s" for end in ("least", "largest")},
}


@dataclass(frozen=True, repr=False)
class Family(Tabular):
    """The orbits of a case along a parameter, in the order of its values.

    Parameters
    ----------
    case : Case
        The oscillator, with the first value.
    parameter : str
        The name of what varies.
    method, order, functions : str, int, int or None
        How each orbit was computed.
    rows : tuple of FamilyRow
        One a value.
    """

    case: Case
    parameter: str
    method: str
    order: int
    functions: int | None
    rows: tuple[FamilyRow, ...]

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
        """Return ``"value"``, ``"period"`` or ``"forcing_phase"`` of all rows; or some rows.

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
        parts = (
            f"{q.symbol} = {self.case.values[q.name]:.4g} {q.unit}".rstrip()
            for q in self.case.scene.parameters
            if q.name != self.parameter
        )
        return ", ".join(parts)

    def durations_of(self, row: FamilyRow) -> dict[str, float]:
        """Return the durations of a cell's phases in s, by name; empty without an orbit."""
        scene = self.case.scene
        own = scene.of_motion(row.motion) if row.motion else scene
        return dict(zip(own.phases, row.durations or (), strict=False))

    def plot(self, ax: Any = None, quantity: str = "displacement", **style: Any) -> Any:
        """Draw one quantity along the parameter and return the axes.

        Needs matplotlib, the extra ``plot``.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where; new ones without it.
        quantity : {"displacement", "velocity", "times", "estimate", "period"}
            Of the first two both ends; the durations of the phases, or of a single one the
            phase of the forcing; the estimated error of the times; the period.
        **style
            Of the lines, as `matplotlib.axes.Axes.plot` takes it.

        Raises
        ------
        ValueError
            If `quantity` is none of these.
        MissingExtra
            An `ImportError`: if matplotlib is not installed.
        """
        from ..plots.families import draw  # noqa: PLC0415  (an extra)

        return draw(self, ax, quantity, **style)

    def table(self) -> Table:
        """Return the rows; the value has the name of the parameter."""
        columns = flat([row.as_dict() for row in self.rows])
        columns = {self.parameter: columns.pop("value")} | columns
        units = UNITS | {q.name: q.unit for q in self.case.scene.parameters if q.unit}
        units |= {name: "s" for name in columns if name.startswith("duration_")}
        scene = self.case.scene
        about = {"scene": scene.name, "class": f"C{scene.k}", "cycles": self.case.cycles}
        about |= {"motion": scene.motion} if scene.motion else {}
        about |= {"parameter": self.parameter, "method": self.method, "order": self.order}
        about |= {} if self.functions is None else {"functions": self.functions}
        fixed = {n: value for n, value in self.case.values.items() if n != self.parameter}
        return Table((self.parameter,), columns, units, about | fixed)

    def __repr__(self) -> str:
        scene, values = self.case.scene, self["value"]
        found = sum(row.status == "ok" for row in self.rows)
        along = f"{self.parameter} = {values[0]:g} to {values[-1]:g}"
        method = f"{shown(scene, self.method)}, N = {self.order}"
        return f"<{scene.label} along {along} by {method}: {len(self)} values, {found} orbits>"

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

    def _repr_html_(self) -> str:
        return of_rows(repr(self), str(self), self.plot)

    def as_dict(self) -> dict[str, Any]:
        """Return the family as the document that ``sweep --vary --json`` writes."""
        return {
            "scene": self.case.scene.name,
            "class": f"C{self.case.scene.k}",
            "motion": self.case.scene.motion,
            "cycles": self.case.cycles,
            "method": self.case.called(self.method),
            "order": self.order,
            "functions": self.functions,
            "parameters": dict(self.case.values),
            "vary": {"parameter": self.parameter, "count": len(self.rows)},
            "rows": [row.as_dict() for row in self.rows],
        }


class FamilyInterrupted(KeyboardInterrupt):
    """Ctrl-C while a family was computed; `done` is the family of the values before."""

    def __init__(self, done: Family) -> None:
        super().__init__(f"after {len(done)} values")
        self.done = done


def family_case(
    case: Case,
    parameter: str,
    values: Iterable[float],
    method: str = FIRST,
    order: int = ORDER,
    functions: int | None = None,
    progress: Callable[[FamilyRow], None] = lambda row: None,
) -> Family:
    """Return the orbits of a case while one parameter takes each of some values.

    Parameters
    ----------
    case : Case
        The oscillator; its own value of the parameter does not matter.
    parameter : str
        One of the scene.
    values : iterable of float
        In SI units, in the order in which the orbit is to be followed.
    method, order, functions : str, int, int
        See `solve_case`.
    progress : callable
        Called with each row when it is done.

    Raises
    ------
    ParameterError
        If the scene has no such parameter, or a value cannot be one; before anything is
        computed.
    ValueError
        If there are no values or too many, or a method or an order cannot be computed.
    FamilyInterrupted
        A `KeyboardInterrupt`: with the orbits that were computed before.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> case = registry.load(registry.names()[0])()
    >>> name = case.scene.parameters[0].name
    >>> [row.status for row in family_case(case, name, [1.0, 1.1], order=8).rows]
    ['ok', 'ok']
    """
    scene = case.scene
    cases = [_with_value(case, parameter, value) for value in values]
    if not 1 <= len(cases) <= MOST_VALUES:
        raise ValueError(f"values: got {len(cases)}, expected 1 to {MOST_VALUES}")
    name = registry.generic_method(scene, method)
    count = number_of_functions(case, name, None) if functions is None else functions
    number = check_order(registry.kernel(scene.each_motion[0], name, count), order)
    rows: list[FamilyRow] = []
    orbit: Orbit | None = None
    try:
        for each in cases:
            orbit, row = _next(each, name, number, count, orbit, each.values[parameter])
            rows.append(row)
            progress(row)
    except KeyboardInterrupt:
        if not rows:
            raise
        done = Family(cases[0], parameter, name, number, count, tuple(rows))
        raise FamilyInterrupted(done) from None
    return Family(cases[0], parameter, name, number, count, tuple(rows))


def _with_value(case: Case, parameter: str, value: object) -> Case:
    names = [q.name for q in case.scene.parameters]
    if parameter not in names:
        expected = f"one of {', '.join(names)}"
        raise ParameterError([f"parameter: got {parameter!r}, expected {expected}"])
    return case.with_value(parameter, value)


def _next(
    case: Case, method: str, order: int, functions: int | None, before: Orbit | None,
    value: float,
) -> tuple[Orbit | None, FamilyRow]:  # fmt: skip
    """Return the orbit of a case, from the one before if that can be, and its row."""
    spent = 0
    if before is not None:
        here = case.of_motion(before.case.scene.motion) if case.scene.motions else case
        kernel = registry.quicker_kernel(here.scene, method, functions, order)
        times = kernel.times(before.unknowns).copy()
        durations = slice(0, len(here.cell.phases))
        times[durations] *= before.case.units.time / case.units.time
        found = attempt(kernel, here, order, times, functions)
        if found.converged and found.admissible:
            orbit = Orbit.of(found)
            return orbit, _row(orbit, value, followed=True)
        spent = found.iterations
    try:
        orbit = solve_case(case, method, order, functions)
    except NoOrbit as finding:
        nothing = (None, None, None, None, None)
        iterations = finding.iterations + spent
        row = FamilyRow(value, finding.status, *nothing, iterations, False, str(finding))
        return None, row
    orbit = replace(orbit, iterations=orbit.iterations + spent)
    return orbit, _row(orbit, value, followed=False)


def _row(orbit: Orbit, value: float, *, followed: bool) -> FamilyRow:
    return FamilyRow(
        value, "ok", orbit.period, orbit.forcing_phase, orbit.durations, orbit.extremes,
        orbit.estimate, orbit.iterations, followed, motion=orbit.case.scene.motion,
    )  # fmt: skip
