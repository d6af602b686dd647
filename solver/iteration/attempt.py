"""One way from rough times to a solution of a method's equations."""

from contextlib import nullcontext

import numpy as np

from ..arrays import Vector
from ..case.case import Case
from ..case.kernel import Kernel
from ..orbit.orbit import Orbit
from .newton import newton
from .start import with_coefficients


def attempt(
    kernel: Kernel, case: Case, order: int, times: Vector, functions: int | None = None
) -> Orbit:
    """Return where Newton's method leads from rough times: an orbit only if it says so.

    Parameters
    ----------
    kernel : Kernel
        Of the method.
    case, order : Case, int
        What to solve.
    times : ndarray
        Durations and, if the scene is forced, the phase of the forcing; without units.
    functions : int, optional
        See `Orbit`.
    """
    with nullcontext() if kernel.account is None else kernel.account.spending():
        size = kernel.size(order)
        if kernel.condensed:
            start = np.concatenate([np.zeros(size - len(times)), times])
        else:
            start = with_coefficients(kernel, case.arguments, size, times)
        outcome = newton(kernel.iterate, case.arguments, start)
    found = Orbit(case, kernel.method, order, outcome, outcome.iterations, functions)
    return case.presented(found)
