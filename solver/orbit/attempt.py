"""One way from rough times to a solution of a method's equations."""

from contextlib import nullcontext

import numpy as np

from ..arrays import Vector
from ..iteration.newton import newton
from ..kernels.kernel import Kernel
from ..kernels.start import with_coefficients
from ..scenes.case import Case
from .solution import Solution


def attempt(
    kernel: Kernel, case: Case, order: int, times: Vector, functions: int | None = None
) -> Solution:
    """Return where Newton's method leads from rough times: an orbit only if it says so.

    Parameters
    ----------
    times : ndarray
        Durations and, if the scene is forced, the phase of the forcing; without units.
    functions : int, optional
        See `Solution`.
    """
    with nullcontext() if kernel.account is None else kernel.account.spending():
        size, given = kernel.size(order), kernel.given(case, order)
        if kernel.condensed:
            start = np.concatenate([np.zeros(size - len(times)), times])
        else:
            start = with_coefficients(kernel, given, size, times)
        outcome = newton(kernel.iterate, given, start)
    return Solution(case, kernel.method, order, outcome, outcome.iterations, functions)
