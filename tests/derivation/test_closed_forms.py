"""Every closed form of the kernels against quadrature of an integrand from the paper.

The kernels are dimensionless: omega_n = 1, x_s = 0.
"""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.polynomial import legendre
from paper import Problem, cosine, one, sine
from scipy.special import spherical_jn

from nonsmooth.generated.shortcuts import c1, hb, hb_c1

# Gauss rules and closed forms agree to rounding of integrands of order one.
CLOSE = {"rel": 1e-11, "abs": 1e-11}

times = st.tuples(st.floats(0.2, 3), st.floats(0.5, 6)).map(
    lambda pair: Problem(pair[0], pair[0] + pair[1])
)
index = st.integers(1, 9)


def tables(problem: Problem, N: int = 9) -> tuple[np.ndarray, np.ndarray]:
    C, S = hb.slip_integrals(N, problem.t1, problem.T)
    return C[0], S[0]


@given(times, st.integers(-18, 18))
def test_tabulated_slip_integrals_are_the_integrals_of_the_harmonics(
    p: Problem, k: int
) -> None:
    C, S = tables(p)
    assert C[k] == pytest.approx(p.slip(cosine(k * p.omega_0)), **CLOSE)
    assert S[k] == pytest.approx(p.slip(sine(k * p.omega_0)), **CLOSE)


def harmonic_entry(p: Problem, wave: str, n: int, test, table: str = "") -> float:
    """Inner product (8) of the residual (4) of one harmonic with a test function."""
    unit = np.eye(n)[n - 1]
    none = np.zeros(n)
    x, acceleration = p.series(0.0, *((unit, none) if wave == "sine" else (none, unit)))
    return p.inner(*p.residual(x, acceleration), test)


@given(times, index, index)
def test_entries_of_5_6_7_are_inner_products_of_the_residual_4(
    p: Problem, n: int, j: int
) -> None:
    C, S = tables(p)
    w = p.omega_0
    diagonal = hb.period_term(p.T, j)[0] if n == j else 0.0
    closed = {
        ("sine", "one"): hb.sine_by_one(S, n),
        ("cosine", "one"): hb.cosine_by_one(C, n),
        ("sine", "sine"): hb.sine_by_sine(C, j, n) + diagonal,
        ("cosine", "sine"): hb.cosine_by_sine(S, j, n),
        ("sine", "cosine"): hb.sine_by_cosine(S, j, n),
        ("cosine", "cosine"): hb.cosine_by_cosine(C, j, n) + diagonal,
    }
    test = {"one": one, "sine": sine(j * w), "cosine": cosine(j * w)}
    for (wave, by), value in closed.items():
        # The acceleration brings a factor (n omega_0)**2 into both sides.
        scale = 1 + (n * w) ** 2 * p.T
        expected = harmonic_entry(p, wave, n, test[by])
        assert value == pytest.approx(expected, abs=1e-12 * scale), (wave, by)


@given(times, index)
def test_entries_of_the_constant_are_inner_products_of_the_residual_4(
    p: Problem, j: int
) -> None:
    C, S = tables(p)
    w = p.omega_0
    x, acceleration = p.series(1.0, np.zeros(1), np.zeros(1))
    residual = p.residual(x, acceleration)
    assert hb.constant_by_one(C) == pytest.approx(p.inner(*residual, one), **CLOSE)
    assert hb.constant_by_sine(S, j) == pytest.approx(p.inner(*residual, sine(j * w)), **CLOSE)
    expected = p.inner(*residual, cosine(j * w))
    assert hb.constant_by_cosine(C, j) == pytest.approx(expected, **CLOSE)


@given(times, index)
def test_velocity_weight_of_10_is_the_velocity_of_a_sine_at_0(p: Problem, n: int) -> None:
    assert hb.velocity_weight(p.T, n)[0] == pytest.approx(n * p.omega_0, rel=1e-14)


def shape(p: Problem) -> float:
    """Return the factor T s**3 between g1 of (12) and its smoothstep form in the kernel."""
    return p.T * (p.T - p.t1) ** 3


@given(times, index)
def test_column_of_c1_is_the_inner_product_13_of_g1(p: Problem, j: int) -> None:
    C, S = hb_c1.slip_integrals(9, p.t1, p.T)
    h = hb_c1.g1_column(9, C, S, p.t1, p.T)[0] * shape(p)
    residual = p.residual(p.g1, p.g1_acceleration)
    w = p.omega_0
    close = {"abs": 1e-10 * shape(p) * (1 + 1 / (p.T - p.t1) ** 2)}
    assert h[0] == pytest.approx(p.inner(*residual, one), **close)
    assert h[j] == pytest.approx(p.inner(*residual, sine(j * w)), **close)
    assert h[9 + j] == pytest.approx(p.inner(*residual, cosine(j * w)), **close)
    close = {"abs": 1e-10 * shape(p) ** 2 * (1 + 1 / (p.T - p.t1) ** 2)}
    assert h[-1] * shape(p) == pytest.approx(p.inner(*residual, p.g1), **close)


@given(times, index)
def test_row_14_of_a_harmonic_is_the_column_of_c1(p: Problem, n: int) -> None:
    C, S = hb_c1.slip_integrals(9, p.t1, p.T)
    h = hb_c1.g1_column(9, C, S, p.t1, p.T)[0] * shape(p)
    scale = 1e-11 * shape(p) * (1 + (n * p.omega_0) ** 2)
    assert h[n] == pytest.approx(harmonic_entry(p, "sine", n, p.g1), abs=scale)
    assert h[9 + n] == pytest.approx(harmonic_entry(p, "cosine", n, p.g1), abs=scale)


@given(times, index)
def test_harmonics_of_g1_are_its_fourier_coefficients(p: Problem, n: int) -> None:
    gamma = hb_c1.harmonics_of_g1(9, p.t1, p.T)[0]
    for position, wave in ((0, one), (n, sine(n * p.omega_0)), (9 + n, cosine(n * p.omega_0))):
        expected = 2 / p.T * p.inner(p.g1, p.g1, wave) / shape(p)
        assert gamma[position] == pytest.approx(expected, abs=1e-12 * (1 + p.T / (p.T - p.t1)))


@given(times, st.floats(0, 1))
def test_pointwise_g1_is_12_as_printed(p: Problem, u: float) -> None:
    t = np.array(p.t1 + u * (p.T - p.t1))
    value, acceleration = hb_c1.g1_in_slip(p.T, p.T - p.t1, float(t), u)
    assert value * shape(p) == pytest.approx(float(p.g1(t)), abs=1e-10 * shape(p))
    expected = float(p.g1_acceleration(t)) / shape(p)
    assert acceleration == pytest.approx(expected, abs=1e-9 * (1 + abs(expected)))
    value, acceleration = hb_c1.g1_in_stick(p.T, u * p.t1)
    assert value * shape(p) == pytest.approx((p.t1 - p.T) ** 3 * u * p.t1, rel=1e-12)
    assert acceleration == 0


@given(st.floats(1e-6, 60))
def test_spherical_bessel_functions_keep_their_digits(z: float) -> None:
    values = hb_c1.spherical_bessel(z, math.cos(z), math.sin(z))
    for l, value in enumerate(values):
        # Beyond the first zero the absolute error counts, as in the integrals.
        expected = spherical_jn(l, z)
        assert value == pytest.approx(expected, rel=4e-14, abs=1e-16)


@settings(max_examples=20)
@given(st.integers(4, 120))
def test_gauss_rule_of_the_kernel_is_numpys(n: int) -> None:
    nodes, weights = hb_c1.gauss_legendre(n)
    expected_nodes, expected_weights = legendre.leggauss(n)
    np.testing.assert_allclose(nodes, expected_nodes, atol=2e-15)
    # The weights at the ends lose digits with 1 - x**2; their absolute error counts.
    np.testing.assert_allclose(weights, expected_weights, atol=1e-14)


def monomial_condition(p: Problem, d: np.ndarray, k: int) -> float:
    """Left side of (18) for a C1 expansion with V = 1, x_0 = -1.3."""
    x, acceleration = p.polynomial(d, 1.0, -1.3)
    _, slip = p.residual(x, acceleration)
    return p.slip(lambda t: slip(t) * (t - p.t1) ** (k + 2) / ((k + 1) * (k + 2)))


def legendre_test_function(k: int) -> np.polynomial.Polynomial:
    """Q_k as a polynomial in u: P_k*(u) integrated twice from 0."""
    x = np.polynomial.Polynomial([-1, 2])
    polynomial = np.polynomial.Polynomial(legendre.leg2poly(np.eye(k + 1)[k]))(x)
    return polynomial.integ(2)


@given(times, st.integers(0, 6), st.lists(st.floats(-1, 1), min_size=7, max_size=7))
def test_row_18_in_legendre_polynomials_combines_the_rows_of_the_paper(
    p: Problem, k: int, parts: list[float]
) -> None:
    s = p.T - p.t1
    z = np.array([*parts, p.t1, p.T])
    R = np.empty(len(z))
    c1.residual(1.3, z, R)
    x = np.polynomial.Polynomial([-1, 2])
    acceleration = np.polynomial.Polynomial(legendre.leg2poly(parts))(x)
    d = acceleration.coef / s ** np.arange(len(acceleration.coef))
    # Q_k = sum of q_i u**(i + 2); row i of the paper has u**(i + 2) s**(i + 2)/((i+1)(i+2)).
    q = legendre_test_function(k).coef[2:]
    combined = sum(
        q_i * (i + 1) * (i + 2) / s ** (i + 2) * monomial_condition(p, d, i) / s
        for i, q_i in enumerate(q)
    )
    scale = np.abs(q).sum() * (10 + np.abs(d * s ** np.arange(len(d))).sum() * (1 + s * s))
    assert R[k] == pytest.approx(combined, abs=1e-12 * scale)


@given(times, st.lists(st.floats(-1, 1), min_size=3, max_size=7))
def test_19_and_20_are_what_one_period_adds(p: Problem, parts: list[float]) -> None:
    s = p.T - p.t1
    z = np.array([*parts, p.t1, p.T])
    R = np.empty(len(z))
    c1.residual(1.3, z, R)
    velocity = legendre.legint(parts, lbnd=-1, scl=0.5)
    displacement = legendre.legint(parts, 2, lbnd=-1, scl=0.5)
    gain = p.T + s * s * legendre.legval(1, displacement)
    assert R[-2] == pytest.approx(gain, abs=1e-12 * (1 + s * s))
    assert R[-1] == pytest.approx(s * legendre.legval(1, velocity), abs=1e-12 * (1 + s))
