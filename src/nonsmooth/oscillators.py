"""`solve`, `sweep`, `branch`, `family`, `exact`: what users ask for."""

from collections.abc import Callable, Iterable, Sequence
from numbers import Integral
from typing import TYPE_CHECKING, Any

import numpy as np

from .solver.branches import Expansion, branch_case, every_branch
from .solver.exact import ExactOrbit, exact_orbit
from .solver.family import family_case
from .solver.scenes.case import Case, check_case
from .solver.scenes.methods import FIRST
from .solver.scenes.parameter_error import is_number
from .solver.solve import solve_case, with_order
from .solver.sweep import sweep_case
from .solver.trade.budget import choose_within
from .solver.trade.tolerance import choose_order

if TYPE_CHECKING:
    import numpy.typing as npt

    from .solver.results.branch import Branch
    from .solver.results.family import Family
    from .solver.results.orbit import Orbit
    from .solver.results.sweep import Sweep

#: N where none is named, as on the command line.
ORDER = 10


def solve(
    case: Case,
    method: str | None = None,
    order: int | None = None,
    *,
    functions: int | None = None,
    tol: float | None = None,
    budget: float | None = None,
    motion: str | None = None,
    phases: str | None = None,
    cycles: int | None = None,
) -> "Orbit":
    """Return the periodic orbit of an oscillator: by method and order, or as accurate as asked.

    Parameters
    ----------
    case : Case
        The oscillator: ``ns.scene("impact")(gap=0.2)``, or a `StickSlip`.
    method : str, optional
        ``"hb"``, ``"hb-ck"``, ``"ck"`` or ``"ck-tau"``, also with the class of the scene,
        as ``"c0-tau"``; of the belt of the paper ``"hb-c1"`` as well.  Without it ``"ck-tau"``,
        or with a budget whichever is best.  The command line shows the orbit by every method
        then: that is ``sweep(case, orders=[10])``.
    order : int, optional
        ``N``; 10 without it.  A tolerance or a budget chooses it, and it is left out.
    functions : int, optional
        Functions beside the harmonics of ``"hb-ck"`` at each switch; 1, or 2 where the
        velocity jumps, if not given.
    tol : float, optional
        Largest error of the times and the period, as estimated, as a part of the period;
        between 0 and 1.  The lowest order is taken that meets it.
    budget : float, optional
        Seconds for one orbit: the best that fits, timed on this machine, by this method or
        by any.  It chooses the order, and excludes a tolerance.
    motion : str, optional
        Of a scene with several motions, orders of its phases, the one that is meant; without
        it each is tried, and the orbit that there is is returned.  If none is stable, that is
        the orbit on which a simulation settles, of whatever order of phases.
    phases : str, optional
        An order of phases that the scene need not declare: ``"slide,stop,slide,stop"``, with a
        minus before the mirror image of one.
    cycles : int, optional
        Periods of the forcing in one of the motion; without it those of the case, usually 1.

    Raises
    ------
    TypeError
        If `case` is none.
    ValueError
        If an argument is not one that can be computed, or some exclude each other.
    NoOrbit
        If there is no admissible orbit, or none was found; it says which.
    NotCertified
        If no orbit in float64 is as accurate as asked for.
    TooSlow
        If none is computed within the budget.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> case = ns.scene("impact")(gap=0.2)
    >>> orbit = ns.solve(case, method="ck-tau", order=10)
    >>> print(f"{orbit.forcing_phase:.6f} rad, {orbit.estimate.times:.0e}")
    1.103021 rad, 3e-13
    >>> ns.solve(case, tol=1e-6).order
    7
    >>> ns.solve(ns.scene("dry-friction")(frequency=0.4), order=8).case.scene.motion
    'two-stops'
    >>> twice = ns.solve(ns.scene("impact")(frequency=3.6), order=8, cycles=2)
    >>> round(twice.period, 9), twice.stable
    (3.490658504, True)
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> print(f"{ns.solve(belt, method='c1', order=7).t1:.6f} s")
    0.200007 s
    """
    check_case(case)
    functions = _whole(functions)
    if phases is not None:
        if motion is not None:
            raise ValueError(f"phases: got {phases!r} beside a motion, expected one of them")
        case = with_order(case, phases, cycles)
    elif cycles is not None:
        case = case.with_cycles(cycles)
    if (tol is not None or budget is not None) and order is not None:
        what = "a budget" if tol is None else "a tolerance"
        raise ValueError(f"order: got {order!r} beside {what}, which chooses it")
    if budget is not None:
        if tol is not None:
            raise ValueError(f"budget: got {budget!r} beside a tolerance, expected one of them")
        return choose_within(case, budget, method, functions).orbit
    chosen = FIRST if method is None else method
    if tol is None:
        return solve_case(case, chosen, ORDER if order is None else order, functions, motion)
    return choose_order(case, tol, chosen, functions, motion).orbit


def sweep(
    case: Case,
    methods: str | Sequence[str] | None = None,
    orders: Iterable[int] = range(1, 21),
    *,
    functions: int | None = None,
    progress: Callable[[Any], None] = lambda row: None,
) -> "Sweep":
    """Solve for each method and order, and compare with the exact orbit.

    Parameters
    ----------
    case : Case
        The oscillator.
    methods : str or sequence of str, optional
        The methods, one after the other.  The default is all of them, without those orders
        that a method cannot compute and another can.
    orders : iterable of int
        The orders of every method.
    functions : int, optional
        Functions of ``"hb-ck"`` at each switch; see `solve`.
    progress : callable, optional
        Called with each row when it is done.

    Raises
    ------
    TypeError
        If `case` is none.
    ValueError
        If a method or an order is not one that can be computed, or there are none; before
        anything is.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> case = ns.scene("impact")()
    >>> print(ns.sweep(case, methods=["hb", "ck-tau"], orders=[4, 8]))
    method      N            T [s]      times       jump  estimate
    hb          4      3.490658504   4.79e-02   4.47e-01   4.8e-02
    hb          8      3.490658504   2.31e-02   2.87e-01   2.3e-02
    c0-tau      4      3.490658504   8.84e-04   2.87e-02   8.8e-04
    c0-tau      8      3.490658504   1.97e-09   7.97e-05   2.0e-09
    """
    check_case(case)
    named = methods
    if not (methods is None or isinstance(methods, str)):
        named = _several("methods", methods, "names of methods")
    numbers = _several("orders", orders, "whole numbers")
    return sweep_case(case, named, numbers, _whole(functions), progress)


def family(
    case: Case,
    parameter: str,
    values: "npt.ArrayLike",
    method: str | None = None,
    order: int | None = None,
    *,
    functions: int | None = None,
    progress: Callable[[Any], None] = lambda row: None,
) -> "Family":
    """Return the orbits of an oscillator as one of its parameters takes many values.

    Parameters
    ----------
    case : Case
        The oscillator.
    parameter : str
        Its name.
    values : array_like of float, shape (n,)
        What it becomes, in SI units.  An orbit is looked for from that at the value before.
    method : str, optional
        See `solve`.
    order : int, optional
        ``N``; without it one at which these have converged to rounding.
    functions : int, optional
        Functions of ``"hb-ck"`` at each switch.
    progress : callable, optional
        Called with each row when it is done.

    Raises
    ------
    TypeError
        If `case` is none.
    ValueError
        If the parameter, the method or the order is not one that there is, or a value
        makes no oscillator (`ParameterError`).

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
    except (TypeError, ValueError):
        raise ValueError(f"values: got {values!r:.80}, expected numbers") from None
    given: Any = {
        name: v for name, v in (("method", method), ("order", order)) if v is not None
    }
    more: Any = {"functions": _whole(functions), "progress": progress}
    return family_case(case, parameter, numbers, **given, **more)


def branch(
    case: Case,
    parameter: str,
    first: float,
    last: float,
    *,
    start: "Orbit | ExactOrbit | None" = None,
    method: str | None = None,
    order: int | None = None,
    functions: int | None = None,
    progress: Callable[[float], None] = lambda value: None,
) -> "Branch":
    """Return the orbit of an oscillator followed along a parameter, stable or not.

    The orbits are exact.  The branch goes round folds, and on with another order of phases
    where one begins or ends; what happens on it is located to rounding and named.

    Parameters
    ----------
    case : Case
        The oscillator.  The branch is that of its orbit, if its value of the parameter is in
        the range; else of one that is found at an end of the range, in the middle or at a
        quarter.
    parameter : str
        Its name.
    first, last : float
        The range of the parameter, in SI units.
    start : Orbit or ExactOrbit, optional
        An orbit on the branch, of any parameters.
    method, order, functions : str, int, int, optional
        An expansion that is solved beside each orbit, from its times, as `solve` takes it;
        with one of the first two the other has its default.  Each row has it as ``beside``,
        with its errors.
    progress : callable, optional
        Called with the parameter of each orbit when it is found.

    Raises
    ------
    TypeError
        If `case` is none.
    ValueError
        If the parameter is none, an end of the range makes no oscillator (`ParameterError`),
        or the range is empty or does not hold `start`.
    NoOrbit
        If there is no orbit to start from.

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
    near = start if isinstance(start, ExactOrbit) else getattr(start, "exact", None)
    if near is None and start is not None:
        raise ValueError(f"start: got {start!r:.80}, expected an orbit near an exact one")
    own = case if near is None else near.case
    how = Expansion.checked(case, method, order, _whole(functions))
    return branch_case(own, parameter, *_range(first, last), near, progress, how)


def branches(
    case: Case,
    parameter: str,
    first: float,
    last: float,
    progress: Callable[[float], None] = lambda value: None,
) -> "list[Branch]":
    """Return the branches of all orbits that are found at a few values of a parameter.

    Orbits that coexist, and islands that no branch from elsewhere reaches.

    Parameters
    ----------
    case, parameter, first, last, progress
        See `branch`.

    Raises
    ------
    TypeError, ValueError, NoOrbit
        See `branch`.
    """
    check_case(case)
    return every_branch(case, parameter, *_range(first, last), progress)


def _range(first: object, last: object) -> tuple[float, float]:
    """Return the ends of a range, checked to be numbers."""
    for value in (first, last):
        if not is_number(value):
            raise ValueError(f"range: got {value!r:.80}, expected a finite number")
    return float(first), float(last)  # type: ignore[arg-type]


def exact(case: Case) -> "ExactOrbit":
    """Return the exact periodic orbit of an oscillator.

    Parameters
    ----------
    case : Case
        The oscillator.

    Returns
    -------
    ExactOrbit
        Period, times and motion, from the closed-form flow of each phase.

    Raises
    ------
    TypeError
        If `case` is none.
    NoOrbit
        If no admissible orbit was found.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> print(f"{ns.exact(belt).period:.10f} s")
    0.6712388980 s
    >>> print(f"{ns.exact(ns.scene('impact')()).forcing_phase:.10f} rad")
    0.9296439860 rad
    """
    check_case(case)
    return exact_orbit(case)


def _whole(number: Any) -> Any:
    """Return a whole number of any type, such as NumPy's, as Python has it; else as it is."""
    return int(number) if isinstance(number, Integral) else number


def _several(name: str, values: object, what: str) -> list[Any]:
    """Return what is asked for, one or more, as a list.

    Raises
    ------
    ValueError
        If it is not a sequence, or an empty one.
    """
    found = [*values] if isinstance(values, Iterable) and not isinstance(values, str) else []
    if not found:
        raise ValueError(f"{name}: got {values!r:.80}, expected {what} in a sequence")
    return found
