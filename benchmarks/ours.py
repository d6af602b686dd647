"""Our contenders, in the form of the rivals: ``make(setting)`` returns ``period(alpha)``."""

import math
from collections.abc import Callable

import numba

import nonsmooth as ns

from .rivals import Period
from .scene_ours import newton, taken


def by_kernel(method: str) -> Callable[[int], Period]:
    """Return a factory for Newton's method by a compiled kernel, from rough times."""

    def make(order: int) -> Period:
        solve = newton("stick-slip", method)
        (low, sizes), (high, _) = (taken_at(alpha, method, order) for alpha in (1.0, 2.0))

        if method == "ck-tau":

            @numba.njit
            def given(alpha: float):
                return (between(low[0], high[0], alpha - 1),)

        else:

            @numba.njit
            def given(alpha: float):
                part = alpha - 1
                return between(low[0], high[0], part), between(low[1], high[1], part)

        @numba.njit
        def period(alpha: float) -> float:
            slip = math.pi + 2 / (alpha + 2 / math.pi)
            t1, s = solve(given(alpha), sizes, 2 * alpha, slip)
            return t1 + s

        return period

    return make


def taken_at(alpha: float, method: str, order: int):
    """Return what `newton` takes at a load: all numbers of a scene are linear in it."""
    values = {"mass": 1, "stiffness": 1, "belt_speed": 1, "mu_s": 0.5, "mu_k": 0.25}
    case = ns.scene("stick-slip")(**values, normal_force=4 * alpha)
    assert case.numbers[:3] == (1, 1, 1)  # in units of mass, frequency and speed of the belt
    return taken(case, method, order)


@numba.njit
def between(low, high, part):
    """Return what a kernel takes at a load between or beyond two."""
    kinds, numbers, setting, memory, cell, tables = low
    now = numbers + part * (high[1] - numbers)
    return kinds, now, setting, memory, cell, tables


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
