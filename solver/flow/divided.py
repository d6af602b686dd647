"""Divided differences of ``exp(z t)`` by z, for nodes that may be far apart or equal.

Every response of a linear oscillator is one of them: with the roots ``a, b`` of its
characteristic equation, ``exp[a, b]`` is what an impulse does, ``exp[a, b, 0]`` a constant
force and ``exp[a, b, i Omega]`` a harmonic one.  They are entire functions of the nodes: no
case of equal roots, of no stiffness or of resonance is special.
"""

import numpy as np
import numpy.typing as npt

from ..arrays import Vector

Waves = npt.NDArray[np.complex128]

#: Terms of the series for nodes that are no farther apart than 1/t: 1/22! is below rounding.
TERMS = 20


def of_two(a: complex, b: complex, t: Vector) -> Waves:
    """Return ``(exp(a t) - exp(b t))/(a - b)`` for times `t`, also where ``a = b``."""
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


def of_three(a: complex, b: complex, c: complex, t: Vector) -> Waves:
    """Return the second divided difference of ``exp(z t)`` at nodes `a`, `b`, `c`.

    Where the nodes are close, by the series in complete symmetric polynomials about their
    mean; elsewhere by the quotient over the two that are farthest apart.
    """
    a, b, c = max(((a, b, c), (b, c, a), (c, a, b)), key=lambda nodes: abs(nodes[0] - nodes[2]))
    near = abs(a - c) * t <= 1
    if near.all():
        return _series(a, b, c, t)
    far = (of_two(a, b, t) - of_two(b, c, t)) / (a - c)
    return np.asarray(np.where(near, _series(a, b, c, t), far)) if near.any() else far


def _series(a: complex, b: complex, c: complex, t: Vector) -> Waves:
    mean = (a + b + c) / 3
    a, b, c = a - mean, b - mean, c - mean
    pairs, product = a * b + b * c + c * a, a * b * c
    before, last, now = 0j, 0j, 1 + 0j  # complete symmetric polynomials, degree j - 2 to j
    power = t * t / 2
    total = np.zeros(len(t), dtype=complex)
    for j in range(TERMS):
        total += now * power
        power = power * t / (j + 3)
        before, last, now = last, now, product * before - pairs * last
    return np.asarray(np.exp(mean * t) * total)
