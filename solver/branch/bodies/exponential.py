"""The change of a state in a time, ``(exp(G t) - 1) Y`` of a generator G, over arrays.

In the eigenbasis each pole responds by itself to its initial value, to the forcing and to
constants: see `answers`.  Without an eigenbasis, by scaling and squaring of a Taylor series.

Plain Python, or compiled by numba.
"""

from math import ceil, log2

import numpy as np

from ...arrays import Complex, Matrix

#: Norm up to which twelve terms of the Taylor series of an exponential are exact to rounding.
SHORT = 0.25

#: 1 over the factorials.
INVERSE_FACTORIALS = tuple(1 / float(np.prod(np.arange(1.0, k + 1))) for k in range(13))

#: A change over half a time that changes no digit.
TINY = 1e-9


def scales_of(generator: Matrix, n: int) -> Matrix:
    """Return the scale of each displacement, and 1 for each velocity; shape (n, 1)."""
    found = np.ones((n, 1))
    for i in range(n // 2):
        found[i] = generator[i, n // 2 + i]
    return found


def drives_of(generator: Matrix, inverse: Matrix, n: int) -> Matrix:
    """Return the input of each pole by the memory, the cosine, the sine and 1."""
    return inverse @ np.ascontiguousarray(generator[:n, n:])


def answers(poles: Complex, omega: float, t: float) -> Complex:
    """Return the responses of poles at rest to ``e^(i omega t)``, to its conjugate and to 1.

    ``(e^(s t) - e^(q t)) / (s - q)`` for each pole s and ``q = i omega, -i omega, 0``, shape
    (3, m); at a resonance, where s is q, the limit.
    """
    s, q = poles.reshape(1, len(poles)), np.array([[1j * omega], [-1j * omega], [0j]])
    half = (s - q) * (t / 2)
    size = np.abs(half)
    near, whole = size <= 1, size > TINY
    small = np.where(near & whole, half, 1 + 0j)
    ratio = np.where(whole, np.sinh(small) / small, 1 + 0j)
    close = t * np.exp((s + q) * (t / 2)) * ratio
    apart = np.where(near, 1 + 0j, s - q)
    found: Complex = np.where(near, close, (np.exp(s * t) - np.exp(q * t)) / apart)
    return found


def doubled(made: Complex, poles: Complex, omega: float, t: float) -> Complex:
    """Return the `answers` after 2 t: ``e^(2a) - e^(2b) = (e^a - e^b)(e^a + e^b)``."""
    grown, found = np.exp(poles * t), np.empty_like(made)
    found[0] = made[0] * (grown + np.exp(1j * omega * t))
    found[1] = made[1] * (grown + np.exp(-1j * omega * t))
    found[2] = made[2] * (grown + 1)
    return found


def by_basis(
    poles: Complex, drives: Matrix, omega: float, made: Complex, t: float, y: Matrix
) -> Matrix:
    """Return the change of modal coordinates in a time, by column.

    Parameters
    ----------
    poles : ndarray of complex, shape (m,)
    drives : ndarray, shape (2 m, r)
        See `drives_of`.
    made : ndarray of complex, shape (3, m)
        The `answers` in the time t.
    y : ndarray, shape (2 m + r, k)
        Real parts of the modal coordinates, imaginary parts, and the inputs.
    """
    m, still = len(poles), made[2]
    even, odd = (made[0] + made[1]) / 2, (made[0] - made[1]) * 0.5j
    rest, r = np.ascontiguousarray(y[2 * m :]), len(y) - 2 * m
    cosine, sine = rest[r - 3], rest[r - 2]
    driven = drives[:m] + 1j * drives[m:]
    by_rest = still.reshape(m, 1) * driven
    by_rest[:, r - 3] = even * driven[:, r - 3] - odd * driven[:, r - 2]
    by_rest[:, r - 2] = even * driven[:, r - 2] + odd * driven[:, r - 3]
    factor, found = (poles * still).reshape(m, 1), np.zeros(y.shape)
    found[:m], found[m : 2 * m] = by_rest.real.copy() @ rest, by_rest.imag.copy() @ rest
    found[:m] += factor.real * y[:m] - factor.imag * y[m : 2 * m]
    found[m : 2 * m] += factor.real * y[m : 2 * m] + factor.imag * y[:m]
    half, whole = np.sin(omega * t / 2), np.sin(omega * t)
    found[2 * m + r - 3] = -2 * half * half * cosine - whole * sine
    found[2 * m + r - 2] = whole * cosine - 2 * half * half * sine
    return found


def exp_less_one(matrix: Matrix, t: float) -> Matrix:
    """Return ``exp(A t) - 1`` of a matrix A, with its digits where it is small."""
    found: Matrix = matrix * t + exp_less_two_terms(matrix, t)
    return found


def exp_less_two_terms(matrix: Matrix, t: float) -> Matrix:
    """Return ``exp(A t) - 1 - A t`` of a matrix A: a Taylor series, then squarings."""
    A, found, doublings = shortened(matrix, t)
    found += A @ A / 2
    for _ in range(doublings):
        whole = A + found
        A, found = 2 * A, whole @ whole + 2 * found
    return found


def exp_less_three_terms(matrix: Matrix, t: float) -> Matrix:
    """Return ``exp(A t) - 1 - A t - (A t)^2/2`` of a matrix A with ``|A t|`` up to `SHORT`."""
    return shortened(matrix, t)[1]


def shortened(matrix: Matrix, t: float) -> tuple[Matrix, Matrix, int]:
    """Return ``B = A t/2^n`` of norm up to `SHORT`, its `exp_less_three_terms`, and n."""
    size, doublings, f = norm(matrix) * abs(t), 0, INVERSE_FACTORIALS
    if size > SHORT:
        doublings = ceil(log2(size / SHORT))
    A = matrix * (t / 2.0**doublings)
    A2 = A @ A
    A3, A4 = A2 @ A, A2 @ A2
    high = f[9] * A + f[10] * A2 + f[11] * A3 + f[12] * A4
    high = f[5] * A + f[6] * A2 + f[7] * A3 + f[8] * A4 + A4 @ high
    return A, f[3] * A3 + f[4] * A4 + A4 @ high, doublings


def norm(matrix: Matrix) -> float:
    """Return the infinity norm."""
    largest = 0.0
    for i in range(len(matrix)):
        largest = max(largest, np.abs(matrix[i]).sum())
    return largest
