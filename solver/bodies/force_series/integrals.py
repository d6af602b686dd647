"""What poles answer to Legendre polynomials of a phase: ``a_m`` and ``Z_mn``, for all kappa.

The formulas are those of `generated.force_series`.  Where ``|kappa|`` is large, ``a_m`` and
``b_n`` come from their recurrences upwards.  Below, ``A_m`` is found downwards from far beyond
the last that is wanted, up to a factor that the first two say, and B_n upwards.

``Z_mn`` is a product, ``Z_mn = above_m below_n steps_(n+2) ... steps_m`` for m > n, and
``Z_nm = (-1)^(m-n) Z_mn``: its factors are kept, and no table of a pole is made.  What a series
is answered takes as many operations as it has degrees.

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

#: From how many degrees beyond the last that is wanted ``A_m`` are found downwards, and half of
#: ``|kappa|``: what is wrong there is below 1e-18 of what is wanted.
BEYOND = 10

#: Degrees of what a series is answered beyond twice its own.
TAIL = 26

#: Where these are among the factors of ``Z_mn``.
ABOVE, BELOW, STEPS, SAME = range(4)


def moments(kappa: Complex, count: int) -> Complex:
    """Return ``a_m(kappa)`` for m below `count`; shape ``(count, len(kappa))``.

    Errors of ``a_m e^(-Re kappa)`` are some 1e-14, for ``Re kappa <= 0`` those of ``a_m``.
    """
    found: Complex = whole(factors(kappa, count))[:count]
    return found


def whole(factors: Complex) -> Complex:
    """Return ``a_m`` from the factors of ``Z_mn``."""
    found: Complex = factors[ABOVE].copy()
    power = np.ones_like(found[0])
    for m in range(1, len(found)):
        power *= factors[STEPS, m]
        found[m] *= power
    return found


def factors(kappa: Complex, count: int) -> Complex:
    """Return the factors of ``Z_mn`` for m, n below `count`, and its diagonal.

    Shape ``(4, count + 1, len(kappa))``: `ABOVE`, `BELOW`, `STEPS`, `SAME` by degree, the last
    entry of the second and the fourth unused.
    """
    found = np.zeros((4, count + 1, len(kappa)), np.complex128)
    for which in apart(kappa, limit(count)):
        k = kappa[which]
        own = room(found, which)
        above, below, steps, same = own[0], own[1], own[2], own[3]
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
        found[:, :, which] = own
    return found


def limit(count: int) -> int:
    """Return the largest ``|kappa|`` for which the formulas are those without powers."""
    return 2 * (count + 1)


def apart(kappa: Complex, limit: int) -> Any:
    """Return the poles that are computed together: those within a limit, and the others.

    Compiled, each is computed by itself; see `one_by_one`.
    """
    near = np.abs(kappa) <= limit
    return [which for which in (np.flatnonzero(near), np.flatnonzero(~near)) if len(which)]


def largest(k: Any) -> float:
    """Return the largest modulus of some kappa."""
    return float(np.abs(k).max())


def room(factors: Complex, which: Any) -> Complex:
    """Return room for the factors of some poles."""
    found: Complex = np.zeros_like(factors[:, :, which])
    return found


def upwards(k: Any, found: Complex) -> None:
    """Fill in ``a_m`` by its recurrence upwards, two at least."""
    grown, inverse = np.exp(k), 1 / k
    found[0] = moment_0(k, grown)
    found[1] = moment_1(k, grown, found[0])
    for m in range(1, len(found) - 1):
        found[m + 1] = next_moment(m, inverse, found[m - 1], found[m])


def weighted(k: Any, found: Complex) -> None:
    """Fill in ``A_m`` by its recurrence downwards, two at least."""
    after, here = 0 * k + 1, 0 * k + 1
    for m in range(len(found) + BEYOND + int(largest(k) / 2), 0, -1):
        after, here = here, weighted_moment(m, k, here, after)
        if m <= len(found):
            found[m - 1] = here
    by_unity = 1 / unity(k, found[0], found[1])
    for m in range(len(found)):
        found[m] = found[m] * by_unity


def answers_upwards(k: Any, found: Complex) -> None:
    """Fill in ``b_n``, which ``Z_(n+1)n`` is ``a_(n+1)`` times; the last is unused."""
    found[0] = answer_0(k)
    found[1] = answer_1(k, found[0])
    for n in range(1, len(found) - 2):
        found[n + 1] = next_answer(n, found[0], found[n - 1], found[n])


def weighted_answers(k: Any, found: Complex) -> None:
    """Fill in the same of ``A_(n+1)``."""
    found[0], found[1] = 1.0, weighted_answer_1(k)
    for n in range(1, len(found) - 2):
        found[n + 1] = weighted_answer(n, k, found[n - 1], found[n])
    for n in range(len(found)):
        found[n] *= weighted_response(n)


def responses(factors: Complex, w: Complex) -> Any:
    """Return ``Re sum w Z_mn`` over the poles, by diagonals; shape (Q, count, count).

    Parameters
    ----------
    factors : ndarray of complex, shape (4, count + 1, K)
    w : ndarray of complex, shape (K, Q)
    """
    above, steps, count = factors[ABOVE], factors[STEPS], factors.shape[1] - 1
    found = np.empty((w.shape[1], count, count))
    flat, below, sign = found.reshape(w.shape[1], -1), factors[BELOW].copy(), -1.0
    flat[:, :: count + 1] = (factors[SAME, :count] @ w).real.T
    for d in range(1, count):
        if d > 1:
            below[: count - d] *= steps[d:count]
        diagonal = ((above[d:count] * below[: count - d]) @ w).real.T
        flat[:, d * count :: count + 1] = diagonal
        flat[:, d : (count - d) * count : count + 1] = sign * diagonal
        sign = -sign
    return found


def response_rates(Z: Matrix, series: Vector) -> Vector:
    """Return ``sum_n l_n dZ_mn/dkappa`` from sums of ``Z_mn``, of the degrees of the series.

    The derivative is by neighbours: Z has one degree more.
    """
    count = len(series)
    found = np.zeros(count)
    for m in range(count):
        for n in range(count):
            left, before = Z[m - 1, n] if m > 0 else 0.0, Z[m, n - 1] if n > 0 else 0.0
            found[m] += response_rate(m, n, left, Z[m + 1, n], before, Z[m, n + 1]) * series[n]
    return found


def summed(factors: Complex, series: Complex) -> Complex:
    """Return ``sum_n Z_mn l_n`` of each pole; shape (count, K).

    Parameters
    ----------
    factors : ndarray of complex, shape (4, count + 1, K)
    series : ndarray of complex, shape (r, K)
        What each pole takes of the forces, of at most `count` degrees.
    """
    above, below, steps, same = factors[0], factors[1], factors[2], factors[3]
    found: Complex = np.empty_like(above[1:])
    sums = np.zeros_like(above[0])
    for m in range(len(found)):  # n < m
        found[m] = above[m] * sums
        sums *= steps[m + 1]
        if m < len(series):
            found[m] += same[m] * series[m]
            sums += below[m] * series[m]
    sums[:] = 0.0
    for m in range(len(series) - 2, -1, -1):  # n > m
        sums *= -steps[m + 2]
        sums -= above[m + 1] * series[m + 1]
        found[m] += below[m] * sums
    return found


def moment_rates(a: Complex) -> Complex:
    """Return ``d a_m/d kappa`` from ``a_m``, one entry less; by the first index."""
    found, before = np.empty_like(a[1:]), np.zeros_like(a[0])
    for m in range(len(found)):
        found[m] = moment_rate(m, before, a[m], a[m + 1])
        before = a[m]
    return found


def rates_by_moments(series: Vector) -> Vector:
    """Return what ``sum_n l_n d a_n/d kappa`` takes of each ``a_m``, one more than l_n."""
    found = np.zeros(len(series) + 1)
    for n in range(len(series)):
        found[n] += moment_rate(n, 0.0, 1.0, 0.0) * series[n]
        found[n + 1] += moment_rate(n, 0.0, 0.0, 1.0) * series[n]
        if n > 0:
            found[n - 1] += moment_rate(n, 1.0, 0.0, 0.0) * series[n]
    return found


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
    rows = 2 * count + TAIL
    E, B = np.zeros_like(kappa), np.zeros((rows, len(kappa)), np.complex128)
    near = np.abs(kappa) <= limit(count)
    found = summed(factors(kappa[near], rows), series[:, near])
    B[:, near] = (2.0 * np.arange(rows) + 1)[:, None] * found
    k = kappa[~near]
    # I_0 = (e^(kappa u) - 1)/kappa, I_1 = (2 I_0 - P_1* - e^(kappa u))/kappa, then by parts
    e, b = np.zeros((2, len(k)), dtype=complex), np.zeros((2, rows, len(k)), dtype=complex)
    e[0], b[0, 0] = answer_0(k), -1 / k
    e[1], b[1, 0], b[1, 1] = answer_1(k, e[0]), 2 * b[0, 0] / k, -1 / k
    for n in range(count):
        own = series[n, ~near]
        E[~near] += own * e[0]
        B[:, ~near] += own * b[0]
        after, beyond = (next_answer(n + 1, 1 / k, q[0], q[1]) for q in (e, b))
        beyond[n + 2] -= 1 / k
        beyond[n] += 1 / k
        e, b = np.stack([e[1], after]), np.stack([b[1], beyond])
    return E, B
