"""What an iteration of ck-tau is made of, beside the RK4 return map: the floor of its time.

    python -m benchmarks.scene_floor

Nanoseconds of one residual, one Jacobian, its LU factors, and one solution, and of three of
each: what Newton's method from rough times cannot do without.  The least of many repetitions.
"""

import time

import numba
import numpy as np

from nonsmooth.solver.case import registry

from . import scene_ours, scene_rivals
from . import scene_references as references

COUNT, REPETITIONS, STEPS = 300, 500, 3

#: Scene: order of ck-tau that is 1e-6 off or less, the map, and its steps for that.
CASES = {
    "impact": (7, scene_rivals.impact_rk4_map, 32),
    "stick-slip-damped": (6, scene_rivals.belt_rk4, 64),
}


@numba.njit
def _copied(J, A):
    A[:] = J


def _nanoseconds(function, *arguments) -> float:
    """Return the time of one call from compiled code."""

    @numba.njit
    def loop(count, arguments):
        for _ in range(count):
            function(*arguments)

    loop(1, arguments)
    times = []
    for _ in range(REPETITIONS):
        begin = time.perf_counter()
        loop(COUNT, arguments)
        times.append(time.perf_counter() - begin)
    return min(times) / COUNT * 1e9


def parts(scene: str) -> dict[str, float]:
    """Return nanoseconds by what is done."""
    order, rk4, steps = CASES[scene]
    case, rough = registry.load(scene)(), references.rough(scene)
    kernel = scene_ours.kernel(scene, "ck-tau")
    names = kernel.iterate.py_func.__globals__  # type: ignore[attr-defined]
    factorise, solve_factorised = names["factorise"], names["solve_factorised"]
    n = kernel.size(order)
    z, R, J, A = np.linspace(0.5, 1.5, n), np.empty(n), np.empty((n, n)), np.empty((n, n))
    rows = np.empty(n, dtype=np.int64)
    kernel.jacobian(case.arguments, z, J)

    @numba.njit
    def factors(J, A, rows):
        A[:] = J
        factorise(A, rows)

    @numba.njit
    def solution(A, rows, b):
        b[:] = 1.0
        solve_factorised(A, rows, b)

    found = {
        "residual": _nanoseconds(kernel.residual, case.arguments, z, R),
        "Jacobian": _nanoseconds(kernel.jacobian, case.arguments, z, J),
        "LU": _nanoseconds(factors, J, A, rows) - _nanoseconds(_copied, J, A),
        "solution": _nanoseconds(solution, A, rows, R),
    }
    found[f"{STEPS} of each"] = STEPS * sum(found.values())
    values, total = tuple(case.values.values()), np.zeros(1)

    @numba.njit
    def mapped(values, rough, total):
        total[0] += rk4(values, steps, rough[0], rough[1] + 1e-15 * total[0])[1]

    found["RK4"] = _nanoseconds(mapped, values, rough, total)
    return found


def main() -> None:
    """Measure and print."""
    for scene in CASES:
        found = parts(scene)
        print(scene, ", ".join(f"{what} {value:.0f}" for what, value in found.items()))


if __name__ == "__main__":
    main()
