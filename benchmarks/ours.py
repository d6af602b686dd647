"""Our contenders, in the form of the rivals: ``make(setting)`` returns ``period(alpha)``."""

import math
from collections.abc import Callable

import numba

import nonsmooth as ns

from .rivals import Period
from .scene_ours import newton


def by_kernel(method: str) -> Callable[[int], Period]:
    """Return a factory for Newton's method by a compiled kernel, from rough times."""

    def make(order: int) -> Period:
        solve = newton("stick-slip", method)

        @numba.njit
        def period(alpha: float) -> float:
            slip = math.pi + 2 / (alpha + 2 / math.pi)
            case = (1.0, 1.0, 1.0, 0.5, 0.25, 4 * alpha)
            t1, s = solve(case, order, 2 * alpha, slip)
            return t1 + s

        return period

    return make


def by_solve(method: str) -> Callable[[int], Period]:
    """Return a factory for a whole `nonsmooth.solve`, with its checks, by compiled kernels."""

    def make(order: int) -> Period:
        def period(alpha: float) -> float:
            belt = ns.StickSlip(
                mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
            )
            return ns.solve(belt, method, order).period

        return period

    return make
