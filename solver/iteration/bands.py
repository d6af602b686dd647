"""Band matrices, factorised from the highest index down, as Python that numba compiles.

A row of the band is kept by its diagonals: entry ``[PAD + i, PAD + j - i]`` is that of unknown
j in row i, with ``PAD = BELOW + ABOVE``.  In front there are PAD rows of zeros, so that sums
over diagonals need no ends.  Rows are exchanged within the band, for the largest pivot.

``BELOW`` and ``ABOVE``, the diagonals on either side, are those of the kernel that is linked.
"""

from typing import Any

from ..arrays import Matrix

#: Stand for those of the kernel.
BELOW, ABOVE, KEPT = 2, 2, 1


def factorise_band(diagonals: Any, exchanged: Any, p: int, size: int, b: Matrix) -> None:
    """Factorise a band in place, and eliminate in the right side `b`.

    diagonals : ndarray, shape (PAD + size, PAD + ABOVE + 1)
        The pivots become their reciprocals.
    exchanged : ndarray of int
        Filled with the row that was exchanged with each.
    """
    pad = BELOW + ABOVE
    for i in range(pad + size - 1, pad - 1, -1):
        pivot, largest = i, abs(diagonals[p, i, pad])
        for up in range(1, ABOVE + 1):
            entry = abs(diagonals[p, i - up, pad + up])
            if entry > largest:
                pivot, largest = i - up, entry
        exchanged[p, i] = pivot
        if pivot != i:
            for q in range(pad + 1):
                value = diagonals[p, i, q]
                diagonals[p, i, q] = diagonals[p, pivot, q + i - pivot]
                diagonals[p, pivot, q + i - pivot] = value
            b[p, i], b[p, pivot] = b[p, pivot], b[p, i]
        inverse = 1.0 / diagonals[p, i, pad]
        diagonals[p, i, pad] = inverse
        for up in range(1, ABOVE + 1):
            factor = diagonals[p, i - up, pad + up] * inverse
            diagonals[p, i - up, pad + up] = factor
            for q in range(pad):
                diagonals[p, i - up, q + up] -= factor * diagonals[p, i, q]
            b[p, i - up] -= factor * b[p, i]


def substitute(diagonals: Any, p: int, size: int, b: Matrix) -> None:
    """Overwrite `b`, in which was eliminated, with the solution."""
    pad = BELOW + ABOVE
    for i in range(pad, pad + size):
        value = b[p, i]
        for q in range(pad):
            value -= diagonals[p, i, q] * b[p, i - pad + q]
        b[p, i] = value * diagonals[p, i, pad]


def solve_columns(
    diagonals: Any, exchanged: Any, p: int, size: int, B: Any, reach: int
) -> None:
    """Overwrite the first `reach` rows of `B` with those of the solution of all its columns."""
    pad = BELOW + ABOVE
    for i in range(pad + size - 1, pad - 1, -1):
        pivot = exchanged[p, i]
        if pivot != i:
            for c in range(KEPT):
                B[p, i, c], B[p, pivot, c] = B[p, pivot, c], B[p, i, c]
        for up in range(1, ABOVE + 1):
            factor = diagonals[p, i - up, pad + up]
            for c in range(KEPT):
                B[p, i - up, c] -= factor * B[p, i, c]
    for i in range(pad, pad + reach):
        for q in range(pad):
            factor = diagonals[p, i, q]
            for c in range(KEPT):
                B[p, i, c] -= factor * B[p, i - pad + q, c]
        inverse = diagonals[p, i, pad]
        for c in range(KEPT):
            B[p, i, c] *= inverse
