"""What rows are made of: tables and motions against quadrature, series, many digits."""

import mpmath
import numpy as np
import pytest
from every_run import tried
from galerkin.by_quadrature import OSCILLATORS
from galerkin.derived import module, pairs
from galerkin.oscillators import case_of
from galerkin.solving import differences
from numpy.polynomial import Polynomial
from numpy.polynomial.legendre import leggauss
from scipy.special import eval_sh_legendre

from nonsmooth.solver.rows.harmonics import (
    harmonic_integrals,
    multiples,
    series_on_phase,
    weighted_integrals,
)
from nonsmooth.solver.rows.moments import legendre_moments, spherical_bessel
from nonsmooth.solver.rows.polynomials import phase_motion

NODES, WEIGHTS = leggauss(60)
NODES, WEIGHTS = (NODES + 1) / 2, WEIGHTS / 2

ARGUMENTS = (0.0, 1e-9, 1e-3, 0.1, 0.5, 0.999999, 1.0, 1.5, 2.3, np.pi, 4.4934, 7.7)
LARGE = (10.0, 29.97, 59.3, 60.0, 61.2, 119.9, 200.0, 299.999)


def bessel(count, x):
    """Return ``j_0, ..., j_(count - 1)`` by the recurrence upwards in 1500 digits."""
    if x == 0:
        return [1.0] + [0.0] * (count - 1)
    with mpmath.workdps(1500):
        x = mpmath.mpf(x)
        found = [mpmath.sin(x) / x, mpmath.sin(x) / x**2 - mpmath.cos(x) / x]
        for n in range(2, count):
            found.append((2 * n - 1) / x * found[-1] - found[-2])
        return [float(value) for value in found[:count]]


def filled(count, x):
    """Return what `spherical_bessel` fills in."""
    found = np.full(count, np.nan)
    spherical_bessel(x, found)
    return found


@pytest.mark.parametrize("x", [*ARGUMENTS, *LARGE, -0.3, -4.4934, -61.2])
def test_spherical_bessel_functions_keep_their_digits(x):
    """Relative beyond the turn, n >= |x|; before it, where zeros are, of the amplitude."""
    expected, got, size = np.array(bessel(61, x)), filled(61, x), abs(x)
    amplitude = np.array([0.0 if n >= size else 1 / max(size, 1) for n in range(61)])
    bound = np.maximum(2e-15 * np.maximum(np.abs(expected), amplitude), 1e-290)
    assert np.all(np.abs(got - expected) <= bound), np.max(np.abs(got - expected) / bound)


@pytest.mark.parametrize("count", [1, 2, 3, 10, 301])
def test_few_and_many_spherical_bessel_functions(count):
    for x in (0.0, 0.3, 1.0, 8.8, 300.0, -0.3, -8.8, -300.0):
        found = filled(count, x)
        np.testing.assert_allclose(found, bessel(count, x), rtol=1e-13, atol=1e-17)


def test_spherical_bessel_functions_of_no_number_are_none():
    assert np.isnan(filled(4, np.nan)).all()


@pytest.mark.parametrize("kappa", [0.0, 1e-6, 0.3, 2.0, 17.0, 55.0, -0.3, -17.0])
def test_legendre_moments_are_integrals(kappa):
    for theta in (0.0, 0.7, -4.0, 9.0):
        wave = np.cos(kappa * NODES + theta)
        expected = [np.sum(WEIGHTS * eval_sh_legendre(l, NODES) * wave) for l in range(12)]
        moments, ahead = np.full((2, 2, 12), np.nan)
        legendre_moments(kappa, theta, moments)
        legendre_moments(kappa, theta + np.pi / 2, ahead)
        got, turned = moments
        np.testing.assert_allclose(turned, ahead[0], rtol=0, atol=1e-14)
        np.testing.assert_allclose(got, expected, rtol=0, atol=1e-14)  # of NumPy's weights


DURATIONS = np.array([0.8, 0.5, 1.1])


def ends_of(durations):
    return tuple(float(t) for t in np.concatenate([[0.0], np.cumsum(durations)]))


def over_cell(durations, integrand):
    """Return the integral over the cell of ``integrand(p, t, u)``."""
    ends = ends_of(durations)
    return sum(
        s * np.sum(WEIGHTS * integrand(p, ends[p] + s * NODES, NODES))
        for p, s in enumerate(durations)
    )


@pytest.mark.parametrize(("power", "turns"), [(0, 1), (1, 1), (2, 1), (2, 2), (0, 2)])
def test_integrals_of_harmonics(power, turns):
    weights, highest = (1.3, -0.4, 0.0), 7

    def table(durations):
        ends, period = ends_of(durations), turns * float(np.sum(durations))
        integrals = harmonic_integrals(ends, period, highest, rates)
        return weighted_integrals(integrals, weights, power, ends, period)

    rates = False
    alone = table(DURATIONS)
    rates = True
    found = table(DURATIONS)
    np.testing.assert_array_equal(alone, found[:, :1])
    omega = 2 * np.pi / (turns * DURATIONS.sum())
    for row, wave in enumerate((np.cos, np.sin)):
        for k in range(-highest, highest + 1):
            expected = omega**power * over_cell(
                DURATIONS, lambda p, t, u, k=k, wave=wave: weights[p] * wave(k * omega * t)
            )
            assert found[row, 0, k] == pytest.approx(expected, abs=1e-13)
    rates = differences(lambda s: table(s)[:, 0], DURATIONS, step=1e-3)
    for q, rate in enumerate(rates):
        np.testing.assert_allclose(found[:, 1 + q], rate, rtol=0, atol=1e-9)


@pytest.mark.parametrize("angle", [0.3, -2.0, 0.0, np.pi / 7, 3.1])
def test_multiples_of_an_angle_keep_their_digits(angle):
    """What is lost is what the angle itself has lost: k roundings of it, at most."""
    cosines, sines = multiples(angle, 801)
    with mpmath.workdps(30):
        for k in (0, 1, 15, 16, 17, 31, 160, 799, 801):
            allowed = 4e-16 + 2e-16 * abs(k * angle)
            assert abs(cosines[k] - mpmath.cos(k * mpmath.mpf(angle))) <= allowed
            assert abs(sines[k] - mpmath.sin(k * mpmath.mpf(angle))) <= allowed
    for few in (0, 1, 15, 16):
        assert [q.tolist() for q in multiples(angle, few)] == [
            cosines[: few + 1].tolist(),
            sines[: few + 1].tolist(),
        ]


def test_a_phase_is_its_acceleration_integrated_twice():
    d, u = np.array([0.3, -1.2, 0.0, 0.7]), np.linspace(0, 1, 9)
    acceleration = sum(
        q * Polynomial(np.poly1d(np.polyfit(u, eval_sh_legendre(l, u), l)).coef[::-1])
        for l, q in enumerate(d)
    )
    s, x, v = 1.7, 0.4, -0.9
    expected = (
        x + s * v * u + s**2 * acceleration.integ(2)(u),
        v + s * acceleration.integ()(u),
        acceleration(u),
    )
    for order, values in enumerate(expected):
        np.testing.assert_allclose(phase_motion(x, v, d, s, u, order), values, atol=1e-13)
    for order, values in enumerate((x + s * v * u, v + 0 * u, 0 * u)):
        np.testing.assert_array_equal(phase_motion(x, v, d[:0], s, u, order), values)


def test_a_series_has_the_velocity_of_its_side_at_the_ends_alone():
    a, b, u = np.array([0.2, 0.1]), np.array([0.5, -0.3]), np.array([0.0, 0.3, 1.0])
    arguments = (a, b, np.array([1, 2]), 1.4, 0.2, 3.0)
    smooth = [series_on_phase(*arguments, 0.0, 0.0, u, order) for order in range(3)]
    turned = [series_on_phase(*arguments, 0.6, -0.8, u, order) for order in range(3)]
    np.testing.assert_array_equal(turned[0], smooth[0])
    np.testing.assert_array_equal(turned[2], smooth[2])
    np.testing.assert_allclose(turned[1] - smooth[1], [0.3, 0.0, 0.4], atol=1e-15)


#: Oscillators, but for one twice and one of dear kernels.
NAMES = [q for q in OSCILLATORS if q not in ("S1n2", "S4a")]

#: Derived for these tests alone; other oscillators have functions of the same kinds.
DEAR = {("S2b", "ck"), ("S2b", "hb_ck_2")}


CASES = [*pairs(NAMES), ("S4a", "ck")]


@pytest.mark.parametrize(
    ("name", "kernel"), tried(CASES, every_run=[pair for pair in CASES if pair not in DEAR])
)
def test_velocity_and_acceleration_are_derivatives_of_the_motion(name, kernel):
    made, case = module(name, kernel), case_of(name)
    z = np.random.default_rng(7).uniform(0.3, 1, made.size(5))
    s = z[len(z) - made.DURATIONS - made.FORCED :]
    for p in range(made.DURATIONS):
        for order in (0, 1):
            slope = differences(
                lambda u, p=p, order=order: made.motion(case, z, p, 0.5 + 0.002 * u, order),
                np.zeros(1),
                step=1.0,
            )[0]
            got = made.motion(case, z, p, np.array([0.5]), order + 1)
            np.testing.assert_allclose(got * s[p], slope / 0.002, rtol=1e-9, atol=1e-9)
    with pytest.raises(IndexError, match="p"):
        made.motion(case, z, made.DURATIONS, np.array([0.5]), 0)
