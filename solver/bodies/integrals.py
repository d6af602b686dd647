"""What poles answer to Legendre polynomials of a phase: ``a_m`` and ``Z_mn``, for all kappa.

The recurrences of `generated.force_series` are stable upwards where kappa is large.  Below
that both come from an equation in Legendre coefficients, which is tridiagonal: S integrates a
series, ``(I - kappa S) c = e_0`` has those of ``e^(kappa u)``, and ``(I - kappa S) c = S e_n``
those of the answer to ``P_n*``.
"""

from functools import cache
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from ...generated import force_series as recurrence
from ..arrays import Matrix

Complex: TypeAlias = npt.NDArray[np.complex128]

#: Rows beyond the last that is wanted, where a system is cut off.
BEYOND = 24


def moments(kappa: npt.ArrayLike, count: int) -> Complex:
    """Return ``a_m(kappa)`` for m below `count`; shape that of `kappa`, then ``(count,)``.

    Errors of ``a_m e^(-Re kappa)`` are some 1e-14, for ``Re kappa <= 0`` those of ``a_m``.
    """
    k = np.asarray(kappa, dtype=complex)
    found = np.empty((*k.shape, count), dtype=complex)
    up = np.abs(k) > 2 * (count + 1)
    for here, way in ((up, _upwards), (~up, _banded)):
        if here.any():
            found[here] = way(k[here], count)
    return found


def _upwards(k: Complex, count: int) -> Complex:
    found = np.empty((len(k), max(count, 2)), dtype=complex)
    found[:, 0] = recurrence.moment_0(k)
    found[:, 1] = recurrence.moment_1(k, found[:, 0])
    for m in range(1, count - 1):
        found[:, m + 1] = recurrence.next_moment(m, k, found[:, m - 1], found[:, m])
    return found[:, :count]


def _banded(k: Complex, count: int) -> Complex:
    """Return the moments, from the Legendre coefficients of ``e^(kappa u)``."""
    one = np.zeros((len(k), _rows(k, count), 1), dtype=complex)
    one[:, 0] = 1.0
    return np.asarray(_solved(k, one)[:, :count, 0] / (2 * np.arange(count) + 1))


def _rows(k: Complex, count: int) -> int:
    """Return where the system of `count` rows that are wanted is cut off."""
    return count + BEYOND + int(np.abs(k).max(initial=0.0) / 2)


def responses(kappa: Complex, count: int) -> Complex:
    """Return ``Z_mn(kappa)`` for m, n below `count`; shape ``(len(kappa), count, count)``."""
    found = np.empty((len(kappa), count, count), dtype=complex)
    up = np.abs(kappa) > 2 * (count + 1)
    for here, way in ((up, _responses_upwards), (~up, _responses_banded)):
        if here.any():
            found[here] = way(kappa[here], count)
    return found


def _responses_upwards(k: Complex, count: int) -> Complex:
    a, unit = moments(k, count), np.eye(count + 1)
    found = np.empty((len(k), count, max(count, 2)), dtype=complex)
    m, wide = np.arange(count), k[:, None]
    found[:, :, 0] = recurrence.response_0(wide, a, unit[0, :count])
    found[:, :, 1] = recurrence.response_1(wide, found[:, :, 0], a, unit[1, :count])
    for n in range(1, count - 1):
        above, below = unit[n + 1, :count], unit[n - 1, :count]
        found[:, :, n + 1] = recurrence.next_response(
            m, n, wide, found[:, :, n - 1], found[:, :, n], above, below
        )
    return found[:, :, :count]


def answers(kappa: Complex, series: Complex) -> tuple[Complex, Complex]:
    """Return ``int_0^u e^(kappa (u - y)) f(y) dy = E e^(kappa u) + sum B_m P_m*(u)``.

    Parameters
    ----------
    kappa : ndarray of complex, shape (m,)
    series : ndarray of complex, shape (m, N + 1)
        The coefficients of f in Legendre polynomials, for each kappa its own.

    Returns
    -------
    E : ndarray of complex, shape (m,)
    B : ndarray of complex, shape (m, R)
    """
    count = series.shape[1]
    rows = 2 * count + BEYOND + 2
    E, B = np.zeros(len(kappa), dtype=complex), np.zeros((len(kappa), rows), dtype=complex)
    up = np.abs(kappa) > 2 * (count + 1)
    k = kappa[up]
    # I_0 = (e^(kappa u) - 1)/kappa, I_1 = (2 I_0 - P_1* - e^(kappa u))/kappa, then by parts
    e, b = np.zeros((2, len(k)), dtype=complex), np.zeros((2, len(k), rows), dtype=complex)
    e[0], b[0, :, 0] = 1 / k, -1 / k
    e[1], b[1, :, 0], b[1, :, 1] = (2 * e[0] - 1) / k, 2 * b[0, :, 0] / k, -1 / k
    for n in range(count):
        E[up] += series[up, n] * e[0]
        B[up] += series[up, n, None] * b[0]
        above = 2 * (2 * n + 3) / k
        after, beyond = e[0] + above * e[1], b[0] + above[:, None] * b[1]
        beyond[:, n + 2] -= 1 / k
        beyond[:, n] += 1 / k
        e, b = np.stack([e[1], after]), np.stack([b[1], beyond])
    right = series[~up] @ _integration(rows, count).T
    B[~up] = _solved(kappa[~up], right[:, :, None])[:, :, 0]
    return E, B


def _integration(rows: int, count: int) -> Complex:
    """Return the matrix that integrates a series of `count` Legendre polynomials from 0."""
    up = recurrence.integral(np.arange(1, rows + 1))
    found = np.zeros((rows, count))
    found[0, 0] = 0.5
    for n in range(count):
        found[n + 1, n] = up[n]
        if n:
            found[n - 1, n] = -up[n]
    return found.astype(complex)


def _solved(kappa: Complex, right: Complex) -> Complex:
    """Return the solutions of ``(I - kappa S) c = right``; shape (m, rows, columns).

    All kappa make one banded matrix, whose blocks nothing couples.
    """
    from scipy.linalg import solve_banded  # noqa: PLC0415  (a scene of one mass needs none)

    if not len(kappa):
        return right
    rows, k = right.shape[1], kappa[:, None]
    up = recurrence.integral(np.arange(1, rows + 1))  # of P_m* in the integral of P_(m-1)*
    bands = np.zeros((3, len(kappa), rows), dtype=complex)
    bands[0, :, 1:], bands[2, :, :-1] = k * up[1:rows], -k * up[: rows - 1]
    bands[1] = 1.0
    bands[1, :, 0] -= kappa / 2
    flat = right.reshape(-1, right.shape[2])
    return np.asarray(solve_banded((1, 1), bands.reshape(3, -1), flat).reshape(right.shape))


def _responses_banded(kappa: Complex, count: int) -> Complex:
    rows = _rows(kappa, count)
    right = np.broadcast_to(_integration(rows, count), (len(kappa), rows, count))
    return np.asarray(_solved(kappa, right)[:, :count] / (2 * np.arange(count)[:, None] + 1))


def moment_rates(a: Complex) -> Complex:
    """Return ``d a_m/d kappa`` from ``a_m``, one entry less."""
    m = np.arange(a.shape[-1] - 1)
    before = np.concatenate([np.zeros_like(a[..., :1]), a[..., :-2]], axis=-1)
    found: Complex = recurrence.moment_rate(m, before, a[..., :-1], a[..., 1:])
    return found


def response_rates(Z: Complex, series: Complex) -> Complex:
    """Return ``d Z_mn/d kappa``, times the coefficients of a series for each kappa.

    Parameters
    ----------
    Z : ndarray of complex, shape (k, N + 2, N + 2)
        One row and one column more than the result has.
    series : ndarray of complex, shape (k, N + 1)

    Returns
    -------
    ndarray of complex, shape (k, N + 1)
    """
    beside = _neighbours(series.shape[1])
    by_row = Z[..., :-1] @ series[:, :, None]
    by_column = Z[:, :-1] @ (series @ beside)[:, :, None]
    return np.asarray((beside @ by_row - by_column)[:, :, 0])


@cache
def _neighbours(count: int) -> Matrix:
    """Return the matrix D of ``d Z/d kappa = D Z - Z D^T``, shape (count, count + 1)."""
    m, found = np.arange(count), np.zeros((count, count + 1))
    found[m[1:], m[:-1]] = recurrence.response_rate(m[1:], 0, 1, 0, 0, 0)
    found[m, m + 1] = recurrence.response_rate(m, 0, 0, 1, 0, 0)
    return found
