"""The equations as the paper prints them, in float64: what the stable forms are held against.

SI units and no scaling; ``g1`` of (12) itself, its integrals as products of powers and
trigonometric functions; the monomials of (15).  The derivation is the same; only the form
differs, and with it the digits.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import sympy as sp
from scipy.linalg import lstsq

from ..codegen.shortcuts.paper import c1, fourier, g1
from ..codegen.shortcuts.paper.c1_legendre import s
from ..codegen.shortcuts.paper.inner_product import FREQUENCY, j
from ..codegen.shortcuts.paper.oscillator import SLIP, T, V, omega_n, t, t1, x_0, x_s
from ..solver.arrays import Matrix, Vector
from ..solver.shortcuts.orbit.oscillator import StickSlip
from ..solver.shortcuts.search import kernels
from ..solver.shortcuts.search.kernels import plain_iteration
from ..solver.shortcuts.search.newton import Outcome, newton
from ..solver.shortcuts.search.start import rough_times

#: Unknowns to left sides and their derivatives.
System = Callable[[Vector], tuple[Vector, Matrix]]


@dataclass(frozen=True)
class Constants:
    """What the printed equations know of an oscillator, in SI units."""

    omega_n: float
    x_s: float
    x_0: float
    V: float

    @classmethod
    def of(cls, belt: StickSlip) -> "Constants":
        """Return the constants of `belt`."""
        x_0 = (2 * belt.mu_k - belt.mu_s) * belt.normal_force / belt.stiffness
        return cls(belt.omega_n, belt.slip_centre, x_0, belt.belt_speed)


def _fourier(N: int, z: Vector, size: int, k: Constants) -> tuple[Vector, Matrix]:
    """Return (5), (6), (7) and, last, (9), (10) of the Fourier series, with derivatives."""
    times = z[-2:]
    omega2 = k.omega_n**2
    hb = kernels.compiled_functions("hb")
    C, S = (omega2 * table for table in hb["slip_integrals"](N, *times))
    D = hb["period_terms"](N, times[1])
    R, J = np.zeros(size), np.zeros((size, size))
    shifted = z[: 2 * N + 1].copy()
    shifted[0] -= 2 * k.x_s  # friction in slip, -mu_k F_N/M, is that of a shifted mean
    hb["fourier_product"](N, shifted, C[0], S[0], D[0], R)
    hb["fourier_matrix"](N, C[0], S[0], D[0], J)
    for row, by_D in ((1, np.zeros(N + 1)), (2, D[1])):
        column = np.zeros(size)
        hb["fourier_product"](N, shifted, C[row], S[row], by_D, column)
        J[:, row - 3] += column
    n = np.arange(1, N + 1)
    rate = 2 * np.pi * n / times[1]
    R[-2] = z[0] / 2 + z[N + 1 : 2 * N + 1].sum() - k.x_0
    R[-1] = rate @ z[1 : N + 1] - k.V
    J[-2, 0], J[-2, N + 1 : 2 * N + 1] = 0.5, 1.0
    J[-1, 1 : N + 1] = rate
    J[-1, -1] = -rate @ z[1 : N + 1] / times[1]
    return R, J


def _with_times(expression: sp.Expr, *arguments: Any) -> Callable[..., list[Any]]:
    """Return value and derivatives by ``t1``, ``T`` of an expression, over arrays."""
    values = [expression, expression.diff(t1), expression.diff(T)]
    function: Callable[..., list[Any]] = sp.lambdify(arguments, values, modules="numpy")
    return function


@cache
def _g1_forms() -> dict[str, Callable[..., list[Any]]]:
    """Integrate (12) as printed, by parts, against each test function."""
    through = SLIP.residual(g1.G1_SLIP) - fourier.forcing()
    tests = {"one": sp.Integer(1), "sine": fourier.TEST["6"], "cosine": fourier.TEST["7"]}
    forms = {}
    for name, test in (tests | {"g1": g1.G1_SLIP}).items():
        integrand = sp.expand(through * test.subs(FREQUENCY))
        forms[name] = _with_times(sp.integrate(integrand, (t, t1, T)), j, omega_n, t1, T)
    return forms


def _hb_c1(N: int, z: Vector, k: Constants) -> tuple[Vector, Matrix]:
    size = 2 * N + 4
    R, J = _fourier(N, z, size, k)
    start, end = z[-2:]
    forms, index = _g1_forms(), np.arange(1, N + 1, dtype=float)
    h = np.empty((3, 2 * N + 2))
    for row in range(3):
        values = {name: form(index, k.omega_n, start, end)[row] for name, form in forms.items()}
        h[row, 0], h[row, -1] = values["one"], values["g1"]
        h[row, 1 : N + 1], h[row, N + 1 : -1] = values["sine"], values["cosine"]
    amplitude, harmonics = z[2 * N + 1], z[: 2 * N + 1].copy()
    harmonics[0] = harmonics[0] / 2 - k.x_s
    for row, target in ((0, R), (1, J[:, -2]), (2, J[:, -1])):
        target[: 2 * N + 1] += h[row, :-1] * amplitude
        target[-3] = h[row, :-1] @ harmonics + h[row, -1] * amplitude
    J[: 2 * N + 2, -3] = h[0]
    J[-3, : 2 * N + 1] = h[0, :-1]
    J[-3, 0] /= 2
    slope = (start - end) ** 3
    R[-1] += slope * amplitude
    J[-1, -3] = slope
    J[-1, -2] += 3 * (start - end) ** 2 * amplitude
    J[-1, -1] -= 3 * (start - end) ** 2 * amplitude
    return R, J


@cache
def _c1_forms() -> list[tuple[Callable[..., list[Any]], Callable[..., list[Any]]]]:
    """Return the factor of ``d_n`` and the rest of (18), (19), (20), in monomials."""
    forms = []
    for condition in c1.conditions():
        entry, load = (
            (condition.weight * part).subs(s, T - t1)
            for part in (condition.entry, condition.load)
        )
        names = (omega_n, V, x_0, x_s)
        forms.append(
            (
                _with_times(entry, c1.n, c1.k, *names, t1, T),
                _with_times(load, c1.k, *names, t1, T),
            )
        )
    return forms


def _c1(N: int, z: Vector, k: Constants) -> tuple[Vector, Matrix]:
    d, times = z[: N + 1], z[-2:]
    given = (k.omega_n, k.V, k.x_0, k.x_s, *times)
    n = np.arange(N + 1, dtype=float)
    R, J = np.zeros(N + 3), np.zeros((N + 3, N + 3))
    rows = (slice(0, N + 1), slice(N + 1, N + 2), slice(N + 2, N + 3))
    for (entry, load), row in zip(_c1_forms(), rows, strict=True):
        index = n[row][:, None] if row.start == 0 else np.zeros((1, 1))
        entries = [np.broadcast_to(e, (len(index), N + 1)) for e in entry(n, index, *given)]
        loads = [np.broadcast_to(e, index.shape)[:, 0] for e in load(index, *given)]
        J[row, : N + 1] = entries[0]
        R[row] = entries[0] @ d + loads[0]
        J[row, -2] = entries[1] @ d + loads[1]
        J[row, -1] = entries[2] @ d + loads[2]
    return R, J


def system(method: str, N: int, belt: StickSlip) -> tuple[System, int]:
    """Return the printed equations of a method at order `N`, and how many they are."""
    k = Constants.of(belt)
    systems: dict[str, tuple[System, int]] = {
        "hb": (lambda z: _fourier(N, z, 2 * N + 3, k), 2 * N + 3),
        "hb-c1": (lambda z: _hb_c1(N, z, k), 2 * N + 4),
        "c1": (lambda z: _c1(N, z, k), N + 3),
    }
    return systems[method]


def solve(
    method: str, N: int, belt: StickSlip, times: tuple[float, float] | None = None
) -> tuple[Outcome, Matrix]:
    """Solve the printed equations by the driver that solves the stable ones.

    Parameters
    ----------
    method, N, belt : str, int, StickSlip
        What to solve.
    times : (float, float), optional
        ``t1`` and ``T`` in s to start from; without them, the rough times of the driver.

    Returns
    -------
    outcome : Outcome
        Unknowns in SI units: ``a0, a_n, b_n`` [and ``c1``] or ``d_n``, then ``t1, T``.
    jacobian : ndarray
        Where the iteration ended.
    """
    evaluate, size = system(method, N, belt)
    with np.errstate(all="ignore"):
        z = np.zeros(size)
        z[-2:] = times or [belt.time_unit * time for time in rough_times(belt.alpha)]
        R, J = evaluate(z)
        if np.isfinite(J).all():
            z[:-2] = lstsq(J[:, :-2], -R, lapack_driver="gelsy")[0]

        def residual(case: None, z: Vector, out: Vector) -> None:
            out[:] = evaluate(z)[0]

        def jacobian(case: None, z: Vector, out: Matrix) -> None:
            out[:] = evaluate(z)[1]

        outcome = newton(plain_iteration(residual, jacobian, compile_algebra=True), None, z)
        return outcome, evaluate(outcome.unknowns)[1]
