"""The motion of Sections 3.1 and 3.2 from its unknowns: series (3), and ``g1`` of (12).

Unknowns ``z``: ``a0, a_1..a_N, b_1..b_N``, for 3.2 the amplitude of the smoothstep form
of ``g1``, then ``t1, T``; dimensionless.  In 3.2 the kernel's coefficients stand beside
the tail of ``g1``; the paper's stand beside ``g1``.
"""

import math
from functools import lru_cache

import numpy as np
from numpy.polynomial import legendre

from ...arrays import Vector
from ...scaling import product_of_powers
from ..orbit.oscillator import StickSlip
from ..search.kernels import functions_for, module

#: Waves that are held at once.
BLOCK = 2_000_000


def series(z: Vector, order: int, t: Vector, derivative: int) -> Vector:
    """Return the Fourier series (3), or its first or second derivative, at times `t`.

    The harmonics are powers of the first one: as exact as sines of multiples, and quicker.
    """
    omega_0 = 2 * math.pi / z[-1]
    a, b = z[1 : order + 1], z[order + 1 : 2 * order + 1]
    rate = (1j * omega_0 * np.arange(1, order + 1)) ** derivative
    # a sin + b cos = Re((b - i a) exp(i n omega_0 t))
    coefficients = rate * (b - 1j * a)
    values = np.full(len(t), z[0] / 2 if derivative == 0 else 0.0)
    block = max(1, BLOCK // order)
    for start in range(0, len(t), block):
        first = np.exp(1j * omega_0 * t[start : start + block])
        waves = np.cumprod(np.broadcast_to(first[:, None], (len(first), order)), axis=1)
        values[start : start + block] += (waves @ coefficients).real
    return values


def smoothstep(t1: float, T: float, t: Vector, derivative: int) -> Vector:
    """Return ``G = g1/(T s**3)`` of (12), ``s = T - t1``, or a derivative, in ``[0, T)``.

    In stick ``-t/T``; in slip ``u**2 (3 - 2 u) - t/T`` with ``u = (t - t1)/s``.
    """
    s = T - t1
    u = np.maximum(t - t1, 0.0) / s
    if derivative == 0:
        return u * u * (3 - 2 * u) - t / T
    if derivative == 1:
        return 6 * u * (1 - u) / s - 1 / T
    return np.where(t < t1, 0.0, (6 - 12 * u) / s**2)


def evaluate_hb(z: Vector, order: int, t: Vector, derivative: int, alpha: float) -> Vector:
    """Return the motion (3) at times `t` in ``[0, T)``."""
    return series(z, order, t, derivative)


def evaluate_hb_c1(z: Vector, order: int, t: Vector, derivative: int, alpha: float) -> Vector:
    """Return the motion (11) at times `t` in ``[0, T)``."""
    beside = series(beside_g1(z, order), order, t, derivative)
    return beside + c1_functions(z, order, t, derivative)


def c1_functions(z: Vector, order: int, t: Vector, derivative: int) -> Vector:
    """Return what is beside the series: ``g1``, and further C1 functions if there are any.

    Function i > 0 has the acceleration ``v (1 - v**2)**i (N + 1)**i`` in slip,
    ``v = 2 u - 1``, in units of its coefficient; its parts are those of the kernel.
    """
    t1, T = z[-2:]
    total = z[2 * order + 1] * smoothstep(t1, T, t, derivative)
    further = z[2 * order + 2 : -2]
    if not len(further):
        return np.asarray(total)
    K, s = len(further) + 1, T - t1
    functions = functions_for("hb-symmetric", order)
    accelerations = functions["accelerations"](K, order)
    displacements = functions["legendre_parts"](K, order, t1, T)[0]
    odd = np.zeros(2 * K + 2)
    odd[1::2] = further @ (accelerations if derivative == 2 else displacements)[1:]
    slope = 2 / s if derivative == 1 else 1.0
    in_slip = slope * legendre.legval(
        2 * (t - t1) / s - 1, legendre.legder(odd) if derivative == 1 else odd
    )
    drift = float(further @ accelerations[1:, 0]) * functions["drift"](T, s)[0]
    in_stick = drift * (t - t1 / 2, np.ones_like(t), np.zeros_like(t))[derivative]
    return np.asarray(total + np.where(t < t1, in_stick, in_slip))


def beside_g1(z: Vector, order: int) -> Vector:
    """Return `z` with the coefficients beside the C1 functions themselves, not their tails."""
    t1, T = float(z[-2]), float(z[-1])
    changed, further = z.copy(), z[2 * order + 2 : -2]
    changed[: 2 * order + 1] -= z[2 * order + 1] * _harmonics_of_g1(order, t1, T)
    if len(further):
        functions, K = functions_for("hb-symmetric", order), len(further) + 1
        moments = functions["slip_moments"](K, order, t1, T)
        gamma = functions["harmonics"](K, order, T, moments)[0, 1:]
        changed[: 2 * order + 1] -= about_stick_start(further @ gamma, 0.0, t1, T)
    return changed


@lru_cache(maxsize=32)
def _harmonics_of_g1(order: int, t1: float, T: float) -> Vector:
    """Return the first harmonics of ``G``; an orbit is evaluated many times.

    About mid-stick they are sines, and ``G`` is ``-6/s**2`` times the first odd C1 function
    but for its mean.
    """
    functions, s = functions_for("hb-symmetric", order), T - t1
    moments = functions["slip_moments"](1, order, t1, T)
    sines = -6 / s**2 * functions["harmonics"](1, order, T, moments)[0, 0]
    mean = module("hb-c1").mean_of_g1(T, s)[0]
    return about_stick_start(sines, float(mean), t1, T)


def about_stick_start(b: Vector, a0: float, t1: float, T: float) -> Vector:
    """Return ``a0, a_1..a_N, b_1..b_N`` about ``t = 0`` for sines about mid-stick.

    ``b sin(n omega_0 (t - t1/2)) = b cos(phi) sin(n omega_0 t) - b sin(phi) cos(n omega_0 t)``
    with ``phi = n omega_0 t1/2``.
    """
    phi = math.pi * t1 / T * np.arange(1, len(b) + 1)
    return np.concatenate(([a0], b * np.cos(phi), -b * np.sin(phi)))


def from_symmetric(z: Vector, order: int) -> Vector:
    """Return the unknowns about ``t = 0`` for those about mid-stick.

    The first C1 function is ``-s**2/6`` times the smoothstep form of ``g1``.

    Parameters
    ----------
    z : ndarray, shape (order + K + 2,)
        ``b_1..b_N``, ``c_1..c_K`` beside the tails, ``t1``, ``T``.

    Returns
    -------
    ndarray, shape (2 order + K + 3,)
        ``a0, a_1..a_N, b_1..b_N``, the amplitude beside the tail of ``g1``, ``c_2..c_K``,
        ``t1, T``.
    """
    t1, T = z[-2:]
    amplitudes = z[order:-2].copy()
    amplitudes[:1] *= -((T - t1) ** 2) / 6
    return np.concatenate([about_stick_start(z[:order], 0.0, t1, T), amplitudes, z[-2:]])


def coefficients_hb(z: Vector, order: int, belt: StickSlip) -> dict[str, object]:
    """Return ``a0``, ``a``, ``b`` of (3) in m."""
    scaled = belt.length_unit * z[: 2 * order + 1]
    return {
        "a0": float(scaled[0] + 2 * belt.slip_centre),
        "a": scaled[1 : order + 1].tolist(),
        "b": scaled[order + 1 :].tolist(),
    }


def coefficients_hb_c1(z: Vector, order: int, belt: StickSlip) -> dict[str, object]:
    """Return ``a0``, ``a``, ``b`` of (11) in m and ``c1`` of the printed ``g1`` in m/s**4.

    With further C1 functions ``c``, in m/s**2: of the accelerations ``v (1 - v**2)**i``,
    ``i = 1, 2, ...``, ``v`` from -1 to 1 in slip.
    """
    t1, T = z[-2:]
    amplitude = float(z[2 * order + 1] / (T * (T - t1) ** 3))
    c1 = product_of_powers(amplitude, (belt.belt_speed, 1), (belt.time_unit, -3))
    further = z[2 * order + 2 : -2] * (order + 1.0) ** np.arange(1, len(z) - 2 * order - 3)
    more = {"c": (belt.acceleration_unit * further).tolist()} if len(further) else {}
    return {**coefficients_hb(beside_g1(z, order), order, belt), "c1": c1, **more}
