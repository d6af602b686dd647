"""Which way to evaluate keeps more digits, measured; SymPy shows elsewhere that all agree.

Equality of the stable and the printed forms: `test_derivation` (smoothstep, Bessel moments,
Legendre polynomials) and `test_kernels` (the tail of g1, the Gauss rule for (14)).
"""

import math

import mpmath as mp
import numpy as np
import pytest

from nonsmooth.generated.shortcuts import hb, hb_c1

HIGHEST = 4000  # k = 2 N at N = 2000
TIMES = [(0.02, 6.28), (2.0, 6.712), (60.0, 63.21)]


def exact_waves(angle: float) -> tuple[np.ndarray, np.ndarray]:
    """Return cos and sin of k times an angle that is taken as exact, k = 0..HIGHEST."""
    with mp.workdps(30):
        turns = [mp.mpf(angle) * k for k in range(HIGHEST + 1)]
        return np.array([float(mp.cos(x)) for x in turns]), np.array(
            [float(mp.sin(x)) for x in turns]
        )


def direct(angle: float) -> tuple[np.ndarray, np.ndarray]:
    turns = [k * angle for k in range(HIGHEST + 1)]
    return np.array([math.cos(x) for x in turns]), np.array([math.sin(x) for x in turns])


def rotation(angle: float) -> tuple[np.ndarray, np.ndarray]:
    return hb.waves(angle, HIGHEST)


def chebyshev(angle: float) -> tuple[np.ndarray, np.ndarray]:
    c, s = np.empty(HIGHEST + 1), np.empty(HIGHEST + 1)
    c[:2], s[:2] = (1.0, math.cos(angle)), (0.0, math.sin(angle))
    for k in range(1, HIGHEST):
        c[k + 1] = 2 * c[1] * c[k] - c[k - 1]
        s[k + 1] = 2 * c[1] * s[k] - s[k - 1]
    return c, s


def worst(way, angle: float) -> float:
    """Return the largest error of cos and sin over k, as it enters C_k: divided by k."""
    pairs = zip(way(angle), exact_waves(angle), strict=True)
    k = np.maximum(np.arange(HIGHEST + 1), 1)
    return max(float(np.abs((found - expected) / k).max()) for found, expected in pairs)


def test_rotation_beats_direct_evaluation_and_chebyshev_up_to_k_4000() -> None:
    angles = [hb.angle(T, t1) for t1, T in TIMES]
    measured = {
        way: max(worst(way, angle) for angle in angles) for way in (rotation, direct, chebyshev)
    }
    assert measured[rotation] < 1.2e-16
    assert measured[rotation] < measured[direct]
    assert measured[rotation] < measured[chebyshev]


@pytest.mark.parametrize(("t1", "T"), TIMES)
def test_slip_integrals_keep_their_digits_at_k_4000(t1: float, T: float) -> None:
    C, S = hb.slip_integrals(HIGHEST // 2, t1, T)
    with mp.workdps(40):
        w = 2 * mp.pi / mp.mpf(T)
        for k in (1, 2, 7, 100, 1999, HIGHEST):
            turn = k * w * mp.mpf(t1)
            # The angle omega_0 t1 <= 2 pi has a rounding error of its own: t1 to an ulp.
            assert abs(C[0, k] + mp.sin(turn) / (k * w)) < 4e-16 * T
            assert abs(S[0, k] - (mp.cos(turn) - 1) / (k * w)) < 4e-16 * T


def test_bessel_moments_keep_digits_that_powers_and_sines_lose() -> None:
    """Moments of degree 3 at small k omega_0 s: the printed form loses seven powers of z."""
    T, s = 63.2, 0.2
    z = hb_c1.half_angle(T, 1, s)
    with mp.workdps(40):
        x = mp.mpf(z)
        j3 = mp.sqrt(mp.pi / (2 * x)) * mp.besselj(mp.mpf(7) / 2, x)
    stable = hb_c1.spherical_bessel(z, math.cos(z), math.sin(z))[3]
    elementary = hb_c1.spherical_bessel_3(math.cos(z), math.sin(z), z)
    assert stable == pytest.approx(float(j3), rel=1e-15)
    assert abs(elementary / float(j3) - 1) > 1e-3
