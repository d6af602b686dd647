"""The motion of 3.1 or 3.2 on a grid over the period, by fast transforms.

The orbit is odd about mid-stick: sines of the time since then, half of a period, and the
first C1 function in closed form.
"""

import math

import numpy as np
import scipy  # its parts are loaded where they are used

from ...arrays import Vector
from ..series import fourier
from ..series.sine_products import on_grid

#: Points in half of a period: at least, and for each harmonic.
FEWEST, PER_HARMONIC = 256, 4


def sines_about_mid_stick(z: Vector, order: int) -> Vector:
    """Return ``b_n`` of ``sin(n omega_0 (t - t1/2))`` for the unknowns about ``t = 0``."""
    phi = math.pi * z[-2] / z[-1] * np.arange(1, order + 1)
    a, b = z[1 : order + 1], z[order + 1 : 2 * order + 1]
    return np.asarray(a * np.cos(phi) - b * np.sin(phi))


def samples(z: Vector, order: int, terms: int) -> tuple[Vector, Vector, Vector]:
    """Return times since mid-stick, displacement and velocity on half of a period.

    Parameters
    ----------
    z : ndarray
        Unknowns about ``t = 0``, dimensionless; see `fourier`.
    terms : int
        C1 functions beside the series.

    Returns
    -------
    tau, displacement, velocity : ndarray
        ``tau`` from 0 to ``T/2``, ends not included.
    """
    t1, T = z[-2:]
    points = scipy.fft.next_fast_len(max(FEWEST, PER_HARMONIC * order), real=True) - 1
    tau = T / 2 * np.arange(1, points + 1) / (points + 1)
    beside = fourier.beside_g1(z, order) if terms else z
    b = sines_about_mid_stick(beside, order)
    rates = np.zeros(points + 2)
    rates[1 : order + 1] = b * (2 * math.pi / T) * np.arange(1, order + 1)
    displacement = beside[0] / 2 + on_grid(b, points) / 2
    velocity = scipy.fft.dct(rates, type=1)[1:-1] / 2
    if terms:
        t = tau + t1 / 2
        displacement += fourier.c1_functions(z, order, t, 0)
        velocity += fourier.c1_functions(z, order, t, 1)
    return tau, displacement, velocity
