"""Latency: CPU or wall time of whole processes, medians."""

import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time

ROUNDS = 5


def _cpu(*arguments: str) -> float:
    """Return the CPU seconds of one process, children and threads included."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(arguments, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def _wall(cache: str | None, *arguments: str) -> float:
    environment = os.environ | ({"NUMBA_CACHE_DIR": cache} if cache else {})
    begin = time.perf_counter()
    subprocess.run(arguments, check=True, capture_output=True, env=environment)
    return time.perf_counter() - begin


def measure() -> list[dict[str, object]]:
    """Return each target with the measured seconds."""
    python, command = sys.executable, (sys.executable, "-m", "nonsmooth")
    rows: list[dict[str, object]] = []

    def add(target: str, at_most: float, seconds: list[float]) -> None:
        measured = statistics.median(seconds)
        rows.append({"target": target, "at_most": at_most, "measured": measured})

    _wall(None, *command, "sweep", "--orders", "60")  # fills the cache
    bare = statistics.median(_cpu(python, "-c", "pass") for _ in range(ROUNDS))
    helped = [_cpu(*command, "--help") - bare for _ in range(ROUNDS)]
    add("nonsmooth --help: CPU s above a bare interpreter", 0.15, helped)
    for method in ("hb", "hb-c1", "c1"):
        solve = (*command, "solve", "--method", method, "--order", "40")
        seconds = [_wall(None, *solve) for _ in range(ROUNDS)]
        add(f"nonsmooth solve, {method}, N = 40: s", 0.6, seconds)
    sweep = (*command, "sweep")
    add("nonsmooth sweep, 120 rows, warm: s", 3.0, [_wall(None, *sweep) for _ in range(3)])
    with tempfile.TemporaryDirectory() as cache:
        add("nonsmooth sweep, 120 rows, no cache: s", 10.0, [_wall(cache, *sweep)])
    add("nonsmooth generate --check: s", 30.0, [_wall(None, *command, "generate", "--check")])
    return rows
