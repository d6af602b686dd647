"""The most accurate orbit of a case within a time budget, measured on this machine."""

import math
from functools import partial

from ..kernels import registry
from ..no_orbit import NoOrbit
from ..results.orbit import Orbit
from ..scenes.case import Case
from ..scenes.methods import in_order
from ..scenes.parameter_error import is_number, repeated
from ..solve import number_of_functions, solve_case
from .choice import Choice, TooSlow, Trial, size
from .measured import orders, timed


def choose_within(
    case: Case, budget: float, method: str | None = None, functions: int | None = None
) -> Choice:
    """Return the orbit with the smallest estimated errors that is computed within a budget.

    Every candidate is solved and timed, with its search from rough times and its checks.  The
    orders of a method end with the first that exceeds the budget.

    Parameters
    ----------
    case : Case
        The oscillator.
    budget : float
        Seconds for one orbit.
    method : str, optional
        The method.  Default: all are tried.
    functions : int, optional
        See `solve_case`.

    Raises
    ------
    ValueError
        If the budget is not a positive number of seconds, or there is no such method.
    TooSlow
        If no orbit is computed within the budget.
    NoOrbit
        If no order that was tried has an orbit.
    """
    if not (is_number(budget) and budget > 0):
        expected = "a positive number of seconds"
        raise ValueError(f"budget: got {repeated(budget)}, expected {expected}")
    scene = case.scene
    names = in_order(registry.methods(scene)) if method is None else (method,)
    trials: list[Trial] = []
    best: Orbit | None = None
    finding: NoOrbit | None = None
    for name in (registry.generic_method(scene, name) for name in names):
        count = number_of_functions(case, name, functions)
        for order in orders(case, name, count):
            try:
                orbit, seconds = timed(partial(solve_case, case, name, order, count))
            except NoOrbit as error:
                finding = error
                trials.append(Trial(name, order, None))
                continue
            trials.append(Trial(name, order, orbit.estimate, seconds))
            if seconds > budget:
                break
            if best is None or size(orbit.estimate) < size(best.estimate):
                best = orbit
    if best is not None:
        return Choice(best, tuple(trials))
    times = [trial.seconds for trial in trials if trial.seconds is not None]
    if finding is not None and not times:
        raise finding
    raise TooSlow(budget, min(times, default=math.inf))
