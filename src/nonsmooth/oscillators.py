"""`solve`: one periodic orbit, by method and order, to a tolerance, or within a budget."""

from .solver.results.orbit import Orbit
from .solver.scenes.case import Case, check_case
from .solver.scenes.methods import FIRST
from .solver.scenes.parameter_error import whole_or_none
from .solver.solve import solve_case, with_order
from .solver.trade.budget import choose_within
from .solver.trade.tolerance import choose_order

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
) -> Orbit:
    """Return the periodic orbit of an oscillator, by one method at one order or to a tolerance.

    Parameters
    ----------
    case : Case
        The oscillator: ``ns.scene("impact")(gap=0.2)``, or a `StickSlip`.
    method : str, optional
        ``"hb"``, ``"hb-ck"``, ``"ck"`` or ``"ck-tau"``; the class of the scene may stand in
        the name, as in ``"c0-tau"``.  A `StickSlip` has ``"hb-c1"`` as well.  Default:
        ``"ck-tau"``, or with a budget the most accurate method.  ``sweep(case, orders=[10])``
        compares all methods.
    order : int, optional
        ``N``; default 10.  Not together with `tol` or `budget`, which choose it.
    functions : int, optional
        Functions with a break at each switch, which ``"hb-ck"`` has beside the harmonics.
        Default: 1, or 2 where the velocity jumps.
    tol : float, optional
        Largest estimated error of the times and the period, as a fraction of the period,
        between 0 and 1.  The lowest order that meets it is used.
    budget : float, optional
        Time for one orbit in s, measured on this machine: the most accurate orbit that fits.
        Not together with `tol`.
    motion : str, optional
        The name of one of the motions that a scene declares, each an order of its phases.
        Default: each is tried, and a stable orbit is preferred.  If none is stable, the orbit
        is that on which a simulation settles, whatever its order of phases.
    phases : str, optional
        An order of phases, such as ``"slide,stop,-slide,-stop"``; the scene need not declare
        it.  A minus stands for the mirror image of a phase.
    cycles : int, optional
        Periods of the forcing in one period of the motion; default: that of the case.

    Raises
    ------
    TypeError
        If `case` is not a `Case`.
    ValueError
        If an argument is out of range, or excludes another.
    NoOrbit
        If there is no admissible orbit, or none was found; the message says which.
    NotCertified
        If no orbit in float64 meets the tolerance.
    TooSlow
        If no orbit can be computed within the budget.

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
    functions = whole_or_none("functions", functions)
    if phases is not None:
        if motion is not None:
            raise ValueError(f"phases: got {phases!r} beside a motion, expected one of them")
        case = with_order(case, phases, cycles)
    elif cycles is not None:
        case = case.with_cycles(cycles)
    if motion is not None:
        case = case.of_motion(motion)
    if (tol is not None or budget is not None) and order is not None:
        choice = "a budget" if tol is None else "a tolerance"
        raise ValueError(f"order: got {order!r} beside {choice}, which chooses it")
    if budget is not None:
        if tol is not None:
            raise ValueError(f"budget: got {budget!r} beside a tolerance, expected one of them")
        return choose_within(case, budget, method, functions).orbit
    chosen = FIRST if method is None else method
    if tol is None:
        return solve_case(case, chosen, ORDER if order is None else order, functions)
    return choose_order(case, tol, chosen, functions).orbit
