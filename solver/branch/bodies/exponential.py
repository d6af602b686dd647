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
    scales = np.ones((n, 1))
    for i in range(n // 2):
        scales[i] = generator[i, n // 2 + i]
    return scales


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
    near, sizable = size <= 1, size > TINY
    argument = np.where(near & sizable, half, 1 + 0j)
    ratio = np.where(sizable, np.sinh(argument) / argument, 1 + 0j)
    by_sinh = t * np.exp((s + q) * (t / 2)) * ratio
    apart = np.where(near, 1 + 0j, s - q)
    return np.where(near, by_sinh, (np.exp(s * t) - np.exp(q * t)) / apart)


def doubled(responses: Complex, poles: Complex, omega: float, t: float) -> Complex:
    """Return the `answers` after 2 t: ``e^(2a) - e^(2b) = (e^a - e^b)(e^a + e^b)``."""
    waves = np.array([[np.exp(1j * omega * t)], [np.exp(-1j * omega * t)], [1 + 0j]])
    twice: Complex = responses * (np.exp(poles * t).reshape(1, len(poles)) + waves)
    return twice


def by_basis(
    poles: Complex, drives: Matrix, omega: float, responses: Complex, t: float, y: Matrix
) -> Matrix:
    """Return the change of modal coordinates in a time, by column.

    Parameters
    ----------
    poles : ndarray of complex, shape (m,)
    drives : ndarray, shape (2 m, r)
        See `drives_of`.
    responses : ndarray of complex, shape (3, m)
        The `answers` in the time t.
    y : ndarray, shape (2 m + r, k)
        Real parts of the modal coordinates, imaginary parts, and the inputs.
    """
    m, to_constant = len(poles), responses[2]
    to_cosine, to_sine = (responses[0] + responses[1]) / 2, (responses[0] - responses[1]) * 0.5j
    inputs, r = np.ascontiguousarray(y[2 * m :]), len(y) - 2 * m
    cosine, sine = inputs[r - 3], inputs[r - 2]
    driven = drives[:m] + 1j * drives[m:]
    forced = to_constant.reshape(m, 1) * driven
    forced[:, r - 3] = to_cosine * driven[:, r - 3] - to_sine * driven[:, r - 2]
    forced[:, r - 2] = to_cosine * driven[:, r - 2] + to_sine * driven[:, r - 3]
    factor, change = (poles * to_constant).reshape(m, 1), np.zeros(y.shape)
    change[:m], change[m : 2 * m] = forced.real.copy() @ inputs, forced.imag.copy() @ inputs
    change[:m] += factor.real * y[:m] - factor.imag * y[m : 2 * m]
    change[m : 2 * m] += factor.real * y[m : 2 * m] + factor.imag * y[:m]
    half_sine, full_sine = np.sin(omega * t / 2), np.sin(omega * t)
    change[2 * m + r - 3] = -2 * half_sine * half_sine * cosine - full_sine * sine
    change[2 * m + r - 2] = full_sine * cosine - 2 * half_sine * half_sine * sine
    return change


def exp_less_one(matrix: Matrix, t: float) -> Matrix:
    """Return ``exp(A t) - 1`` of a matrix A, with its digits where it is small."""
    return matrix * t + exp_less_two_terms(matrix, t)


def exp_less_two_terms(matrix: Matrix, t: float) -> Matrix:
    """Return ``exp(A t) - 1 - A t`` of a matrix A: a Taylor series, then squarings."""
    A, exponential, doublings = shortened(matrix, t)
    exponential += A @ A / 2
    for _ in range(doublings):
        gain = A + exponential
        A, exponential = 2 * A, gain @ gain + 2 * exponential
    return exponential


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
