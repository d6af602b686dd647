"""Checks of Section 2 on the exact orbit, and of (12) on ``g1``."""

import math

import numpy as np

from nonsmooth.solver.accuracy.quadrature import panels
from nonsmooth.solver.shortcuts.orbit import exact
from nonsmooth.solver.shortcuts.series.fourier import smoothstep

from ..case import MOST, Case
from ..finding import Finding
from ..words import number, percent

#: What is left of zero after a handful of operations in float64.
ROUNDING = 1e-12

#: Samples of a period, for the part of ``g1`` that its harmonics leave.
GRID = 4096


def _jumps(alpha: float, derivative: int) -> list[float]:
    """Return by how much the exact motion jumps at the end of stick and of slip."""
    t1, T = exact.times(alpha)
    before = exact.evaluate(alpha, np.nextafter([t1, T], 0), derivative)
    return list(exact.evaluate(alpha, np.array([t1, 0.0]), derivative) - before)


def smooth(case: Case) -> Finding:
    """Return whether the exact motion is C1 and no smoother."""
    x, v, a = (_jumps(case.alpha, derivative) for derivative in (0, 1, 2))
    size = ROUNDING * (1 + case.alpha)
    falls = case.belt.acceleration_unit * case.alpha
    holds = max(map(abs, x + v)) <= size and max(a) <= -case.alpha + size
    return Finding(holds, f"the acceleration falls by {number(falls)} m/s² at both")


def never_faster(case: Case) -> Finding:
    """Return whether the mass is never faster than the belt."""
    t = np.linspace(0, exact.times(case.alpha)[1], 2001)[:-1]
    fastest = float(exact.evaluate(case.alpha, t, 1).max())
    return Finding(fastest <= 1 + ROUNDING, f"largest velocity {number(fastest)} V")


def friction_drives(case: Case) -> Finding:
    """Return whether friction is never against the belt; in stick it is ``K x``."""
    belt = case.belt
    least = (2 * belt.mu_k - belt.mu_s) * belt.normal_force
    return Finding(least >= 0, f"least friction in stick, K x(0): {number(least)} N")


def centred(case: Case) -> Finding:
    """Return whether the mean displacement is ``x_s``."""
    t1, T = exact.times(case.alpha)
    theta, weights = panels([t1 / T], 4)
    mean = float(weights @ exact.evaluate(case.alpha, theta * T, 0))
    words = f"x_s = {number(case.belt.slip_centre)} m"
    return Finding(abs(mean) <= ROUNDING * (1 + case.alpha), words)


def g1_is_c1(case: Case) -> Finding:
    """Return whether ``g1`` and its derivative have no jump."""
    t1, T = exact.times(case.alpha)
    before = np.nextafter([t1, T], 0)
    gaps = [
        np.abs(smoothstep(t1, T, np.array([t1, 0.0]), d) - smoothstep(t1, T, before, d)).max()
        for d in (0, 1)
    ]
    jump = 6 * (T / (T - t1)) ** 2
    words = f"its acceleration jumps by {number(jump)} h/T², with h the height it rises in slip"
    return Finding(max(gaps) <= ROUNDING * (1 + 1 / (T - t1)), words)


def in_span_of_harmonics(case: Case) -> Finding:
    """Return whether its first harmonics leave nothing of ``g1``."""
    t1, T = exact.times(case.alpha)
    g1 = smoothstep(t1, T, np.arange(GRID) * T / GRID, 0)
    harmonics = np.abs(np.fft.rfft(g1))[1:]
    left = math.sqrt(float(np.sum(harmonics[MOST:] ** 2) / np.sum(harmonics**2)))
    words = f"{percent(left)} of g₁, its mean apart, is left after its first {MOST} harmonics"
    return Finding(left < ROUNDING, words)
