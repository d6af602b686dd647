"""LU factors of small systems, and products, as Python that numba compiles with the kernel.

At forty unknowns LAPACK is no faster, and its call from Python takes longer.  Zeros below the
diagonal, of which bands and borders have many, cost nothing.
"""

from typing import Any

import numpy as np

from ..arrays import Matrix, Vector

#: A column of numbers of size 1 that is no longer than this is nothing but rounding.
NOTHING = 1e-13


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
            if A[i, k] == 0:
                continue
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
    for i in range(n):
        row, value = A[i], b[i]
        for j in range(i):
            value -= row[j] * b[j]
        b[i] = value
    for later in range(n):
        i = n - 1 - later
        row, value = A[i], b[i]
        for back in range(later):
            j = n - 1 - back
            value -= row[j] * b[j]
        b[i] = value / row[i]


def least_squares(A: Matrix, count: int, x: Vector) -> None:
    """Fill `x` with the solution of least residual, by Householder's reflections.

    The first `count` columns of `A` are the matrix, the next is the right side; overwritten.
    A column that adds nothing to those before it gets zero.
    """
    rows = len(A)
    for k in range(count):
        square = 0.0
        for i in range(k, rows):
            square += A[i, k] * A[i, k]
        if square <= NOTHING * NOTHING:
            A[k, k] = 0.0
            continue
        norm = -np.sqrt(square) if A[k, k] > 0 else np.sqrt(square)
        A[k, k] -= norm
        for j in range(k + 1, count + 1):
            total = 0.0
            for i in range(k, rows):
                total += A[i, k] * A[i, j]
            total /= norm * A[k, k]
            for i in range(k, rows):
                A[i, j] += total * A[i, k]
        A[k, k] = norm
    for k in range(count - 1, -1, -1):
        value = A[k, count]
        for j in range(k + 1, count):
            value -= A[k, j] * x[j]
        x[k] = value / A[k, k] if A[k, k] != 0 else 0.0


def product(steps: Vector, sizes: Vector) -> tuple[Matrix, Matrix]:
    """Return the product of matrices, and what its rounding errors are parts of.

    The rounding of each, a part of its `sizes`, goes with what comes before and behind it: the
    product of all sizes would grow with every phase, whatever the product itself does.

    Parameters
    ----------
    steps, sizes : ndarray, shape (P, n, n)
    """
    count, n = len(steps), steps.shape[1]
    before, behind, size = np.empty((count + 1, n, n)), np.eye(n), np.zeros((n, n))
    before[0] = behind
    for p in range(count):
        before[p + 1] = np.dot(steps[p], before[p])
    for p in range(count - 1, -1, -1):
        size += np.dot(np.abs(behind), np.dot(sizes[p], np.abs(before[p])))
        behind = np.dot(behind, steps[p])
    return before[count], size
