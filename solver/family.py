"""Orbits of a case at values of a parameter: those of its branches there.

From the orbit that is found at the first value its branch is followed through all of them.
Where that has none, another is looked for, as `solve_case` does, and the row says that it was
not followed.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field

from .branch.branch import Both, go, orbits_at, start_of
from .kernels import registry
from .no_orbit import NoOrbit
from .orbit.exact_orbit import ExactOrbit
from .results.family import Family, FamilyInterrupted, FamilyRow
from .results.orbit import Orbit
from .scenes.case import Case, index_of
from .scenes.methods import FIRST
from .search import check_order
from .solve import number_of_functions, orbit_beside, solve_case
from .stability.monodromy import NoMultipliersError

#: Order at which the times of a smooth motion in each phase are at rounding.
ORDER = 20

#: Most values: more than a terminal or a file of rows is for.
MOST_VALUES = 100_000

#: Most of the range of the parameter in a step.
PART = 0.25


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
        In SI units, in the order of the rows.
    method, order, functions : str, int, int
        See `solve_case`.
    progress : callable
        Called with each row when it is done.

    Returns
    -------
    Family
        A row for each orbit that is found at each value: several where a branch turns back
        between, one without an orbit where none is found.

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
    >>> case = registry.load("impact")()
    >>> [row.status for row in family_case(case, "mass", [1.0, 1.1], order=8).rows]
    ['ok', 'ok']
    """
    scene = case.scene
    index_of(case, parameter)
    cases = [case.with_value(parameter, value) for value in values]
    if not 1 <= len(cases) <= MOST_VALUES:
        raise ValueError(f"values: got {len(cases)}, expected 1 to {MOST_VALUES}")
    name = registry.generic_method(scene, method)
    count = number_of_functions(case, name, None) if functions is None else functions
    number = check_order(registry.kernel(scene, name, count), order)
    found = _Rows(parameter, name, number, count, tuple(cases))
    try:
        for row in found.each():
            progress(row)
    except KeyboardInterrupt:
        if not found.done:
            raise
        raise FamilyInterrupted(found.family) from None
    return found.family


@dataclass
class _Rows:
    """The rows of a family as they are found."""

    parameter: str
    method: str
    order: int
    functions: int | None
    cases: tuple[Case, ...]
    done: list[FamilyRow] = field(default_factory=list)
    branches: list[Both] = field(default_factory=list)

    @property
    def family(self) -> Family:
        """What has been found."""
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
        """Return the row of an orbit that is not on a branch, and follow the branch from it."""
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
        """Follow the branch from an orbit through all values."""
        values = [each.values[self.parameter] for each in self.cases]
        bounds = min(values), max(values)
        if bounds[0] == bounds[1]:
            return
        found = Both(index_of(exact.case, self.parameter))
        try:
            start = start_of(exact, found.index, bounds)
        except ArithmeticError:  # it is not isolated
            return
        self.branches.append(found)
        go(found, start, PART)


def _same(orbit: Orbit, row: FamilyRow) -> bool:
    """Whether an orbit is that of a row, to rounding."""
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
    """Return the state of an orbit where the phase of the forcing is 0."""
    if orbit.forcing_phase is None:
        return None
    omega = float(orbit.case.values[str(orbit.case.scene.frequency)])
    t = [-orbit.forcing_phase % (2 * math.pi) / omega]
    return float(orbit.displacement(t)[0]), float(orbit.velocity(t)[0])
