"""Responses of poles to Legendre polynomials: ``a_m(kappa)`` and ``Z_mn(kappa)``.

The formulas are those of `generated.force_series`; `codegen.galerkin.force_series` defines both
integrals.  Where ``|kappa|`` is large, ``a_m`` and ``b_n`` come from their upward recurrences.
Else ``A_m`` comes from its downward recurrence, started far above the highest degree that is
wanted and normalized by `unity`, and ``B_n`` from its upward recurrence.

``Z_mn = above_m below_n steps_(n+2) ... steps_m`` for m > n, and ``Z_nm = (-1)^(m-n) Z_mn``.
Only the factors are kept: the response to a series of N degrees takes O(N) operations.

Plain Python, or compiled by numba.
"""

from typing import Any

import numpy as np

from ....generated.force_series import (
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
from ...arrays import Complex, Matrix, Vector

#: The downward recurrence of ``A_m`` starts `BEYOND` plus ``|kappa|/2`` degrees above the
#: highest that is wanted: its error is then below 1e-18.
BEYOND = 10

#: Degrees of the response to a series, beyond twice its own.
TAIL = 26

#: Indices of the factors of ``Z_mn``, and of its diagonal.
ABOVE, BELOW, STEPS, SAME = range(4)


def moments(kappa: Complex, count: int) -> Complex:
    """Return ``a_m(kappa)`` for m below `count`; shape ``(count, len(kappa))``.

    The error is some 1e-14, for ``Re kappa > 0`` times ``e^(Re kappa)``.
    """
    values: Complex = whole(factors(kappa, count))[:count]
    return values


def whole(factors: Complex) -> Complex:
    """Return ``a_m`` from the factors of ``Z_mn``."""
    values: Complex = factors[ABOVE].copy()
    power = np.ones_like(values[0])
    for m in range(1, len(values)):
        power *= factors[STEPS, m]
        values[m] *= power
    return values


def factors(kappa: Complex, count: int) -> Complex:
    """Return the factors of ``Z_mn`` for m, n below `count`, and its diagonal.

    Shape ``(4, count + 1, len(kappa))``: `ABOVE`, `BELOW`, `STEPS`, `SAME` by degree; the last
    entries of `BELOW` and `SAME` are unused.
    """
    table = np.zeros((4, count + 1, len(kappa)), np.complex128)
    for which in apart(kappa, limit(count)):
        k = kappa[which]
        part = room(table, which)
        above, below, steps, same = part[0], part[1], part[2], part[3]
        if largest(k) <= limit(count):
            weighted(k, above)
            weighted_answers(k, below)
            for m in range(count + 1):
                steps[m] = weight(m, k)
        else:
            upwards(k, above)
            answers_upwards(k, below)
            steps[:] = 1.0
        same[0] = response_0(above[0], steps[1] * above[1])
        for n in range(1, count):
            before, after = above[n] * below[n - 1], above[n + 1] * below[n]
            same[n] = same_response(n, k, before, after)
        table[:, :, which] = part
    return table


def limit(count: int) -> int:
    """Return the largest ``|kappa|`` for which ``A_m`` and ``B_n`` are used."""
    return 2 * (count + 1)


def apart(kappa: Complex, limit: int) -> Any:
    """Return the indices of poles that are computed together: within the limit, and beyond.

    In compiled code each pole is computed by itself; see `one_by_one`.
    """
    near = np.abs(kappa) <= limit
    return [which for which in (np.flatnonzero(near), np.flatnonzero(~near)) if len(which)]


def largest(k: Any) -> float:
    """Return ``max |kappa|``."""
    return float(np.abs(k).max())


def room(factors: Complex, which: Any) -> Complex:
    """Return an array of zeros for the factors of the poles `which`."""
    zeros: Complex = np.zeros_like(factors[:, :, which])
    return zeros


def upwards(k: Any, a: Complex) -> None:
    """Fill in ``a_m`` by its upward recurrence; at least two entries."""
    grown, inverse = np.exp(k), 1 / k
    a[0] = moment_0(k, grown)
    a[1] = moment_1(k, grown, a[0])
    for m in range(1, len(a) - 1):
        a[m + 1] = next_moment(m, inverse, a[m - 1], a[m])


def weighted(k: Any, A: Complex) -> None:
    """Fill in ``A_m`` by its downward recurrence; at least two entries."""
    after, current = 0 * k + 1, 0 * k + 1
    for m in range(len(A) + BEYOND + int(largest(k) / 2), 0, -1):
        after, current = current, weighted_moment(m, k, current, after)
        if m <= len(A):
            A[m - 1] = current
    by_unity = 1 / unity(k, A[0], A[1])
    for m in range(len(A)):
        A[m] = A[m] * by_unity


def answers_upwards(k: Any, b: Complex) -> None:
    """Fill in ``b_n = Z_(n+1)n/a_(n+1)`` by its upward recurrence; the last entry is unused."""
    b[0] = answer_0(k)
    b[1] = answer_1(k, b[0])
    for n in range(1, len(b) - 2):
        b[n + 1] = next_answer(n, b[0], b[n - 1], b[n])


def weighted_answers(k: Any, B: Complex) -> None:
    """Fill in ``Z_(n+1)n/A_(n+1)``, by the upward recurrence of ``B_n``."""
    B[0], B[1] = 1.0, weighted_answer_1(k)
    for n in range(1, len(B) - 2):
        B[n + 1] = weighted_answer(n, k, B[n - 1], B[n])
    for n in range(len(B)):
        B[n] *= weighted_response(n)


def responses(factors: Complex, w: Complex) -> Any:
    """Return ``Re sum w Z_mn`` over the poles, diagonal by diagonal; shape (Q, count, count).

    Parameters
    ----------
    factors : ndarray of complex, shape (4, count + 1, K)
    w : ndarray of complex, shape (K, Q)
    """
    above, steps, count = factors[ABOVE], factors[STEPS], factors.shape[1] - 1
    sums = np.empty((w.shape[1], count, count))
    flat, below, sign = sums.reshape(w.shape[1], -1), factors[BELOW].copy(), -1.0
    flat[:, :: count + 1] = (factors[SAME, :count] @ w).real.T
    for d in range(1, count):
        if d > 1:
            below[: count - d] *= steps[d:count]
        diagonal = ((above[d:count] * below[: count - d]) @ w).real.T
        flat[:, d * count :: count + 1] = diagonal
        flat[:, d : (count - d) * count : count + 1] = sign * diagonal
        sign = -sign
    return sums


def response_rates(Z: Matrix, series: Vector) -> Vector:
    """Return ``sum_n l_n dZ_mn/dkappa`` for each m, from weighted sums Z of ``Z_mn``.

    The derivative follows from the neighbours: Z has one degree more than the series.
    """
    count = len(series)
    rates = np.zeros(count)
    for m in range(count):
        for n in range(count):
            left, before = Z[m - 1, n] if m > 0 else 0.0, Z[m, n - 1] if n > 0 else 0.0
            rates[m] += response_rate(m, n, left, Z[m + 1, n], before, Z[m, n + 1]) * series[n]
    return rates


def summed(factors: Complex, series: Complex) -> Complex:
    """Return ``sum_n Z_mn l_n`` for each m and pole; shape (count, K).

    Parameters
    ----------
    factors : ndarray of complex, shape (4, count + 1, K)
    series : ndarray of complex, shape (r, K)
        The coefficients l_n for each pole, of at most `count` degrees.
    """
    above, below, steps, same = factors[0], factors[1], factors[2], factors[3]
    sums: Complex = np.empty_like(above[1:])
    running = np.zeros_like(above[0])
    for m in range(len(sums)):  # n < m
        sums[m] = above[m] * running
        running *= steps[m + 1]
        if m < len(series):
            sums[m] += same[m] * series[m]
            running += below[m] * series[m]
    running[:] = 0.0
    for m in range(len(series) - 2, -1, -1):  # n > m
        running *= -steps[m + 2]
        running -= above[m + 1] * series[m + 1]
        sums[m] += below[m] * running
    return sums


def moment_rates(a: Complex) -> Complex:
    """Return ``da_m/dkappa`` from ``a_m``, along the first index; one entry less."""
    rates, before = np.empty_like(a[1:]), np.zeros_like(a[0])
    for m in range(len(rates)):
        rates[m] = moment_rate(m, before, a[m], a[m + 1])
        before = a[m]
    return rates


def rates_by_moments(series: Vector) -> Vector:
    """Return c with ``sum_n l_n da_n/dkappa = sum_m c_m a_m``; one entry more than l."""
    coefficients = np.zeros(len(series) + 1)
    for n in range(len(series)):
        coefficients[n] += moment_rate(n, 0.0, 1.0, 0.0) * series[n]
        coefficients[n + 1] += moment_rate(n, 0.0, 0.0, 1.0) * series[n]
        if n > 0:
            coefficients[n - 1] += moment_rate(n, 1.0, 0.0, 0.0) * series[n]
    return coefficients


def answers(kappa: Complex, series: Complex) -> tuple[Complex, Complex]:
    """Return ``int_0^u e^(kappa (u - y)) f(y) dy = E e^(kappa u) + sum B_m P_m*(u)``.

    Parameters
    ----------
    kappa : ndarray of complex, shape (K,)
    series : ndarray of complex, shape (N + 1, K)
        The Legendre coefficients of f for each kappa.

    Returns
    -------
    E : ndarray of complex, shape (K,)
    B : ndarray of complex, shape (R, K)
    """
    count = len(series)
    rows = 2 * count + TAIL
    E, B = np.zeros_like(kappa), np.zeros((rows, len(kappa)), np.complex128)
    near = np.abs(kappa) <= limit(count)
    sums = summed(factors(kappa[near], rows), series[:, near])
    B[:, near] = (2.0 * np.arange(rows) + 1)[:, None] * sums
    k = kappa[~near]
    # I_0 = (e^(kappa u) - 1)/kappa, I_1 = (2 I_0 - P_1* - e^(kappa u))/kappa, then by parts
    e, b = np.zeros((2, len(k)), dtype=complex), np.zeros((2, rows, len(k)), dtype=complex)
    e[0], b[0, 0] = answer_0(k), -1 / k
    e[1], b[1, 0], b[1, 1] = answer_1(k, e[0]), 2 * b[0, 0] / k, -1 / k
    for n in range(count):
        coefficients = series[n, ~near]
        E[~near] += coefficients * e[0]
        B[:, ~near] += coefficients * b[0]
        after, beyond = (next_answer(n + 1, 1 / k, q[0], q[1]) for q in (e, b))
        beyond[n + 2] -= 1 / k
        beyond[n] += 1 / k
        e, b = np.stack([e[1], after]), np.stack([b[1], beyond])
    return E, B
