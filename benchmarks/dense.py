"""Sections 3.1 and 3.2, dense: a whole solve against its own LU factorisations by LAPACK.

Start with `make bench`, which gives LAPACK one thread.
"""

import statistics
import time
from collections.abc import Callable

import numpy as np
from scipy.linalg import lapack

from nonsmooth.solver.shortcuts.search import kernels
from nonsmooth.solver.shortcuts.search.newton import newton
from nonsmooth.solver.shortcuts.search.start import cubic_slip, rough_times

ROUNDS, ORDER = 300, 40

#: What a solve may cost, in its own factorisations, and filling in one factorisation.
SOLVE, FILL = 2.0, 1.0


def _median(work: Callable[[], object]) -> float:
    seen = []
    for _ in range(ROUNDS):
        begin = time.perf_counter()
        work()
        seen.append(time.perf_counter() - begin)
    return statistics.median(seen)


def measure(order: int = ORDER) -> list[dict[str, object]]:
    """Return each target with the measured ratio."""
    kernel = kernels.compiled("hb-symmetric")
    rows: list[dict[str, object]] = []
    for name, terms in (("hb", 0), ("hb-c1", 1)):
        case = (1.0, terms)
        times = rough_times(case[0])
        start = cubic_slip(kernel, terms, order, *times)
        orbit = newton(kernel.iterate, case, start)
        size = len(start)
        R, J, factors = np.empty(size), np.empty((size, size)), np.empty((size, size))
        kernel.jacobian(case, orbit.unknowns, J)
        full = kernels.compiled(name)
        whole = np.empty((full.size(order), full.size(order)), order="F")
        full.jacobian(case[0], np.linspace(1, 2, len(whole)), whole)
        # LAPACK factorises in place: a copy each, whose own time is taken off.
        J = np.asfortranarray(J)

        def solve(case=case, terms=terms, times=times) -> None:
            z = cubic_slip(kernel, terms, order, *times)
            kernel.iterate(case, z, 40)

        lu = _median(lambda J=J: lapack.dgetrf(J)) - _median(lambda J=J: J.copy("F"))
        lu_full = _median(lambda A=whole: lapack.dgetrf(A)) - _median(
            lambda A=whole: A.copy("F")
        )
        seconds = _median(solve)
        fill = _median(lambda c=case, z=orbit.unknowns, R=R: kernel.residual(c, z, R))
        fill += _median(lambda c=case, z=orbit.unknowns, A=factors: kernel.jacobian(c, z, A))
        count = orbit.iterations
        label = f"{name}, N = {order}"
        rows += [
            _row(f"{label}: solve over its {count} LU, halved", SOLVE, seconds / (count * lu)),
            _row(f"{label}: filling over LU, halved", FILL, fill / lu),
            _row(f"{label}: solve over {count} LU, whole", SOLVE, seconds / (count * lu_full)),
            _row(f"{label}: filling over LU, whole", FILL, fill / lu_full),
        ]
    return rows


def _row(target: str, at_most: float, measured: float) -> dict[str, object]:
    return {"target": target, "at_most": at_most, "measured": measured}
