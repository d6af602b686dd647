"""Convergence of the methods over orders: one row each, whatever comes of it."""

import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass, fields
from typing import Any, overload

from ...no_orbit import NoOrbit
from ...results.notebook import of_rows
from ...results.table import Table, Tabular, flat
from ..accuracy.convergence import Rate, rate
from ..accuracy.errors import Errors
from ..accuracy.estimate import Estimate
from ..names import SCENE
from ..orbit.methods import METHODS, check_belt, check_method, check_order, with_terms
from ..orbit.oscillator import StickSlip
from . import kernels
from .solve import solve

#: Squared orders, summed, that plain Python solves while numba compiles.
COMPILING = 200_000


@dataclass(frozen=True)
class Row:
    """One method at one order.

    Parameters
    ----------
    method, order : str, int
        What was asked for.
    status : {"ok", "no-orbit", "not-converged"}
        An orbit; shown that there is none; none found.
    t1, period : float or None
        In s; None without an orbit.
    iterations : int
        Jacobians factorised.
    errors : Errors or None
        Against the exact orbit; None without an orbit.
    seconds : float
        Time of the search; with the first order of a method, compilation too.
    estimate : Estimate or None
        The errors as estimated without the exact orbit; None without an orbit.
    message : str
        Why there is no orbit; empty if there is one.
    """

    method: str
    order: int
    status: str
    t1: float | None
    period: float | None
    iterations: int
    errors: Errors | None
    seconds: float
    estimate: Estimate | None
    message: str = ""

    def as_dict(self) -> dict[str, object]:
        """Return the row as JSON has it."""
        row = asdict(self)
        if self.errors is None:
            row["errors"] = dict.fromkeys(field.name for field in fields(Errors))
            row["estimate"] = dict.fromkeys(field.name for field in fields(Estimate))
        return row


@dataclass(frozen=True, repr=False)
class Sweep(Tabular, Sequence[Row]):
    """The rows of a sweep, in the order in which they were asked for."""

    belt: StickSlip
    rows: tuple[Row, ...]
    c1_terms: int = 1

    @overload
    def __getitem__(self, index: int) -> Row: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[Row, ...]: ...

    def __getitem__(self, index: int | slice) -> Row | tuple[Row, ...]:
        return self.rows[index]

    def __len__(self) -> int:
        return len(self.rows)

    def of(self, method: str) -> tuple[Row, ...]:
        """Return the rows of one method."""
        return tuple(row for row in self.rows if row.method == method)

    def rates(self) -> dict[str, Rate]:
        """Return how fast each method converges, by name."""
        found: dict[str, list[tuple[int, Errors]]] = {}
        for row in self.rows:
            orders = found.setdefault(row.method, [])
            if row.errors is not None:
                orders.append((row.order, row.errors))
        return {method: rate(method, rows) for method, rows in found.items()}

    def as_dict(self) -> dict[str, Any]:
        """Return the sweep as the document that ``sweep --json`` writes."""
        from ....files.shortcuts import as_any_scene, documents  # noqa: PLC0415  (it reads this)

        return as_any_scene.scene() | documents.of_sweep(self)

    def plot(self, ax: Any = None, quantity: str = "period", **style: Any) -> Any:
        """Draw one quantity against the order, a line a method; return the axes.

        Needs matplotlib, the extra ``plot``.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where; new ones, with a legend, without it.
        quantity : {"period", "acceleration", "ratio"}
            The error of the period, or of the acceleration (22), which is not drawn where it
            is below rounding; or the period in exact periods.
        **style
            Of the lines, as `matplotlib.axes.Axes.plot` takes it.

        Raises
        ------
        ValueError
            If `quantity` is none of these.
        MissingExtra
            An `ImportError`: if matplotlib is not installed.
        """
        from ....plots.shortcuts.sweeps import draw  # noqa: PLC0415  (an extra)

        return draw(self, ax, quantity, **style)

    def table(self) -> Table:
        """Return the rows, with the errors and the estimates as columns."""
        columns = flat([row.as_dict() for row in self.rows])
        units = {"t1": "s", "period": "s", "seconds": "s"}
        about = {"scene": SCENE, "class": "C1", "c1_terms": self.c1_terms}
        return Table(("method", "order"), columns, units, about | asdict(self.belt))

    def __repr__(self) -> str:
        names = ", ".join(dict.fromkeys(row.method for row in self.rows))
        found = sum(row.status == "ok" for row in self.rows)
        return f"<sweep of {SCENE} by {names}: {len(self)} rows, {found} orbits>"

    def _repr_html_(self) -> str:
        return of_rows(repr(self), str(self), self.plot)

    def __str__(self) -> str:
        lines = [f"{'method':8}{'N':>5}  {'T [s]':>15}  {'T/T_exact-1':>12}  {'(22)':>10}"]
        for row in self.rows:
            head = f"{row.method:8}{row.order:5d}  "
            if row.errors is None or row.period is None:
                lines.append(f"{head}{row.status}: {row.message}")
                continue
            errors = row.errors
            lines.append(
                f"{head}{row.period:15.10g}  {errors.period:12.3e}  {errors.acceleration:10.3e}"
            )
        return "\n".join(lines)


def sweep(
    belt: StickSlip,
    methods: str | Sequence[str] | None = None,
    orders: Iterable[int] = range(1, 41),
    *,
    c1_terms: int = 1,
    progress: Callable[[Row], None] = lambda row: None,
) -> Sweep:
    """Solve for each method and order, and compare with the exact orbit.

    Parameters
    ----------
    belt : StickSlip
        The oscillator.
    methods : {"hb", "hb-c1", "c1"} or a sequence of them, optional
        The methods, one after the other.  The default is all three, without those orders that
        a method cannot compute and another can.
    orders : iterable of int
        The orders of every method.
    c1_terms : int
        C1 functions of ``"hb-c1"``, 1 to 6; the paper has one.
    progress : callable, optional
        Called with each row when it is done.

    Raises
    ------
    TypeError
        If `belt` is not a `StickSlip`.
    ValueError
        If a method or an order is not one that can be computed; before anything is.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> print(ns.sweep(belt, methods=["c1"], orders=[3, 5]))
    method      N            T [s]   T/T_exact-1        (22)
    c1          3     0.6690781172    -3.219e-03   1.310e-01
    c1          5     0.6712755659     5.463e-05   2.319e-02
    """
    check_belt(belt)
    if not isinstance(orders, Iterable):
        raise ValueError(f"orders: got {orders!r}, expected whole numbers in a sequence")
    jobs = _jobs(methods, list(orders), c1_terms)
    rows, many = [], _worth_compiling(jobs)
    for name, order in jobs:
        row = _row(belt, name, order, many, c1_terms)
        progress(row)
        rows.append(row)
    return Sweep(belt, tuple(rows), c1_terms)


def _jobs(
    methods: str | Sequence[str] | None, orders: list[int], c1_terms: int
) -> list[tuple[str, int]]:
    """Return each method and order that is to be computed."""
    known = dict(METHODS) | {"hb-c1": with_terms(METHODS["hb-c1"], c1_terms)}
    if methods is not None:
        names = (methods,) if isinstance(methods, str) else methods
        chosen = [known[check_method(name).name] for name in names]
        return [(method.name, check_order(n, method)) for method in chosen for n in orders]
    most = max(known.values(), key=lambda method: method.highest_order)
    numbers = [check_order(n, most) for n in orders]
    return [(m.name, n) for m in known.values() for n in numbers if n <= m.highest_order]


def _worth_compiling(jobs: list[tuple[str, int]]) -> bool:
    """Return whether to compile: what is in the cache, or would take longer as Python."""
    if sum(order**2 for _, order in jobs) > COMPILING:
        return True
    names = {"c1" if name == "c1" else "hb-symmetric" for name, _ in jobs}
    return all(kernels.is_compiled(name) for name in names)


def _row(belt: StickSlip, method: str, order: int, many: bool, c1_terms: int) -> Row:
    begin = time.perf_counter()
    try:
        terms = c1_terms if method == "hb-c1" else 1
        orbit = solve(belt, method, order, c1_terms=terms, many=many)
    except NoOrbit as finding:
        seconds = time.perf_counter() - begin
        message = str(finding)
        return Row(
            method,
            order,
            finding.status,
            None,
            None,
            finding.iterations,
            None,
            seconds,
            None,
            message,
        )
    seconds = time.perf_counter() - begin
    return Row(
        method,
        order,
        "ok",
        orbit.t1,
        orbit.period,
        orbit.iterations,
        orbit.errors,
        seconds,
        orbit.estimate,
    )
