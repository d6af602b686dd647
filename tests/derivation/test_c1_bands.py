"""The full system of Section 3.3 solved by its bands: the same orbit, to rounding."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.generated.shortcuts import c1 as kernel
from nonsmooth.solver.shortcuts.search import kernels
from nonsmooth.solver.shortcuts.search.start import rough_times

#: Orders and alphas below for which there is no orbit.
WITHOUT_ORBIT = {(2, 0.245), (3, 0.245)}


def banded(n: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Return a random matrix with 4 diagonals below and above, dense and in rows of 13."""
    rng = np.random.default_rng(seed)
    rows, columns = np.indices((n, n))
    dense = np.where(np.abs(rows - columns) <= 4, rng.normal(size=(n, n)), 0.0)
    rows_of_13 = np.zeros((n, 13))
    for i in range(n):
        for k in range(max(0, i - 4), min(n, i + 5)):
            rows_of_13[i, k - i + 4] = dense[i, k]
    return dense, rows_of_13


@settings(max_examples=60)
@given(st.integers(1, 25), st.integers(0, 10**6))
def test_band_solve_is_a_solve(n: int, seed: int) -> None:
    dense, band = banded(n, seed)
    X = np.random.default_rng(seed + 1).normal(size=(n, 3))
    expected = np.linalg.solve(dense, X)
    assert kernel.band_solve(band, X)
    allowed = 1e-13 * np.linalg.cond(dense) * np.abs(expected).max()
    np.testing.assert_allclose(X, expected, atol=allowed)


def test_band_solve_pivots() -> None:
    dense, band = banded(6, 3)
    dense[0, 0] = band[0, 4] = 0.0
    X = np.ones((6, 1))
    assert kernel.band_solve(band, X)
    np.testing.assert_allclose(dense @ X, 1, rtol=1e-12)


def test_a_singular_band_is_refused() -> None:
    assert not kernel.band_solve(np.zeros((3, 13)), np.ones((3, 1)))


@pytest.mark.parametrize("N", [1, 4, 9])
def test_band_tables_are_the_matrix_of_the_jacobian(N: int) -> None:
    A, B, _, _ = kernel.band_tables(N)
    z = np.random.default_rng(N).normal(size=N + 3)
    z[-2:] = 1.3, 5.9
    J = np.empty((N + 3, N + 3))
    kernel.jacobian(1.0, z, J)
    s = z[-1] - z[-2]
    for k in range(N + 1):
        for n in range(max(0, k - 4), min(N, k + 4) + 1):
            value = A[k, n - k + 4] + s * s * B[k, n - k + 4]
            assert value == pytest.approx(J[k, n], rel=1e-12, abs=1e-15)


def by_bands(functions, alpha: float, N: int) -> tuple[np.ndarray, int]:
    """Return the unknowns and the status of `band_newton` from the rough start."""
    p, twice, rho = np.empty(N + 1), np.empty(N + 3), np.empty(N + 3)
    M, X = np.empty((N + 1, 13)), np.empty((N + 1, 3))
    work = (p, M, X, twice, rho)
    tables = functions["band_tables"](N)
    t1, T, status = functions["band_newton"](alpha, *rough_times(alpha), *tables, *work)
    return np.array([*p, t1, T]), status


@pytest.mark.parametrize("N", [1, 2, 3, 5, 8, 13, 20, 60])
@pytest.mark.parametrize("alpha", [0.245, 1.0, 10.0, 1e4])
def test_bands_give_the_orbit_of_the_dense_solver(N: int, alpha: float) -> None:
    belt = ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )
    try:
        orbit = ns.solve(belt, "c1", N)
    except ns.NoOrbit:
        assert (N, alpha) in WITHOUT_ORBIT
        return
    assert (N, alpha) not in WITHOUT_ORBIT
    z, status = by_bands(vars(kernel), alpha, N)
    assert status == 0
    T = orbit.unknowns[-1]
    np.testing.assert_allclose(z[-2:], orbit.unknowns[-2:], atol=4e-15 * T)
    np.testing.assert_allclose(z[:-2], orbit.unknowns[:-2], atol=1e-14 * T)


def test_plain_and_compiled_give_the_same_bits() -> None:
    functions = kernels.compiled_functions("c1")
    for N in (3, 9, 20):
        plain, compiled = (by_bands(f, 0.7, N)[0] for f in (vars(kernel), functions))
        assert plain.tobytes() == compiled.tobytes()
