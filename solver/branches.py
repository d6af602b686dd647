"""Branches of a case along a parameter: that of one orbit, or all that are found."""

from dataclasses import replace

from ..nearest import counted
from .beside import Expansion
from .branch.branch import BothWays, Bounds, go, start_of
from .branch.every_way import Seen, Start, every_way, motions_for_ever
from .branch.rows import event_of, row_of
from .exact import exact_orbit
from .existence.reasons import WithoutSwitches
from .no_orbit import NoOrbit
from .orbit.exact_orbit import ExactOrbit
from .results.branch import Branch
from .results.interrupted import Interrupted
from .results.orbit import Orbit
from .scenes.case import Case, check_case, index_of
from .scenes.parameter_error import ParameterError, is_number, repeated

#: Values at which orbits are looked for where all branches are wanted.
VALUES = 7

#: Parts of the range at which an orbit to start from is looked for, in turn.
STARTS = (0.0, 1.0, 0.5, 0.25, 0.75)

#: Least difference of the ends of a range, as a part of them: less is rounding.
LEAST_RANGE = 1e-13

#: Where orbits of twice the period, or without their symmetry, begin.
DOUBLED = frozenset(("flip", "branch-point"))


def branch(
    case: Case,
    parameter: str,
    first: float,
    last: float,
    *,
    start: Orbit | ExactOrbit | None = None,
    method: str | None = None,
    order: int | None = None,
    functions: int | None = None,
    progress: Seen = lambda value: None,
) -> Branch:
    """Follow the exact orbit of an oscillator along a parameter, stable or not.

    The branch turns at folds, and continues where the order of phases changes.  Events (folds,
    flips, grazings and so on) are named and located to rounding.

    Parameters
    ----------
    case : Case
        The oscillator.  The branch begins at its orbit if its own value of the parameter is
        in the range; else at an orbit found at the ends, the middle or the quarters of it; else
        at a motion without switches there.
    parameter : str
        The name of the parameter.
    first, last : float
        The range of the parameter, in SI units.
    start : Orbit or ExactOrbit, optional
        An orbit of `case` to begin with, in place of one that is searched for.  Its value of
        the parameter that varies and its number of periods of the forcing may be others.
    method, order, functions : str, int, int, optional
        An expansion to solve beside each exact orbit, from its times; see `solve`.  Given one
        of `method` and `order`, the other has its default.  ``row.beside`` has its errors.
    progress : callable, optional
        Called with the parameter of each orbit.

    Raises
    ------
    TypeError
        If `case` is not a `Case`.
    ValueError
        If the scene has no such parameter, an end of the range is out of its bounds
        (`ParameterError`), the range is empty, or `start` is outside of it, or an orbit of
        another scene or of other parameters.
    NoOrbit
        If no orbit to begin with is found; with all starts that were tried.
    Interrupted
        A `KeyboardInterrupt`, with the part that was found before.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> spring = ns.scene("clearance")(force=0.3, damping=0.1, gap=1.0, frequency=1.0)
    >>> response = ns.branch(spring, "frequency", 0.8, 1.3)
    >>> [f"{event.kind} {event.parameter:.9f}" for event in response.events]
    ['grazing 0.843867938', 'fold 1.234899060', 'fold 1.130048750', 'grazing 1.130436598']
    >>> [row.stable for row in response if 1.14 < row.value < 1.23].count(False) > 0
    True
    """
    check_case(case)
    exact = start if isinstance(start, ExactOrbit) else getattr(start, "exact", None)
    if exact is None and start is not None:
        raise ValueError(f"start: got {start!r:.80}, expected an orbit near an exact one")
    if exact is not None:
        _check_start(case, parameter, exact.case)
        case = exact.case
    how = Expansion.checked(case, method, order, functions)
    bounds = _bounds(case, parameter, first, last)
    orbit = _start(case, parameter, bounds) if exact is None else exact
    value = orbit.case.values[parameter]
    if not bounds[0] <= value <= bounds[1]:
        expected = f"an orbit between {first:g} and {last:g}"
        raise ValueError(f"start: got one at {parameter} = {value:g}, expected {expected}")
    followed = BothWays(index_of(case, parameter))
    try:
        place = start_of(orbit, followed.index, bounds)
    except ArithmeticError as error:
        words = f"{orbit.case.scene.label}: no branch can be followed from the orbit at"
        why = str(error) or "its equations are singular, to rounding"
        raise NoOrbit(f"{words} {parameter} = {value:g}: {why}", False, ()) from None
    try:
        go(followed, place, progress=progress)
    except KeyboardInterrupt:
        if not followed.points():
            raise
        raise _interrupted([_result(case, parameter, followed, how)]) from None
    return _result(case, parameter, followed, how)


def branches(
    case: Case,
    parameter: str,
    first: float,
    last: float,
    progress: Seen = lambda value: None,
    *,
    method: str | None = None,
    order: int | None = None,
    functions: int | None = None,
) -> list[Branch]:
    """Return the branches of all orbits that are found at a few values of a parameter.

    So coexisting orbits and isolated branches are found, and motions without switches that no
    orbit becomes.  Branches of doubled period are followed from each flip, and unsymmetric ones
    from where symmetry is lost.  Where none is found there, the branch is that of `branch`.

    Parameters
    ----------
    case, parameter, first, last, progress, method, order, functions
        See `branch`.

    Raises
    ------
    TypeError, ValueError, NoOrbit, Interrupted
        See `branch`.
    """
    check_case(case)
    how = Expansion.checked(case, method, order, functions)
    bounds = _bounds(case, parameter, first, last)
    results: list[Branch] = []
    try:
        for followed in every_way(case, parameter, bounds, VALUES, DOUBLED, progress):
            own_case = case if followed.course is None else followed.course.case(case)
            results.append(_result(own_case, parameter, followed, how))
    except KeyboardInterrupt:
        if not results:
            raise
        raise _interrupted(results) from None
    if results:
        return results
    alone = branch(
        case, parameter, first, last,
        method=method, order=order, functions=functions, progress=progress,
    )  # fmt: skip
    return [alone]


def _check_start(case: Case, parameter: str, own: Case) -> None:
    """Check that an orbit whose case is `own` is one of `case`; a `ValueError` if not."""
    if own.scene.whole != case.scene.whole:
        other = f"an orbit of another scene, {own.scene.name}"
        raise ValueError(f"start: got {other}, expected one of {case.scene.name}")
    for name, value in case.values.items():
        if name != parameter and own.values[name] != value:
            differs = f"{name} = {own.values[name]!r}, and the case has {value!r}"
            expected = f"an orbit that differs in {parameter} alone"
            raise ValueError(f"start: got one with {differs}; expected {expected}")


def _interrupted(done: list[Branch]) -> Interrupted:
    return Interrupted(done, f"{counted(sum(map(len, done)), 'orbit')} found")


def _bounds(case: Case, parameter: str, first: float, last: float) -> Bounds:
    for end in (first, last):
        if not is_number(end):
            raise ValueError(f"range: got {repeated(end)}, expected a finite number")
    index_of(case, parameter)
    ends = sorted(case.with_value(parameter, q).values[parameter] for q in (first, last))
    if ends[1] - ends[0] <= LEAST_RANGE * max(map(abs, ends)):
        expected = "two different values, not by rounding"
        raise ValueError(f"range: got {first!r} to {last!r}, expected {expected}")
    return ends[0], ends[1]


def _start(case: Case, parameter: str, bounds: Bounds) -> Start:
    """Return an orbit from which a branch can be followed, or else a motion without switches.

    Where there is no such oscillator at some of the values, it is looked for at the others.
    """
    value_of_case, (low, high) = case.values[parameter], bounds
    values = [value_of_case] if low <= value_of_case <= high else []
    tried: list[str] = []
    errors: list[ParameterError] = []
    without_switches: list[WithoutSwitches] = []
    parts = ((1 - part) * low + part * high for part in STARTS)  # the ends are exact
    for value in dict.fromkeys([*values, *parts]):
        try:
            case_at_value = case.with_value(parameter, value)
            without_switches += motions_for_ever(case_at_value)
            return exact_orbit(case_at_value)
        except NoOrbit as finding:
            reasons = (finding.reason,) if finding.proven else finding.reasons
            tried += [f"at {parameter} = {value:g}: {why}" for why in reasons]
        except ParameterError as error:
            errors.append(error)
            tried.append(f"at {parameter} = {value:g}: {error}")
    if without_switches:
        return without_switches[0]
    if len(errors) == len(tried):
        raise errors[0]
    words = f"{case.scene.label}: no orbit was found from which a branch could be followed"
    raise NoOrbit(words, False, tuple(tried))


def _result(case: Case, parameter: str, followed: BothWays, how: Expansion) -> Branch:
    """Return what is found of a branch as users hold it."""
    found_events = followed.events()
    events = tuple(map(event_of, found_events))
    ends = {id(event.place) for event in found_events if event.changes}  # of an order of phases
    rows = tuple(
        replace(row_of(piece, place, id(place) not in ends), beside=how.beside(piece, place))
        for piece, place in followed.points()
    )
    expansion = how.method, how.order, how.functions
    return Branch(case, parameter, *expansion, rows, events, followed.why())
