"""Section 3.1 by the generic machine against the kernel that is made for it alone, N = 40.

Residual, Jacobian, and LAPACK's factorisation of each system: of the paper's equations, which
both have with 2 N + 3 unknowns, and of the halved system that is solved today.
"""

import statistics
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.linalg import lapack

from nonsmooth.solver.case import registry
from nonsmooth.solver.shortcuts.search import kernels

ORDER, ROUNDS = 40, 400

#: What the generic kernel may take of the time of the other.
AT_MOST = 2.0


def measure(order: int = ORDER) -> list[dict[str, object]]:
    """Return each target with the measured ratio."""
    scene = registry.load("stick-slip")
    case = scene()
    generic = registry.kernel(scene, "hb", compile_it=True)
    paper, halved = kernels.compiled("hb"), kernels.compiled("hb-symmetric")
    ways: dict[str, tuple[Any, Any, int]] = {
        "generic": (generic, case.numbers, generic.size(order)),
        "of the paper's system": (paper, 1.0, paper.size(order)),
        "halved": (halved, (1.0, 0), halved.size(order, 0)),
    }
    parts = {name: _parts(*way) for name, way in ways.items()}
    seen: dict[tuple[str, str], list[float]] = {}
    for _ in range(ROUNDS):
        for name, works in parts.items():
            for part, work in works.items():
                begin = time.perf_counter()
                work()
                seconds = time.perf_counter() - begin
                seen.setdefault((name, part), []).append(seconds)
    medians = {key: statistics.median(times) for key, times in seen.items()}
    rows: list[dict[str, object]] = []
    for name in ("of the paper's system", "halved"):
        for which in (("residual",), ("jacobian",), ("residual", "jacobian", "LU")):
            ratio = sum(medians["generic", part] for part in which)
            ratio /= sum(medians[name, part] for part in which)
            what = f"generic hb, N = {order}: {' + '.join(which)} over that {name}"
            rows.append({"target": what, "at_most": AT_MOST, "measured": ratio})
    return rows


def _parts(kernel: Any, case: Any, size: int) -> dict[str, Callable[[], object]]:
    z, R, J = np.linspace(0.5, 1.5, size), np.empty(size), np.empty((size, size))
    z[-2:] = 2.0, 6.7  # the times, or stick and period
    kernel.residual(case, z, R)
    kernel.jacobian(case, z, J)
    A = np.asfortranarray(J)
    return {
        "residual": lambda: kernel.residual(case, z, R),
        "jacobian": lambda: kernel.jacobian(case, z, J),
        "LU": lambda: lapack.dgetrf(A),
    }
