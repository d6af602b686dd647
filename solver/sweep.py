"""Convergence of the methods of a scene over orders: one row each, with or without an orbit."""

import time
from collections.abc import Callable, Iterable, Sequence

from .kernels import registry
from .no_orbit import NoOrbit
from .results.sweep import Sweep, SweepRow
from .scenes.case import Case, check_case
from .scenes.methods import in_order
from .scenes.parameter_error import several, whole_or_none
from .search import check_order
from .solve import number_of_functions, solve_case, with_motion


def sweep(
    case: Case,
    methods: str | Sequence[str] | None = None,
    orders: Iterable[int] = range(1, 21),
    *,
    functions: int | None = None,
    progress: Callable[[SweepRow], None] = lambda row: None,
) -> Sweep:
    """Return the orbits of each method and order, compared with the exact orbit.

    Parameters
    ----------
    case : Case
        The oscillator.
    methods : str or sequence of str, optional
        The methods, in order.  Default: all, each without the orders below its lowest.
    orders : iterable of int
        The orders of every method.
    functions : int, optional
        Functions of ``"hb-ck"`` at each switch; see `solve`.
    progress : callable, optional
        Called with each row when it is done.

    Raises
    ------
    TypeError
        If `case` is not a `Case`.
    ValueError
        If there is no such method or order, or none is given; raised before the orbits are
        computed.

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
    wanted = [methods] if isinstance(methods, str) else methods
    if wanted is not None:
        wanted = several("methods", wanted, "names of methods")
    numbers = several("orders", orders, "whole numbers")
    scene, functions, kernels = case.scene, whole_or_none("functions", functions), []
    names = in_order(registry.methods(scene)) if wanted is None else wanted
    for method in (registry.generic_method(scene, name) for name in names):
        count = number_of_functions(case, method, functions)
        of_motions = [registry.kernel(each, method, count) for each in scene.each_motion]
        kernels.append((max(of_motions, key=lambda kernel: kernel.lowest), method, count))
    if methods is None:
        least = min((kernel for kernel, *_ in kernels), key=lambda kernel: kernel.lowest)
        numbers = [check_order(least, order) for order in numbers]
    jobs = []
    for kernel, method, count in kernels:
        chosen = (order for order in numbers if methods is not None or order >= kernel.lowest)
        jobs += [(method, check_order(kernel, order), count) for order in chosen]
    none: NoOrbit | None = None
    try:
        case = with_motion(case)
    except NoOrbit as finding:
        none = finding
    rows = []
    for method, order, count in jobs:
        made = _row(case, method, order, count) if none is None else _empty(method, order, none)
        rows.append(made)
        progress(rows[-1])
    return Sweep(case, tuple(rows), functions)


def _empty(method: str, order: int, finding: NoOrbit, seconds: float = 0.0) -> SweepRow:
    """Return the row of a method and an order without an orbit."""
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
