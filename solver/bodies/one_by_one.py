"""Integrals of one pole after the other: what stands for functions of `integrals` compiled.

There kappa is one number, and what is found of it one column.
"""

from typing import Any

import numpy as np

from ...generated.force_series import response_0, same_response
from ..arrays import Complex


def apart(kappa: Complex, limit: int) -> Any:
    """Return the poles that are computed together: each by itself."""
    return range(len(kappa))


def largest(k: Any) -> float:
    """Return the modulus of one kappa."""
    return float(abs(k))


def room(count: int, k: Any) -> Complex:
    """Return room for so many numbers of one kappa."""
    return np.empty(count, np.complex128)


def products(k: Any, a: Complex, b: Complex, steps: Complex) -> Any:
    """Return ``Z_mn``, shape ``(rows, columns)``; see `integrals.products`."""
    rows, columns = len(a) - 1, len(b)
    found = np.empty((rows, columns), np.complex128)
    found[0, 0] = response_0(a[0], steps[1] * a[1])
    for n in range(columns):
        if n > 0:
            found[n, n] = same_response(n, k, a[n] * b[n - 1], a[n + 1] * b[n])
        factor, sign = b[n], -1.0
        for m in range(n + 1, rows):
            if m > n + 1:
                factor *= steps[m]
            found[m, n] = a[m] * factor
            if m < columns:
                found[n, m] = sign * found[m, n]
            sign = -sign
    return found
