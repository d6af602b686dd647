"""Very many harmonics: products, sums beyond them, and the orbit of the dense equations."""

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.solver.shortcuts.accuracy.errors import (
    acceleration_error,
    aligned_acceleration_error,
)
from nonsmooth.solver.shortcuts.orbit import exact
from nonsmooth.solver.shortcuts.orbit.admissible import violations
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
from nonsmooth.solver.shortcuts.orbit.samples import samples
from nonsmooth.solver.shortcuts.search import kernels, search
from nonsmooth.solver.shortcuts.search.newton import newton
from nonsmooth.solver.shortcuts.search.start import cubic_slip, rough_times
from nonsmooth.solver.shortcuts.series import newton_krylov
from nonsmooth.solver.shortcuts.series.left_out import left_out
from nonsmooth.solver.shortcuts.series.matrix_free import Problem
from nonsmooth.solver.shortcuts.series.sine_products import (
    from_grid,
    grid_size,
    on_grid,
    symbol,
)
from nonsmooth.solver.shortcuts.series.spectral_errors import spectral_errors


def compiled():
    return kernels.compiled("hb-symmetric")


def belt_at(alpha: float) -> ns.StickSlip:
    return ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )


@given(st.integers(1, 70), st.floats(0.1, 3), st.floats(0.3, 6), st.integers(0, 10**6))
def test_sine_transforms_multiply_by_the_matrix(N: int, t1: float, s: float, seed: int) -> None:
    functions = kernels.plain("hb-symmetric").functions
    b = np.random.default_rng(seed).normal(size=N)
    _, sines = functions["stick_waves"](N, t1, t1 + s)
    C = functions["slip_cosines"](N, t1, t1 + s, sines)
    expected = np.empty(N)
    functions["slip_product"](N, b, C, expected)
    points = grid_size(N)
    found = from_grid(symbol(C[2 * N :], points) * on_grid(b, points), N)
    np.testing.assert_allclose(found, expected, atol=1e-14 * N)


def left_out_exactly(N: int, t1: float, T: float) -> tuple[list, mp.mpf]:
    """Return the coefficients of b_n and c_1 in (14): closed forms, in 60 digits."""
    t1, T = mp.mpf(t1), mp.mpf(T)
    s, w = T - t1, 2 * mp.pi / T
    n = range(1, N + 1)

    def moment(l: int, k: int) -> mp.mpf:
        z = mp.pi * k * s / T
        j = mp.sqrt(mp.pi / (2 * z)) * mp.besselj(l + mp.mpf(1) / 2, z)
        return (-1) ** (k + (l - 1) // 2) * s * j

    M = {k: moment(1, k) for k in n}
    gamma = {k: -2 / T * M[k] / (k * w) ** 2 for k in n}
    q1, q3 = -(s**2) / 10 + s**3 / (12 * T), s**2 / 60
    H = {k: M[k] * (1 + q1) + moment(3, k) * q3 for k in n}
    C = [s] + [-T * mp.sin(mp.pi * k * t1 / T) / (mp.pi * k) for k in range(1, 2 * N + 1)]
    h = []
    for j in n:
        product = mp.fsum((C[abs(j - k)] - C[j + k]) / 2 * gamma[k] for k in n)
        h.append(H[j] + 2 * mp.pi**2 * j**2 / T * gamma[j] - product)
    whole = s / 3 * (1 + q1) * q1 + s / 7 * q3**2
    return h, whole - mp.fsum(gamma[j] * (H[j] + h[j - 1]) for j in n)


@pytest.mark.parametrize(("t1", "T"), [(2.0, 6.7), (0.02, 6.3), (60.0, 63.2)])
def test_what_is_left_out_keeps_its_digits(t1: float, T: float) -> None:
    N = 120
    with mp.workdps(60):
        h, w = left_out_exactly(N, t1, T)
        found = left_out(compiled().functions, N, t1, T)
        assert found.by_tail == pytest.approx(float(w), rel=1e-10)
        low = np.array([float(value) for value in h[: len(found.by_sine)]])
    np.testing.assert_allclose(found.by_sine, low, atol=1e-12 * np.abs(low).max())


@pytest.mark.parametrize("K", [0, 1])
@pytest.mark.parametrize("alpha", [1e-6, 0.01, 0.245, 1.0, 5.0, 30.0])
@pytest.mark.parametrize("N", [100, 240, 500])
def test_the_orbit_is_the_dense_one(K: int, alpha: float, N: int) -> None:
    kernel = compiled()
    start = cubic_slip(kernel, K, N, *rough_times(alpha))
    dense = newton(kernel.iterate, (alpha, K), start)
    free = newton_krylov.solve(Problem(kernel, alpha, K, N), start)
    assert dense.converged
    assert free.converged
    np.testing.assert_allclose(
        free.unknowns[-2:], dense.unknowns[-2:], rtol=1e-12, atol=1e-13 * dense.unknowns[-1]
    )


def test_iterations_do_not_grow_with_the_harmonics() -> None:
    counts = []
    for N in (300, 3000, 30_000):
        start = cubic_slip(compiled(), 0, N, *rough_times(1.0))
        counts.append(newton_krylov.solve(Problem(compiled(), 1.0, 0, N), start).iterations)
    assert max(counts) <= 6


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
@pytest.mark.parametrize("order", [300, 20_000])
def test_very_many_harmonics_are_an_orbit(method: str, order: int) -> None:
    orbit = ns.solve(DEFAULT, method, order)
    assert orbit.admissible
    if method == "hb":
        assert orbit.errors.period == pytest.approx(-0.050660 / order, rel=2 / order + 1e-5)
    else:  # the sign changes with the order
        assert abs(orbit.errors.period) <= 0.13 / order**3 + 2e-15


def test_no_orbit_is_said_where_the_harmonics_do_not_resolve_the_phases() -> None:
    with pytest.raises(ns.NoOrbit, match="no damped step reduces"):
        ns.solve(belt_at(1e4), "hb", search.MOST_DENSE + 50)


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
@pytest.mark.parametrize("alpha", [1e-3, 0.3, 1.0, 10.0])
def test_sums_over_harmonics_give_the_error_of_quadrature(method: str, alpha: float) -> None:
    chosen, N = METHODS[method], 150
    z = ns.solve(belt_at(alpha), method, N).unknowns
    normalised, aligned = spectral_errors(z, N, alpha, chosen.c1_terms)
    by_quadrature = acceleration_error(chosen, N, alpha, z)
    assert normalised == pytest.approx(by_quadrature, rel=1e-5)
    assert aligned == pytest.approx(aligned_acceleration_error(chosen, N, alpha, z), rel=1e-5)


@settings(max_examples=20)
@given(st.sampled_from(["hb", "hb-c1"]), st.floats(0.01, 5), st.integers(1, 60))
def test_samples_are_the_motion(method: str, alpha: float, N: int) -> None:
    """Every example has an orbit: both series have one at every order up to alpha = 5."""
    chosen = METHODS[method]
    z = ns.solve(belt_at(alpha), method, N, many=True).unknowns
    tau, displacement, velocity = samples(z, N, chosen.c1_terms)
    t = np.mod(tau + z[-2] / 2, z[-1])
    for derivative, values in enumerate((displacement, velocity)):
        expected = chosen.evaluate(z, N, t, derivative, alpha)
        np.testing.assert_allclose(values, expected, atol=1e-12 * (1 + alpha))
    assert not violations(chosen, N, belt_at(alpha), z)


def test_a_long_series_is_evaluated_in_blocks() -> None:
    orbit = ns.solve(DEFAULT, "hb", 3000)
    t = np.linspace(0, orbit.period, 2500)
    reference = ns.exact(DEFAULT).displacement(t * exact.times(1.0)[1] / orbit.unknowns[-1])
    np.testing.assert_allclose(orbit.displacement(t), reference, atol=2e-4)


@pytest.mark.parametrize(("t1", "T"), [(1e-9, 6.0), (6.0, 6.0 + 1e-9)])
def test_a_phase_shorter_than_the_samples_is_looked_at_nevertheless(t1, T) -> None:
    z = np.zeros(2 * 3 + 3)
    z[-2:] = t1, T
    assert violations(METHODS["hb"], 3, belt_at(1.0), z)
