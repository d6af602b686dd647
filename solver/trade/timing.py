"""How long work takes on this machine."""

import statistics
import time
from collections.abc import Callable

#: Seconds and rounds that are spent on measuring one piece of work.
MEASURED, MOST_ROUNDS = 0.01, 25


def median_seconds(work: Callable[[], object]) -> float:
    """Return the median time of `work`, after one run that fills the caches."""
    work()
    seen: list[float] = []
    while len(seen) < MOST_ROUNDS and sum(seen) < MEASURED:
        begin = time.perf_counter()
        work()
        seen.append(time.perf_counter() - begin)
    return statistics.median(seen)
