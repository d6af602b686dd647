"""Divided differences of ``exp(z t)`` by z, for nodes that may be far apart or equal.

Every response of a linear oscillator is one of them: with the roots ``a, b`` of its
characteristic equation, ``exp[a, b]`` is the response to an impulse, ``exp[a, b, 0]`` to a
constant force and ``exp[a, b, i Omega]`` to a harmonic one.  They are entire functions of the
nodes: equal roots, zero stiffness and resonance are no special cases.

Functions for one time are plain Python, as a call of NumPy takes longer than one number; numba
compiles them with the exact equations.  Functions named ``..._at`` are for arrays of times.
"""

import cmath
import math
from typing import Any

import numpy as np
import numpy.typing as npt

from ..arrays import Vector

Waves = npt.NDArray[np.complex128]

#: Terms of the series for nodes that are no farther apart than 1/t: 1/22! is below rounding.
TERMS = 20


#: The exponent beyond which ``exp`` is infinite in float64.
LARGEST = 709.0


def exp(z: complex) -> complex:
    """Return ``exp(z)``; on overflow infinity or NaN, and no error."""
    if abs(z.imag) < math.inf:
        size = math.exp(z.real) if z.real <= LARGEST else math.inf
        return complex(size * math.cos(z.imag), size * math.sin(z.imag))
    return complex(math.nan, math.nan)


def expm1(z: complex) -> complex:
    """Return ``exp(z) - 1`` without cancellation; on overflow ``exp(z)``."""
    if not (z.real <= LARGEST and abs(z.imag) < math.inf):
        return exp(z)
    half = max(z.real, -LARGEST) / 2
    less = 2 * math.exp(half) * math.sinh(half)  # numba rounds `math.expm1` otherwise
    sine = math.sin(z.imag / 2)
    return complex(less * math.cos(z.imag) - 2 * sine * sine, (less + 1) * math.sin(z.imag))


def of_two(a: complex, b: complex, t: float) -> complex:
    """Return the first divided difference ``(exp(a t) - exp(b t))/(a - b)``, also for a = b."""
    half = (a - b) / 2 * t
    square = half.real * half.real + half.imag * half.imag
    if square > 1:
        return (exp(a * t) - exp(b * t)) / (a - b)
    ratio = cmath.sinh(half) / half if square > 1e-18 else 1.0
    return t * exp((a + b) / 2 * t) * ratio


def of_three(a: complex, b: complex, c: complex, t: float) -> complex:
    """Return the second divided difference of ``exp(z t)`` at nodes `a`, `b`, `c`.

    For close nodes it is the series in complete symmetric polynomials about their mean; else
    the quotient by the difference of the two that are farthest apart.
    """
    a, b, c = farthest_first(a, b, c)
    if not abs(a - c) * t <= 1:
        return (of_two(a, b, t) - of_two(b, c, t)) / (a - c)
    mean = (a + b + c) / 3
    close: complex = of_close(a - mean, b - mean, c - mean, t)
    return exp(mean * t) * close


def of_close(a: complex, b: complex, c: complex, t: Any) -> Any:
    """Return the second divided difference at close nodes of mean 0, for one or many times."""
    pairs, product = a * b + b * c + c * a, a * b * c
    before, last, now = 0j, 0j, 1 + 0j  # complete symmetric polynomials, degree j - 2 to j
    power, total = t * t / 2, 0j
    for j in range(TERMS):
        total = total + now * power
        power = power * t / (j + 3)
        before, last, now = last, now, product * before - pairs * last
    return total


def farthest_first(a: complex, b: complex, c: complex) -> tuple[complex, complex, complex]:
    """Return three nodes, reordered so that the first and last are farthest apart."""
    ab, bc, ca = abs(a - b), abs(b - c), abs(c - a)
    if ca >= ab and ca >= bc:
        return a, b, c
    return (b, c, a) if ab >= bc else (c, a, b)


def of_two_at(a: complex, b: complex, t: Vector) -> Waves:
    """Return `of_two` at times `t`."""
    half = (a - b) / 2 * t
    near = np.abs(half) <= 1
    if a != b:
        far = (np.exp(a * t) - np.exp(b * t)) / (a - b)
        if not near.any():
            return np.asarray(far)
    small = np.where(near, half, 1.0)
    ratio = np.ones(len(t), dtype=complex)
    np.divide(np.sinh(small), small, out=ratio, where=np.abs(small) > 1e-9)
    close = t * np.exp((a + b) / 2 * t) * ratio
    return np.asarray(close if a == b else np.where(near, close, far))


def of_three_at(a: complex, b: complex, c: complex, t: Vector) -> Waves:
    """Return `of_three` at times `t`."""
    a, b, c = farthest_first(a, b, c)
    near = abs(a - c) * t <= 1
    if near.all():
        return _near(a, b, c, t)
    far = (of_two_at(a, b, t) - of_two_at(b, c, t)) / (a - c)
    return np.asarray(np.where(near, _near(a, b, c, t), far)) if near.any() else far


def _near(a: complex, b: complex, c: complex, t: Vector) -> Waves:
    """Return `of_three` at times `t` by the series for close nodes."""
    mean = (a + b + c) / 3
    return np.asarray(np.exp(mean * t) * of_close(a - mean, b - mean, c - mean, t))
