"""Convergence of the methods of a scene over orders: one row each, whatever comes of it."""

import time
from collections.abc import Callable, Iterable, Sequence

from .kernels import registry
from .no_orbit import NoOrbit
from .results.sweep import Sweep, SweepRow
from .scenes.case import Case
from .scenes.methods import in_order
from .search import check_order
from .solve import number_of_functions, solve_case, with_motion


def sweep_case(
    case: Case,
    methods: str | Sequence[str] | None = None,
    orders: Iterable[int] = range(1, 21),
    functions: int | None = None,
    progress: Callable[[SweepRow], None] = lambda row: None,
    motion: str | None = None,
) -> Sweep:
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
        See `solve_case`.
    progress : callable
        Called with each row when it is done.
    motion : str, optional
        One of several motions; without it, that which is found by `solve_case`.

    Raises
    ------
    ValueError
        If a method or an order is not one that can be computed; before anything is.
    """
    none: NoOrbit | None = None
    try:
        case = with_motion(case) if motion is None else case.of_motion(motion)
    except NoOrbit as finding:
        none = finding
    scene, numbers = case.scene, list(orders)
    named = in_order(registry.methods(scene)) if methods is None else methods
    wanted = (named,) if isinstance(named, str) else named
    kernels = []
    for method in (registry.generic_method(scene, name) for name in wanted):
        count = number_of_functions(case, method, functions)
        kernels.append((registry.kernel(scene, method, count), method, count))
    if methods is None:
        least = min((kernel for kernel, *_ in kernels), key=lambda kernel: kernel.lowest)
        numbers = [check_order(least, order) for order in numbers]
    jobs = []
    for kernel, method, count in kernels:
        chosen = (order for order in numbers if methods is not None or order >= kernel.lowest)
        jobs += [(method, check_order(kernel, order), count) for order in chosen]
    rows = []
    for method, order, count in jobs:
        made = _row(case, method, order, count) if none is None else _empty(method, order, none)
        rows.append(made)
        progress(rows[-1])
    return Sweep(case, tuple(rows), functions)


def _empty(method: str, order: int, finding: NoOrbit, seconds: float = 0.0) -> SweepRow:
    """Return the row of an orbit that was not found."""
    nothing = (None, None, None, finding.iterations, None, None)
    return SweepRow(method, order, finding.status, *nothing, seconds, finding.in_full)


def _row(case: Case, method: str, order: int, functions: int | None) -> SweepRow:
    begin = time.perf_counter()
    try:
        orbit = solve_case(case, method, order, functions)
    except NoOrbit as finding:
        return _empty(method, order, finding, time.perf_counter() - begin)
    seconds = time.perf_counter() - begin
    return SweepRow(
        orbit.method, order, "ok", orbit.period, orbit.forcing_phase, orbit.durations,
        orbit.iterations, orbit.errors, orbit.estimate, seconds, further=orbit.further,
    )  # fmt: skip
