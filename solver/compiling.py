"""Functions of generated modules over other names: as plain Python, or compiled by numba.

Which of the two is quicker depends on how often a kernel is used, and nobody says that
beforehand.  So a kernel begins in plain Python, and is compiled, or loaded from numba's cache,
once it has cost about as long as that takes: what is spent in all is then at most about twice
what knowing would have cost.  Both give the same bits.
"""

import os
import sys
import time
import types
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

#: Up to this order a kernel begins as plain Python; beyond, one solve takes as long as loading.
PLAIN_ORDER = 48

#: Seconds that numba and a kernel from its cache take, a further kernel, and one that is to be
#: compiled.
START, LOAD, COMPILE = 0.5, 0.05, 8.0


class Account:
    """What a kernel has cost in plain Python in this process, and whether compiling it pays.

    Parameters
    ----------
    file : str
        That of the function by which the kernel is found in numba's cache.
    name : str
        Of that function, with its fingerprint.
    """

    #: What all kernels have cost.
    total = 0.0

    def __init__(self, file: str, name: str) -> None:
        self.seconds = 0.0
        self.is_compiled = False
        self._file, self._name = file, name
        self._cached: bool | None = None

    @contextmanager
    def spending(self) -> Iterator[None]:
        """Count the time within."""
        begin = time.perf_counter()
        try:
            yield
        finally:
            spent = time.perf_counter() - begin
            self.seconds += spent
            Account.total += spent

    def pays(self) -> bool:
        """Return whether the next use is better by the compiled kernel."""
        if self.is_compiled:
            return True
        if self.seconds < LOAD or Account.total < LOAD:
            return False
        if not self.is_cached():
            return self.seconds >= COMPILE
        return "numba" in sys.modules or Account.total >= START

    def is_cached(self) -> bool:
        """Return whether the compiled kernel is in numba's cache, as far as can be seen."""
        if self._cached is None:
            folder, pattern = os.environ.get("NUMBA_CACHE_DIR"), f"*.{self._name}-*.nbi"
            beside = (Path(self._file).parent / "__pycache__").glob(pattern)
            self._cached = any(Path(folder).rglob(pattern) if folder else beside)
        return self._cached


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
