"""LU factors of small systems, as Python that numba compiles with the kernel.

At forty unknowns LAPACK is no faster, and its call from Python takes longer.
"""

from typing import Any

from ..arrays import Matrix, Vector


def factorise(A: Matrix, rows: Any) -> bool:
    """Factorise `A` in place, P A = L U with partial pivoting; whether it is regular.

    rows : ndarray of int, shape (n,)
        Filled with the row that was exchanged with each.
    """
    n = len(A)
    for k in range(n):
        pivot = k
        for i in range(k + 1, n):
            if abs(A[i, k]) > abs(A[pivot, k]):
                pivot = i
        rows[k] = pivot
        if A[pivot, k] == 0:
            return False
        if pivot != k:
            for j in range(n):
                A[k, j], A[pivot, j] = A[pivot, j], A[k, j]
        right = A[k, k + 1 :]
        for i in range(k + 1, n):
            factor = A[i, k] / A[k, k]
            A[i, k] = factor
            row = A[i, k + 1 :]
            for j in range(len(right)):
                row[j] -= factor * right[j]
    return True


def solve_factorised(A: Matrix, rows: Any, b: Vector) -> None:
    """Overwrite `b` with the solution for the factors and exchanges of `factorise`."""
    n = len(A)
    for k in range(n):
        pivot = rows[k]
        b[k], b[pivot] = b[pivot], b[k]
    for k in range(n):
        for i in range(k + 1, n):
            b[i] -= A[i, k] * b[k]
    for k in range(n - 1, -1, -1):
        b[k] /= A[k, k]
        for i in range(k):
            b[i] -= A[i, k] * b[k]
