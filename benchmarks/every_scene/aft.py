"""Harmonic balance with alternating frequency and time (AFT), by hand and by a package.

The unknowns are the Fourier coefficients of the displacement; the nonlinear force is formed at
points of time and transformed back.  By hand: matrices of harmonics at these points, the exact
Jacobian, Newton's method in NumPy.  The package is `harmonicbalance` (PyPI, MIT), where it is
installed: `scipy.optimize.root` with its central differences.  Switching times are not among
the unknowns of either; they are found afterwards, which is not timed.
"""

import contextlib
import importlib.util
import io
import math
from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq

from .laws import LAWS, Forced
from .problem import STATE_OFF, Problem

#: Points of time for each harmonic.
POINTS = 8

LIMIT, SMALL = 40, 1e-12

#: Returns mean, cosines, sines.
Series = Callable[[int], np.ndarray]


def start(which: Problem, forced: Forced, harmonics: int) -> np.ndarray:
    """Return mean and first harmonic of the exact motion, too large, where forcing is cos."""
    many = 64
    turns = 2 * np.pi * (np.arange(many) + 0.5) / many
    t1 = which.exact.angle / forced.Omega
    x = which.exact.displacement(turns / forced.Omega - t1)
    found = np.zeros(2 * harmonics + 1)
    found[0] = x.mean()
    found[1], found[1 + harmonics] = (2 * np.mean(x * f(turns)) for f in (np.cos, np.sin))
    return STATE_OFF * found


def by_hand(which: Problem) -> Series | None:
    """Return ``solve(harmonics)``, or None where no law of force stands for the scene."""
    if which.name not in LAWS:
        return None
    forced = LAWS[which.name](which.case.values)
    m, c, k, Omega = forced.m, forced.c, forced.k, forced.Omega

    def solve(harmonics: int) -> np.ndarray:
        many, n = POINTS * harmonics, np.arange(1, harmonics + 1)
        angles = np.outer(2 * np.pi * np.arange(many) / many, n)
        E = np.hstack([np.ones((many, 1)), np.cos(angles), np.sin(angles)])
        zero = np.zeros((many, 1))
        D = np.hstack([zero, -n * Omega * np.sin(angles), n * Omega * np.cos(angles)])
        back = E.T * (2 / many)
        back[0] /= 2
        L = np.zeros((2 * harmonics + 1, 2 * harmonics + 1))
        L[0, 0] = k
        i, j = n, n + harmonics
        L[i, i] = L[j, j] = k - m * (n * Omega) ** 2
        L[i, j], L[j, i] = c * n * Omega, -c * n * Omega
        X = start(which, forced, harmonics)
        for _ in range(LIMIT):
            x = E @ X
            f, by_x, by_v = forced.law(x, D @ X, harmonics)
            R = L @ X + back @ f
            R[1] -= forced.F
            slope = by_x @ E if by_x.ndim == 2 else by_x[:, None] * E
            J = L + back @ (slope + by_v[:, None] * D)
            step = np.linalg.solve(J, -R)
            X = X + step
            if np.max(np.abs(step)) < SMALL * np.max(np.abs(X)):
                return X
        return np.full(len(X), np.nan)

    return solve


def by_package(which: Problem) -> Series | None:
    """Return ``solve(harmonics)`` by `harmonicbalance`, or None where it cannot be had."""
    if which.name not in LAWS or not importlib.util.find_spec("harmonicbalance"):
        return None
    from harmonicbalance.fourier import Fourier
    from harmonicbalance.solvers import fouriersolve

    forced = LAWS[which.name](which.case.values)

    def solve(harmonics: int) -> np.ndarray:
        def residual(X):
            v = X.dt()
            # its derivative belongs to a cos - b sin, its transform to a cos + b sin: time runs
            # backward there, which a force with memory must not
            speeds = v._to_time_domain()[::-1]
            force = X.nonlinearity(lambda x: forced.law(x[::-1], speeds, harmonics)[0][::-1])
            push = np.zeros(harmonics)
            push[0] = forced.F
            outer = Fourier(0.0, push, np.zeros(harmonics), forced.Omega, harmonics)
            return forced.m * v.dt() + forced.c * v + forced.k * X + force - outer

        given = start(which, forced, harmonics)
        cosines, sines = np.split(given[1:], 2)
        first = Fourier(given[0], cosines, -sines, forced.Omega, harmonics)
        with contextlib.redirect_stdout(io.StringIO()):  # it prints its time
            found, how = fouriersolve(residual, first, method="hybr")
        if not how.success:
            return np.full(2 * harmonics + 1, np.nan)
        return np.hstack([found.coeff_dc, found.coeffs_cos, -found.coeffs_sin])

    return solve


def switching_times(which: Problem, X: np.ndarray) -> np.ndarray:
    """Return the times of a series: where the events vanish next to the exact ones."""
    cell, length = which.case.cell, which.case.units.length
    count, n = len(cell.phases), np.arange(1, len(X) // 2 + 1)
    a, b = np.split(X[1:], 2)
    if not np.isfinite(X).all():
        return np.full(count + 1, np.nan)

    def motion(t: float) -> tuple[float, float]:
        """Return displacement and velocity, all without units."""
        C, S = np.cos(n * cell.omega * t), np.sin(n * cell.omega * t)
        x, v = X[0] + a @ C + b @ S, (b @ (n * C) - a @ (n * S)) * cell.omega
        return float(x / length), float(v / length)

    def zero(form, near: float, memory: float) -> float:
        ex, ev, ec, e0, *em = form

        def event(t: float) -> float:
            x, v = motion(t)
            return ex * x + ev * v + ec * math.cos(cell.omega * t) + e0 + sum(em) * memory

        for part in (0.01, 0.03, 0.1, 0.3):
            off = part * float(which.times[:count].min())
            if event(near - off) * event(near + off) < 0:
                return float(brentq(event, near - off, near + off, xtol=1e-15))
        return math.nan

    switches = which.times[-1] / cell.omega + np.cumsum([0, *which.times[:count]])
    forms = [cell.carrying(p).event for p in range(count)]
    *linear, constant = forms[-1][:4]  # of the cell before, which may be the mirror image
    start = zero((*(cell.sign * q for q in linear), constant), switches[0], 0.0)
    memory = motion(start)[0] if cell.memory and math.isfinite(start) else 0.0
    ends = [zero(form, at, memory) for form, at in zip(forms, switches[1:], strict=True)]
    return np.array([*np.diff([start, *ends]), cell.omega * start])
