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


def eliminate_row(D: Any, p: int, i: int, b: Matrix, first: int) -> None:
    """Subtract row i from those above that see its pivot; it begins at diagonal `first`."""
    pad = BELOW + ABOVE
    inverse = 1.0 / D[p, i, pad]
    D[p, i, pad] = inverse
    for up in range(1, ABOVE + 1):
        factor = D[p, i - up, pad + up] * inverse
        D[p, i - up, pad + up] = factor
        for q in range(first, pad):
            D[p, i - up, q + up] -= factor * D[p, i, q]
        b[p, i - up] -= factor * b[p, i]


def factorise_band(D: Any, exchanged: Any, p: int, size: int, b: Matrix) -> None:
    """Factorise band `p` in place, and eliminate in its right side.

    D : ndarray, shape (bands, PAD + size, PAD + ABOVE + 1)
        The pivots become their reciprocals.
    exchanged : ndarray of int, shape (bands, PAD + size)
        Filled with the row that was exchanged with each.
    b : ndarray, shape (bands, PAD + size)
        Right sides.
    """
    pad, wide = BELOW + ABOVE, False
    for i in range(pad + size - 1, pad - 1, -1):
        pivot, largest = i, abs(D[p, i, pad])
        for up in range(1, ABOVE + 1):
            entry = abs(D[p, i - up, pad + up])
            if entry > largest:
                pivot, largest = i - up, entry
        exchanged[p, i] = pivot
        if pivot != i:
            wide = True  # from now on rows may reach further down
            for q in range(pad + 1):
                value = D[p, i, q]
                D[p, i, q] = D[p, pivot, q + i - pivot]
                D[p, pivot, q + i - pivot] = value
            b[p, i], b[p, pivot] = b[p, pivot], b[p, i]
        eliminate_row(D, p, i, b, 0 if wide else ABOVE)


def substitute(D: Any, p: int, first: int, last: int, b: Matrix, found: Matrix) -> None:
    """Fill in the solution from one row up to another; those before are there."""
    pad = BELOW + ABOVE
    for i in range(pad + first, pad + last):
        value = b[p, i]
        for q in range(pad):
            value -= D[p, i, q] * found[p, i - pad + q]
        found[p, i] = value * D[p, i, pad]


def solve_columns(D: Any, exchanged: Any, p: int, size: int, B: Any, reach: int) -> None:
    """Overwrite the first `reach` rows of `B` with those of the solution of all its columns."""
    pad = BELOW + ABOVE
    for i in range(pad + size - 1, pad - 1, -1):
        pivot = exchanged[p, i]
        if pivot != i:
            for c in range(KEPT):
                B[p, i, c], B[p, pivot, c] = B[p, pivot, c], B[p, i, c]
        for up in range(1, ABOVE + 1):
            factor = D[p, i - up, pad + up]
            for c in range(KEPT):
                B[p, i - up, c] -= factor * B[p, i, c]
    for i in range(pad, pad + reach):
        for q in range(pad):
            factor = D[p, i, q]
            for c in range(KEPT):
                B[p, i, c] -= factor * B[p, i - pad + q, c]
        inverse = D[p, i, pad]
        for c in range(KEPT):
            B[p, i, c] *= inverse
