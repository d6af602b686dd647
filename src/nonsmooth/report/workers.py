"""Work on all cores by processes that do not outlive this one."""

import os
import signal
import threading
import time
import warnings
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context
from typing import Any

#: What calls a function with each of several arguments, and yields each with its result.
Run = Callable[[Callable[[Any], Any], Iterable[Any]], Iterator[tuple[Any, Any]]]


def one_by_one(work: Callable[[Any], Any], each: Iterable[Any]) -> Iterator[tuple[Any, Any]]:
    """Yield each argument with its result, computed in this process."""
    return ((argument, work(argument)) for argument in each)


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
    found = ProcessPoolExecutor(count, get_context("spawn"), _leave_with, (os.getpid(),))
    try:
        yield found
    finally:
        for process in (getattr(found, "_processes", None) or {}).values():
            process.terminate()
        found.shutdown(wait=True, cancel_futures=True)


@contextmanager
def processes() -> Iterator[Run]:
    """Yield what computes in processes, one a core: in order, a few results ahead."""
    count = os.cpu_count() or 1

    def run(work: Callable[[Any], Any], each: Iterable[Any]) -> Iterator[tuple[Any, Any]]:
        ahead: deque[tuple[Any, Future[Any]]] = deque()
        for argument in each:
            ahead.append((argument, found.submit(work, argument)))
            if len(ahead) > 2 * count:
                first, result = ahead.popleft()
                yield first, result.result()
        while ahead:
            first, result = ahead.popleft()
            yield first, result.result()

    with pool() as found:
        yield run
