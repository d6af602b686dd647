"""The error measure (22) of a Fourier series of many harmonics, from the harmonics alone.

About mid-stick both accelerations are series of sines; the exact one is
``rho sin(sigma)`` in slip, ``sigma`` the time since mid-slip, and zero in stick.  Sums over
harmonics replace the quadrature of `errors`, whose cost is ``N**2``.  What is subtracted is
of order 1: below about 1e-8 the measure is rounding, as it is for jumps that are misplaced.
"""

import math
from dataclasses import dataclass

import numpy as np

from ...accuracy.quadrature import panels
from ...arrays import Vector
from ..accuracy.quadrature import Shape
from ..orbit import exact
from ..orbit.samples import sines_about_mid_stick
from . import fourier
from .sine_products import from_grid, grid_size, on_grid, symbol


def wave_by_sines(rate: float, t1: float, T: float, N: int) -> Vector:
    """Return the integral over slip of ``sin(rate sigma)`` times each harmonic.

    The harmonics are ``sin(n omega_0 tau)``, and ``tau = sigma + T/2``.
    """
    n = np.arange(1, N + 1)
    omega, half, phi = 2 * math.pi / T, (T - t1) / 2, math.pi * t1 / T
    # (-1)**n sin((n omega -+ rate) half), without the large angle n pi; and where n omega
    # is close to the rate, without the difference.
    sines, cosines = np.sin(n * phi), np.cos(n * phi)
    c, s = math.cos(rate * half), math.sin(rate * half)
    apart = n * omega - rate
    close = np.abs(apart) * half < 1
    minus = (-sines * c - cosines * s) / np.where(close, 1.0, apart)
    minus[close] = ((-1.0) ** n * half * np.sinc(apart * half / math.pi))[close]
    return np.asarray(minus - (-sines * c + cosines * s) / (n * omega + rate))


@dataclass(frozen=True)
class Harmonics:
    """The acceleration of a Fourier series, and of ``g1`` beside it, by harmonics.

    Parameters
    ----------
    t1, T : float
    series : ndarray, shape (order,)
        Coefficients of ``sin(n omega_0 tau)`` beside ``g1`` itself.
    slope : float
        The acceleration of ``g1`` in slip is ``slope sigma``.
    ramp : ndarray, shape (order,)
        Its integral over slip times each harmonic.
    """

    t1: float
    T: float
    series: Vector
    slope: float
    ramp: Vector


def harmonics(z: Vector, order: int, terms: int) -> Harmonics:
    """Return the acceleration of the unknowns `z`, about ``t = 0``, by harmonics.

    terms : int
        C1 functions beside the series, 0 or 1.
    """
    t1, T = float(z[-2]), float(z[-1])
    omega, half, phi = 2 * math.pi / T, (T - t1) / 2, math.pi * t1 / T
    n = np.arange(1, order + 1)
    beside = fourier.beside_g1(z, order) if terms else z
    series = -((n * omega) ** 2) * sines_about_mid_stick(beside, order)
    slope = -12 * float(z[-3]) / (T - t1) ** 3 if terms else 0.0
    # (-1)**n 2 (sin(n omega half)/(n omega)**2 - half cos(n omega half)/(n omega))
    rate = n * omega
    ramp = 2 * slope * (-np.sin(n * phi) / rate**2 - half * np.cos(n * phi) / rate)
    return Harmonics(t1, T, series, slope, ramp)


def normalised_error(found: Harmonics, reference: Shape, theirs: Vector) -> float:
    """Return (22) on normalised time: harmonic on harmonic.

    Parameters
    ----------
    found : Harmonics
    reference : Shape
        The motion to compare with, odd about its own mid-stick.
    theirs : ndarray, shape (order,)
        The sine coefficients of its acceleration.
    """
    T, n = found.T, np.arange(1, len(theirs) + 1)
    ours, g1 = found.series + 2 / T * found.ramp, 2 / T * found.ramp
    shift = found.t1 / T - reference.t1 / reference.T  # of one mid-stick from the other
    apart = 4 * theirs * np.sin(n * math.pi * shift / 2) ** 2

    def squares(own: Vector) -> float:
        return 0.5 * float(np.sum((own - theirs) ** 2 + own * apart))

    # All harmonics of g1'' less the reference, phase by phase; less those up to the order.
    theta, weights = panels([found.t1 / T, reference.t1 / reference.T], 8)
    sigma = theta * T - (found.t1 + T) / 2
    ramp = np.where(theta * T < found.t1, 0.0, found.slope * sigma)
    expected = reference.acceleration(theta * reference.T)
    beyond = float(weights @ (ramp - expected) ** 2) - squares(g1)
    total = (squares(ours) + beyond) / float(weights @ expected**2)
    return math.sqrt(max(total, 0.0))


def spectral_errors(z: Vector, order: int, alpha: float, terms: int) -> tuple[float, float]:
    """Return (22), and (22) with the phases aligned; see `errors.Errors`.

    Parameters
    ----------
    z, order, alpha : ndarray, int, float
        Unknowns about ``t = 0``, dimensionless; harmonics; the oscillator.
    terms : int
        C1 functions beside the series, 0 or 1.
    """
    found, (t1, T) = harmonics(z, order, terms), exact.times(alpha)
    rho = math.hypot(1.0, alpha)
    theirs = 2 / T * rho * wave_by_sines(1.0, t1, T, order)
    reference = Shape(t1, T, lambda t: exact.evaluate(alpha, t, 2))
    return normalised_error(found, reference, theirs), _aligned(found, rho, t1, T)


def _aligned(found: Harmonics, rho: float, exact_t1: float, exact_T: float) -> float:
    """Return (22) with stick on stick, and slip on slip of the exact orbit, stretched."""
    t1, T, series, slope = found.t1, found.T, found.series, found.slope
    s, exact_s, order = T - t1, exact_T - exact_t1, len(series)
    half, rate, points = s / 2, exact_s / s, grid_size(order)
    C, k = np.empty(2 * order + 1), np.arange(1, 2 * order + 1)
    C[0] = s
    C[1:] = -T * np.sin(k * math.pi * t1 / T) / (k * math.pi)
    inside = float(series @ from_grid(symbol(C, points) * on_grid(series, points), order))
    stick = T / 2 * float(series @ series) - inside
    cross = float(series @ (found.ramp - rho * wave_by_sines(rate, t1, T, order)))
    # The integral over slip of (slope sigma - rho sin(rate sigma))**2.
    mixed = 2 * (math.sin(rate * half) / rate**2 - half * math.cos(rate * half) / rate)
    waves = rho**2 * (s - math.sin(rate * s) / rate) / 2
    rest = slope**2 * s**3 / 12 - 2 * slope * rho * mixed + waves
    total = exact_t1 / t1 * stick + exact_s / s * (inside + 2 * cross + rest)
    size = rho**2 * (exact_s - math.sin(exact_s)) / 2
    return math.sqrt(max(total / size, 0.0))
