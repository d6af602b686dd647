"""Functions of generated modules over other names: as plain Python, or compiled by numba."""

import types
from typing import Any

#: Up to this order one orbit in plain Python is quicker than starting numba.
PLAIN_ORDER = 48


def rebuilt(function: Any, namespace: dict[str, Any]) -> Any:
    """Return the same function over another namespace, where it finds what it calls."""
    clone = types.FunctionType(function.__code__, namespace, function.__name__)
    clone.__module__ = function.__module__
    return clone


def jit(function: types.FunctionType) -> Any:
    """Return `function` compiled; uncached where no folder for the cache is writable."""
    import numba  # noqa: PLC0415  (750 ms, for compiled kernels only)

    options: dict[str, Any] = {
        "error_model": "numpy",
        "parallel": "prange" in function.__code__.co_names,
    }
    try:
        return numba.njit(cache=True, **options)(function)
    except RuntimeError:
        return numba.njit(**options)(function)
