"""All real solutions of the C1 series of the paper (Section 3.3), orbits or not.

Without units: time in ``1/omega_n``, length in ``V/omega_n``.  The slip acceleration is a
series ``p_0 .. p_N`` of shifted Legendre polynomials, and (20) is ``p_0 = 0``.  Given the slip
duration ``s``, equations (18) are linear in ``p_1/s .. p_N/s`` and in ``y(t1)/s``, with
coefficients rational in ``s**2``; (19) then gives ``t1``.  What is left is ``alpha = y_0(s)``
with a rational function, so every solution is a positive root of one polynomial
``alpha D(s**2) - s E(s**2)``, isolated in exact arithmetic: that none of them is an orbit is
then a fact, not a failed iteration.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import gcd, lcm
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.polynomial.polynomial import polyval

from .solver.existence.real_roots import Polynomial, isolate, refine
from .solver.kernels.registry import kernel
from .solver.orbit.solution import attempt

if TYPE_CHECKING:
    from .kim_perkins import StickSlip


@dataclass(frozen=True)
class RealSolution:
    """A real solution of (18) to (20).

    Parameters
    ----------
    slip, t1, period : float
        In s; `t1` may be negative.
    violations : tuple of str
        Why it is not an orbit; empty if it is.
    transition_mismatch : float or None
        `StickSlipOrbit.transition_mismatch`; None where `t1` is not positive.
    """

    slip: float
    t1: float
    period: float
    violations: tuple[str, ...]
    transition_mismatch: float | None


def solutions(belt: "StickSlip", order: int) -> list[RealSolution]:
    """Return all real solutions of (18) to (20), orbits or not, by ascending slip duration.

    Raises
    ------
    ArithmeticError
        If two of them coincide.
    """
    roots = []
    for t1, slip in isolated(order, belt.alpha):
        stick, slide = t1 / belt.omega_n, slip / belt.omega_n
        violations: tuple[str, ...] = (f"stick lasts {stick:.3g} s",)
        mismatch = None
        if t1 > 0:
            times = np.array([stick, slide]) / belt.units.time
            orbit = belt.presented(attempt(kernel(belt.scene, "ck"), belt, order, times))
            violations, mismatch = orbit.violations, orbit.transition_mismatch
        turns = slip / (2 * math.pi)
        if turns > 1 + 1 / (2 * order):
            words = f"slip lasts {turns:.4g} natural periods: within one, the velocity is back"
            violations = (f"{words} at V", *violations)
        roots.append(RealSolution(slide, stick, stick + slide, violations, mismatch))
    return roots


def isolated(order: int, alpha: float) -> list[tuple[float, float]]:
    """Return ``t1`` and ``s`` of every real solution at an order, ascending in `s`.

    Raises
    ------
    ArithmeticError
        If two solutions coincide.

    Examples
    --------
    >>> [(round(t1, 6), round(s, 6)) for t1, s in isolated(3, 1.0)]
    [(2.066468, 4.624313), (0.710579, 5.740552), (3.377437, 14.341854)]
    """
    p = polynomial(order, alpha)
    roots = []
    for slip in (refine(p, *interval) for interval in isolate(p)):
        D, _, W = (polyval(slip**2, part) for part in _rational_function(order))
        roots.append((float(slip * W / D), float(slip)))
    return roots


def alpha_of(order: int, slip: float) -> float:
    """Return the `alpha` for which (18) to (20) have a given slip duration at an order.

    For the exact orbit it is ``-tan(s/2)``.
    """
    D, E, _ = _rational_function(order)
    square = Fraction(slip) ** 2
    return float(Fraction(slip) * polyval(square, E) / polyval(square, D))


def polynomial(order: int, alpha: float) -> Polynomial:
    """Return ``alpha D(s**2) - s E(s**2)`` with coprime integer coefficients."""
    denominator, numerator, _ = _rational_function(order)
    exact = Fraction(alpha)
    coefficients = []
    for D, E in zip(denominator, numerator, strict=True):
        coefficients += [exact * D, -E]
    while coefficients[-1] == 0:
        coefficients.pop()
    scale = lcm(*(c.denominator for c in coefficients))
    integers = [int(c * scale) for c in coefficients]
    common = gcd(*integers)
    return [c // common for c in integers]


@cache
def _rational_function(order: int) -> tuple[list[Fraction], list[Fraction], list[Fraction]]:
    """Return ``D``, ``E``, ``W``: ``alpha = s E/D`` and ``t1 = s W/D``, constants first.

    Polynomials in ``s**2``, interpolated from exact values at ``order + 2`` places.
    """
    places: list[Fraction] = []
    values: list[tuple[Fraction, Fraction, Fraction]] = []
    square = Fraction(0)
    while len(places) < order + 2:
        square += 1
        eliminated = _eliminate(_system(order, square))
        if eliminated is not None:
            determinant, solution = eliminated
            t1 = square * solution[0] / 6 - 1  # (19): t1 + s = s**2 p_1/6
            places.append(square)
            values.append((determinant, determinant * (t1 - solution[-1]), determinant * t1))
    D, E, W = (_interpolate(places, column) for column in zip(*values, strict=True))
    return D, E, W


@cache
def _parts(n: int) -> dict[int, Fraction]:
    """Return ``P_n*``, integrated twice from 0, by parts in ``P_l*``; ``P_(-1-l)* = -P_l*``."""
    parts: dict[int, Fraction] = {}
    for l, divisor in (
        (n + 2, 4 * (2 * n + 1) * (2 * n + 3)),
        (n, -2 * (2 * n - 1) * (2 * n + 3)),
        (n - 2, 4 * (2 * n - 1) * (2 * n + 1)),
    ):
        sign, index = (1, l) if l >= 0 else (-1, -1 - l)
        parts[index] = parts.get(index, Fraction(0)) + Fraction(sign, divisor)
    return parts


def _project(k: int, rho: dict[int, Fraction]) -> Fraction:
    """Return the inner product of a series with the test function ``k`` of (18)."""
    products = (q * rho[l] / (2 * l + 1) for l, q in _parts(k).items() if l in rho)
    return sum(products, Fraction(0))


def _system(order: int, square: Fraction) -> list[list[Fraction]]:
    """Return the augmented linear system for ``p_1/s .. p_N/s, y(t1)/s`` at ``s**2``."""
    columns = []
    for n in range(1, order + 1):
        rho = {l: square * q for l, q in _parts(n).items()}
        rho[n] = rho.get(n, Fraction(0)) + 1
        columns.append(rho)
    columns.append({0: Fraction(1)})
    line = {0: Fraction(1, 2), 1: Fraction(1, 2)}
    return [
        [*(_project(k, rho) for rho in columns), -_project(k, line)] for k in range(order + 1)
    ]


def _eliminate(rows: list[list[Fraction]]) -> tuple[Fraction, list[Fraction]] | None:
    """Return determinant and solution of the augmented system, which is overwritten.

    Gaussian elimination that skips zeros: the matrix is almost banded.
    """
    determinant, size = Fraction(1), len(rows)
    filled: list[list[int]] = []
    for i in range(size):
        pivot = next((r for r in range(i, size) if rows[r][i]), None)
        if pivot is None:
            return None
        if pivot != i:
            rows[i], rows[pivot] = rows[pivot], rows[i]
            determinant = -determinant
        head = rows[i][i]
        determinant *= head
        filled.append([c for c in range(i + 1, size + 1) if rows[i][c]])
        for r in range(i + 1, size):
            if rows[r][i]:
                factor = rows[r][i] / head
                for c in filled[i]:
                    rows[r][c] -= factor * rows[i][c]
    solution = [Fraction(0)] * size
    for i in reversed(range(size)):
        solved = sum((rows[i][c] * solution[c] for c in filled[i] if c < size), Fraction(0))
        solution[i] = (rows[i][size] - solved) / rows[i][i]
    return determinant, solution


def _interpolate(places: list[Fraction], values: Sequence[Fraction]) -> list[Fraction]:
    """Return the coefficients of the polynomial through the values, by Newton's form.

    The arrays are of fractions: nothing is rounded.
    """
    x: Any = np.array(places)
    table: Any = np.array(values)
    for level in range(1, len(x)):
        table[level:] = (table[level:] - table[level - 1 : -1]) / (x[level:] - x[:-level])
    coefficients = table[-1:]
    for place, value in zip(x[-2::-1], table[-2::-1], strict=True):
        coefficients = np.convolve(coefficients, [-place, 1])
        coefficients[0] += value
    return list(coefficients)
