"""Derivatives of conditions that reach the unknowns of a phase through what determines them."""

#: Stands for that of the kernel.
KEPT = 1


def follow(J, row, slopes, p, i, value):
    """Add to a row of J a coefficient times the derivatives of an unknown, slopes[p, i]."""
    for column in range(KEPT):
        J[row, column] += value * slopes[p, i, column]
