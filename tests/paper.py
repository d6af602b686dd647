"""The paper's functions and conditions, typed from the paper, without codegen.

Numbers in any units; integrals by Gauss rules, phase by phase, as (8) splits them.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.polynomial.legendre import leggauss

Function = Callable[[np.ndarray], np.ndarray]

#: The three methods, as the program calls them.
METHODS = ("hb", "hb-c1", "c1")

_X, _W = leggauss(200)


@dataclass(frozen=True)
class Problem:
    """An oscillator and trial times: everything in the integrands but the coefficients."""

    t1: float
    T: float
    omega_n: float = 1.0
    x_s: float = 0.0  # mu_k F_N / K

    @property
    def omega_0(self) -> float:
        return 2 * np.pi / self.T

    def stick(self, f: Function) -> float:
        """Integrate over 0 <= t < t1."""
        return float(self.t1 / 2 * _W @ f(self.t1 / 2 * (1 + _X)))

    def slip(self, f: Function) -> float:
        """Integrate over t1 <= t < T."""
        s = self.T - self.t1
        return float(s / 2 * _W @ f(self.t1 + s / 2 * (1 + _X)))

    def inner(self, stick: Function, slip: Function, test: Function) -> float:
        """Return (8) for a function given by phases."""
        return self.stick(lambda t: stick(t) * test(t)) + self.slip(lambda t: slip(t) * test(t))

    def residual(self, x: Function, acceleration: Function) -> tuple[Function, Function]:
        """Return (1) with (2): in stick the spring term cancels against F_f = K x."""
        omega2 = self.omega_n**2
        return acceleration, lambda t: acceleration(t) + omega2 * x(t) - omega2 * self.x_s

    # Equation (3) and its acceleration.
    def series(self, a0: float, a: np.ndarray, b: np.ndarray) -> tuple[Function, Function]:
        n = np.arange(1, len(a) + 1)
        w = self.omega_0

        def x(t: np.ndarray) -> np.ndarray:
            angle = w * np.multiply.outer(t, n)
            return a0 / 2 + np.sin(angle) @ a + np.cos(angle) @ b

        def acceleration(t: np.ndarray) -> np.ndarray:
            angle = w * np.multiply.outer(t, n)
            return -(np.sin(angle) @ (n**2 * w**2 * a) + np.cos(angle) @ (n**2 * w**2 * b))

        return x, acceleration

    # Equation (12), as printed, and its acceleration.
    def g1(self, t: np.ndarray) -> np.ndarray:
        t1, T = self.t1, self.T
        stick = (t1 - T) ** 3 * t
        slip = -2 * T * t**3 + 3 * T * (t1 + T) * t**2
        slip = slip + (2 * t1**3 - (t1 + T) ** 3) * t - t1**2 * T * (t1 - 3 * T)
        return np.where(t < t1, stick, slip)

    def g1_acceleration(self, t: np.ndarray) -> np.ndarray:
        t1, T = self.t1, self.T
        return np.where(t < t1, 0.0, -12 * T * t + 6 * T * (t1 + T))

    # Equation (16) and (15).
    def polynomial(self, d: np.ndarray, e0: float, e1: float) -> tuple[Function, Function]:
        n = np.arange(len(d))

        def x(t: np.ndarray) -> np.ndarray:
            tau = np.maximum(t - self.t1, 0)
            powers = np.power.outer(tau, n + 2) / ((n + 1) * (n + 2))
            return powers @ d + e0 * t + e1

        def acceleration(t: np.ndarray) -> np.ndarray:
            tau = np.maximum(t - self.t1, 0)
            return np.where(t < self.t1, 0.0, np.power.outer(tau, n) @ d)

        return x, acceleration


def one(t: np.ndarray) -> np.ndarray:
    return np.ones_like(t)


def sine(omega: float) -> Function:
    return lambda t: np.sin(omega * t)


def cosine(omega: float) -> Function:
    return lambda t: np.cos(omega * t)
