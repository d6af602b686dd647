"""`solve`: the orbit that users ask for, by method and order or as accurate as they say."""

from .solver.results.orbit import Orbit
from .solver.scenes.case import Case, check_case
from .solver.scenes.methods import FIRST
from .solver.scenes.parameter_error import plain
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
    functions = plain(functions)
    if phases is not None:
        if motion is not None:
            raise ValueError(f"phases: got {phases!r} beside a motion, expected one of them")
        case = with_order(case, phases, cycles)
    elif cycles is not None:
        case = case.with_cycles(cycles)
    if motion is not None:
        case = case.of_motion(motion)
    if (tol is not None or budget is not None) and order is not None:
        what = "a budget" if tol is None else "a tolerance"
        raise ValueError(f"order: got {order!r} beside {what}, which chooses it")
    if budget is not None:
        if tol is not None:
            raise ValueError(f"budget: got {budget!r} beside a tolerance, expected one of them")
        return choose_within(case, budget, method, functions).orbit
    chosen = FIRST if method is None else method
    if tol is None:
        return solve_case(case, chosen, ORDER if order is None else order, functions)
    return choose_order(case, tol, chosen, functions).orbit
