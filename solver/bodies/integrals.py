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
from ..arrays import Complex

#: Degrees beyond the last that is wanted from which recurrences go down.
BEYOND = 24


def moments(kappa: Complex, count: int) -> Complex:
    """Return ``a_m(kappa)`` for m below `count`; shape ``(count, len(kappa))``.

    Errors of ``a_m e^(-Re kappa)`` are some 1e-14, for ``Re kappa <= 0`` those of ``a_m``.
    """
    found = np.empty((max(count, 2), len(kappa)), np.complex128)
    for which in apart(kappa, limit(count)):
        k = kappa[which]
        own = room(len(found), k)
        if largest(k) <= limit(count):
            weighted(k, own)
            power = weight(1, k)
            own[1] = own[1] * power
            for m in range(2, len(own)):
                power = power * weight(m, k)
                own[m] = own[m] * power
        else:
            upwards(k, own)
        found[:, which] = own
    return found[:count]


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


def room(count: int, k: Any) -> Complex:
    """Return room for so many numbers of some kappa."""
    return np.empty((count, len(k)), np.complex128)


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


def responses(kappa: Complex, rows: int, columns: int) -> Any:
    """Return ``Z_mn(kappa)`` for n below `columns`, m below as many `rows` or more.

    Shape ``(len(kappa), rows, columns)``.
    """
    found = np.empty((len(kappa), rows, columns), np.complex128)
    respond(kappa, found)
    return found


def respond(kappa: Complex, found: Any) -> None:
    """Fill in the same."""
    rows, columns = found.shape[1:]
    for which in apart(kappa, limit(rows)):
        k = kappa[which]
        a, b, steps = room(rows + 1, k), room(columns, k), room(rows + 1, k)
        if largest(k) <= limit(rows):
            weighted(k, a)
            for m in range(rows + 1):
                steps[m] = weight(m, k)
            b[0] = 1.0
            if columns > 1:
                b[1] = weighted_answer_1(k)
            for n in range(1, columns - 1):
                b[n + 1] = weighted_answer(n, k, b[n - 1], b[n])
            for n in range(columns):
                b[n] = b[n] * weighted_response(n)
        else:
            upwards(k, a)
            steps[:] = 1.0
            b[0] = answer_0(k)
            if columns > 1:
                b[1] = answer_1(k, b[0])
            for n in range(1, columns - 1):
                b[n + 1] = next_answer(n, b[0], b[n - 1], b[n])
        found[which] = products(k, a, b, steps)


def products(k: Complex, a: Complex, b: Complex, steps: Complex) -> Any:
    """Return ``Z_mn`` by diagonals; shape ``(len(k), rows, columns)``.

    Parameters
    ----------
    k : ndarray of complex, shape (K,)
    a : ndarray of complex, shape (rows + 1, K)
        ``a_m`` or ``A_m``.
    b : ndarray of complex, shape (columns, K)
        What makes these ``Z_(n+1)n``.
    steps : ndarray of complex, shape (rows + 1, K)
        ``Z_mn/Z_(m-1)n`` by the same of ``a_m``, for m > n + 1.
    """
    rows, columns = len(a) - 1, len(b)
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
    return found.T.reshape(len(k), rows, columns)


def moment_rates(a: Complex) -> Complex:
    """Return ``d a_m/d kappa`` from ``a_m``, one entry less; by the first index."""
    found, before = np.empty_like(a[1:]), np.zeros_like(a[0])
    for m in range(len(found)):
        found[m] = moment_rate(m, before, a[m], a[m + 1])
        before = a[m]
    return found


def answered(Z: Any, series: Complex, b: Complex) -> tuple[Complex, Complex]:
    """Return ``sum_n Z_mn l_n``, and the same of ``d Z_mn/d kappa``; shape (K, count) each.

    Parameters
    ----------
    Z : ndarray of complex, shape (K, count + 1, count + 1)
        One row and one column more than the results have.
    series : ndarray of complex, shape (count, c)
        The coefficients of each contact.
    b : ndarray of complex, shape (c, K)
        What each pole takes of them: ``l_n`` is the sum of the products.
    """
    count, room = len(series), len(series) + 1
    found = np.zeros((len(Z), room), np.complex128)
    rates = np.zeros((len(Z), room), np.complex128)
    flat = np.ascontiguousarray(Z).reshape(len(Z) * room, room)
    for k in range(len(b)):
        own = np.zeros((room, 2), np.complex128)  # l_n, and what rates have from columns of Z
        own[:count, 0] = series[:, k]
        for n in range(count):
            own[n + 1, 1] += response_rate(0, n, 0.0, 0.0, 0.0, 1.0) * series[n, k]
            if n > 0:
                own[n - 1, 1] += response_rate(0, n, 0.0, 0.0, 1.0, 0.0) * series[n, k]
        answers = (flat @ own).reshape(len(Z), room, 2)
        by = b[k].copy().reshape(-1, 1)
        found += answers[:, :, 0] * by
        rates += answers[:, :, 1] * by
    left = np.zeros(len(Z), np.complex128)
    for m in range(count):
        rates[:, m] += response_rate(m, 0, left, found[:, m + 1], 0.0, 0.0)
        left = found[:, m]
    return found[:, :count], rates[:, :count]


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
    near = np.abs(kappa) <= limit(count)
    Z, by_degree = responses(kappa[near], rows, count), 2.0 * np.arange(rows) + 1
    B[:, near] = by_degree[:, None] * (Z @ series[:, near].T[:, :, None])[:, :, 0].T
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
