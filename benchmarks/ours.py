"""Our contenders, in the form of the rivals: ``make(setting)`` returns ``period(alpha)``."""

import math

import numba
import numpy as np

import nonsmooth as ns
from nonsmooth.solver.shortcuts.search import kernels

from .rivals import Period


def c1_reduced(order: int) -> Period:
    """Section 3.3 by its scalar equation; the table of coefficients made once an order."""
    functions = kernels.compiled_functions("c1-reduced")
    orbit_times, table = functions["orbit_times"], functions["series_coefficients"](order)

    @numba.njit
    def period(alpha: float) -> float:
        t1, s, _ = orbit_times(alpha, order, table)
        return t1 + s

    return period


def c1_reduced_with_table(order: int) -> Period:
    """Return the same, with the table made anew for every orbit."""
    functions = kernels.compiled_functions("c1-reduced")
    orbit_times, coefficients = functions["orbit_times"], functions["series_coefficients"]

    @numba.njit
    def period(alpha: float) -> float:
        t1, s, _ = orbit_times(alpha, order, coefficients(order))
        return t1 + s

    return period


def c1_full(order: int) -> Period:
    """Section 3.3 with all its unknowns: Newton with bands; the tables made once an order."""
    functions = kernels.compiled_functions("c1")
    band_newton = functions["band_newton"]
    A, B, parts, weights = functions["band_tables"](order)

    @numba.njit
    def period(alpha: float) -> float:
        t1 = 2 * alpha
        T = t1 + math.pi + 2 / (alpha + 2 / math.pi)
        p, twice, rho = np.empty(order + 1), np.empty(order + 3), np.empty(order + 3)
        M, X = np.empty((order + 1, 13)), np.empty((order + 1, 3))
        t1, T, _ = band_newton(alpha, t1, T, A, B, parts, weights, p, M, X, twice, rho)
        return T

    return period


def by_solve(method: str):
    """Return a factory for a whole `nonsmooth.solve`, with its checks, by compiled kernels."""

    def make(order: int) -> Period:
        def period(alpha: float) -> float:
            belt = ns.StickSlip(
                mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
            )
            return ns.solve(belt, method, order, many=True).period

        return period

    return make
