"""Many orbits at once by the scalar equation of Section 3.3: one for each alpha."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ...arrays import Vector
from ..orbit.methods import LARGEST_ALPHA, METHODS, SMALLEST_ALPHA, check_order
from ..search import kernels

#: Orbits between two looks at the keyboard: a tenth of a second.
BLOCK = 500_000

#: Status of an orbit in a batch.
OK, NOT_CONVERGED, NOT_ADMISSIBLE = 0, 1, 2


@dataclass(frozen=True)
class Batch:
    """Times of many C1 orbits, dimensionless.

    Parameters
    ----------
    alpha, t1, T : ndarray, shape (n,)
        The parameter; end of stick and period in ``1/omega_n``.
    status : ndarray of int, shape (n,)
        0: converged and admissible; 1: not converged; 2: converged to what is not an orbit.
        Where it is not 0, ``t1`` and ``T`` are NaN.

    Notes
    -----
    ``T`` keeps 14 digits.  ``t1`` has an error of about ``1e-15 (1 + 1/alpha) T``: pure slip
    is another root of the same equation, ``2 alpha`` away.  Below ``alpha`` of about 1e-5
    the two are not told apart, and the status says so.  `solve` has no such loss.
    """

    alpha: Vector
    t1: Vector
    T: Vector
    status: npt.NDArray[np.int64]


def c1_times(alpha: npt.ArrayLike, order: int) -> Batch:
    """Solve Section 3.3 for every `alpha`, on all cores.

    Parameters
    ----------
    alpha : array_like of float, shape (n,)
        Values of ``omega_n (mu_s - mu_k) F_N / (K V)``, from 1e-8 to 1e8.
    order : int
        ``N`` of (15).

    Raises
    ------
    ValueError
        If an alpha is out of range, or the order cannot be computed.

    Examples
    --------
    >>> result = c1_times([0.5, 1.0, 2.0], 9)
    >>> result.T.round(6)
    array([6.35589 , 6.712389, 8.068888])
    """
    check_order(order, METHODS["c1"])
    alphas = np.atleast_1d(np.asarray(alpha, dtype=float)).ravel()
    wrong = alphas[~((alphas >= SMALLEST_ALPHA) & (alphas <= LARGEST_ALPHA))]
    if len(wrong):
        allowed = f"{SMALLEST_ALPHA:g} to {LARGEST_ALPHA:g}"
        raise ValueError(f"alpha: got {float(wrong[0])!r}, expected numbers from {allowed}")
    functions = kernels.compiled_functions("c1-reduced")
    table = functions["series_coefficients"](order)
    t1, s = np.empty((2, len(alphas)))
    status = np.empty(len(alphas), dtype=np.int64)
    for start in range(0, len(alphas), BLOCK):
        part = slice(start, start + BLOCK)
        functions["batch"](alphas[part], order, table, t1[part], s[part], status[part])
    t1[status != OK] = s[status != OK] = np.nan
    return Batch(alphas, t1, t1 + s, status)
