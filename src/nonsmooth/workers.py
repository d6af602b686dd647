"""Work on all cores by processes that do not outlive this one."""

import os
import signal
import threading
import time
import warnings
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context


def _leave_with(parent: int) -> None:
    """Leave Ctrl-C and warnings to the parent process, and end with it, however it ends."""
    warnings.simplefilter("ignore")
    signal.signal(signal.SIGINT, signal.SIG_IGN)

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(0.5)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


@contextmanager
def pool() -> Iterator[ProcessPoolExecutor]:
    """Yield processes, one a core, that are gone behind it.

    They are spawned, not forked: a fork after a parallel kernel can hang.
    """
    count = os.cpu_count() or 1
    executor = ProcessPoolExecutor(count, get_context("spawn"), _leave_with, (os.getpid(),))
    try:
        yield executor
    finally:
        for process in (getattr(executor, "_processes", None) or {}).values():
            process.terminate()
        executor.shutdown(wait=True, cancel_futures=True)
