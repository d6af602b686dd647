"""Whether compiling a kernel pays, by the time that it has taken in plain Python.

Which of the two is quicker depends on how often a kernel is used, which is not known in
advance.  So a kernel begins in plain Python, and is compiled, or loaded from numba's cache,
once it has taken about as long as that takes, in this process and those before.  The total is
then at most about twice that of the better choice.
"""

import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import cached_property
from pathlib import Path

from .numba_cache import owned

#: Up to this order, and this number of phases, a kernel begins as plain Python; beyond, one
#: solve takes as long as loading.
PLAIN_ORDER, PLAIN_PHASES = 48, 12

#: Seconds to load numba and a first kernel from its cache, to load a further one, and to
#: compile most kernels.
START, LOAD, COMPILE = 0.5, 0.05, 8.0


class Account:
    """The time a kernel has taken in plain Python; whether compiling it pays.

    Parameters
    ----------
    file, name : str
        File and name, with a fingerprint, of the function that is looked for in numba's cache.
    compiling : float
        Seconds that compiling the kernel takes.
    """

    #: Seconds that all kernels have taken in this process.
    total = 0.0

    def __init__(self, file: str, name: str, compiling: float = COMPILE) -> None:
        self.seconds, self._compiling = 0.0, compiling
        self.is_compiled = False
        self._file, self._name = file, name
        self._cached, self._looked = False, -1.0
        self._kept = 0.0

    @contextmanager
    def spending(self) -> Iterator[None]:
        """Count the processor time of a ``with`` block, which does not depend on other load."""
        begin = time.thread_time()
        try:
            yield
        finally:
            spent = time.thread_time() - begin
            self.seconds += spent
            Account.total += spent
            self._keep()

    def pays(self) -> bool:
        """Return whether the next use should be by the compiled kernel."""
        if self.is_compiled:
            return True
        if self.seconds < LOAD * self._compiling / COMPILE or Account.total < LOAD:
            return False
        if not self.is_cached():
            enough = self.seconds + self.before >= self._compiling
            if enough:  # where compiled kernels cannot be kept, the next process begins anew
                self._forget()
            return enough
        return "numba" in sys.modules or Account.total >= START

    def is_cached(self) -> bool:
        """Return whether numba's cache seems to have the compiled kernel, by names of files.

        As another process may have compiled it, the cache is looked at again when the time
        spent has doubled.
        """
        if not self._cached and self.seconds > 2 * self._looked:
            folder, pattern = os.environ.get("NUMBA_CACHE_DIR"), f"*.{self._name}-*.nbc"
            files = (Path(self._file).parent / "__pycache__").glob(pattern)
            self._cached = any(Path(folder).rglob(pattern) if folder else files)
            self._looked = self.seconds
        return self._cached

    @cached_property
    def before(self) -> float:
        """Seconds that the kernel has taken in earlier processes, as far as they kept them."""
        kept = 0.0
        with suppress(OSError, ValueError):
            kept = float(self._file_of_seconds.read_text())
        return kept if kept > 0 else 0.0

    def _keep(self) -> None:
        """Keep the seconds beside numba's cache, if that can be, whenever they have doubled."""
        if self.seconds < max(LOAD, 2 * self._kept):
            return
        self._kept = self.seconds
        with suppress(OSError), owned():
            self._file_of_seconds.parent.mkdir(parents=True, exist_ok=True)
            self._file_of_seconds.write_text(repr(self.before + self.seconds))

    def _forget(self) -> None:
        """Keep no seconds for later processes."""
        with suppress(OSError):
            self._file_of_seconds.unlink()

    @property
    def _file_of_seconds(self) -> Path:
        file = Path(self._file)
        folder = os.environ.get("NUMBA_CACHE_DIR", file.parent / "__pycache__")
        return Path(folder) / f"{file.stem}.{self._name}.spent"
