"""The error measure (22) of a Fourier series of many harmonics, from the harmonics alone.

About mid-stick both accelerations are series of sines; the exact one is
``rho sin(sigma)`` in slip, ``sigma`` the time since mid-slip, and zero in stick.  Sums over
harmonics replace the quadrature of `errors`, whose cost is ``N**2``.  What is subtracted is
of order 1: below about 1e-8 the measure is rounding, as it is for jumps that are misplaced.
"""

import math

import numpy as np

from . import exact, fourier
from .arrays import Vector
from .quadrature import panels
from .samples import sines_about_mid_stick
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


def spectral_errors(z: Vector, order: int, alpha: float, terms: int) -> tuple[float, float]:
    """Return (22), and (22) with the phases aligned; see `errors.Errors`.

    Parameters
    ----------
    z, order, alpha : ndarray, int, float
        Unknowns about ``t = 0``, dimensionless; harmonics; the oscillator.
    terms : int
        C1 functions beside the series, 0 or 1.
    """
    t1, T = z[-2:]
    exact_t1, exact_T = exact.times(alpha)
    s, exact_s = T - t1, exact_T - exact_t1
    rho = math.hypot(1.0, alpha)
    omega, n = 2 * math.pi / T, np.arange(1, order + 1)
    beside = fourier.beside_g1(z, order) if terms else z
    series = -((n * omega) ** 2) * sines_about_mid_stick(beside, order)
    amplitude = -12 * z[-3] / s**3 if terms else 0.0  # g1'' = amplitude sigma, in slip
    ramp = amplitude * _ramp_by_sines(t1, T, order)
    size = rho**2 * (exact_s - math.sin(exact_s)) / 2

    def slip_squares(rate: float, height: float) -> float:
        """Return the integral over slip of ``(amplitude sigma - height sin(..))**2``."""
        h = s / 2
        mixed = 2 * (math.sin(rate * h) / rate**2 - h * math.cos(rate * h) / rate)
        squares = height**2 * (s - math.sin(rate * s) / rate) / 2
        return float(amplitude**2 * s**3 / 12 - 2 * amplitude * height * mixed + squares)

    # Phase on phase: slip of the exact orbit stretched to this one.
    rate = exact_s / s
    points = grid_size(order)
    C = np.empty(2 * order + 1)
    C[0], k = s, np.arange(1, 2 * order + 1)
    C[1:] = -2 * np.sin(k * math.pi * t1 / T) / (k * omega)
    inside = float(series @ from_grid(symbol(C, points) * on_grid(series, points), order))
    stick = T / 2 * float(series @ series) - inside
    cross = float(series @ (ramp - rho * wave_by_sines(rate, t1, T, order)))
    slip = inside + 2 * cross + slip_squares(rate, rho)
    aligned = exact_t1 / t1 * stick + exact_s / s * slip

    # On normalised time: harmonic on harmonic, the phases of the harmonics apart.
    ours = series + 2 / T * ramp
    theirs = 2 / exact_T * rho * wave_by_sines(1.0, exact_t1, exact_T, order)
    apart = np.sin(n * math.pi * (t1 / T - exact_t1 / exact_T) / 2)
    low = 0.5 * float(np.sum((ours - theirs) ** 2 + 4 * ours * theirs * apart**2))
    beyond = _beyond(z, alpha, amplitude) - 0.5 * float(
        np.sum((2 / T * ramp - theirs) ** 2 + 8 / T * ramp * theirs * apart**2)
    )
    normalised = (low + beyond) / (size / exact_T)
    return math.sqrt(max(normalised, 0.0)), math.sqrt(max(aligned / size, 0.0))


def _ramp_by_sines(t1: float, T: float, N: int) -> Vector:
    """Return the integral over slip of ``sigma`` times each harmonic."""
    n = np.arange(1, N + 1)
    omega, half, phi = 2 * math.pi / T, (T - t1) / 2, math.pi * t1 / T
    rate = n * omega
    # (-1)**n 2 (sin(rate half)/rate**2 - half cos(rate half)/rate)
    return np.asarray(2 * (-np.sin(n * phi) / rate**2 - half * np.cos(n * phi) / rate))


def _beyond(z: Vector, alpha: float, amplitude: float) -> float:
    """Return the mean square of ``g1''`` less the exact acceleration, on normalised time."""
    t1, T = z[-2:]
    exact_t1, exact_T = exact.times(alpha)
    theta, weights = panels([t1 / T, exact_t1 / exact_T], 8)
    sigma = theta * T - (t1 + T) / 2
    ours = np.where(theta * T < t1, 0.0, amplitude * sigma)
    difference = ours - exact.evaluate(alpha, theta * exact_T, 2)
    return float(weights @ difference**2)
