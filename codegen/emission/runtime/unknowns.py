"""Families of unknowns whose index may run over their ends: there they are zero."""


def entry(z, start, count, index):
    """Return the unknown of an index, from those that stand at ``z[start:start + count]``."""
    return z[start + index] if 0 <= index < count else 0.0


def put(J, row, start, count, index, value):
    """Add a derivative by the unknown of an index, if there is one."""
    if 0 <= index < count:
        J[row, start + index] += value
