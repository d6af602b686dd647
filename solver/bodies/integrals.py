"""What poles answer to Legendre polynomials of a phase: ``a_m`` and ``Z_mn``, for all kappa.

The recurrences of `generated.force_series` are stable upwards where kappa is large.  Below
that ``a_m`` comes from Miller's recurrence downwards, scaled by its first entry, and ``Z_mn``
from the equation of the answer in Legendre coefficients, ``(I - kappa S) c = S e_n``, which is
tridiagonal: S integrates a series.
"""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt
from scipy.linalg import solve_banded

from ...generated import force_series as recurrence

Complex: TypeAlias = npt.NDArray[np.complex128]

#: Rows beyond the last that is wanted, where a recurrence is begun or a system is cut off.
BEYOND = 24

#: What stands for no kappa; entries of a recurrence beyond which it is scaled down.
TINY, LARGE = 1e-60, 1e200


def moments(kappa: npt.ArrayLike, count: int) -> Complex:
    """Return ``a_m(kappa)`` for m below `count`; shape that of `kappa`, then ``(count,)``.

    Errors of ``a_m e^(-Re kappa)`` are some 1e-14, for ``Re kappa <= 0`` those of ``a_m``.
    """
    k = np.asarray(kappa, dtype=complex)
    found = np.empty((*k.shape, count), dtype=complex)
    up = np.abs(k) > 2 * (count + 1)
    found[up] = _upwards(k[up], count)
    found[~up] = _downwards(k[~up], count)
    return found


def _upwards(k: Complex, count: int) -> Complex:
    found = np.empty((len(k), max(count, 2)), dtype=complex)
    found[:, 0] = recurrence.moment_0(k)
    found[:, 1] = recurrence.moment_1(k, found[:, 0])
    for m in range(1, count - 1):
        found[:, m + 1] = recurrence.next_moment(m, k, found[:, m - 1], found[:, m])
    return found[:, :count]


def _downwards(k: Complex, count: int) -> Complex:
    """Return the moments by Miller's recurrence.

    Its scale is from ``e^(kappa u) = sum (2 m + 1) a_m P_m*(u)`` at the end of the phase where
    that is larger.
    """
    k = np.where(np.abs(k) < TINY, TINY, k)
    growing = k.real > 0
    above, here = np.zeros(len(k), dtype=complex), np.full(len(k), 1e-280, dtype=complex)
    total, found = np.zeros_like(here), np.empty((len(k), count), dtype=complex)
    for m in range(2 * count + BEYOND, -1, -1):
        total += (2 * m + 1) * (here if m % 2 == 0 else np.where(growing, here, -here))
        if m < count:
            found[:, m] = here
        if m:  # `next_moment`, solved for its first
            above, here = here, above - recurrence.next_moment(m, k, 0.0, here)
            large = np.abs(here) > LARGE
            for q in (above, here, total, found[:, m:].T):
                q[..., large] /= LARGE
    return np.asarray(found * (np.where(growing, np.exp(k), 1.0) / total)[:, None])


def responses(kappa: Complex, count: int) -> Complex:
    """Return ``Z_mn(kappa)`` for m, n below `count`; shape ``(len(kappa), count, count)``."""
    found = np.empty((len(kappa), count, count), dtype=complex)
    up = np.abs(kappa) > 2 * (count + 1)
    found[up] = _responses_upwards(kappa[up], count)
    for i in np.flatnonzero(~up):
        found[i] = _responses_banded(complex(kappa[i]), count)
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


def _responses_banded(k: complex, count: int) -> Complex:
    rows = count + BEYOND + int(abs(k) / 2)
    up = recurrence.integral(np.arange(1, rows + 1))  # of P_m* in the integral of P_(m-1)*
    bands = np.zeros((3, rows), dtype=complex)
    bands[0, 1:], bands[2, :-1] = k * up[1:rows], -k * up[: rows - 1]
    bands[1] = 1.0
    bands[1, 0] -= k / 2
    right = np.zeros((rows, count))
    right[0, 0] = 0.5
    for n in range(count):
        right[n + 1, n] = up[n]
        if n:
            right[n - 1, n] = -up[n]
    answers = solve_banded((1, 1), bands, right)[:count]
    return np.asarray(answers / (2 * np.arange(count)[:, None] + 1))


def moment_rates(a: Complex) -> Complex:
    """Return ``d a_m/d kappa`` from ``a_m``, one entry less."""
    m = np.arange(a.shape[-1] - 1)
    before = np.concatenate([np.zeros_like(a[..., :1]), a[..., :-2]], axis=-1)
    found: Complex = recurrence.moment_rate(m, before, a[..., :-1], a[..., 1:])
    return found


def response_rates(Z: Complex) -> Complex:
    """Return ``d Z_mn/d kappa`` from ``Z_mn``, one row and one column less."""
    m, n = np.ogrid[: Z.shape[-2] - 1, : Z.shape[-1] - 1]
    inner = Z[..., :-1, :-1]
    left, before = np.zeros_like(inner), np.zeros_like(inner)
    left[..., 1:, :], before[..., :, 1:] = inner[..., :-1, :], inner[..., :, :-1]
    found: Complex = recurrence.response_rate(
        m, n, left, Z[..., 1:, :-1], before, Z[..., :-1, 1:]
    )
    return found
