"""Sections 3.1 and 3.2 with very many harmonics: growth, time, memory, agreement."""

import json
import math
import subprocess
import sys

import numpy as np

from nonsmooth.solver.shortcuts.search import kernels
from nonsmooth.solver.shortcuts.search.newton import newton
from nonsmooth.solver.shortcuts.search.start import cubic_slip, rough_times
from nonsmooth.solver.shortcuts.series import newton_krylov
from nonsmooth.solver.shortcuts.series.matrix_free import Problem

#: Largest exponent of growth between 1e4 and 1e6 harmonics, seconds and MiB at 1e6 (hb), and
#: relative difference from the dense solver.
GROWTH, SECONDS, MEMORY, AGREEMENT = 1.15, 10.0, 2048.0, 1e-12

#: One whole `solve` in a process of its own: its seconds, warm, and the peak of its memory.
SCRIPT = """
import json, resource, statistics, sys, time
import nonsmooth as ns
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
method, order, rounds = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
ns.solve(DEFAULT, method, 1000)
seen = []
for _ in range(rounds):
    begin = time.perf_counter()
    orbit = ns.solve(DEFAULT, method, order)
    seen.append(time.perf_counter() - begin)
peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
try:  # Linux counts in what was before the program began; this does not
    (line,) = (line for line in open("/proc/self/status") if line.startswith("VmHWM"))
    peak = int(line.split()[1]) / 1024
except (OSError, ValueError):
    pass
print(json.dumps([statistics.median(seen), peak, orbit.errors.period]))
"""


def _solve(method: str, order: int, rounds: int) -> tuple[float, float, float]:
    command = [sys.executable, "-c", SCRIPT, method, str(order), str(rounds)]
    seconds, peak, error = json.loads(
        subprocess.run(command, check=True, capture_output=True, text=True).stdout
    )
    return seconds, peak, error


def difference(terms: int, order: int = 1000, alpha: float = 1.0) -> float:
    """Return how far the times of the matrix-free solver are from those of the dense one."""
    kernel = kernels.compiled("hb-symmetric")
    start = cubic_slip(kernel, terms, order, *rough_times(alpha))
    dense = newton(kernel.iterate, (alpha, terms), start).unknowns[-2:]
    problem = Problem(kernel, alpha, terms, order)
    return float(np.max(np.abs(newton_krylov.solve(problem, start).unknowns[-2:] / dense - 1)))


def measure() -> tuple[list[dict[str, object]], list[dict[str, object]]]:
    """Return each target with what was measured, and the solves themselves."""
    rows: list[dict[str, object]] = []
    solves: list[dict[str, object]] = []
    for terms, method in enumerate(("hb", "hb-c1")):
        seconds = {}
        for order, rounds in ((10**4, 15), (10**5, 5), (10**6, 3)):
            seconds[order], peak, error = _solve(method, order, rounds)
            solves.append(
                {
                    "method": method,
                    "order": order,
                    "seconds": seconds[order],
                    "peak_MiB": peak,
                    "period_error": error,
                }
            )
        growth = math.log(seconds[10**6] / seconds[10**4]) / math.log(100)
        rows.append(_row(f"{method}: exponent of time, N = 1e4 to 1e6", GROWTH, growth))
        if method == "hb":
            rows.append(_row("hb, N = 1e6: seconds", SECONDS, seconds[10**6]))
            rows.append(_row("hb, N = 1e6: MiB", MEMORY, peak))
        what = f"{method}, N = 1000: matrix-free against dense"
        rows.append(_row(what, AGREEMENT, difference(terms)))
    return rows, solves


def _row(target: str, at_most: float, measured: float) -> dict[str, object]:
    return {"target": target, "at_most": at_most, "measured": measured}
