"""Checks of Section 2 on the exact orbit, and of (12) on ``g1``."""

import math

import numpy as np

from nonsmooth.solver.arrays import Vector
from nonsmooth.solver.orbit.quadrature import panels

from ..case import MOST, Case
from ..words import number, percent
from . import Finding

#: Relative rounding error of a few operations in float64.
ROUNDING = 1e-12

#: Samples of a period, for the part of ``g1`` that is not in the span of harmonics.
GRID = 4096


def smooth(case: Case) -> Finding:
    """Check that the exact motion is C1, and that its acceleration jumps at both switches."""
    exact, omega = case.exact, case.belt.omega_n
    after, before = [exact.t1, 0.0], np.nextafter([exact.t1, exact.period], 0)
    x, v, a = (
        getattr(exact, quantity)(after) - getattr(exact, quantity)(before)
        for quantity in ("displacement", "velocity", "acceleration")
    )
    size = ROUNDING * (case.belt.amplitude + case.belt.slip_centre)
    size += 4 * np.spacing(exact.period) * omega * case.belt.amplitude  # times are rounded, too
    continuous = max(*np.abs(x), *np.abs(v / omega)) <= size
    falls = case.belt.largest_jump
    holds = continuous and max(a) <= -falls + size * omega**2
    return Finding(bool(holds), f"the acceleration falls by {number(falls)} m/s² at both")


def never_faster(case: Case) -> Finding:
    """Check that the mass is never faster than the belt."""
    times = np.linspace(0, case.exact.period, 2001)[:-1]
    fastest = float(case.exact.velocity(times).max()) / case.belt.belt_speed
    return Finding(fastest <= 1 + ROUNDING, f"largest velocity {number(fastest)} V")


def friction_drives(case: Case) -> Finding:
    """Check that friction never opposes the belt; in stick it is ``K x``."""
    belt = case.belt
    least = (2 * belt.mu_k - belt.mu_s) * belt.normal_force
    return Finding(least >= 0, f"least friction in stick, K x(0): {number(least)} N")


def centred(case: Case) -> Finding:
    """Check that the mean displacement is ``x_s``."""
    exact, centre = case.exact, case.belt.slip_centre
    part, weights = panels([exact.t1 / exact.period], 4)
    mean = float(weights @ exact.displacement(part * exact.period))
    holds = abs(mean - centre) <= ROUNDING * (case.belt.amplitude + centre)
    return Finding(holds, f"x_s = {number(centre)} m")


def g1(t1: float, T: float, t: Vector, derivative: int) -> Vector:
    """Return ``g1`` of (12) divided by ``T (T - t1)**3``, or its derivative, on ``[0, T]``."""
    u = np.maximum(t - t1, 0.0) / (T - t1)
    if derivative == 0:
        return u * u * (3 - 2 * u) - t / T
    return 6 * u * (1 - u) / (T - t1) - 1 / T


def g1_is_c1(case: Case) -> Finding:
    """Check that ``g1`` and its derivative have no jump."""
    t1, T = case.exact.t1, case.exact.period
    after, before = np.array([t1, 0.0]), np.array([np.nextafter(t1, 0), T])
    jumps = [T**d * (g1(t1, T, after, d) - g1(t1, T, before, d)) for d in (0, 1)]
    steepest = T / (T - t1)
    words = (
        f"its acceleration jumps by {number(6 * steepest**2)} h/T², with h the height it rises "
        "in slip"
    )
    return Finding(bool(np.abs(jumps).max() <= ROUNDING * (1 + steepest)), words)


def in_span_of_harmonics(case: Case) -> Finding:
    """Check that ``g1`` is in the span of its first harmonics, to rounding."""
    t1, T = case.exact.t1, case.exact.period
    harmonics = np.abs(np.fft.rfft(g1(t1, T, np.arange(GRID) * T / GRID, 0)))[1:]
    share = math.sqrt(float(np.sum(harmonics[MOST:] ** 2) / np.sum(harmonics**2)))
    words = f"{percent(share)} of g₁, its mean apart, is left after its first {MOST} harmonics"
    return Finding(share < ROUNDING, words)
