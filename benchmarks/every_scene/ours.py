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
    """Return Newton's method from rough times: ``solve(taken, sizes, times)``, compiled.

    The coefficients that fit the times best, by normal equations, then the iteration of the
    solver.  All but ck-tau start from the times of ck-tau at a low order, as `solve_case` does.
    What they take for a case at an order, and how many unknowns there are: `taken`.

    Parameters
    ----------
    scene : LoadedScene
        Of one motion.
    method : str
    """
    own = _kernel(scene, method)
    if own.condensed:
        return _from_times(own)
    residual, jacobian, iterate = own.residual, own.jacobian, own.iterate
    names = getattr(iterate, "py_func", iterate).__globals__  # plain where numba is disabled
    factorise, solve_factorised = names["factorise"], names["solve_factorised"]
    many, coarse = own.durations + own.forced, method != "ck-tau"
    before = newton(scene, "ck-tau") if coarse else as_given

    @numba.njit(error_model="numpy")
    def solve(taken, sizes, times):
        times = before(taken[:1], sizes[:1], times)
        case, n = taken[1], sizes[1]
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
    iterate = kernel.iterate

    @numba.njit(error_model="numpy")
    def solve(taken, sizes, times):
        z = np.zeros(sizes[0])
        z[len(z) - len(times) :] = times
        if iterate(taken[0], z, LIMIT)[0] != 0:
            z[:] = np.nan
        return z[len(z) - len(times) :].copy()

    return solve


def taken(case, method, order):
    """Return what `newton` takes for a case at an order, and how many unknowns there are.

    Of methods that start from another's times, those of that one come first.
    """
    orders = {method: order} if method == "ck-tau" else {"ck-tau": COARSE[0], method: order}
    kernels = [(_kernel(case.scene, name), n) for name, n in orders.items()]
    return tuple(k.given(case, n) for k, n in kernels), tuple(k.size(n) for k, n in kernels)


def _kernel(scene, method):
    counts = number_of_functions(scene(), method, None) is not None
    return registry.kernel(scene, method, FUNCTIONS if counts else None, compile_it=True)


@numba.njit
def as_given(taken, sizes, times):
    """Return the times as they are."""
    return times


def exact_flow(which: Problem):
    """Return ``solve(_)`` by the solver's exact orbit: Python, and checked."""
    case, rough, unit = which.case, which.rough, which.case.units.time
    count = len(case.cell.phases)
    angle = float(rough[-1]) if case.cell.forced else 0.0

    def solve(_: int) -> np.ndarray:
        found = exact_orbit(case, rough[:count] * unit, angle)
        return found.times

    return solve
