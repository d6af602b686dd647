"""Nonlinear forces as users of harmonic balance write them: at all points of time in a period.

A law returns the force beside mass, damper and spring, and its derivatives by displacement
and velocity, at displacements and velocities of one period.  Where the force is a function of
displacement it is the exact law.  Dry friction is smoothed, and a force with memory is followed
through two periods.  A rigid impact has no law of force, and friction on a belt has two values
at rest: nothing here stands for those scenes.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

#: ``law(x, v, harmonics)``: force, derivative by x, derivative by v; (M,), the derivatives (M,)
#: or, where earlier points count, (M, M).
Law = Callable[[np.ndarray, np.ndarray, int], tuple[np.ndarray, np.ndarray, np.ndarray]]


@dataclass(frozen=True)
class Forced:
    """``m x'' + c x' + k x + law = F cos(Omega t)``, SI units."""

    m: float
    c: float
    k: float
    F: float
    Omega: float
    law: Law


def clearance(p: Mapping[str, float]) -> Forced:
    """Return a mass with a spring behind a gap."""

    def law(x, v, harmonics):
        there = x > p["gap"]
        k = p["contact_stiffness"]
        return k * np.where(there, x - p["gap"], 0.0), k * there, 0 * v

    return Forced(p["mass"], p["damping"], p["stiffness"], p["force"], p["frequency"], law)


def backlash(p: Mapping[str, float]) -> Forced:
    """Return a mass with play on both sides."""

    def law(x, v, harmonics):
        near = np.clip(x, -p["gap"], p["gap"])
        inside, outside = p["gap_stiffness"], p["stiffness"]
        slope = np.where(np.abs(x) <= p["gap"], inside, outside)
        return inside * near + outside * (x - near), slope, 0 * v

    return Forced(p["mass"], p["damping"], 0.0, p["force"], p["frequency"], law)


def dry_friction(p: Mapping[str, float]) -> Forced:
    """Return a mass with dry friction, smoothed: as sharp as the harmonics can follow."""
    force = p["mu_k"] * p["normal_force"]

    def law(x, v, harmonics):
        width = np.max(np.abs(v)) / harmonics
        value = np.tanh(v / width)
        return force * value, 0 * x, force * (1 - value**2) / width

    return Forced(p["mass"], p["damping"], p["stiffness"], p["force"], p["frequency"], law)


def elastic_plastic(p: Mapping[str, float]) -> Forced:
    """Return a mass on an element that yields: followed from rest, the second period counts."""
    k, most = p["stiffness"], p["yield_force"]

    def law(x, v, harmonics):
        many = len(x)
        z, slope = 0.0, np.zeros(many)
        force, slopes = np.zeros(many), np.zeros((many, many))
        for i in range(2 * many):
            here, before = i % many, (i - 1) % many
            z += k * (x[here] - x[before])
            if abs(z) < most:
                slope = slope.copy()
                slope[here] += k
                slope[before] -= k
            else:
                z, slope = np.clip(z, -most, most), np.zeros(many)
            force[here], slopes[here] = z, slope
        return force, slopes, 0 * v

    return Forced(p["mass"], p["damping"], p["hardening"], p["force"], p["frequency"], law)


LAWS: dict[str, Callable[[Mapping[str, float]], Forced]] = {
    "clearance": clearance,
    "backlash": backlash,
    "dry-friction": dry_friction,
    "elastic-plastic": elastic_plastic,
}
