"""Work on all cores by processes that do not outlive this one."""

import os
import signal
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from multiprocessing import get_context
from typing import TypeVar

from .problems import print_warnings

Argument = TypeVar("Argument")
Result = TypeVar("Result")


def _leave_with(parent: int) -> None:
    """Leave Ctrl-C to the parent process, and end when it has ended, however it did."""
    print_warnings()
    signal.signal(signal.SIGINT, signal.SIG_IGN)

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(0.5)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def in_order(
    work: Callable[[Argument], Result], arguments: Iterable[Argument]
) -> Iterator[tuple[Argument, Result]]:
    """Yield each argument with its result, in order; a few are computed ahead.

    Processes are spawned, not forked: a fork after a parallel kernel can hang.
    """
    count = os.cpu_count() or 1
    pool = ProcessPoolExecutor(count, get_context("spawn"), _leave_with, (os.getpid(),))
    ahead: deque[tuple[Argument, Future[Result]]] = deque()
    try:
        for argument in arguments:
            ahead.append((argument, pool.submit(work, argument)))
            if len(ahead) > 2 * count:
                first, result = ahead.popleft()
                yield first, result.result()
        while ahead:
            first, result = ahead.popleft()
            yield first, result.result()
    finally:
        for process in (getattr(pool, "_processes", None) or {}).values():
            process.terminate()
        pool.shutdown(wait=True, cancel_futures=True)
