"""LU factors of a system that may be large, by rows and blocks.

The functions stand for those of the same names in `iteration.linear` and `iteration.iteration`,
which are quicker where there are few unknowns.  Plain Python, or compiled by numba.
"""

from typing import Any

import numpy as np

from ...arrays import Matrix, Vector

#: Columns that are factorised together.
BLOCK = 32


def factorise(A: Matrix, rows: Any) -> bool:
    """Factorise `A` in place, P A = L U with partial pivoting; whether it is regular."""
    n = len(A)
    for first in range(0, n, BLOCK):
        last = min(first + BLOCK, n)
        for k in range(first, last):
            pivot = k + int(np.argmax(np.abs(A[k:, k])))
            rows[k] = pivot
            if A[pivot, k] == 0 or not np.isfinite(A[pivot, k]):
                return False
            if pivot != k:
                row = A[k].copy()
                A[k], A[pivot] = A[pivot], row
            A[k + 1 :, k] /= A[k, k]
            A[k + 1 :, k + 1 : last] -= A[k + 1 :, k : k + 1] * A[k, k + 1 : last]
        for k in range(first, last):
            A[k + 1 : last, last:] -= A[k + 1 : last, k : k + 1] * A[k, last:]
        left, right = A[last:, first:last].copy(), A[first:last, last:].copy()
        A[last:, last:] -= left @ right
    return True


def solve_factorised(A: Matrix, rows: Any, b: Vector) -> None:
    """Overwrite `b` with the solution for the factors and exchanges of `factorise`."""
    n = len(A)
    for k in range(n):
        pivot = rows[k]
        b[k], b[pivot] = b[pivot], b[k]
    for i in range(n):
        b[i] -= np.dot(A[i, :i], b[:i])
    for i in range(n - 1, -1, -1):
        b[i] = (b[i] - np.dot(A[i, i + 1 :], b[i + 1 :])) / A[i, i]


def scale_rows(J: Matrix, scales: Vector) -> None:
    """Divide each row by its largest entry, which `scales` keeps."""
    for i in range(len(J)):
        largest = np.abs(J[i]).max()
        scales[i] = largest if largest > 0 else 1.0
        J[i] /= scales[i]
