"""LU factors in plain Python, all rows at once: the same bits as by `linear`, to compile."""

from typing import Any

import numpy as np

from ..arrays import Matrix
from . import linear

#: Fewest unknowns for which NumPy is quicker.
MANY = 16


def factorise(A: Matrix, rows: Any) -> bool:
    """Factorise `A` in place; see `linear.factorise`."""
    n = len(A)
    if n < MANY:
        return linear.factorise(A, rows)
    for k in range(n):
        pivot = k + int(np.argmax(np.abs(A[k:, k])))
        rows[k] = pivot
        if A[pivot, k] == 0:
            return False
        if pivot != k:
            A[[k, pivot]] = A[[pivot, k]]
        below = k + 1 + np.flatnonzero(A[k + 1 :, k])
        factors = A[below, k] / A[k, k]
        A[below, k] = factors
        A[below, k + 1 :] -= factors[:, None] * A[k, k + 1 :]
    return True
