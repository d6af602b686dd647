"""Integrals of one pole after the other: what stands for functions of `integrals` compiled.

There kappa is one number, and what is found of it one column.
"""

from typing import Any

from ...arrays import Complex


def apart(kappa: Complex, limit: int) -> Any:
    """Return the poles that are computed together: each by itself."""
    return range(len(kappa))


def largest(k: Any) -> float:
    """Return the modulus of one kappa."""
    return float(abs(k))


def room(factors: Complex, which: Any) -> Complex:
    """Return the room for the factors of one pole."""
    found: Complex = factors[:, :, which]
    return found
