"""One way from rough times to a solution of a method's equations."""

from ..arrays import Vector
from ..kernels.kernel import Kernel
from ..kernels.start import solved
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
    with kernel.spending():
        given = kernel.given(case, order)
        outcome = solved(kernel, given, kernel.size(order), times)
    return Solution(case, kernel.method, order, outcome, outcome.iterations, functions)
