"""Our ways to the two scenes that are timed, in the form of the rivals.

Kernels are compiled, and so is all around them: the start of the coefficients, and the coarse
orbit from whose times every method but ck-tau starts, as `solve_case` does it.
"""

import math
from functools import cache

import numpy as np

from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.kernel import Kernel
from nonsmooth.solver.orbit.motion import Motion
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.solve import COARSE, solve_case

from .scene_rivals import Solve, njit

LIMIT = 40


@cache
def kernel(scene: str, method: str, functions: int | None = None) -> Kernel:
    """Return a compiled kernel."""
    return registry.kernel(registry.load(scene), method, functions, compile_it=True)


def newton(scene: str, method: str, functions: int | None = None) -> Solve:
    """Return Newton's method from the coefficients that fit rough times best.

    Where the kernel starts from times alone, it finds them itself; elsewhere it is by normal
    equations, which lose half the digits of a start, and are quicker than LAPACK.  In the place
    of a case and an order it has what `taken` returns.

    Parameters
    ----------
    scene, method, functions : str, str, int or None
        See `registry.kernel`.
    """
    own = kernel(scene, method, functions)
    if own.condensed:
        return _from_times(own, _as_given if method == "ck-tau" else newton(scene, "ck-tau"))
    before = newton(scene, "ck-tau")
    residual, jacobian, iterate = own.residual, own.jacobian, own.iterate
    names = getattr(iterate, "py_func", iterate).__globals__  # plain where numba is disabled
    factorise, solve_factorised = names["factorise"], names["solve_factorised"]
    times = own.durations + own.forced

    @njit
    def solve(taken, sizes, a, b):
        a, b = before(taken[:1], sizes[:1], a, b)
        case, n = taken[1], sizes[1]
        count = n - times
        z, R, J = np.zeros(n), np.empty(n), np.empty((n, n))
        z[-2], z[-1] = a, b
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
        status, _, _, _ = iterate(case, z, LIMIT)
        return (z[-2], z[-1]) if status == 0 else (math.nan, math.nan)

    return solve


def _from_times(kernel: Kernel, before: Solve) -> Solve:
    """Return the iteration of a kernel that starts from times alone, as the solver has it."""
    iterate = kernel.iterate

    @njit
    def solve(taken, sizes, a, b):
        z = np.zeros(sizes[-1])
        z[-2], z[-1] = before(taken[:1], sizes[:1], a, b)
        status, _, _, _ = iterate(taken[-1], z, LIMIT)
        return (z[-2], z[-1]) if status == 0 else (math.nan, math.nan)

    return solve


def taken(case: Case, method: str, order: int, functions: int | None = None):
    """Return what `newton` takes: cases and sizes of ck-tau at a low order and of a method."""
    orders = {("ck-tau", None): COARSE[0]}
    if method == "ck-tau":
        orders = {}
    orders[method, functions] = order
    kernels = [(kernel(case.scene.name, *which), n) for which, n in orders.items()]
    return tuple(k.given(case, n) for k, n in kernels), tuple(k.size(n) for k, n in kernels)


@njit
def _as_given(taken, sizes, a, b):
    return a, b


def _oscillator(scene: str, case: tuple[float, ...]) -> Case:
    load = registry.load(scene)
    names = (parameter.name for parameter in load.parameters)
    return load(**dict(zip(names, case, strict=True)))


def whole(scene: str, method: str) -> Solve:
    """Return `solve_case` from Python: blind, with its checks; SI units."""

    def solve(case, order, a, b):
        return _pair(solve_case(_oscillator(scene, case), method, order))

    return solve


def exact_flow(scene: str) -> Solve:
    """Return the solver's exact orbit from the rough times: in Python, checked; SI units."""

    def solve(case, _, a, b):
        oscillator = _oscillator(scene, case)
        if oscillator.cell.forced:
            return _pair(exact_orbit(oscillator, (a,), b))
        return _pair(exact_orbit(oscillator, (a, b)))

    return solve


def _pair(orbit: Motion) -> tuple[float, float]:
    first, *rest = orbit.durations
    return first, rest[0] if rest else float(orbit.forcing_phase or 0.0)
