"""Functions of generated modules over other names: as plain Python, or compiled by numba.

Which of the two is quicker depends on how often a kernel is used, and nobody says that
beforehand.  So a kernel begins in plain Python, and is compiled, or loaded from numba's cache,
once it has cost about as long as that takes: what is spent in all is then at most about twice
what knowing would have cost.  Both give the same bits.

The cache is a convenience: where it cannot be read or written, because a disk is full or
damaged, or others could have written to it, kernels are compiled all the same, for this
process, and a `CacheWarning` says so.
"""

import os
import sys
import time
import types
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ..scenes.sealed import NotPrivate

#: Up to this order a kernel begins as plain Python; beyond, one solve takes as long as loading.
PLAIN_ORDER = 48

#: Seconds that numba and a kernel from its cache take, a further kernel, and most that are to
#: be compiled.
START, LOAD, COMPILE = 0.5, 0.05, 8.0


#: Bytes of bytecode of a function without arrays of its own that is copied into its callers:
#: to hand over a dozen arrays takes as long as what such a function does with them.
SHORT = 1200


class Account:
    """What a kernel has cost in plain Python in this process, and whether compiling it pays.

    It is found in numba's cache by the file and the name of a function, with its fingerprint;
    compiling it takes so many seconds.
    """

    #: What all kernels have cost.
    total = 0.0

    def __init__(self, file: str, name: str, compiling: float = COMPILE) -> None:
        self.seconds, self._compiling = 0.0, compiling
        self.is_compiled = False
        self._file, self._name = file, name
        self._cached: bool | None = None

    @contextmanager
    def spending(self) -> Iterator[None]:
        """Count the time of the processor within: how busy the machine is does not matter."""
        begin = time.thread_time()
        try:
            yield
        finally:
            spent = time.thread_time() - begin
            self.seconds += spent
            Account.total += spent

    def pays(self) -> bool:
        """Return whether the next use is better by the compiled kernel."""
        if self.is_compiled:
            return True
        if self.seconds < LOAD * self._compiling / COMPILE or Account.total < LOAD:
            return False
        if not self.is_cached():
            return self.seconds >= self._compiling
        return "numba" in sys.modules or Account.total >= START

    def is_cached(self) -> bool:
        """Return whether the compiled kernel is in numba's cache, as far as can be seen."""
        if self._cached is None:
            folder, pattern = os.environ.get("NUMBA_CACHE_DIR"), f"*.{self._name}-*.nbc"
            beside = (Path(self._file).parent / "__pycache__").glob(pattern)
            self._cached = any(Path(folder).rglob(pattern) if folder else beside)
        return self._cached


def rebuilt(function: Any, namespace: dict[str, Any], counted: bool = True) -> Any:
    """Return the same function over another namespace, where it finds what it calls."""
    clone = types.FunctionType(function.__code__, namespace, function.__name__)
    clone.__module__ = function.__module__
    return clone


class CacheWarning(UserWarning):
    """What is compiled is not kept for the next process."""


def inner(function: types.FunctionType, *, counted: bool = True) -> Any:
    """Return `function` compiled for others that are compiled, which Python cannot call.

    Parameters
    ----------
    counted : bool
        Whether numba counts who holds its arrays.  What makes none need not, and each count
        takes as long as some ten operations; numba refuses to compile it if it does make one.
    """
    import numba  # noqa: PLC0415  (750 ms, for compiled kernels only)

    from .inner import Inner  # noqa: PLC0415  (see above)

    options: dict[str, Any] = {
        "error_model": "numpy",
        "_nrt": counted,
        "forceinline": not counted and len(function.__code__.co_code) <= SHORT,
    }
    return numba.njit(pipeline_class=Inner, **options)(function)


def entry(compiled: Any) -> Any:
    """Return an `inner` function for Python to call, kept in numba's cache if possible.

    What is none, a constant or a function where numba is disabled, is returned as it is.
    """
    options = getattr(compiled, "targetoptions", None)
    return compiled if options is None else jit(compiled.py_func, **options)


def jit(function: types.FunctionType, **options: Any) -> Any:
    """Return `function` compiled, and kept in numba's cache where that can be written."""
    import numba  # noqa: PLC0415  (see `inner`)

    text = Path(function.__code__.co_filename)
    try:
        return _cached(function, text.parent, options)
    except NotPrivate as refusal:
        _warn_once(refusal.filename, str(refusal.strerror))
    except RuntimeError:  # numba found no folder that it can write to
        if text.exists():  # what is not from a file has no cache anywhere
            folder = text.parent / "__pycache__"
            _warn_once(str(folder), "not writable, and no other folder is")
    return numba.jit(**options)(function)


class Entries(dict[str, Any]):
    """Compiled functions by their names, each made for Python when it is asked for."""

    def __init__(self, of: dict[str, Any]) -> None:
        super().__init__()
        self._of = of

    def __missing__(self, name: str) -> Any:
        """Return the function of a name."""
        found = self[name] = entry(self._of[name])
        return found


def _cached(function: types.FunctionType, source: Path, options: dict[str, Any]) -> Any:
    """Return a function of the folder `source` compiled, with numba's cache.

    `NotPrivate` is raised if others may write to it, a RuntimeError if there is no folder.
    """
    import numba  # noqa: PLC0415  (see `inner`)

    from .numba_cache import check_cache, guard, owned  # noqa: PLC0415

    with owned():
        found = numba.jit(cache=True, **options)(function)
    check_cache(found._cache, source)
    guard(found._cache, f"{function.__module__}.{function.__qualname__}", _warn_once)
    return found


#: What was said of the cache in this process: one line is enough.
_SAID: list[str] = []


def _warn_once(folder: str, cause: str) -> None:
    """Warn that what is compiled is not kept."""
    words = f"numba's cache: {folder}: {cause}; kernels are compiled for this process alone"
    if not _SAID:
        _SAID.append(words)
        warnings.warn(words, CacheWarning, stacklevel=3)
