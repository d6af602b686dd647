"""Convergence of the expansions: the errors of one mode over the orders, and rates."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from ..accuracy.rates import slope
from ..orbit.quadrature import panels
from ..presentation.table import Table, Tabular, flat
from ..scenes.parameter_error import whole
from .attached import Attached
from .eigenvalues import secular
from .eigenvalues.exact import ExactModes, exact_modes, of_frequency
from .expansions.methods import bare_modes, check_order, shown
from .expansions.shapes import Shape, jump_mismatch, shape_of

#: Relative errors of an eigenvalue below this are rounding.
ROUNDING = 1e-14

#: Least number of quadrature panels of 20 points each; one for each half wave.
LEAST = 2

#: Lowest order in the fit of a rate.
FROM = 4


@dataclass(frozen=True)
class Line:
    """One expansion of a study: a method and its number of forced modes."""

    method: str
    forced: int = 0

    def name(self, attached: Attached) -> str:
        """Return its name with the class of the structure: ``ritz-c1(2)``."""
        return shown(attached.structure, self.method, self.forced)


@dataclass(frozen=True)
class ConvergenceRow:
    """One mode by one expansion at one order.

    Parameters
    ----------
    method : str
    forced, order, unknowns : int
    beta : float or None
        None if the expansion has fewer modes.
    error : float or None
        Relative error of the frequency.
    eigenvalue_error : float or None
        Relative error of the eigenvalue.
    shape, discontinuous : float or None
        Relative L2 error of the displacement, and of the first derivative that jumps.
    jump_mismatch : float or None
        As in `Mode`.
    """

    method: str
    forced: int
    order: int
    unknowns: int
    beta: float | None = None
    error: float | None = None
    eigenvalue_error: float | None = None
    shape: float | None = None
    discontinuous: float | None = None
    jump_mismatch: float | None = None


@dataclass(frozen=True)
class Convergence(Tabular):
    """The rows of a study of one mode.

    Parameters
    ----------
    number : int
        Of the mode, from 1.
    """

    attached: Attached
    number: int
    lines: tuple[Line, ...]
    rows: tuple[ConvergenceRow, ...]

    def of(self, line: Line) -> list[ConvergenceRow]:
        """Return the rows of one expansion that have the mode."""
        return [
            row
            for row in self.rows
            if (row.method, row.forced) == (line.method, line.forced) and row.beta is not None
        ]

    def rate(self, line: Line) -> float | None:
        """Return the fitted power of the order in the error of the eigenvalue.

        From errors above rounding, of orders from `FROM` on; None for fewer than three.
        """
        points = [
            (row.order, row.eigenvalue_error)
            for row in self.of(line)
            if row.eigenvalue_error is not None and row.order >= FROM
        ]
        falls = slope(points, ROUNDING, power=True, fewest=3)
        return None if falls is None else -falls

    def expected(self, line: Line) -> int | None:
        """Return the power that theory predicts; None without one, as for ``ck``."""
        if line.method == "ck" or (
            self.attached.structure.kind == "compliance" and line.forced == 0
        ):
            return None
        return -self.attached.structure.rates[line.forced]

    def plot(self, ax: Any = None, quantity: str = "eigenvalue_error", **style: Any) -> Any:
        """Draw one error against the unknowns, a line for each expansion; return the axes.

        See `nonsmooth.plots.modes.draw_convergence`.
        """
        from ...plots.modes import draw_convergence  # noqa: PLC0415  (an extra)

        return draw_convergence(self, ax, quantity, **style)

    def table(self) -> Table:
        """Return the rows, with names of expansions as in pictures."""
        rows = [asdict(row) for row in self.rows]
        for row in rows:
            row["method"] = Line(row["method"], row["forced"]).name(self.attached)
        about = self.attached.about | {"number": self.number} | dict(self.attached.values)
        return Table(("method", "order"), flat(rows), {}, about)

    def as_dict(self) -> dict[str, Any]:
        """Return the study as plain numbers."""
        return self.attached.as_dict() | {
            "number": self.number,
            "rows": [asdict(row) for row in self.rows],
            "rates": [
                {
                    "method": line.method,
                    "forced": line.forced,
                    "fitted": self.rate(line),
                    "expected": self.expected(line),
                }
                for line in self.lines
            ],
        }


def convergence(
    attached: Attached,
    lines: Sequence[Line],
    orders: Iterable[int],
    number: int = 1,
    done: Callable[[str], None] = lambda words: None,
) -> Convergence:
    """Return the errors of one mode by several expansions over several orders.

    Parameters
    ----------
    attached : Attached
    lines : sequence of Line
    orders : iterable of int
    number : int
        Number of the mode, from 1.
    done : callable
        Called with a message after each computation.

    Raises
    ------
    ValueError
        If an order is out of the range of a method.

    Examples
    --------
    >>> from nonsmooth.solver.space.attached import attach
    >>> from nonsmooth.solver.space.structure import load
    >>> study = convergence(attach(load("string-mass")), [Line("ritz-ck", 1)], (8, 16, 32))
    >>> f"{study.rate(study.lines[0]):.0f}", study.expected(study.lines[0])
    ('-5', -5)
    """
    whole("mode", number)
    orders, rows = tuple(orders), []
    pairs = [(line, check_order(line.method, order)) for line in lines for order in orders]
    for line, order in pairs:
        rows.append(_row(attached, line, order, number))
        done(f"{line.name(attached)}, N = {order}")
    return Convergence(attached, number, tuple(lines), tuple(rows))


def _row(attached: Attached, line: Line, order: int, number: int) -> ConvergenceRow:
    """Return the errors of one mode by one expansion at one order."""
    bare = bare_modes(attached, line.method, order, line.forced)
    head = ConvergenceRow(line.method, line.forced, order, bare.unknowns)
    if bare.count < number:
        return head
    roots = secular.eigenvalues(bare, attached, number)
    exact, i = exact_modes(attached, number), number - 1
    error = exact.error(roots, i)
    shape = shape_of(attached, bare, roots, i)
    displacement, discontinuous = shape_errors(attached, shape, exact, number, order)
    value = float(roots.values[i])
    return replace(
        head,
        beta=value ** (1 / (2 * attached.structure.m)),
        error=of_frequency(error),
        eigenvalue_error=error,
        shape=displacement,
        discontinuous=discontinuous,
        jump_mismatch=None if exact.untouched[i] else jump_mismatch(attached, shape, value),
    )


def shape_errors(
    attached: Attached, shape: Shape, exact: ExactModes, number: int, waves: int
) -> tuple[float, ...]:
    """Return the relative L2 errors of a mode and of the first derivative that jumps.

    Parameters
    ----------
    number : int
        Of the mode, from 1.
    waves : int
        Half waves of the finest function in `shape`.
    """
    x, weights = panels([float(attached.a)], max(LEAST, waves + number))
    u, u_exact = shape.values(x, 0), exact.shape(number, x, 0)
    scale = 1 / np.sqrt(weights @ u_exact**2)
    scale = scale if weights @ (u * u_exact) > 0 else -scale
    errors = []
    for derivative in (0, attached.structure.broken):
        target = scale * exact.shape(number, x, derivative)
        difference = shape.values(x, derivative) - target
        errors.append(float(np.sqrt(weights @ difference**2 / (weights @ target**2))))
    return tuple(errors)
