"""Factors of band matrices, eliminated from the highest index down, compiled by numba.

Rows are stored by diagonals: entry ``[PAD + i, PAD + j - i]`` is that of unknown j in row i.
PAD rows of zeros in front save the ends of sums over diagonals.  The first two rows remain a
block, whose inverse is stored in their place: the pivot of the second may vanish though the
matrix is regular.  Other rows are exchanged only if a factor would be large, which is rare: in
phases of several periods.
"""

from typing import Any

from ..arrays import Matrix

#: Diagonals on either side; width below the diagonal after exchanges of rows.
SIDE = 2
PAD = 2 * SIDE

#: Size of the block at the lowest indices.
BLOCK = 2

#: The largest factor of elimination without an exchange.
LARGE = 10.0


def factorise_band(D: Matrix, exchanged: Any, size: int) -> bool:
    """Factorise a band in place; return whether rows were exchanged.

    D : ndarray, shape (PAD + size, PAD + SIDE + 1)
        Pivots are replaced by their reciprocals, entries above them by the factors.
    exchanged : ndarray of int, shape (PAD + size,)
        Filled with the index of the pivot row of each row.
    """
    wide = False
    for i in range(PAD + size - 1, PAD + BLOCK - 1, -1):
        wide = factorise_row(D, exchanged, i, wide)
    invert_block(D)
    return wide


def factorise_row(D: Matrix, exchanged: Any, i: int, wide: bool) -> bool:
    """Eliminate unknown i from the two rows above; return whether any rows were exchanged."""
    diagonal, above, second = D[i, PAD], D[i - 1, PAD + 1], D[i - 2, PAD + 2]
    exchanged[i] = i
    if LARGE * abs(diagonal) < max(abs(above), abs(second)):
        exchanged[i] = pivot = i - 1 if abs(above) >= abs(second) else i - 2
        wide = True  # from now on rows may reach further down
        for q in range(PAD + 1):
            value = D[i, q]
            D[i, q] = D[pivot, q + i - pivot]
            D[pivot, q + i - pivot] = value
        above, second = D[i - 1, PAD + 1], D[i - 2, PAD + 2]
    inverse = 1.0 / D[i, PAD]
    above, second = above * inverse, second * inverse
    D[i, PAD], D[i - 1, PAD + 1], D[i - 2, PAD + 2] = inverse, above, second
    for q in range(0 if wide else SIDE, PAD):
        D[i - 1, q + 1] -= above * D[i, q]
        D[i - 2, q + 2] -= second * D[i, q]
    return wide


def invert_block(D: Matrix) -> None:
    """Replace the block of the first two rows by its inverse."""
    a, b = D[PAD, PAD], D[PAD, PAD + 1]
    c, d = D[PAD + 1, PAD - 1], D[PAD + 1, PAD]
    inverse = 1.0 / (a * d - b * c)
    D[PAD, PAD], D[PAD, PAD + 1] = d * inverse, -b * inverse
    D[PAD + 1, PAD - 1], D[PAD + 1, PAD] = -c * inverse, a * inverse


def eliminate(D: Matrix, exchanged: Any, size: int, B: Matrix, first: int, last: int) -> None:
    """Apply the elimination to columns ``first:last`` of right sides, down to the block."""
    for i in range(PAD + size - 1, PAD + BLOCK - 1, -1):
        pivot, above, second = exchanged[i], D[i - 1, PAD + 1], D[i - 2, PAD + 2]
        for c in range(first, last):
            if pivot != i:
                B[i, c], B[pivot, c] = B[pivot, c], B[i, c]
            B[i - 1, c] -= above * B[i, c]
            B[i - 2, c] -= second * B[i, c]


def solve_block(D: Matrix, B: Matrix, first: int, last: int) -> None:
    """Overwrite the first two rows of columns ``first:last`` with the solution."""
    for c in range(first, last):
        low, high = B[PAD, c], B[PAD + 1, c]
        B[PAD, c] = D[PAD, PAD] * low + D[PAD, PAD + 1] * high
        B[PAD + 1, c] = D[PAD + 1, PAD - 1] * low + D[PAD + 1, PAD] * high


def substitute(D: Matrix, wide: bool, B: Matrix, end: int, first: int, last: int) -> None:
    """Overwrite rows up to `end` of columns with the solution; those of the block have it."""
    for i in range(PAD + BLOCK, PAD + end):
        for c in range(first, last):
            value = B[i, c] - D[i, PAD - 1] * B[i - 1, c] - D[i, PAD - 2] * B[i - 2, c]
            if wide:
                value -= D[i, PAD - 3] * B[i - 3, c] + D[i, PAD - 4] * B[i - 4, c]
            B[i, c] = value * D[i, PAD]


def solve(
    D: Matrix, exchanged: Any, wide: bool, rows: int, B: Matrix, first: int, last: int
) -> None:
    """Overwrite columns ``first:last`` of right sides with the solutions."""
    eliminate(D, exchanged, rows, B, first, last)
    solve_block(D, B, first, last)
    substitute(D, wide, B, rows, first, last)


def add_full(
    full: Matrix, at: int, rows: int, B: Matrix, first: int, last: int, needed: int
) -> None:
    """Correct columns, solutions of the band, for two full columns of the matrix.

    By the Sherman-Morrison-Woodbury formula: ``full[:, at:at + 2]`` are the solutions of the
    band for the full columns, which belong to the last two unknowns; the first `needed` rows
    are corrected.
    """
    i, j = PAD + rows - 2, PAD + rows - 1
    a, b, c, d = 1 - full[i, at], -full[i, at + 1], -full[j, at], 1 - full[j, at + 1]
    inverse = 1.0 / (a * d - b * c)
    for column in range(first, last):
        before, behind = B[i, column], B[j, column]
        upper, lower = (d * before - b * behind) * inverse, (a * behind - c * before) * inverse
        for low in range(PAD, PAD + needed):
            B[low, column] += upper * full[low, at] + lower * full[low, at + 1]
