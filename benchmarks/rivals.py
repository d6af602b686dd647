"""What a user would otherwise write for this oscillator, written as well as our own code.

Each rival is a factory: ``make(setting)`` returns ``period(alpha)``, dimensionless.  Those
that numba compiles are compiled functions, so that a compiled loop can call them.
"""

import math
from collections.abc import Callable

import numba
import numpy as np
from scipy.integrate import solve_bvp, solve_ivp
from scipy.optimize import fsolve

Period = Callable[[float], float]


@numba.njit
def _rates(y: float, v: float) -> tuple[float, float]:
    """Return the right side of the equation of motion in slip."""
    return v, -y


@numba.njit
def _rk4_step(y: float, v: float, h: float) -> tuple[float, float]:
    """Return the state one step of classical RK4 ahead."""
    k1, l1 = _rates(y, v)
    k2, l2 = _rates(y + h / 2 * k1, v + h / 2 * l1)
    k3, l3 = _rates(y + h / 2 * k2, v + h / 2 * l2)
    k4, l4 = _rates(y + h * k3, v + h * l3)
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), v + h / 6 * (l1 + 2 * l2 + 2 * l3 + l4)


@numba.njit
def _power_step(y: float, v: float, h: float) -> tuple[float, float]:
    """Return the same for this linear system, its four stages multiplied out by hand."""
    c = 1 - h * h / 2 + h**4 / 24
    s = h - h**3 / 6
    return c * y + s * v, c * v - s * y


def _with_event(step: Callable[..., tuple[float, float]]) -> Callable[[int], Period]:
    """Return a factory: fixed steps through slip, the end by Newton on the last step."""

    def make(steps: int) -> Period:
        h = 2 * math.pi / steps

        @numba.njit
        def period(alpha: float) -> float:
            y, v = step(alpha, 1.0, h)
            t = h
            while True:
                ahead_y, ahead_v = step(y, v, h)
                if v < 1.0 <= ahead_v:
                    break
                y, v = ahead_y, ahead_v
                t += h
            part = h * (1.0 - v) / (ahead_v - v)
            for _ in range(3):
                end_y, end_v = step(y, v, part)
                part -= (end_v - 1.0) / -end_y
            return 2 * alpha + t + part

        return period

    return make


#: Fixed-step RK4 with event location, for any right side; `steps` in a natural period.
rk4_with_event = _with_event(_rk4_step)

#: The same for this one linear right side: nearer to the closed form than to a method.
linear_rk4_with_event = _with_event(_power_step)


def _chebyshev(nodes: int) -> tuple[np.ndarray, np.ndarray]:
    """Return Chebyshev points on (0, 1) and the differentiation matrix."""
    n = nodes - 1
    x = np.cos(np.pi * np.arange(n + 1) / n)[::-1]
    c = np.ones(n + 1)
    c[[0, -1]] = 2
    c *= (-1.0) ** np.arange(n + 1)
    gaps = x[:, None] - x + np.eye(n + 1)
    D = np.outer(c, 1 / c) / gaps
    D -= np.diag(D.sum(axis=1))
    return (1 + x) / 2, 2 * D


def collocation(nodes: int) -> Period:
    """Chebyshev collocation of the slip phase, with its duration, by Newton in numba."""
    x, D = _chebyshev(nodes)
    D2 = D @ D

    @numba.njit
    def period(alpha: float) -> float:
        n = nodes
        s = math.pi + 2 / (alpha + 2 / math.pi)
        J = np.zeros((n + 1, n + 1))
        R = np.zeros(n + 1)
        y = alpha * np.cos(s * x) + np.sin(s * x)
        for _ in range(20):
            for i in range(1, n - 1):
                total = s * s * y[i]
                for k in range(n):
                    total += D2[i, k] * y[k]
                    J[i, k] = D2[i, k]
                J[i, i] += s * s
                J[i, n] = 2 * s * y[i]
                R[i] = total
            R[0] = y[0] - alpha
            J[0, :] = 0.0
            J[0, 0] = 1.0
            first = last = 0.0
            for k in range(n):
                first += D[0, k] * y[k]
                last += D[n - 1, k] * y[k]
                J[n - 1, k] = D[0, k]
                J[n, k] = D[n - 1, k]
            R[n - 1], R[n] = first - s, last - s
            J[n - 1, n] = J[n, n] = -1.0
            step = np.linalg.solve(J, R)
            for k in range(n):
                y[k] -= step[k]
            s -= step[n]
            if abs(step[n]) < 1e-9 * s:
                break
        return 2 * alpha + s

    return period


def dop853(tolerance: float) -> Period:
    """`solve_ivp` with DOP853 and a terminal event."""

    def back(t: float, state: np.ndarray) -> float:
        return float(state[1] - 1.0)

    back.terminal, back.direction = True, 1  # type: ignore[attr-defined]

    def period(alpha: float) -> float:
        run = solve_ivp(
            lambda t, state: (state[1], -state[0]),
            (0, 7),
            (alpha, 1.0 - 1e-15),
            method="DOP853",
            events=back,
            rtol=tolerance,
            atol=tolerance,
            max_step=0.4,
        )
        return 2 * alpha + float(run.t_events[0][-1])

    return period


def bvp_two_segments(tolerance: float) -> Period:
    """`solve_bvp` on stick and slip side by side, both mapped to (0, 1), times unknown."""

    def period(alpha: float) -> float:
        def rates(u: np.ndarray, z: np.ndarray, p: np.ndarray) -> np.ndarray:
            t1, s = p
            return np.array([t1 * z[1], 0 * z[1], s * z[3], -s * z[2]])

        def ends(a: np.ndarray, b: np.ndarray, p: np.ndarray) -> np.ndarray:
            return np.array(
                [a[0] + alpha, a[1] - 1, b[0] - alpha, a[2] - b[0], a[3] - b[1], b[3] - 1]
            )

        u = np.linspace(0, 1, 12)
        s = math.pi + 2 / (alpha + 2 / math.pi)
        slip = alpha * np.cos(s * u) + np.sin(s * u)
        start = np.array([2 * alpha * u - alpha, 1 + 0 * u, slip, np.gradient(slip, s * u)])
        found = solve_bvp(rates, ends, u, start, p=[2 * alpha, s], tol=tolerance)
        return float(found.p.sum())

    return period


def quadrature_and_fsolve(order: int) -> Period:
    """Section 3.3, integrals by Gauss and equations by `fsolve`, in monomials of u."""
    x, w = np.polynomial.legendre.leggauss(order + 8)
    u, w = (x + 1) / 2, w / 2
    n = np.arange(order + 1)
    powers = u[:, None] ** n
    twice = powers * (u**2)[:, None] / ((n + 1) * (n + 2))

    def period(alpha: float) -> float:
        def conditions(z: np.ndarray) -> np.ndarray:
            d, t1, s = z[:-2], z[-2], z[-1]
            residual = powers @ d + s * s * (twice @ d) - alpha + t1 + s * u
            closure = s * s * (d / ((n + 1) * (n + 2))).sum() + t1 + s, s * (d / (n + 1)).sum()
            return np.concatenate([(residual * w) @ twice, closure])

        # The start that our own solver has: rough times, and what is linear solved for them.
        start = np.zeros(order + 3)
        start[-2:] = 2 * alpha, math.pi + 2 / (alpha + 2 / math.pi)
        load = conditions(start)
        columns = np.array([conditions(start + unit) - load for unit in np.eye(order + 3)[:-2]])
        start[:-2] = np.linalg.lstsq(columns.T, -load, rcond=None)[0]
        found = fsolve(conditions, start, xtol=1e-13)
        return float(found[-2] + found[-1])

    return period
