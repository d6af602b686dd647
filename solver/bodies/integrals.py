"""What poles answer to Legendre polynomials of a phase: ``a_m`` and ``Z_mn``, for all kappa.

The formulas are those of `generated.force_series`.  Where ``|kappa|`` is large, ``a_m`` and
``b_n`` come from their recurrences upwards.  Below, ``A_m`` is found downwards from far beyond
the last that is wanted, up to a factor that the first two say, and B_n upwards.

Plain Python, or compiled by numba.
"""

from typing import Any

import numpy as np

from ...generated.force_series import (
    answer_0,
    answer_1,
    moment_0,
    moment_1,
    moment_rate,
    next_answer,
    next_moment,
    response_0,
    response_rate,
    same_response,
    unity,
    weight,
    weighted_answer,
    weighted_answer_1,
    weighted_moment,
    weighted_response,
)
from ..arrays import Complex, Indices

#: Degrees beyond the last that is wanted from which recurrences go down.
BEYOND = 24


def moments(kappa: Complex, count: int) -> Complex:
    """Return ``a_m(kappa)`` for m below `count`; shape ``(count, len(kappa))``.

    Errors of ``a_m e^(-Re kappa)`` are some 1e-14, for ``Re kappa <= 0`` those of ``a_m``.
    """
    found = np.empty((max(count, 2), len(kappa)), np.complex128)
    near = is_near(kappa, count)
    found[:, ~near] = upwards(kappa[~near], len(found))
    k = kappa[near]
    own, power = weighted(k, len(found)), np.ones_like(k)
    for m in range(1, len(found)):
        power = power * weight(m, k)
        own[m] = own[m] * power
    found[:, near] = own
    return found[:count]


def is_near(kappa: Complex, count: int) -> Indices:
    """Return for which kappa the formulas are those without powers."""
    found: Indices = np.abs(kappa) <= 2 * (count + 1)
    return found


def upwards(k: Complex, count: int) -> Complex:
    """Return ``a_m`` by its recurrence upwards, two at least."""
    found = np.empty((count, len(k)), np.complex128)
    found[0] = moment_0(k)
    found[1] = moment_1(k, found[0])
    for m in range(1, count - 1):
        found[m + 1] = next_moment(m, k, found[m - 1], found[m])
    return found


def weighted(k: Complex, count: int) -> Complex:
    """Return ``A_m`` by its recurrence downwards, two at least."""
    found, largest = np.empty((count, len(k)), np.complex128), 0.0
    for i in range(len(k)):
        largest = max(largest, abs(k[i]))
    after, here = np.ones_like(k), np.ones_like(k)
    for m in range(count + BEYOND + int(largest / 2), 0, -1):
        after, here = here, weighted_moment(m, k, here, after)
        if m <= count:
            found[m - 1] = here
    found /= unity(k, found[0], found[1])
    return found


def responses(kappa: Complex, rows: int, columns: int) -> Complex:
    """Return ``Z_mn(kappa)`` for n below `columns`, m below as many `rows` or more.

    Shape ``(rows, columns, len(kappa))``.
    """
    found = np.empty((rows * columns, len(kappa)), np.complex128)
    near = is_near(kappa, rows)
    k, j = kappa[near], kappa[~near]
    a, b = weighted(k, rows + 1), np.ones((columns, len(k)), np.complex128)
    steps = np.empty((rows + 1, len(k)), np.complex128)
    for m in range(rows + 1):
        steps[m] = weight(m, k)
    if columns > 1:
        b[1] = weighted_answer_1(k)
    for n in range(1, columns - 1):
        b[n + 1] = weighted_answer(n, k, b[n - 1], b[n])
    for n in range(columns):
        b[n] *= weighted_response(n)
    found[:, near] = products(k, a, b, steps, rows)
    a, b = upwards(j, rows + 1), np.empty((columns, len(j)), np.complex128)
    b[0] = answer_0(j)
    if columns > 1:
        b[1] = answer_1(j, b[0])
    for n in range(1, columns - 1):
        b[n + 1] = next_answer(n, j, b[n - 1], b[n])
    found[:, ~near] = products(j, a, b, np.ones_like(a), rows)
    return found.reshape(rows, columns, len(kappa))


def products(k: Complex, a: Complex, b: Complex, steps: Complex, rows: int) -> Complex:
    """Return ``Z_mn`` by diagonals; shape ``(rows * columns, len(k))``.

    Parameters
    ----------
    k : ndarray of complex, shape (K,)
    a : ndarray of complex, shape (rows + 1, K)
        ``a_m`` or ``A_m``.
    b : ndarray of complex, shape (columns, K)
        What makes these ``Z_(n+1)n``.
    steps : ndarray of complex, shape (rows + 1, K)
        ``Z_mn/Z_(m-1)n`` by the same of ``a_m``, for m > n + 1.
    rows : int
    """
    columns = len(b)
    found = np.empty((rows * columns, len(k)), np.complex128)
    below = a[1 : columns + 1] * b
    found[0] = response_0(a[0], steps[1] * a[1])
    for n in range(1, columns):
        found[n * (columns + 1)] = same_response(n, k, below[n - 1], below[n])
    factors = b.copy()
    for d in range(1, rows):
        count, sign = min(columns, rows - d), -1.0 if d % 2 else 1.0
        if d > 1:
            factors[:count] *= steps[d : d + count]
        own = a[d : d + count] * factors[:count]
        found[d * columns :: columns + 1][:count] = own
        if d < columns:
            found[d :: columns + 1][: columns - d] = sign * own[: columns - d]
    return found


def moment_rates(a: Complex) -> Complex:
    """Return ``d a_m/d kappa`` from ``a_m``, one entry less; by the first index."""
    found, before = np.empty_like(a[1:]), np.zeros_like(a[0])
    for m in range(len(found)):
        found[m] = moment_rate(m, before, a[m], a[m + 1])
        before = a[m]
    return found


def answered(Z: Complex, series: Complex) -> tuple[Complex, Complex]:
    """Return ``sum_n Z_mn l_n``, and the same of ``d Z_mn/d kappa``; shape (count, K) each.

    Parameters
    ----------
    Z : ndarray of complex, shape (count + 1, count + 1, K)
        One row and one column more than the results have.
    series : ndarray of complex, shape (count, K)
        ``l_n``, for each kappa its own.
    """
    count = len(series)
    found = np.zeros_like(Z[0])
    rates = np.zeros_like(series)
    before = np.zeros_like(series)
    for n in range(count):
        found += Z[:, n] * series[n]
        after = Z[:count, n + 1]
        rates += response_rate(0, n, 0.0, 0.0, before, after) * series[n]
        before = Z[:count, n]
    left = np.zeros_like(series[0])
    for m in range(count):
        rates[m] += response_rate(m, 0, left, found[m + 1], 0.0, 0.0)
        left = found[m]
    return found[:count], rates


def answers(kappa: Complex, series: Complex) -> tuple[Complex, Complex]:
    """Return ``int_0^u e^(kappa (u - y)) f(y) dy = E e^(kappa u) + sum B_m P_m*(u)``.

    Parameters
    ----------
    kappa : ndarray of complex, shape (K,)
    series : ndarray of complex, shape (N + 1, K)
        The coefficients of f in Legendre polynomials, for each kappa its own.

    Returns
    -------
    E : ndarray of complex, shape (K,)
    B : ndarray of complex, shape (R, K)
    """
    count = len(series)
    rows = 2 * count + BEYOND + 2
    E, B = np.zeros_like(kappa), np.zeros((rows, len(kappa)), np.complex128)
    near = is_near(kappa, count)
    Z: Any = responses(kappa[near], rows, count)
    by_degree = 2.0 * np.arange(rows) + 1
    B[:, near] = by_degree[:, None] * (Z * series[:, near]).sum(axis=1)
    k = kappa[~near]
    # I_0 = (e^(kappa u) - 1)/kappa, I_1 = (2 I_0 - P_1* - e^(kappa u))/kappa, then by parts
    e, b = np.zeros((2, len(k)), dtype=complex), np.zeros((2, rows, len(k)), dtype=complex)
    e[0], b[0, 0] = answer_0(k), -1 / k
    e[1], b[1, 0], b[1, 1] = answer_1(k, e[0]), 2 * b[0, 0] / k, -1 / k
    for n in range(count):
        own = series[n, ~near]
        E[~near] += own * e[0]
        B[:, ~near] += own * b[0]
        after, beyond = (next_answer(n + 1, k, q[0], q[1]) for q in (e, b))
        beyond[n + 2] -= 1 / k
        beyond[n] += 1 / k
        e, b = np.stack([e[1], after]), np.stack([b[1], beyond])
    return E, B
