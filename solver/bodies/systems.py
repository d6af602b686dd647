"""Sparse matrix products without rounding errors, and refined solutions of sparse systems.

K. Ozaki, T. Ogita, S. Oishi and S. M. Rump, Numer. Algorithms 59 (2012), 95-118.
"""

from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np

from ..arrays import Matrix, Vector

#: Bits of a number, and of how many parts it is the sum.
BITS, PARTS = 53, 4

#: Entries of a matrix, as a part of all, from which on products are those of a full one.
FULL = 0.1

Solve: TypeAlias = Callable[[Matrix], Matrix]


class BodyError(ValueError):
    """A body for which no orbit can be computed; the message says why."""


def exact_product(A: Any, B: Matrix) -> tuple[Matrix, Matrix]:
    """Return ``A B`` of a sparse and a full matrix, rounded, and its rounding error.

    Both are cut into parts of so few bits that the products of parts are without rounding.

    Parameters
    ----------
    A : sparse array, shape (n, k)
    B : ndarray, shape (k, m)

    Returns
    -------
    product, rest : ndarray, shape (n, m)
    """
    A = A.tocsr()
    counts = np.diff(A.indptr)
    bits = (BITS - int(np.ceil(np.log2(max(counts.max(initial=0), 2))))) // 2
    rows, full = abs(A).max(axis=1).toarray().ravel(), A.nnz > FULL * A.shape[0] * A.shape[1]
    values, sizes = (A.toarray(), rows[:, None]) if full else (A.data, np.repeat(rows, counts))
    columns = _parts(B, np.abs(B).max(axis=0), bits)
    total = low = np.zeros((A.shape[0], B.shape[1]))
    for part in _parts(values, sizes, bits):
        if not full:
            part = type(A)((part, A.indices, A.indptr), shape=A.shape)  # noqa: PLW2901
        for column in columns:
            product = part @ column
            grown = total + product
            high = grown - total
            low = low + ((total - (grown - high)) + (product - high))
            total = grown
    return total + low, (total - (total + low)) + low


def _parts(values: Any, sizes: Vector, bits: int) -> list[Any]:
    """Return a splitting of numbers into parts of few bits, the largest first."""
    parts, top = [], np.exp2(np.ceil(np.log2(np.where(sizes > 0, sizes, 1.0))))
    for q in range(1, 1 + PARTS):
        step = top * 2.0 ** (BITS - q * bits)  # what is less than a bit of it is rounded
        part = (values + step) - step
        parts.append(part)
        values = values - part
        if not values.any():
            break
    return parts


def factored(matrix: Any) -> Any:
    """Return the LU factors of a symmetric sparse matrix."""
    from scipy import sparse  # noqa: PLC0415

    try:
        return sparse.linalg.splu(
            matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.1,
            options={"SymmetricMode": True},
        )  # fmt: skip
    except RuntimeError:
        raise BodyError("the matrices of the body are singular") from None


def solver(matrix: Any, factors: Any = None) -> Solve:
    """Return a solver of systems with a symmetric sparse matrix, to full accuracy.

    What is left of a system is solved once more.  Right sides have the shape (n, k).
    """
    factors = factored(matrix) if factors is None else factors

    def solve(right: Matrix) -> Matrix:
        solution = factors.solve(right)
        product, remainder = exact_product(matrix, solution)
        return np.asarray(solution + factors.solve((right - product) - remainder))

    return solve
