"""A sweep over orders as a result: a row for each method and order."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any, overload

from ...nearest import counted
from ..accuracy.rates import Rate, rate
from ..kernels import registry
from ..orbit.errors import Errors
from ..presentation.table import OfRows, Table, flat
from ..scenes.case import Case
from ..scenes.methods import shown
from .document import errors_of


@dataclass(frozen=True)
class SweepRow:
    """The orbit of one method at one order, or why there is none.

    Parameters
    ----------
    method, order : str, int
        Generic name, and order.
    status : {"ok", "no-orbit", "not-converged"}
        An orbit was found; proved that there is none; none was found.
    period : float or None
        In s; None without an orbit, as are all fields below but `iterations` and `seconds`.
    forcing_phase : float or None
        In rad; None also without forcing.
    durations : tuple of float or None
        Durations of the phases of one period, in s.
    iterations : int
        Jacobians factorised.
    errors, estimate : Errors or None
        Errors against the exact orbit; estimated without it.
    seconds : float
        Time of the search, which may include that of compilation.
    message : str
        Why there is no orbit; empty if there is one.
    further : mapping
        `Orbit.further`.
    """

    method: str
    order: int
    status: str
    period: float | None
    forcing_phase: float | None
    durations: tuple[float, ...] | None
    iterations: int
    errors: Errors | None
    estimate: Errors | None
    seconds: float
    message: str = ""
    further: Mapping[str, float] = field(default_factory=dict, hash=False)

    def as_dict(self) -> dict[str, Any]:
        """Return the row as in JSON documents."""
        record: dict[str, Any] = asdict(self) | {
            "errors": errors_of(self.errors),
            "estimate": errors_of(self.estimate),
        }
        record |= record.pop("further")
        return record


#: Units of the numbers in a row.
UNITS = {"period": "s", "forcing_phase": "rad", "seconds": "s", "t1": "s"}


@dataclass(frozen=True, repr=False)
class Sweep(OfRows, Sequence[SweepRow]):
    """The rows of a sweep of a case, in the order of the request."""

    case: Case
    rows: tuple[SweepRow, ...]
    functions: int | None = None

    @overload
    def __getitem__(self, index: int) -> SweepRow: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[SweepRow, ...]: ...

    def __getitem__(self, index: int | slice) -> SweepRow | tuple[SweepRow, ...]:
        return self.rows[index]

    def __len__(self) -> int:
        return len(self.rows)

    def of(self, method: str) -> tuple[SweepRow, ...]:
        """Return the rows of one method, by either of its names."""
        name = registry.generic_method(self.case.scene, method)
        return tuple(row for row in self.rows if row.method == name)

    def rates(self) -> dict[str, Rate]:
        """Return the rate of convergence of each method, by its generic name."""
        rates = {}
        for method in dict.fromkeys(row.method for row in self.rows):
            rows = [(row.order, asdict(row.errors)) for row in self.of(method) if row.errors]
            rates[method] = rate(method, rows)
        return rates

    def dictionaries(self) -> list[dict[str, Any]]:
        """Return the rows as in JSON documents, all with the same keys in the same order."""
        records = []
        for row in self.rows:
            values = row.as_dict() | {"method": self.case.called(row.method)}
            values |= {name: values.pop(name, None) for name in self.case.own_numbers}
            values["errors"] = dict.fromkeys(self.case.own_errors) | values["errors"]
            records.append(values)
        return records

    def as_dict(self) -> dict[str, Any]:
        """Return the sweep as the document that ``sweep --json`` writes."""
        rates = {self.case.called(name): asdict(q) for name, q in self.rates().items()}
        return self.head() | {"rows": self.dictionaries(), "rates": rates}

    def plot(self, ax: Any = None, quantity: str = "times", **style: Any) -> Any:
        """Draw one error against the order, a line for each method; return the axes.

        Needs matplotlib, the extra ``plot``.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Axes to draw in; by default new ones with a legend.
        quantity : {"times", "discontinuous", "period"}
            A field of `Errors`.
        **style
            Style of the lines, as for `matplotlib.axes.Axes.plot`.

        Raises
        ------
        ValueError
            If `quantity` is none of these.
        MissingExtra
            An `ImportError`: if matplotlib is not installed.
        """
        from ...plots.sweeps import draw  # noqa: PLC0415  (an extra)

        return draw(self, ax, quantity, **style)

    def table(self) -> Table:
        """Return the rows; `duration_1` and so on are the durations of phases of a period."""
        columns = flat(self.dictionaries())
        units = UNITS | {n: "s" for n in columns if n.startswith("duration_")}
        return Table(("method", "order"), columns, units, self.about() | dict(self.case.values))

    def __repr__(self) -> str:
        names = dict.fromkeys(shown(self.case.scene, row.method) for row in self.rows)
        orbits = counted(sum(row.status == "ok" for row in self.rows), "orbit")
        head = f"sweep of {self.case.scene.label} by {', '.join(names)}"
        return f"<{head}: {counted(len(self), 'row')}, {orbits}>"

    def __str__(self) -> str:
        lines = [f"{'method':8}{'N':>5}  {'T [s]':>15}  {'times':>9}  {'jump':>9}  estimate"]
        for row in self.rows:
            head = f"{shown(self.case.scene, row.method):8}{row.order:5d}  "
            if row.errors is None or row.estimate is None:
                lines.append(f"{head}{row.status}: {row.message:.60}")
                continue
            errors = f"{row.errors.times:9.2e}  {row.errors.discontinuous:9.2e}"
            lines.append(f"{head}{row.period:15.10g}  {errors}  {row.estimate.times:8.1e}")
        return "\n".join(lines)
