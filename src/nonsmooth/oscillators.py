"""`solve`, `sweep` and `exact` for any oscillator: the paper's, or a case of any scene."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any, overload

from .solver.shortcuts.orbit.oscillator import StickSlip

if TYPE_CHECKING:
    from .solver.case.case import Case
    from .solver.flow.exact import ExactSceneOrbit
    from .solver.orbit.orbit import SceneOrbit
    from .solver.shortcuts.orbit.motion import ExactOrbit
    from .solver.shortcuts.orbit.orbit import Orbit
    from .solver.shortcuts.search.sweep import Sweep
    from .solver.sweep import SceneSweep

#: The scene that a `StickSlip` is a case of.
PAPER = "stick-slip"


@overload
def solve(
    case: StickSlip,
    method: str | None = None,
    order: int | None = None,
    *,
    c1_terms: int = 1,
    functions: int | None = None,
    tol: float | None = None,
    tol_acceleration: float | None = None,
    budget: float | None = None,
    many: bool = False,
) -> "Orbit": ...


@overload
def solve(
    case: "Case",
    method: str | None = None,
    order: int | None = None,
    *,
    functions: int | None = None,
    tol: float | None = None,
    motion: str | None = None,
    cycles: int | None = None,
) -> "SceneOrbit": ...


def solve(
    case: "StickSlip | Case",
    method: str | None = None,
    order: int | None = None,
    *,
    functions: int | None = None,
    tol: float | None = None,
    motion: str | None = None,
    cycles: int | None = None,
    **paper: Any,
) -> "Orbit | SceneOrbit":
    """Return the periodic orbit of an oscillator: by method and order, or as accurate as asked.

    Of a `StickSlip` by the paper's methods ``"hb"``, ``"hb-c1"`` and ``"c1"`` it is an `Orbit`,
    found as the paper has it; `method` and `order`, or a tolerance, or a budget is needed.  Of
    a `Case`, and of a `StickSlip` by any other method, it is a `SceneOrbit`, found by the
    kernels that every scene has.

    Parameters
    ----------
    case : StickSlip or Case
        The oscillator; a `Case` is ``ns.scene("impact")(gap=0.2)``.
    method : str, optional
        ``"hb"``, ``"hb-ck"``, ``"ck"`` or ``"ck-tau"``, also with the class of the scene,
        as ``"c0-tau"``.  Of a `Case` ``"ck-tau"`` without it, or with a tolerance of a
        `StickSlip` whichever is cheapest.
    order : int, optional
        ``N``; of a `Case` 10 without it.  A tolerance chooses it, and it is left out.
    functions : int, optional
        Functions beside the harmonics of ``"hb-ck"`` at each switch; 1, or 2 where the
        velocity jumps, if not given.
    tol : float, optional
        Largest error of the times and the period, as estimated, as a part of the period;
        between 0 and 1.  Of a `Case`, the lowest order is taken that meets it.
    motion : str, optional
        Of a scene with several motions, orders of its phases, the one that is meant; without
        it each is tried, and the orbit that there is is returned.
    cycles : int, optional
        Periods of the forcing in one of the motion; without it those of the case, usually 1.
    c1_terms, tol_acceleration, budget, many : optional
        Of a `StickSlip` by the paper's methods, as for the function `solve` of the shortcuts.

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
    <impact by c0-tau, N = 8: T = 3.490658504 s, 7 iterations>
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> print(f"{ns.solve(belt, 'c1', 7).period:.9f}, {ns.solve(belt, 'c1-tau', 7).period:.9f}")
    0.671238381, 0.671238898
    """
    generic = _generic(case, method, functions)
    if generic is not None and cycles is not None:
        generic = generic.with_cycles(cycles)
    if generic is None:
        if motion is not None or cycles not in (None, 1):
            what, value = ("motion", motion) if motion is not None else ("cycles", cycles)
            raise ValueError(f"{what}: got {value!r}, expected it for a case of ns.scene(...)")
        from .solver.shortcuts.search import solve as paper_solve  # noqa: PLC0415  (it loads parts of SciPy)

        name: Any = paper_name(method)
        return paper_solve.solve(case, name, order, tol=tol, **paper)  # type: ignore[arg-type]
    if paper:
        option, value = next(iter(paper.items()))
        raise ValueError(f"{option}: got {value!r}, expected it for the paper's methods only")
    from .solver.accuracy.estimate import BEST  # noqa: PLC0415
    from .solver.solve import solve_case  # noqa: PLC0415

    chosen = BEST if method is None else method
    if tol is None:
        return solve_case(generic, chosen, 10 if order is None else order, functions, motion)
    if order is not None:
        raise ValueError(f"order: got {order!r} beside a tolerance, which chooses it")
    from .solver.tolerance import choose_order  # noqa: PLC0415  (it loads SciPy)

    return choose_order(generic, tol, chosen, functions, motion).orbit


def sweep(
    case: "StickSlip | Case",
    methods: str | Sequence[str] | None = None,
    orders: Iterable[int] | None = None,
    *,
    c1_terms: int = 1,
    functions: int | None = None,
    progress: Callable[[Any], None] = lambda row: None,
) -> "Sweep | SceneSweep":
    """Solve for each method and order, and compare with the exact orbit.

    Parameters
    ----------
    case : StickSlip or Case
        The oscillator.
    methods : str or sequence of str, optional
        The methods, each in its turn; without it all, those orders left out that a method
        cannot compute and another can.
    orders : iterable of int, optional
        The orders of every method; 1 to 40 without it, of a `Case` 1 to 20.
    c1_terms : int
        C1 functions of ``"hb-c1"`` of a `StickSlip`, 1 to 6; the paper has one.
    functions : int, optional
        Functions of ``"hb-ck"`` at each switch of a `Case`; see `solve`.
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
        If a method or an order is not one that can be computed; before anything is.

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
    named = [methods] if isinstance(methods, str) or methods is None else [*methods]
    found = [_generic(case, name, functions) for name in named]
    generic = found[0] if found else _generic(case, None, functions)
    for name, each in zip(named, found, strict=True):
        if (each is None) != (generic is None):
            raise ValueError(
                f"methods: got {name!r} beside {named[0]!r}, expected either the paper's or "
                "those of every scene; a case of ns.scene('stick-slip') has all by the latter"
            )
    if generic is None:
        from .solver.shortcuts.search import sweep as paper_sweep  # noqa: PLC0415  (it loads parts of SciPy)

        numbers = range(1, 41) if orders is None else orders
        return paper_sweep.sweep(
            case,  # type: ignore[arg-type]
            None if methods is None else [str(paper_name(name)) for name in named],
            numbers,
            c1_terms=c1_terms,
            progress=progress,
        )
    if c1_terms != 1:
        raise ValueError(f"c1_terms: got {c1_terms!r}, expected functions for these methods")
    from .solver.sweep import sweep_case  # noqa: PLC0415

    numbers = range(1, 21) if orders is None else orders
    return sweep_case(generic, methods, numbers, functions, progress)


@overload
def exact(case: StickSlip) -> "ExactOrbit": ...


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
    generic = _generic(case, None, None)
    if generic is None:
        from .solver.shortcuts.orbit import motion  # noqa: PLC0415  (only where it is needed)

        return motion.exact(case)  # type: ignore[arg-type]
    from .solver.flow.exact import exact_orbit  # noqa: PLC0415

    return exact_orbit(generic)


def _generic(case: object, method: object, functions: int | None) -> "Case | None":
    """Return the case that the kernels of every scene solve; None if the paper's way is meant.

    What is neither a case nor a `StickSlip` goes the paper's way, and is refused there.
    """
    if isinstance(case, StickSlip):
        if functions is None and not of_every_scene(method):
            return None
        from .solver.case.registry import load  # noqa: PLC0415

        return load(PAPER)(**asdict(case))
    from .solver.case.case import Case  # noqa: PLC0415

    return case if isinstance(case, Case) else None


def paper_name(method: object) -> object:
    """Return the paper's name of a method that is named as in every scene.

    Examples
    --------
    >>> paper_name("hb-ck"), paper_name("ck-tau")
    ('hb-c1', 'ck-tau')
    """
    return (
        {"hb-ck": "hb-c1", "ck": "c1"}.get(method, method)
        if isinstance(method, str)
        else method
    )


def of_every_scene(method: object) -> bool:
    """Whether a method of the paper's oscillator is one of every scene, and not the paper's.

    Examples
    --------
    >>> of_every_scene("c1-tau"), of_every_scene("c1"), of_every_scene("no method")
    (True, False, False)
    """
    from .solver.case.registry import UnknownScene, generic_method, load  # noqa: PLC0415

    if not isinstance(method, str) or paper_name(method) in ("hb", "hb-c1", "c1"):
        return False
    try:
        generic_method(load(PAPER), method)
    except UnknownScene:
        return False
    return True
