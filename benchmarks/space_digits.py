"""The scalar equation of Ritz and forced modes in many digits, for rates below rounding."""

from functools import cache
from typing import Any

import mpmath as mp
import sympy as sp

from nonsmooth.codegen.space import STRUCTURES, forced_modes
from nonsmooth.codegen.space.data import lam

DIGITS = 60


@cache
def _tail(K: int) -> Any:
    return sp.lambdify([lam, *forced_modes.sums(2 * K)], forced_modes.tail(K), "mpmath")


class ManyDigits:
    """A structure at a place `a`, in `DIGITS` digits: errors of its lowest felt mode.

    Parameters
    ----------
    name : str
    a : mpf
    s : mpf
    """

    def __init__(self, name: str, a: Any, s: Any) -> None:
        self.structure, self.a, self.s = STRUCTURES[name], mp.mpf(a), mp.mpf(s)
        self.m, self.j = self.structure.m, self.structure.felt
        self.compliant = self.structure.kind == "compliance"

    def bare(self, n: int) -> Any:
        """Return mu_n."""
        return (n * mp.pi) ** (2 * self.m)

    def felt(self, n: int) -> Any:
        """Return r_n squared; of a compliance, of the displacement."""
        wave, j = n * mp.pi, 0 if self.compliant else self.j
        return 2 * wave ** (2 * j) * (mp.sin if j == 0 else mp.cos)(wave * self.a) ** 2

    def total(self, q: int) -> Any:
        """Return the sum of r_n^2/mu_n^q, by Bernoulli polynomials."""
        j = 0 if self.compliant else self.j
        p = self.m * q - j
        unit = (-1) ** (p + 1) * mp.mpf(2) ** (2 * p) / (2 * mp.factorial(2 * p))
        return unit * (mp.bernpoly(2 * p, 0) - (-1) ** j * mp.bernpoly(2 * p, self.a))

    def eigenvalue(self, N: int, K: int, near: Any) -> Any:
        """Return the lowest felt eigenvalue by N sines and K forced modes."""
        modes = [(self.felt(n), self.bare(n)) for n in range(1, N + 1)]
        left = [
            self.total(q) - mp.fsum(w / mu**q for w, mu in modes) for q in range(1, 2 * K + 2)
        ]

        def equation(value: Any) -> Any:
            if self.compliant:  # K - 1 nodes, and the static answer by itself
                inside = mp.fsum(w / (mu * (mu - value)) for w, mu in modes)
                if K > 1:
                    inside += _tail(K - 1)(value, *left[1 : 2 * K - 1])
                return 1 - self.s * value * (self.total(1) + value * inside)
            G = mp.fsum(w / (mu - value) for w, mu in modes)
            if K:
                G += _tail(K)(value, *left[: 2 * K])
            sign = self.s if self.structure.kind == "stiffness" else -self.s * value
            return 1 + sign * G

        return mp.findroot(equation, (near, near * (1 + mp.mpf(10) ** -6)), verify=False)

    def rate(self, K: int, orders: tuple[int, ...], near: Any) -> float:
        """Return the fitted power of N in the error of the eigenvalue."""
        with mp.workdps(DIGITS):
            exact = self.eigenvalue(600, 3, mp.mpf(near))
            errors = [abs(self.eigenvalue(N, K, exact) / exact - 1) for N in orders]
            x = [mp.log(N) for N in orders]
            y = [mp.log(error) for error in errors]
            mean_x, mean_y = mp.fsum(x) / len(x), mp.fsum(y) / len(y)
            above = mp.fsum((p - mean_x) * (q - mean_y) for p, q in zip(x, y, strict=True))
            return float(above / mp.fsum((p - mean_x) ** 2 for p in x))
