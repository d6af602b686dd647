"""LU factors, least squares and products of small matrices, compiled with the kernel by numba.

At forty unknowns LAPACK is no faster, and its call from Python takes longer.  Zeros below the
diagonal, of which banded and bordered matrices have many, cost nothing.
"""

from typing import Any

import numpy as np

from ..arrays import Matrix, Vector

#: Norm below which a column with entries of size 1 is only rounding.
NOTHING = 1e-13


def factorise(A: Matrix, rows: Any) -> bool:
    """Factorise `A` in place, P A = L U with partial pivoting; return whether it is regular.

    rows : ndarray of int, shape (n,)
        Filled with the index of the pivot row of each step.
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
    """Overwrite `b` with the solution of A x = b, for the factors and pivots of `factorise`."""
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
    """Fill `x` with the least-squares solution, by Householder reflections.

    The first `count` columns of `A` are the matrix, the next is the right side; `A` is
    overwritten.  The unknown of a column that depends on those before it is set to zero.
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
    """Return the product of matrices, the last one leftmost, and the scale of its rounding.

    The rounding error of each factor, relative to its `sizes`, is propagated through the other
    factors themselves: a product of all sizes would grow with every phase.

    Parameters
    ----------
    steps, sizes : ndarray, shape (P, n, n)
    """
    count, n = len(steps), steps.shape[1]
    before, after, size = np.empty((count + 1, n, n)), np.eye(n), np.zeros((n, n))
    before[0] = after
    for p in range(count):
        before[p + 1] = np.dot(steps[p], before[p])
    for p in range(count - 1, -1, -1):
        size += np.dot(np.abs(after), np.dot(sizes[p], np.abs(before[p])))
        after = np.dot(after, steps[p])
    return before[count], size
