"""Functions that replace those of the same names in `integrals` when compiled.

Each pole is computed by itself: kappa is a number, its results one column.
"""

from typing import Any

from ...arrays import Complex


def apart(kappa: Complex, limit: int) -> Any:
    """Return the index of each pole."""
    return range(len(kappa))


def largest(k: Any) -> float:
    """Return ``|kappa|``."""
    return float(abs(k))


def room(factors: Complex, which: Any) -> Complex:
    """Return a view of the factors of one pole."""
    view: Complex = factors[:, :, which]
    return view
