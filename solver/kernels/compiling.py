"""Functions rebuilt over another namespace: as plain Python, or compiled by numba.

Both give the same bits; `Account` says which is to be used.

The cache is a convenience.  If it cannot be read or written (disk full, file damaged), or
others could have written to it, kernels are compiled for this process only, and a
`CacheWarning` says so.
"""

import types
import warnings
from pathlib import Path
from typing import Any

from ..scenes.sealed import NotPrivate

#: Most bytes of bytecode of a function without arrays of its own that is inlined: passing a
#: dozen arrays takes as long as its body.
SHORT = 1200


def rebuilt(function: Any, namespace: dict[str, Any], counted: bool = True) -> Any:
    """Return the same function over another namespace, which has its global names."""
    clone = types.FunctionType(function.__code__, namespace, function.__name__)
    clone.__module__ = function.__module__
    return clone


class CacheWarning(UserWarning):
    """Compiled kernels are not cached for the next process."""


def inner(function: types.FunctionType, *, counted: bool = True) -> Any:
    """Return `function` compiled for calls from compiled functions; Python cannot call it.

    Parameters
    ----------
    counted : bool
        Whether numba counts references to arrays.  Functions that allocate none do not need it,
        and each count takes as long as ten operations.  numba refuses to compile a function
        without counts that allocates an array.
    """
    import numba  # noqa: PLC0415  (750 ms, for compiled kernels only)

    from .inner import Inner  # noqa: PLC0415  (see above)

    options: dict[str, Any] = {
        "error_model": "numpy",
        "_nrt": counted,
        "forceinline": not counted and len(function.__code__.co_code) <= SHORT,
    }
    return numba.njit(pipeline_class=Inner, **options)(function)


def jit(function: types.FunctionType, **options: Any) -> Any:
    """Return `function` compiled, with numba's cache if it can be used."""
    import numba  # noqa: PLC0415  (see `inner`)

    text = Path(function.__code__.co_filename)
    try:
        return _cached(function, text.parent, options)
    except NotPrivate as refusal:
        _warn_once(refusal.filename, str(refusal.strerror))
    except RuntimeError:  # numba found no folder that it can write to
        if text.exists():  # a function that is not from a file has no cache anyway
            folder = text.parent / "__pycache__"
            _warn_once(str(folder), "not writable, and no other folder is")
    return numba.jit(**options)(function)


class Entries(dict[str, Any]):
    """`inner` functions by their names; each is compiled for Python at its first use.

    Anything else (a constant, or a function if numba is disabled) is itself.
    """

    def __init__(self, of: dict[str, Any]) -> None:
        super().__init__()
        self._of = of

    def __missing__(self, name: str) -> Any:
        """Return what has a name, a function compiled for Python, and cached if possible."""
        found = self._of[name]
        options = getattr(found, "targetoptions", None)
        self[name] = found if options is None else jit(found.py_func, **options)
        return self[name]


def _cached(function: types.FunctionType, source: Path, options: dict[str, Any]) -> Any:
    """Return a function of the folder `source` compiled, with numba's cache.

    Raises
    ------
    NotPrivate
        If others may write to the cache.
    RuntimeError
        If there is no folder for it.
    """
    import numba  # noqa: PLC0415  (see `inner`)

    from .numba_cache import check_cache, guard, owned  # noqa: PLC0415

    with owned():
        compiled = numba.jit(cache=True, **options)(function)
    check_cache(compiled._cache, source)
    guard(compiled._cache, f"{function.__module__}.{function.__qualname__}", _warn_once)
    return compiled


#: The warning that was given in this process: one is enough.
_SAID: list[str] = []


def _warn_once(folder: str, cause: str) -> None:
    """Warn, once in a process, that compiled kernels are not cached."""
    message = f"numba's cache: {folder}: {cause}; kernels are compiled for this process alone"
    if not _SAID:
        _SAID.append(message)
        warnings.warn(message, CacheWarning, stacklevel=3)
