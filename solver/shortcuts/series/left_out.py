"""What the tail of ``g_1`` meets beyond ``N`` harmonics: (14) for very many of them.

The harmonics of ``g_1`` fall off like ``m**-3``; with ``phi = omega_0 t1/2``,
``psi = pi - phi`` and ``G = 2 s/(T omega_0**2)``

    gamma_m = G (sin(m phi)/(psi**2 m**4) + cos(m phi)/(psi m**3)),

and everything that (14) needs is a sum over ``m > N`` of their products with waves and
powers of ``m``.  As differences of closed forms these sums lose ``N**3`` roundings.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...arrays import Vector
from .sine_products import from_grid, grid_size, on_grid, symbol
from .tail_sums import tail_sums

#: Harmonics in slip for which the tail is odd enough, and most that are multiplied out.
RESOLVED, LARGEST_FACTOR = 1e4, 64

#: Functions of the kernel, by name.
Functions = Mapping[str, Any]

#: Below this part of N the coefficients of (14) are a power series in ``n/N``.
LOW = 1 / 2
TERMS = 52


@dataclass(frozen=True)
class LeftOut:
    """Sums over ``m > N`` of the harmonics of ``g_1``.

    Parameters
    ----------
    by_tail : float
        Coefficient of ``c_1`` in (14): the tail through (1), tested by itself.
    by_sine : ndarray
        Coefficients of ``b_1, b_2, ...`` in (14), as many as are below ``N/2``.
    """

    by_tail: float
    by_sine: Vector


class _Sums:
    """Sums over ``m > N`` of products of the harmonics with waves and powers."""

    def __init__(self, N: int, t1: float, T: float) -> None:
        self.omega, s = 2 * math.pi / T, T - t1
        self.phi, self.psi = math.pi * t1 / T, math.pi * s / T
        # exp(2 i m phi) = exp(-2 i m psi): the smaller angle is the exact one.
        angle = 2 * self.phi if self.phi < self.psi else -2 * self.psi
        self.wave = tail_sums(N, angle, TERMS + 6)
        self.zeta = tail_sums(N, 0.0, TERMS + 6).real
        self.G = 2 * s / (T * self.omega**2)

    def products(self, p: int) -> tuple[float, float, float]:
        """Return the sums of sin sin, sin cos, cos cos of ``m phi`` over ``m**p``."""
        wave, zeta = self.wave[p], self.zeta[p]
        return (zeta - wave.real) / 2, wave.imag / 2, (zeta + wave.real) / 2

    def energy(self, p: int) -> float:
        """Return the sum of ``(m**3 gamma_m)**2/m**p``."""
        total = self.products(p + 2)[0] / self.psi**4
        total += 2 * self.products(p + 1)[1] / self.psi**3
        total += self.products(p)[2] / self.psi**2
        return float(self.G**2 * total)

    def by_sine(self, n: Vector) -> Vector:
        """Return the integral over slip of the tail times ``sin(n omega_0 tau)``, n << N."""
        even, odd = np.zeros(len(n)), np.zeros(len(n))
        for i in range(TERMS - 1, -1, -1):
            sin_sin, sin_cos, _ = self.products(i + 5)
            _, low_sin_cos, cos_cos = self.products(i + 4)
            even *= n
            odd *= n
            if i % 2 == 0:
                even += sin_cos / self.psi**2 + cos_cos / self.psi
            else:
                odd += sin_sin / self.psi**2 + low_sin_cos / self.psi
        waves = np.sin(n * self.phi) * even - np.cos(n * self.phi) * odd
        return np.asarray(2 * self.G / self.omega * waves)


def tail_squared(functions: Functions, N: int, t1: float, T: float) -> float:
    """Return the integral over slip of the tail of ``g_1`` squared.

    About the end of stick the tail is odd, but for a part of ``1/N``: slip has half of what
    the period has.  That is taken for what is beyond ``B N`` harmonics; those between are
    multiplied out, with each other and, up to half of ``B N``, with those beyond.
    """
    resolved = N * (1 - t1 / T)
    more = N * min(LARGEST_FACTOR, math.ceil((RESOLVED / resolved) ** (2 / 3)))
    sums = _Sums(more, t1, T)
    beyond = T / 4 * sums.energy(6)
    if more == N:
        return beyond
    points = grid_size(more)
    _, sines = functions["stick_waves"](more, t1, T)
    C = functions["slip_cosines"](more, t1, T, sines)[2 * more :]
    gamma = functions["harmonics"](1, more, T, functions["slip_moments"](1, more, t1, T))[0, 0]
    gamma[:N] = 0.0
    product = from_grid(symbol(C, points) * on_grid(gamma, points), more)
    n = np.arange(N + 1.0, int(LOW * more) + 1)
    across = gamma[N : N + len(n)] @ sums.by_sine(n)
    return float(gamma @ product + 2 * across) + beyond


def left_out(functions: Functions, N: int, t1: float, T: float) -> LeftOut:
    """Return the sums for `N` harmonics; `t1`, `T` dimensionless."""
    sums = _Sums(N, t1, T)
    n = np.arange(1.0, int(LOW * N) + 1)
    acceleration = -(sums.omega**2) * T / 2 * sums.energy(4)
    return LeftOut(acceleration + tail_squared(functions, N, t1, T), sums.by_sine(n))
