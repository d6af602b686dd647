"""The exact equations of a body along a parameter, as the steps of a branch take them.

Unknown are the state at the beginning and the times (see `bodies.exact.opened`).  The functions
stand for those of the same names in `extended`, `watch`, `cell_map` and `linear`, in plain
NumPy: what a step costs is the eigenbasis of each phase.
"""

from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ...arrays import Indices, Matrix, Vector
from ...bodies.exact import Evaluation, gained, opened, seen
from ...bodies.part import generator_of, parts_of
from ...bodies.perturbed import cell_map as perturbed
from ...scenes.parameter_error import ParameterError
from ..watch import (
    AT_SWITCH,
    BEGINS,
    BEHIND,
    END,
    INTO,
    IS_END,
    KIND,
    LEAST,
    PHASE,
    START,
    WITHIN,
)

if TYPE_CHECKING:
    from ...scenes.bodies.cell import BodyCell

#: Points of a phase a radian of its quickest part, at least and at most.
A_RADIAN, FEWEST, MOST = 2.0, 32, 1024

#: Critical points that are refined, those of the least values; corrections of each.
REFINED, CORRECTIONS_INSIDE = 4, 6

#: Derivatives of a form that are looked at where a phase begins.
HIGHEST = 3


class At(NamedTuple):
    """A body's cell at a value of a parameter, and the forms that are watched there.

    Parameters
    ----------
    cell : BodyCell
    forms : ndarray, shape (R, S + M)
    """

    cell: "BodyCell"
    forms: Matrix


def times_of(cell: "BodyCell", z: Vector) -> Vector:
    """Return the times among unknowns."""
    return z[len(z) - len(cell.phases) - cell.forced :]


def case_at(along: Any, q: float) -> At | None:
    """Return the cell at a value of the parameter, with the forms that are watched.

    None where there is no such body, as of a mode with exactly critical damping.
    """
    try:
        found: At = along.series(float(q))
    except ParameterError:
        return None
    return found


def left_sides(along: Any, z: Vector, q: float, R: Vector) -> None:
    """Fill R with the left sides of the equations at a value of the parameter."""
    equations(case_at(along, q), along.divided, z, R, np.empty((len(z), len(z))))


def equations(case: At | None, divided: Any, z: Vector, R: Vector, J: Matrix) -> None:
    """Fill R with the left sides of the equations of a cell, J with their derivatives by z."""
    n = len(z)
    R[:n], J[:] = np.nan, np.nan
    if case is None:
        return
    try:
        found = opened(case.cell, z)
    except ValueError:  # singular, or a law that does not fix its force
        return
    R[:n], J[:] = found.residual, found.jacobian
    for p in np.flatnonzero(divided):
        times = times_of(case.cell, z)
        row, s = n - len(times) + int(p), times[p]
        change, by = gained(case.cell, times, int(p), found)
        R[row], J[row] = change / s, by / s
        J[row, row] -= change / s**2


def factorise(matrix: Matrix, rows: Vector) -> bool:
    """Factorise a matrix in place, by LAPACK; `rows` are exchanged as it does."""
    from scipy.linalg import lu_factor  # noqa: PLC0415  (a scene of one mass needs none)

    if not np.isfinite(matrix).all():
        return False
    matrix[:], rows[:] = lu_factor(matrix, check_finite=False)
    return bool(np.diag(matrix).all())


def solve_factorised(matrix: Matrix, rows: Vector, right: Vector) -> None:
    """Solve with a matrix that was factorised, in place of the right side."""
    from scipy.linalg import lu_solve  # noqa: PLC0415

    right[:] = lu_solve((matrix, rows), right, check_finite=False)


def end_rates(case: At, z: Vector) -> None:
    """Return nothing: perturbations of a body are mapped by its own times."""


def cell_map(case: At, z: Vector, reached: Any, speed: float) -> tuple[Matrix, Matrix, Vector]:
    """Return what a cell makes of perturbations; see `stability.cell_map`."""
    return perturbed(case.cell, times_of(case.cell, z), opened(case.cell, z))


def beside_minus_one(own: Matrix) -> float:
    """Return what has the sign of the product of all multipliers plus 1: the least of these."""
    return _least_factor(np.linalg.eigvals(own) + 1)


def beyond_one(own: Matrix) -> float:
    """Return the same of what the multipliers are in pairs, together, beyond 1."""
    values = np.linalg.eigvals(own)
    first, second = np.triu_indices(len(values), 1)
    return _least_factor(values[first] * values[second] - 1)


def _least_factor(factors: Any) -> float:
    """Return the least size of factors, which are real or in pairs, with their joint sign."""
    sizes = np.abs(factors)
    turned = complex(np.prod(factors / np.where(sizes > 0, sizes, 1.0)))
    return float(np.copysign(sizes.min(initial=np.inf), turned.real))


def watched(case: At, table: Any, z: Vector, values: Matrix, extremes: Matrix) -> None:
    """Fill in what is watched at an orbit, and the ends of its displacement and velocity.

    See `watch.watched`; of the first contact.
    """
    values[:] = np.nan
    extremes[:, 0], extremes[:, 1] = np.inf, -np.inf
    for p in range(len(case.cell.phases)):
        phase = Seen.of(case.cell, z, p)
        watched_here = np.flatnonzero(table[:, PHASE] == p)
        both = np.eye(2, case.forms.shape[1])
        rows = phase.rows(np.vstack([case.forms[watched_here], both]))
        at_ends = phase.at(rows, np.array([0.0, 1.0]))
        rates = phase.at(phase.rate(rows, 1), phase.grid)
        for i, row in enumerate(watched_here):
            into, kind, end = table[row, INTO], table[row, KIND], at_ends[i, 1]
            if kind == WITHIN:
                begins = int(table[row, BEGINS])
                values[row, START] = phase.beginning(rows[i], begins)
                values[row, LEAST] = phase.least(rows[i], rates[i], begins)[0]
                values[row, END] = -rates[i, -1] if table[row, IS_END] else end
            elif kind in (AT_SWITCH, BEHIND):
                end = -end if kind == BEHIND else end
                values[into, END] = np.fmax(values[into, END], end)
        for j in (0, 1):
            row, rate = rows[j - 2], rates[j - 2]
            low, high = phase.least(row, rate, 0)[0], -phase.least(-row, -rate, 0)[0]
            extremes[j, 0] = np.nanmin([extremes[j, 0], *at_ends[j - 2], low])
            extremes[j, 1] = np.nanmax([extremes[j, 1], *at_ends[j - 2], high])


def when_least(case: At, table: Any, z: Vector, row: int) -> float:
    """Return when in its phase a form has the least value at a critical point inside."""
    p = int(table[row, PHASE])
    phase = Seen.of(case.cell, z, p)
    form = phase.rows(case.forms[row])
    rates = phase.at(phase.rate(form, 1), phase.grid)
    return float(phase.least(form, rates, int(table[row, BEGINS]))[1] * phase.s)


class Seen:
    """Linear forms on a phase of a body's orbit.

    Parameters
    ----------
    cell : BodyCell
    times : ndarray
    p : int
    found : Evaluation
        At these times.
    """

    def __init__(self, cell: "BodyCell", times: Vector, p: int, found: Evaluation) -> None:
        self.cell, self.times, self.p, self.found = cell, times, p, found
        self.s, self.part = float(times[p]), parts_of(cell)[p]
        self.generator = generator_of(self.part, cell.omega)

    @classmethod
    def of(cls, cell: "BodyCell", z: Vector, p: int) -> "Seen":
        """Return a phase at unknowns of `bodies.exact.opened`."""
        return cls(cell, times_of(cell, z), p, opened(cell, z))

    def state(self, t: float) -> Vector:
        """Return ``(y, memory)`` at a time from the beginning of the phase."""
        rows, states = np.eye(len(self.generator)), self.part.lawful.A.shape[0]
        kept = [*range(states), *range(states + 3, len(rows))]
        u = np.array([t / self.s])
        found = seen(self.cell, self.times, self.p, u, rows[kept], self.found)
        return np.asarray(found[:, 0])

    @property
    def velocity_at_end(self) -> float:
        """Of the first contact, before the switch."""
        return float(self.at(self.part.lawful.rows[1], np.ones(1))[0])

    def rows(self, forms: Any) -> Any:
        """Return a form of what is seen, or some, by ``(y, cos, sin, 1, memory)``."""
        return forms @ self.part.lawful.rows

    def rate(self, row: Any, times: int) -> Any:
        """Return a derivative by time of a form, or of some."""
        for _ in range(times):
            row = row @ self.generator
        return row

    def at(self, rows: Any, u: Vector) -> Any:
        """Return a form, or some, at local times in [0, 1]."""
        given = self.cell, self.times, self.p, u, np.atleast_2d(rows), self.found
        found = seen(*given)
        return found if np.ndim(rows) == 2 else found[0]

    def beginning(self, row: Vector, begins: int) -> float:
        """Return a derivative of a form where the phase begins."""
        return float(self.at(self.rate(row, begins), np.zeros(1))[0])

    @cached_property
    def grid(self) -> Vector:
        """Local times that are as close as the waves of the phase."""
        turned = float(np.abs(self.part.flow.poles).max() * abs(self.s))
        return np.linspace(0.0, 1.0, 1 + int(np.clip(A_RADIAN * turned, FEWEST, MOST)))

    def begins(self, form: Vector, rounding: float) -> int:
        """Return the first derivative of a form that is not zero where the phase begins.

        Sizes below `rounding`, as a part of the largest, are zero.
        """
        row = self.rows(form)
        sizes = np.abs([self.beginning(row, j) for j in range(HIGHEST + 1)])
        total = float(np.sum(self.times[: len(self.cell.phases)]))
        sizes /= max(self.cell.omega, 1.0 / total) ** np.arange(len(sizes))
        return int(np.argmax(sizes > rounding * sizes.max()))

    def least(self, row: Vector, rates: Vector, begins: int) -> tuple[float, float]:
        """Return the least value of a form at its critical points, and the local time there.

        Not numbers without one.

        Parameters
        ----------
        row : ndarray
        rates : ndarray
            Its derivative on the grid.
        begins : int
            The first derivative of the form that is not zero by itself where the phase begins.
        """
        grid, rate = self.grid, self.rate(row, 1)
        if begins > 1:
            rates = np.append(self.beginning(row, begins), rates[1:])
        where = np.flatnonzero((rates[:-1] < 0) & (rates[1:] >= 0))
        if not len(where):
            return np.nan, np.nan
        best: Indices = where[np.argsort(self.at(row, grid[where]))[:REFINED]]
        low, high = grid[best], grid[best + 1]
        u = low + (high - low) * rates[best] / (rates[best] - rates[best + 1])
        bend = self.rate(rate, 1)
        for _ in range(CORRECTIONS_INSIDE):
            curved = self.at(bend, u) * self.s
            with np.errstate(all="ignore"):
                moved = u - np.where(curved > 0, self.at(rate, u) / curved, 0.0)
            u = np.clip(moved, low, high)
        values = self.at(row, u)
        least = int(np.argmin(values))
        return float(values[least]), float(u[least])
