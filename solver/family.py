"""Orbits of a case at values of a parameter, from branches.

The branch of the orbit at the first value is followed through all values.  At a value where no
branch has an orbit, `solve_case` looks for one, and its branch is followed as well.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from .branch.branch import BothWays, go, orbits_at, start_of
from .kernels import registry
from .no_orbit import NoOrbit
from .orbit.exact_orbit import ExactOrbit
from .results.family import Family, FamilyRow
from .results.interrupted import Interrupted
from .results.orbit import Orbit
from .scenes.case import Case, check_case, index_of
from .scenes.methods import FIRST
from .scenes.parameter_error import repeated, whole_or_none
from .search import check_order
from .solve import number_of_functions, orbit_beside, solve_case
from .stability.monodromy import NoMultipliersError

#: Order at which the times of a motion that is smooth in each phase are exact to rounding.
ORDER = 20

#: Largest number of values.
MOST_VALUES = 100_000

#: Longest step of the continuation, relative to the range of the parameter.
PART = 0.25


def family(
    case: Case,
    parameter: str,
    values: npt.ArrayLike,
    method: str | None = None,
    order: int | None = None,
    *,
    functions: int | None = None,
    progress: Callable[[FamilyRow], None] = lambda row: None,
) -> Family:
    """Return the orbits of an oscillator at many values of one parameter.

    Parameters
    ----------
    case : Case
        The oscillator.
    parameter : str
        The name of the parameter.
    values : array_like of float, shape (n,)
        Its values, in SI units.  The branch of the orbit at the first is followed.
    method : str, optional
        See `solve`.
    order : int, optional
        ``N``; default: an order at which the method has converged to rounding.
    functions : int, optional
        Functions of ``"hb-ck"`` at each switch.
    progress : callable, optional
        Called with each row when it is done.

    Returns
    -------
    Family
        A row for each orbit at each value: several where a branch has folds, and one without
        an orbit where none is found.

    Raises
    ------
    TypeError
        If `case` is not a `Case`.
    ValueError
        If there is no such parameter, method or order, no value or too many, or a value is out
        of bounds (`ParameterError`).  This is checked before anything is computed.
    Interrupted
        A `KeyboardInterrupt`, with the rows computed before it.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> along = ns.family(ns.scene("impact")(), "gap", [0.0, 0.1, 0.2])
    >>> along["forcing_phase"].round(6)
    array([0.761291, 0.929644, 1.103021])
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> orbits = ns.family(belt, "belt_speed", [0.5, 1.0, 2.0])
    >>> orbits["period"].round(6)
    array([0.806889, 0.671239, 0.635589])
    """
    check_case(case)
    try:
        if np.iscomplexobj(values):
            raise TypeError
        numbers = np.atleast_1d(np.asarray(values, dtype=float)).ravel().tolist()
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"values: got {repeated(values)}, expected numbers") from None
    scene = case.scene
    index_of(case, parameter)
    cases = [case.with_value(parameter, value) for value in numbers]
    if not 1 <= len(cases) <= MOST_VALUES:
        raise ValueError(f"values: got {len(cases)}, expected 1 to {MOST_VALUES}")
    name = registry.generic_method(scene, FIRST if method is None else method)
    wanted = whole_or_none("functions", functions)
    count = number_of_functions(case, name, None) if wanted is None else wanted
    kernel = registry.kernel(scene, name, count)
    number = check_order(kernel, ORDER if order is None else order)
    rows = _Rows(parameter, name, number, count, tuple(cases))
    try:
        for row in rows.each():
            progress(row)
    except KeyboardInterrupt:
        if not rows.done:
            raise
        count = len({row.value for row in rows.done})
        words = f"{count} of {len(cases)} values are done"
        raise Interrupted(rows.family, words) from None
    return rows.family


@dataclass
class _Rows:
    """The rows of a family while they are computed."""

    parameter: str
    method: str
    order: int
    functions: int | None
    cases: tuple[Case, ...]
    done: list[FamilyRow] = field(default_factory=list)
    branches: list[BothWays] = field(default_factory=list)

    @property
    def family(self) -> Family:
        """The family of the rows so far."""
        how = self.parameter, self.method, self.order, self.functions
        return Family(self.cases[0], *how, tuple(self.done))

    def each(self) -> Iterator[FamilyRow]:
        """Yield the rows, value by value."""
        for case in self.cases:
            value = case.values[self.parameter]
            rows: list[FamilyRow] = []
            for exact in (q for branch in self.branches for q in orbits_at(branch, value)):
                orbit = orbit_beside(exact, self.method, self.order, self.functions)
                if orbit is not None and not any(_same(orbit, row) for row in rows):
                    rows.append(_row(orbit, value, followed=True))
            for row in rows or [self._anew(case, value)]:
                self.done.append(row)
                yield row

    def _anew(self, case: Case, value: float) -> FamilyRow:
        """Return the row of an orbit that is on no branch yet, and follow its branch."""
        try:
            orbit = solve_case(case, self.method, self.order, self.functions)
        except NoOrbit as finding:
            nothing = (None, None, None, None, None)
            how = finding.iterations, False, finding.in_full
            return FamilyRow(value, finding.status, *nothing, *how)
        if orbit.exact is not None:
            self._follow(orbit.exact)
        return _row(orbit, value, followed=False)

    def _follow(self, exact: ExactOrbit) -> None:
        """Follow the branch of an orbit through all values."""
        values = [case.values[self.parameter] for case in self.cases]
        bounds = min(values), max(values)
        if bounds[0] == bounds[1]:
            return
        followed = BothWays(index_of(exact.case, self.parameter))
        try:
            start = start_of(exact, followed.index, bounds)
        except ArithmeticError:  # the orbit is not isolated
            return
        self.branches.append(followed)
        go(followed, start, PART)


def _same(orbit: Orbit, row: FamilyRow) -> bool:
    """Whether an orbit is that of a row, in all digits."""
    return row.durations == orbit.durations and row.forcing_phase == orbit.forcing_phase


def _row(orbit: Orbit, value: float, *, followed: bool) -> FamilyRow:
    try:
        multipliers, stable = tuple(map(complex, orbit.multipliers)), orbit.stable
    except NoMultipliersError:
        multipliers, stable = None, None
    return FamilyRow(
        value, "ok", orbit.period, orbit.forcing_phase, orbit.durations, orbit.extremes,
        orbit.estimate, orbit.iterations, followed, motion=orbit.case.scene.motion,
        multipliers=multipliers, stable=stable, strobe=_at_phase_zero(orbit),
    )  # fmt: skip


def _at_phase_zero(orbit: Orbit) -> tuple[float, float] | None:
    """Return displacement and velocity at forcing phase 0; None without a forcing."""
    if orbit.forcing_phase is None:
        return None
    omega = float(orbit.case.values[str(orbit.case.scene.frequency)])
    t = [-orbit.forcing_phase % (2 * math.pi) / omega]
    return float(orbit.displacement(t)[0]), float(orbit.velocity(t)[0])
