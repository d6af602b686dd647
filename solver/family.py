"""Orbits of a case along one of its parameters: each found from the one before it.

The times of an orbit start the search at the next value.  Where that leads to no orbit, the
search is the one of `solve_case`, and the row says that the orbit was not followed.
"""

from collections.abc import Callable, Iterable
from dataclasses import replace

from .kernels import registry
from .no_orbit import NoOrbit
from .orbit.attempt import attempt
from .results.family import Family, FamilyInterrupted, FamilyRow
from .results.orbit import Orbit
from .scenes.case import Case
from .scenes.methods import FIRST
from .scenes.parameter_error import ParameterError
from .solve import check_order, number_of_functions, solve_case

#: Order at which the times of a smooth motion in each phase are at rounding.
ORDER = 20

#: Most values: more than a terminal or a file of rows is for.
MOST_VALUES = 100_000


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
        own = before.case.scene
        here = case if own == case.scene else Case(own, case.values, case.cycles)
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
