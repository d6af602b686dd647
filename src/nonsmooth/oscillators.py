"""`solve`, `sweep`, `exact` and `simulate` of any oscillator: the paper's, or of any scene."""

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, overload

if TYPE_CHECKING:
    from .solver.case.case import Case
    from .solver.flow.exact import ExactSceneOrbit
    from .solver.orbit.orbit import SceneOrbit
    from .solver.shortcut import Entrance
    from .solver.shortcuts.orbit.motion import ExactOrbit
    from .solver.shortcuts.orbit.orbit import Orbit
    from .solver.shortcuts.orbit.oscillator import StickSlip
    from .solver.shortcuts.search.sweep import Sweep
    from .solver.simulation.record import Simulation
    from .solver.sweep import SceneSweep

#: N where none is named, as on the command line.
ORDER = 10


@overload
def solve(
    case: "StickSlip",
    method: str | None = None,
    order: int | None = None,
    *,
    c1_terms: int = 1,
    functions: int | None = None,
    tol: float | None = None,
    tol_acceleration: float | None = None,
    budget: float | None = None,
) -> "Orbit": ...


@overload
def solve(
    case: "Case",
    method: str | None = None,
    order: int | None = None,
    *,
    functions: int | None = None,
    tol: float | None = None,
    budget: float | None = None,
    motion: str | None = None,
    cycles: int | None = None,
    shortcuts: bool = True,
) -> "SceneOrbit": ...


def solve(
    case: "StickSlip | Case",
    method: str | None = None,
    order: int | None = None,
    *,
    functions: int | None = None,
    tol: float | None = None,
    budget: float | None = None,
    motion: str | None = None,
    cycles: int | None = None,
    shortcuts: bool = True,
    **own: Any,
) -> "Orbit | SceneOrbit":
    """Return the periodic orbit of an oscillator: by method and order, or as accurate as asked.

    Of a `StickSlip` by the paper's methods ``"hb"``, ``"hb-c1"`` and ``"c1"`` it is an `Orbit`,
    found as the paper has it.  Of a `Case`, and of a `StickSlip` by any other method, it is a
    `SceneOrbit`, found by the kernels that every scene has.

    Parameters
    ----------
    case : StickSlip or Case
        The oscillator; a `Case` is ``ns.scene("impact")(gap=0.2)``.
    method : str, optional
        ``"hb"``, ``"hb-ck"``, ``"ck"`` or ``"ck-tau"``, also with the class of the scene,
        as ``"c0-tau"``.  Without it ``"ck-tau"``, of a `StickSlip` ``"c1"``, or with a
        tolerance whichever is cheapest.  The command line shows the orbit by every method
        then: that is ``sweep(case, orders=[10])``.
    order : int, optional
        ``N``; 10 without it.  A tolerance or a budget chooses it, and it is left out.
    functions : int, optional
        Functions beside the harmonics of ``"hb-ck"`` at each switch; 1, or 2 where the
        velocity jumps, if not given.
    tol : float, optional
        Largest error of the times and the period, as estimated, as a part of the period;
        between 0 and 1.  Of a `Case`, the lowest order is taken that meets it.
    budget : float, optional
        Seconds for one orbit: the best that fits, timed on this machine, by this method or
        by any.  It chooses the order, and excludes a tolerance.
    motion : str, optional
        Of a scene with several motions, orders of its phases, the one that is meant; without
        it each is tried, and the orbit that there is is returned.
    cycles : int, optional
        Periods of the forcing in one of the motion; without it those of the case, usually 1.
    shortcuts : bool
        Whether a `StickSlip` is solved the paper's way where it has one; without, by the
        kernels that every scene has.
    c1_terms, tol_acceleration : int, float, optional
        Of a `StickSlip` by the paper's methods: the C1 functions of ``"hb-c1"``, 1 to 6; the
        largest error (22) of the acceleration, as estimated.

    Raises
    ------
    TypeError
        If `case` is neither.
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
    >>> ns.solve(ns.scene("impact")(frequency=3.6), order=8, cycles=2)
    <impact by c0-tau, N = 8: T = 3.490658504 s, phi = 1.103915868 rad, estimate 2.7e-07>
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> print(f"{ns.solve(belt, 'c1', 7).period:.9f}, {ns.solve(belt, 'c1-tau', 7).period:.9f}")
    0.671238381, 0.671238898
    """
    generic, entrance = _way(case, [method], functions, shortcuts)
    if entrance is not None:
        if motion is not None or cycles not in (None, 1):
            what, value = ("motion", motion) if motion is not None else ("cycles", cycles)
            raise ValueError(f"{what}: got {value!r}, expected it for a case of ns.scene(...)")
        if budget is not None:
            own["budget"] = budget
        name, chooses = entrance.own_name(method), ("budget", "tol_acceleration")
        if tol is None and all(own.get(option) is None for option in chooses):
            name = entrance.default if name is None else name
            order = ORDER if order is None else order
        orbit: Orbit = entrance.solve(case, name, order, tol=tol, **own)
        return orbit
    if cycles is not None:
        generic = generic.with_cycles(cycles)
    if own:
        option, value = next(iter(own.items()))
        raise ValueError(f"{option}: got {value!r}, expected it for the paper's methods only")
    from .solver.case.methods import FIRST  # noqa: PLC0415
    from .solver.solve import solve_case  # noqa: PLC0415

    if (tol is not None or budget is not None) and order is not None:
        what = "a budget" if tol is None else "a tolerance"
        raise ValueError(f"order: got {order!r} beside {what}, which chooses it")
    if budget is not None:
        if tol is not None:
            raise ValueError(f"budget: got {budget!r} beside a tolerance, expected one of them")
        from .solver.trade.budget import choose_within  # noqa: PLC0415

        return choose_within(generic, budget, method, functions).orbit
    chosen = FIRST if method is None else method
    if tol is None:
        return solve_case(generic, chosen, ORDER if order is None else order, functions, motion)
    from .solver.trade.tolerance import choose_order  # noqa: PLC0415  (it loads SciPy)

    return choose_order(generic, tol, chosen, functions, motion).orbit


def sweep(
    case: "StickSlip | Case",
    methods: str | Sequence[str] | None = None,
    orders: Iterable[int] | None = None,
    *,
    c1_terms: int = 1,
    functions: int | None = None,
    shortcuts: bool = True,
    progress: Callable[[Any], None] = lambda row: None,
) -> "Sweep | SceneSweep":
    """Solve for each method and order, and compare with the exact orbit.

    Parameters
    ----------
    case : StickSlip or Case
        The oscillator.
    methods : str or sequence of str, optional
        The methods, one after the other.  The default is all of them, without those orders
        that a method cannot compute and another can.
    orders : iterable of int, optional
        The orders of every method; 1 to 40 without it, of a `Case` 1 to 20.
    c1_terms : int
        C1 functions of ``"hb-c1"`` of a `StickSlip`, 1 to 6; the paper has one.
    functions : int, optional
        Functions of ``"hb-ck"`` at each switch of a `Case`; see `solve`.
    shortcuts : bool
        See `solve`.
    progress : callable, optional
        Called with each row when it is done.

    Returns
    -------
    Sweep or SceneSweep
        Of a `StickSlip` by the paper's methods, or by the methods of every scene.

    Raises
    ------
    TypeError
        If `case` is neither.
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
    one = methods is None or isinstance(methods, str)
    named = [methods] if one else _several("methods", methods, "names of methods")
    if orders is not None:
        orders = _several("orders", orders, "whole numbers")
    generic, entrance = _way(case, named, functions, shortcuts)
    if entrance is not None:
        numbers = range(1, 41) if orders is None else orders
        names = None if methods is None else [entrance.own_name(name) for name in named]
        rows: Sweep = entrance.sweep(case, names, numbers, c1_terms=c1_terms, progress=progress)
        return rows
    if c1_terms != 1:
        raise ValueError(f"c1_terms: got {c1_terms!r}, expected functions for these methods")
    from .solver.sweep import sweep_case  # noqa: PLC0415

    numbers = range(1, 21) if orders is None else orders
    return sweep_case(generic, methods, numbers, functions, progress)


@overload
def exact(case: "StickSlip") -> "ExactOrbit": ...


@overload
def exact(case: "Case") -> "ExactSceneOrbit": ...


def exact(case: "StickSlip | Case") -> "ExactOrbit | ExactSceneOrbit":
    """Return the exact periodic orbit of an oscillator.

    Parameters
    ----------
    case : StickSlip or Case
        The oscillator.

    Returns
    -------
    ExactOrbit or ExactSceneOrbit
        Period, times and motion, from the closed-form flow of each phase.

    Raises
    ------
    TypeError
        If `case` is neither.
    NoOrbit
        If no admissible orbit of a `Case` was found.

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
    generic, entrance = _way(case, [None], None, shortcuts=True)
    if entrance is not None:
        found: ExactOrbit = entrance.exact(case)
        return found
    from .solver.flow.exact import exact_orbit  # noqa: PLC0415

    return exact_orbit(generic)


def simulate(
    case: "StickSlip | Case",
    state: Sequence[float] | None = None,
    cycles: float | None = None,
    *,
    time: float | None = None,
    forcing_phase: float = 0.0,
) -> "Simulation":
    """Return the motion of an oscillator from a given state, from event to event.

    Each phase is the exact flow of its equation, and no event can be stepped over.

    Parameters
    ----------
    case : StickSlip or Case
        The oscillator.
    state : (float, float), optional
        Displacement in m and velocity in m/s at the start; without it at rest at 0 or, if
        the scene does not admit that, at or next to the nearest limit.
    cycles : float, optional
        How many periods of the forcing or, where nothing forces, how many times 2 pi of the
        scene's unit of time; 20 without it.
    time : float, optional
        How long in s, in place of `cycles`.
    forcing_phase : float
        Phase of the forcing at the start, in rad; 0 where nothing forces.

    Returns
    -------
    Simulation
        Its phases, the motion at any time, and why it ended where it did so early.

    Raises
    ------
    TypeError
        If `case` is neither.
    ValueError
        If a number is not one that can be simulated, or no phase takes the state at the start.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> motion = ns.simulate(ns.scene("impact")(), cycles=3)
    >>> motion
    <impact simulated for 10.472 s: 4 phases>
    >>> [round(phase.start, 6) for phase in motion.phases]
    [0.0, 0.468885, 4.237267, 7.641]
    >>> print(motion.displacement([0, 1, 2]).round(6))
    [ 0.        0.023297 -0.395435]
    """
    from .solver.simulation.simulate import simulate as simulated  # noqa: PLC0415

    generic, _ = _way(case, [None], None, shortcuts=False)
    return simulated(generic, state, cycles, time=time, forcing_phase=forcing_phase)


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


def _way(
    oscillator: object, methods: Sequence[object], functions: int | None, shortcuts: bool
) -> "tuple[Case, None] | tuple[Any, Entrance]":
    """Return the case that the kernels of every scene solve, or the entrance that is meant.

    Raises
    ------
    TypeError
        If it is not an oscillator.
    ValueError
        If some methods are of every scene, and others are not.
    """
    from .solver.case.case import Case  # noqa: PLC0415

    if isinstance(oscillator, Case):
        return oscillator, None
    from .solver.shortcut import entrance_of  # noqa: PLC0415

    entrance = entrance_of(oscillator)
    if functions is not None or not shortcuts:
        return entrance.case(oscillator), None
    of_every_scene = [entrance.is_of_every_scene(method) for method in methods]
    for method, each in zip(methods, of_every_scene, strict=True):
        if each != of_every_scene[0]:
            raise ValueError(
                f"methods: got {method!r} beside {methods[0]!r}, expected either the paper's "
                "or those of every scene; with shortcuts=False all are solved by the latter"
            )
    if of_every_scene and of_every_scene[0]:
        return entrance.case(oscillator), None
    return oscillator, entrance
