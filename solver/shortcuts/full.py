"""The whole systems in whose place the shortcuts are solved: to hold them against.

Three kinds: the kernel that every scene has, whose rows are those of Section 3.1; the paper's
own kernels of Sections 3.2 and 3.3, whose rows are other than the generic ones (see `table`);
and the rows of 3.2 with several C1 functions by quadrature, of which there is no other kernel.
"""

import math

import numpy as np

from ..accuracy.quadrature import panels
from ..arrays import Vector
from ..case import registry
from ..case.case import Case
from ..compiling import PLAIN_ORDER
from ..no_orbit import NoOrbit
from ..shortcut import Full
from ..solve import solve_case
from .entrance import alpha_of_case
from .search import kernels
from .search.newton import newton
from .search.start import rough_times, with_coefficients
from .series import fourier


def parts(z: Vector) -> Vector:
    """Return stick and slip as parts of the period, of unknowns that end in ``t1, T``."""
    t1, T = z[-2:]
    return np.asarray([t1 / T, (T - t1) / T])


def parts_of_cell(z: Vector) -> Vector:
    """Return stick and slip as parts of the period, of unknowns that end in both durations."""
    return np.asarray(z[-2:] / z[-2:].sum())


def of_every_scene(method: str) -> Full:
    """Return the kernel of a method that every scene has."""

    def residual(case: Case, order: int, functions: int | None, z: Vector) -> Vector:
        R = np.empty(len(z))
        many = order > PLAIN_ORDER
        kernel = registry.kernel(case.scene, method, functions, compile_it=many)
        kernel.residual(case.numbers, z, R)
        return R

    def times(case: Case, order: int, functions: int | None) -> Vector | None:
        try:
            return parts_of_cell(solve_case(case, method, order, functions).unknowns)
        except NoOrbit:
            return None

    return Full("the rows that every scene has", residual, times)


def of_the_paper(method: str) -> Full:
    """Return the paper's own kernel of a method."""

    def completed(alpha: float, order: int, found: Vector) -> Vector:
        if len(found) > len(parts(found)):
            return found
        t1, T = map(float, found)
        return with_coefficients(kernels.plain(method), alpha, order, t1, T)

    def residual(case: Case, order: int, functions: int | None, found: Vector) -> Vector:
        alpha = alpha_of_case(case)
        z = completed(alpha, order, found)
        R = np.empty(len(z))
        kernels.plain(method).residual(alpha, z, R)
        return R

    def times(case: Case, order: int, functions: int | None) -> Vector | None:
        alpha = alpha_of_case(case)
        kernel = kernels.compiled(method)
        start = with_coefficients(kernel, alpha, order, *rough_times(alpha))
        outcome = newton(kernel.iterate, alpha, start)
        return parts(outcome.unknowns) if outcome.converged else None

    return Full("the rows of the paper", residual, times)


def by_quadrature(case: Case, order: int, functions: int | None, z: Vector) -> Vector:
    """Return (5)-(7), (9), (10) and (14) of a series with C1 functions, by a Gauss rule.

    (14) is tested by each function itself, scaled to be at most 1: that the residual is
    orthogonal to its tail is then the same, since by (5)-(7) it is so to the harmonics.
    """
    alpha, (t1, T) = alpha_of_case(case), map(float, z[-2:])
    u, weights = panels([t1 / T], 4 * order)
    t = T * u
    y, acceleration = (fourier.evaluate_hb_c1(z, order, t, m, alpha) for m in (0, 2))
    weighted = T * weights * (acceleration + np.where(t < t1, 0.0, y))
    angles = 2 * math.pi * np.outer(np.arange(order + 1), u)
    rows = [np.cos(angles) @ weighted, np.sin(angles[1:]) @ weighted]
    for i in range(2 * order + 1, 2 * order + 1 + (functions or 1)):
        one = np.zeros(len(z))
        one[i], one[-2:] = 1.0, z[-2:]
        function = fourier.c1_functions(one, order, t, 0)
        rows.append(np.array([function @ weighted]) / np.abs(function).max())
    start = np.zeros(1)
    rows.append(fourier.evaluate_hb_c1(z, order, start, 0, alpha) + alpha)
    rows.append(fourier.evaluate_hb_c1(z, order, start, 1, alpha) - 1)
    return np.concatenate(rows)


#: The rows of Section 3.2 with several functions.
WITH_SEVERAL = Full("the rows of the paper, by quadrature", by_quadrature, None)
