"""The generated kernels: residual against quadrature, Jacobian against 40-digit differences."""

import types

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from paper import METHODS, Problem, cosine, one, sine

from nonsmooth.solver.shortcuts.search import kernels

ALPHA = 1.3


def unknowns(method: str, N: int, seed: int) -> np.ndarray:
    """Return random coefficients of order one, and times 0 < t1 < T."""
    rng = np.random.default_rng(seed)
    z = rng.normal(size=kernels.plain(method).size(N))
    z[-2] = rng.uniform(0.3, 3)
    z[-1] = z[-2] + rng.uniform(1, 6)
    return z


def residual(method: str, z: np.ndarray) -> np.ndarray:
    R = np.empty(len(z))
    kernels.plain(method).residual(ALPHA, z, R)
    return R


def jacobian(method: str, z: np.ndarray) -> np.ndarray:
    J = np.empty((len(z), len(z)))
    kernels.plain(method).jacobian(ALPHA, z, J)
    return J


def fourier_conditions(p: Problem, x, acceleration, N: int) -> list[float]:
    """Return (5), (6) for j = 1..N and (7) for j = 1..N by quadrature."""
    w = p.omega_0
    waves = [one]
    waves += [sine(j * w) for j in range(1, N + 1)]
    waves += [cosine(j * w) for j in range(1, N + 1)]
    return [p.inner(*p.residual(x, acceleration), wave) for wave in waves]


@given(st.integers(1, 7), st.integers(0, 10**6))
def test_residual_of_hb_is_5_6_7_9_10(N: int, seed: int) -> None:
    z = unknowns("hb", N, seed)
    p = Problem(*z[-2:])
    a, b = z[1 : N + 1], z[N + 1 : 2 * N + 1]
    expected = fourier_conditions(p, *p.series(z[0], a, b), N)
    expected += [z[0] / 2 + b.sum() + ALPHA, p.omega_0 * (np.arange(1, N + 1) @ a) - 1]
    scale = 1 + (N * p.omega_0) ** 2 * p.T
    np.testing.assert_allclose(residual("hb", z), expected, atol=1e-12 * scale)


def tail(p: Problem, N: int):
    """Return g1 of (12), scaled, without its first N harmonics; by quadrature."""
    scale = p.T * (p.T - p.t1) ** 3
    waves = {"a": sine, "b": cosine}
    gamma = {
        name: np.array(
            [2 / p.T * p.inner(p.g1, p.g1, wave(n * p.omega_0)) for n in range(1, N + 1)]
        )
        for name, wave in waves.items()
    }
    mean = 2 / p.T * p.inner(p.g1, p.g1, one)
    own, own_acceleration = p.series(mean, gamma["a"], gamma["b"])
    at_0 = -(mean / 2 + gamma["b"].sum()) / scale
    velocity_at_0 = (p.t1 - p.T) ** 3 - p.omega_0 * np.arange(1, N + 1) @ gamma["a"]

    def x(t):
        return (p.g1(t) - own(t)) / scale

    def acceleration(t):
        return (p.g1_acceleration(t) - own_acceleration(t)) / scale

    return x, acceleration, at_0, velocity_at_0 / scale


@given(st.integers(1, 7), st.integers(0, 10**6))
def test_residual_of_hb_c1_is_5_6_7_14_9_10_with_the_tail_of_g1(N: int, seed: int) -> None:
    z = unknowns("hb-c1", N, seed)
    p, c1 = Problem(*z[-2:]), z[-3]
    a, b = z[1 : N + 1], z[N + 1 : 2 * N + 1]
    series, series_acceleration = p.series(z[0], a, b)
    g, g_acceleration, at_0, velocity_at_0 = tail(p, N)

    def x(t):
        return series(t) + c1 * g(t)

    def acceleration(t):
        return series_acceleration(t) + c1 * g_acceleration(t)

    expected = fourier_conditions(p, x, acceleration, N)
    expected.append(p.inner(*p.residual(x, acceleration), g))
    expected.append(z[0] / 2 + b.sum() + c1 * at_0 + ALPHA)
    velocity = p.omega_0 * np.arange(1, N + 1) @ a + c1 * velocity_at_0
    expected.append(velocity - 1)
    s = p.T - p.t1
    scale = 1 + (N * p.omega_0) ** 2 * p.T + 1 / s**2
    np.testing.assert_allclose(residual("hb-c1", z), expected, atol=1e-11 * scale)


class _Exact:
    """What the kernels use of NumPy, with room for mpmath numbers."""

    @staticmethod
    def empty(shape) -> np.ndarray:
        array = np.empty(shape, dtype=object)
        array.fill(mp.mpf(0))
        return array

    zeros = empty


def exact_residual(method: str, z: list) -> np.ndarray:
    """Return the residual in 40 digits, by the generated code itself."""
    source = kernels.module(method)
    namespace = vars(source) | {"np": _Exact, "cos": mp.cos, "sin": mp.sin, "pi": mp.pi}
    for name, function in vars(source).items():
        if isinstance(function, types.FunctionType):
            namespace[name] = types.FunctionType(function.__code__, namespace)
    R = _Exact.empty(len(z))
    namespace["residual"](mp.mpf(ALPHA), np.array(z, dtype=object), R)
    return R


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(("N", "seed"), [(1, 1), (2, 2), (4, 3)])
def test_jacobian_is_the_derivative_of_the_residual(method: str, N: int, seed: int) -> None:
    z = unknowns(method, N, seed)
    h = mp.mpf(10) ** -15
    with mp.workdps(40):
        expected = np.empty((len(z), len(z)))
        for column in range(len(z)):
            ahead, behind = ([mp.mpf(v) for v in z] for _ in range(2))
            ahead[column] += h
            behind[column] -= h
            difference = exact_residual(method, ahead) - exact_residual(method, behind)
            expected[:, column] = [float(d / (2 * h)) for d in difference]
    scale = np.abs(expected).max()
    # Row 14 of hb-c1 is derived twice: Gauss in the residual, closed form in the Jacobian.
    # The nodes stop at 1e-15, so do these differences: squared, over h.
    np.testing.assert_allclose(jacobian(method, z), expected, atol=1e-12 * scale)


@pytest.mark.parametrize("method", METHODS)
def test_plain_and_compiled_kernels_give_the_same_bits(method: str) -> None:
    plain, compiled = kernels.plain(method), kernels.compiled(method)
    for N, seed in ((1, 4), (6, 5), (17, 6)):
        z = unknowns(method, N, seed)
        R = [np.empty(len(z)) for _ in range(2)]
        J = [np.empty((len(z), len(z)), order="F") for _ in range(2)]
        for kernel, r, j in zip((plain, compiled), R, J, strict=True):
            kernel.residual(ALPHA, z, r)
            kernel.jacobian(ALPHA, z, j)
        assert R[0].tobytes() == R[1].tobytes()
        assert J[0].tobytes() == J[1].tobytes()


@pytest.mark.parametrize("method", METHODS)
@settings(max_examples=25)
@given(st.integers(1, 30))
def test_size_counts_the_equations_of_the_paper(method: str, N: int) -> None:
    beside = {"hb": 2 * N + 3, "hb-c1": 2 * N + 4, "c1": N + 3}
    assert kernels.plain(method).size(N) == beside[method]


def test_jacobian_of_c1_is_banded_but_for_the_times() -> None:
    J = jacobian("c1", unknowns("c1", 12, 7))[:13, :13]
    rows, columns = np.nonzero(J)
    assert np.abs(rows - columns).max() <= 4
