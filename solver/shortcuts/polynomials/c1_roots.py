"""All real solutions of the C1 series (Section 3.3) at a given order, isolated exactly.

Given the slip duration ``s``, equations (18) and (20) are linear in ``p_1/s .. p_N/s`` and
in ``y(t1)/s``, with coefficients rational in ``s**2``; (19) then gives ``t1``.  What is
left is ``alpha = y_0(s)`` with a rational function, so every solution is a positive root
of one polynomial ``alpha D(s**2) - s E(s**2)``, isolated in exact arithmetic: that none of
them is an orbit is then a fact, not a failed iteration.
"""

from fractions import Fraction
from functools import cache
from math import gcd, lcm

import numpy as np

from ...arrays import Vector
from ..search.kernels import module
from .real_roots import Polynomial, isolate, refine


@cache
def _parts(n: int) -> dict[int, Fraction]:
    """Return ``Q_n``, which is ``P_n*`` integrated twice, by parts in ``P_l*``."""
    parts: dict[int, Fraction] = {}
    for l, value in zip(
        (n - 2, n, n + 2), module("c1").twice_integrated(Fraction(n)), strict=True
    ):
        sign, index = (1, l) if l >= 0 else (-1, -1 - l)
        parts[index] = parts.get(index, Fraction(0)) + sign * value
    return parts


@cache
def _weights(k: int) -> dict[int, Fraction]:
    """Return the integrals of ``Q_k`` times ``P_l*``, by ``l``; the others are zero."""
    norm = module("c1").norm
    return {l: q * norm(Fraction(l)) for l, q in _parts(k).items()}


def _project(k: int, rho: dict[int, Fraction]) -> Fraction:
    return sum((weight * rho[l] for l, weight in _weights(k).items() if l in rho), Fraction(0))


def _system(order: int, square: Fraction) -> list[list[Fraction]]:
    """Return the augmented linear system for ``p_1/s .. p_N/s, y(t1)/s`` at ``s**2``."""
    one, half = Fraction(1), Fraction(1, 2)
    columns = []
    for n in range(1, order + 1):
        rho = {l: square * q for l, q in _parts(n).items()}
        rho[n] = rho.get(n, Fraction(0)) + one
        columns.append(rho)
    columns.append({0: one})
    line = {0: half, 1: half}
    return [
        [*(_project(k, rho) for rho in columns), -_project(k, line)] for k in range(order + 1)
    ]


def _eliminate(rows: list[list[Fraction]]) -> tuple[Fraction, list[Fraction]] | None:
    """Return determinant and solution of the augmented system, which is overwritten.

    By Gauss, from the ends of the band on: what is zero is skipped.
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
        known = sum((rows[i][c] * solution[c] for c in filled[i] if c < size), Fraction(0))
        solution[i] = (rows[i][size] - known) / rows[i][i]
    return determinant, solution


def _stick_duration(square: Fraction, p1: Fraction) -> Fraction:
    """Return ``t1/s`` from (19), which is ``t1 + s = s**2 p_1/6``; `p1` is ``p_1/s``."""
    weight: Fraction = module("c1").displacement_weights(Fraction(1))[1]
    return -weight * square * p1 - 1


@cache
def _rational_function(
    order: int,
) -> tuple[list[Fraction], list[Fraction], list[Fraction]]:
    """Return ``D``, ``E``, ``W``: ``alpha = s E/D`` and ``t1 = s W/D``, constants first.

    Polynomials in ``s**2``, interpolated from exact values at ``order + 2`` places.
    """
    places: list[Fraction] = []
    below: list[Fraction] = []
    above: list[Fraction] = []
    travel: list[Fraction] = []
    square = Fraction(0)
    while len(places) < order + 2:
        square += 1
        found = _eliminate(_system(order, square))
        if found is not None:
            determinant, solution = found
            places.append(square)
            below.append(determinant)
            t1 = _stick_duration(square, solution[0])
            above.append(determinant * (t1 - solution[-1]))
            travel.append(determinant * t1)
    D, E, W = (_interpolate(places, values) for values in (below, above, travel))
    return D, E, W


def _interpolate(places: list[Fraction], values: list[Fraction]) -> list[Fraction]:
    """Return the coefficients of the polynomial through the values (Newton's form)."""
    table = list(values)
    for level in range(1, len(places)):
        for i in range(len(places) - 1, level - 1, -1):
            table[i] = (table[i] - table[i - 1]) / (places[i] - places[i - level])
    result = [table[-1]]
    for i in range(len(places) - 2, -1, -1):
        shifted = [Fraction(0), *result]
        for power, value in enumerate(result):
            shifted[power] -= places[i] * value
        shifted[0] += table[i]
        result = shifted
    return result


def polynomial(order: int, alpha: float) -> Polynomial:
    """Return ``alpha D(s**2) - s E(s**2)`` with coprime integer coefficients."""
    below, above, _ = _rational_function(order)
    exact = Fraction(alpha)
    coefficients = []
    for D, E in zip(below, above, strict=True):
        coefficients += [exact * D, -E]
    while coefficients[-1] == 0:
        coefficients.pop()
    scale = lcm(*(c.denominator for c in coefficients))
    integers = [int(c * scale) for c in coefficients]
    common = gcd(*integers)
    return [c // common for c in integers]


def roots(order: int, alpha: float) -> list[Fraction]:
    """Return every positive solution ``s`` at this order, ascending, to `BITS` bits.

    Raises
    ------
    ArithmeticError
        If two of them coincide.
    """
    p = polynomial(order, alpha)
    return [refine(p, *interval) for interval in isolate(p)]


def solutions(order: int, alpha: float) -> list[Vector]:
    """Return the kernel's unknowns for each root, ``p_0..p_N, t1, T``, in float64.

    Raises
    ------
    ArithmeticError
        If two roots coincide.
    """
    return [_unknowns(order, s) for s in roots(order, alpha)]


def _unknowns(order: int, s: Fraction) -> Vector:
    """Return the kernel's unknowns at a root; the times to rounding, whatever their size."""
    square = s * s
    system = np.array(_system(order, square), dtype=float)
    scaled = np.linalg.solve(system[:, :-1], system[:, -1])
    D, _, W = (_evaluate(part, square) for part in _rational_function(order))
    t1 = s * W / D
    return np.array([0.0, *(float(s) * scaled[:-1]), float(t1), float(t1 + s)])


def _evaluate(coefficients: list[Fraction], x: Fraction) -> Fraction:
    total = Fraction(0)
    for c in reversed(coefficients):
        total = total * x + c
    return total
