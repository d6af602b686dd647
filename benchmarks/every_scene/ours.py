"""Our methods: compiled kernels from rough times, and the exact flow from Python."""

from functools import cache

import numba
import numpy as np

from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.solve import COARSE, number_of_functions

from .problem import Problem

LIMIT = 40

#: Functions beside the harmonics at each switch.
FUNCTIONS = 2


@cache
def newton(scene, method):
    """Return Newton's method from rough times: ``solve(case, order, times)``, compiled.

    The coefficients that fit the times best, by normal equations, then the iteration of the
    solver.  All but ck-tau start from the times of ck-tau at a low order, as `solve_case` does.

    Parameters
    ----------
    scene : LoadedScene
        Of one motion.
    method : str
    """
    counts = number_of_functions(scene(), method, None) is not None
    own = registry.kernel(scene, method, FUNCTIONS if counts else None, compile_it=True)
    if own.condensed:
        return _from_times(own)
    residual, jacobian, iterate, size = own.residual, own.jacobian, own.iterate, own.size
    names = getattr(iterate, "py_func", iterate).__globals__  # plain where numba is disabled
    factorise, solve_factorised = names["factorise"], names["solve_factorised"]
    many, coarse = own.durations + own.forced, method != "ck-tau"
    before, low = newton(scene, "ck-tau") if coarse else as_given, COARSE[0]

    @numba.njit(error_model="numpy")
    def solve(case, order, times):
        times = before(case, low, times)
        n = size(order)
        count = n - many
        z, R, J = np.zeros(n), np.empty(n), np.empty((n, n))
        z[count:] = times
        residual(case, z, R)
        jacobian(case, z, J)
        A = np.ascontiguousarray(J[:, :count])
        for i in range(n):
            scale = np.max(np.abs(A[i]))
            if scale > 0:
                A[i] /= scale
                R[i] /= scale
        best, rows = A.T @ A, np.empty(count, dtype=np.int64)
        z[:count] = -(A.T @ R)
        factorise(best, rows)
        solve_factorised(best, rows, z[:count])
        if iterate(case, z, LIMIT)[0] != 0:
            z[:] = np.nan
        return z[count:].copy()

    return solve


def _from_times(kernel):
    """Return the iteration of a kernel that starts from times alone."""
    iterate, size = kernel.iterate, kernel.size

    @numba.njit(error_model="numpy")
    def solve(case, order, times):
        z = np.zeros(size(order))
        z[len(z) - len(times) :] = times
        if iterate(case, z, LIMIT)[0] != 0:
            z[:] = np.nan
        return z[len(z) - len(times) :].copy()

    return solve


@numba.njit
def as_given(case, order, times):
    """Return the times as they are."""
    return times


def exact_flow(which: Problem):
    """Return ``solve(_)`` by the solver's exact orbit: Python, and checked."""
    case, rough, unit = which.case, which.rough, which.case.units.time
    count = len(case.cell.phases)
    angle = float(rough[-1]) if case.cell.forced else 0.0

    def solve(_: int) -> np.ndarray:
        found = exact_orbit(case, rough[:count] * unit, angle)
        return np.array([*found.cell_durations, *([found.angle] if case.cell.forced else [])])

    return solve
