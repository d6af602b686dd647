"""The kernel about mid-stick: quadrature, the full equations, and what symmetry leaves."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import legendre
from numpy.polynomial.legendre import leggauss
from scipy.special import spherical_jn

import nonsmooth as ns
from nonsmooth.codegen.shortcuts.symmetric import hb_symmetric, odd_functions, symmetry
from nonsmooth.codegen.system import DerivationError
from nonsmooth.generated.shortcuts import hb_c1
from nonsmooth.generated.shortcuts import hb_symmetric as kernel
from nonsmooth.solver.shortcuts.orbit import exact
from nonsmooth.solver.shortcuts.search import kernels
from nonsmooth.solver.shortcuts.search.newton import newton
from nonsmooth.solver.shortcuts.search.start import cubic_slip, rough_times
from nonsmooth.solver.shortcuts.series import fourier
from nonsmooth.solver.shortcuts.series.fourier import from_symmetric

ALPHA = 1.3
X, W = leggauss(120)


def unknowns(N: int, K: int, seed: int) -> np.ndarray:
    """Return random coefficients that fall off, and times 0 < t1 < T."""
    rng = np.random.default_rng(seed)
    z = rng.normal(size=N + K + 2)
    z[:N] /= np.arange(1, N + 1) ** 2
    z[-2] = rng.uniform(0.3, 3)
    z[-1] = z[-2] + rng.uniform(1, 6)
    return z


class Quadrature:
    """The motion of `z` and its inner products, by Gauss in a half of each phase."""

    def __init__(self, z: np.ndarray, K: int) -> None:
        self.N, self.K, self.t1, self.T = len(z) - K - 2, K, *z[-2:]
        self.z, self.s, self.w = z, z[-1] - z[-2], 2 * np.pi / z[-1]
        self.ends = ((0, self.t1 / 2), (self.t1 / 2, self.T / 2))
        self.harmonics: dict[int, np.ndarray] = {}

    def over(self, f, phase: int) -> float:
        """Integrate an even function over both halves of a phase."""
        start, end = self.ends[phase]
        return (end - start) * float(W @ f(start + (end - start) * (1 + X) / 2, phase))

    def g(self, i: int, tau, phase: int, derivative: int):
        """Return function i from its definition: P_l* in slip, integrated twice."""
        drift = self.s**2 / (6 * self.T) if i == 0 else 0.0
        if phase == 0:
            return (drift * tau, drift + 0 * tau, 0 * tau)[derivative]
        v = 2 * (tau - self.T / 2) / self.s
        unit = np.eye(2 * i + 2)[2 * i + 1]
        once = legendre.legint(unit, lbnd=-1)
        twice = legendre.legint(once, lbnd=-1)
        # Odd about mid-slip, and with the drift from there.
        twice[0] = 0.0
        forms = (
            (self.s / 2) ** 2 * legendre.legval(v, twice) + drift * (tau - self.T / 2),
            self.s / 2 * legendre.legval(v, once) + drift,
            legendre.legval(v, unit),
        )
        return forms[derivative]

    def sines(self, b: np.ndarray, tau, derivative: int):
        n = np.arange(1, len(b) + 1)
        angle = self.w * np.multiply.outer(tau, n)
        if derivative == 1:
            return np.cos(angle) @ (n * self.w * b)
        return np.sin(angle) @ (b if derivative == 0 else -((n * self.w) ** 2) * b)

    def smooth(self, i: int, tau, phase: int, derivative: int):
        """Return C1 function i: ``v (1 - v**2)**i (N + 1)**i`` in slip, integrated twice."""
        v = np.polynomial.Polynomial([0, 1])
        power = (v * (1 - v**2) ** i * (self.N + 1) ** i).coef
        parts = legendre.poly2leg(power)[1::2]
        return sum(c * self.g(m, tau, phase, derivative) for m, c in enumerate(parts))

    def gamma(self, i: int) -> np.ndarray:
        """Return the first N harmonics of C1 function i."""
        if i not in self.harmonics:

            def product(n: int) -> float:
                return sum(
                    self.over(lambda t, p: self.smooth(i, t, p, 0) * np.sin(n * self.w * t), p)
                    for p in range(2)
                )

            self.harmonics[i] = 2 / self.T * np.array([product(n + 1) for n in range(self.N)])
        return self.harmonics[i]

    def tail(self, i: int, tau, phase: int, derivative: int):
        smooth = self.smooth(i, tau, phase, derivative)
        return smooth - self.sines(self.gamma(i), tau, derivative)

    def motion(self, tau, phase: int, derivative: int):
        total = self.sines(self.z[: self.N], tau, derivative)
        for i in range(self.K):
            total = total + self.z[self.N + i] * self.tail(i, tau, phase, derivative)
        return total

    def inner(self, test) -> float:
        """Return the inner product of the residual with an odd function."""

        def residual(tau, phase):
            acceleration = self.motion(tau, phase, 2)
            return acceleration if phase == 0 else acceleration + self.motion(tau, phase, 0)

        return sum(self.over(lambda t, p: residual(t, p) * test(t, p), p) for p in range(2))


@given(st.integers(1, 6), st.integers(0, 3), st.integers(0, 10**6))
def test_residual_is_6_14_9_10_about_mid_stick(N: int, K: int, seed: int) -> None:
    z = unknowns(N, K, seed)
    q = Quadrature(z, K)
    R = np.empty(len(z))
    kernel.residual((ALPHA, K), z, R)
    n = np.arange(1, N + 1)
    expected = [q.inner(lambda t, p, j=j: np.sin(j * q.w * t)) for j in n]
    expected += [q.inner(lambda t, p, i=i: q.tail(i, t, p, 0)) for i in range(K)]
    force = [q.over(lambda t, p, j=j: q.motion(t, 1, 0) * np.sin(j * q.w * t), 1) for j in n]
    response = np.array(force) / ((n * q.w) ** 2 * q.T / 2)
    end = np.array([q.t1 / 2])
    for derivative, known in ((0, ALPHA), (1, 1.0)):
        tails = sum(z[N + i] * q.tail(i, end, 0, derivative)[0] for i in range(K))
        expected.append(q.sines(response, end, derivative)[0] + tails - known)
    np.testing.assert_allclose(R, expected, atol=1e-11 * (1 + (N * q.w) ** 2 * q.T))


@given(st.integers(1, 9), st.integers(0, 3), st.integers(0, 10**6))
def test_jacobian_is_the_derivative_of_the_residual(N: int, K: int, seed: int) -> None:
    z = unknowns(N, K, seed)
    size = len(z)
    J, expected, R = np.empty((size, size)), np.empty((size, size)), np.empty((2, size))
    kernel.jacobian((ALPHA, K), z, J)
    for column in range(size):
        h = 1e-5 * max(1.0, abs(z[column]))
        for row, step in enumerate((h, -h)):
            moved = z.copy()
            moved[column] += step
            kernel.residual((ALPHA, K), moved, R[row])
        expected[:, column] = (R[0] - R[1]) / (2 * h)
    np.testing.assert_allclose(J, expected, atol=2e-9 * np.abs(J).max())


@pytest.mark.parametrize("K", [0, 1, 3])
def test_plain_and_compiled_give_the_same_bits(K: int) -> None:
    plain, compiled = kernels.plain("hb-symmetric"), kernels.compiled("hb-symmetric")
    for N in (1, 7, 20):
        z = cubic_slip(plain, K, N, *rough_times(ALPHA))
        assert cubic_slip(compiled, K, N, *rough_times(ALPHA)).tobytes() == z.tobytes()
        found = [newton(k.iterate, (ALPHA, K), z) for k in (plain, compiled)]
        assert found[0].unknowns.tobytes() == found[1].unknowns.tobytes()
        assert found[0].iterations == found[1].iterations
        assert found[0].converged


@given(st.floats(1e-4, 0.9), st.integers(1, 200), st.integers(0, 12))
def test_spherical_bessel_functions(share: float, k: int, highest: int) -> None:
    z = np.pi * k * share
    j = np.empty(max(highest, 1) + 1)
    kernel.spherical_bessel(max(highest, 1), z, np.cos(z), np.sin(z), j)
    expected = spherical_jn(np.arange(len(j)), z)
    np.testing.assert_allclose(j, expected, rtol=1e-11, atol=1e-14)


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
@pytest.mark.parametrize("alpha", [1e-3, 0.245, 1.0, 5.0, 20.0])
@pytest.mark.parametrize("N", [6, 25, 60])
def test_the_orbit_is_that_of_the_full_equations(method: str, alpha: float, N: int) -> None:
    """2 N + 3 or 2 N + 4 conditions hold, and their own solver finds nothing else nearby."""
    K = {"hb": 0, "hb-c1": 1}[method]
    symmetric = kernels.compiled("hb-symmetric")
    half = newton(
        symmetric.iterate, (alpha, K), cubic_slip(symmetric, K, N, *rough_times(alpha))
    )
    assert half.converged
    z = from_symmetric(half.unknowns, N)
    full = kernels.compiled(method)
    R = np.empty(len(z))
    full.residual(alpha, z, R)
    scale = np.abs(z[:-2]).max() * (N * 2 * np.pi / z[-1]) ** 2 * z[-1]
    assert np.abs(R).max() <= 1e-14 * max(scale, 1.0)
    start = z * (1 + 1e-4 * np.random.default_rng(N).normal(size=len(z)))
    whole = newton(full.iterate, alpha, start)
    assert whole.converged
    np.testing.assert_allclose(whole.unknowns[-2:], z[-2:], atol=2e-13 * z[-1])


@pytest.mark.parametrize("method", ["hb", "hb-c1"])
@pytest.mark.parametrize("alpha", [1e-8, 1e-6])
def test_an_orbit_that_hardly_sticks_is_found_by_symmetry_alone(
    method: str, alpha: float
) -> None:
    """Pure slip is 2 alpha away; the full equations are led there."""
    belt = ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )
    orbit = ns.solve(belt, method, 20)
    t1, T = exact.times(alpha)
    assert orbit.t1 == pytest.approx(t1, rel=1e-10)
    assert orbit.period == pytest.approx(T, rel=1e-14)


# mathematics.md, section 2: period errors at alpha = 1, N = 8, of the first odd functions.
@pytest.mark.parametrize(
    ("K", "error"), [(1, 9.3e-5), (2, -1.7e-5), (3, 5.3e-8)], ids=["P1", "P1P3", "P1P3P5"]
)
def test_further_odd_functions_help(K: int, error: float) -> None:
    symmetric = kernels.plain("hb-symmetric")
    found = newton(symmetric.iterate, (1.0, K), cubic_slip(symmetric, K, 8, *rough_times(1.0)))
    assert found.converged
    assert found.unknowns[-1] / exact.times(1.0)[1] - 1 == pytest.approx(error, rel=0.05)


@pytest.mark.parametrize(("K", "N"), [(3, 150), (4, 60), (5, 32), (6, 16)])
@pytest.mark.parametrize("alpha", [0.3, 1.0])
def test_more_functions_reach_rounding_and_stay_there(K: int, N: int, alpha: float) -> None:
    kernel = kernels.compiled("hb-symmetric")
    found = newton(kernel.iterate, (alpha, K), cubic_slip(kernel, K, N, *rough_times(alpha)))
    assert found.converged
    assert abs(found.unknowns[-1] / exact.times(alpha)[1] - 1) < 1e-12


@pytest.mark.parametrize(
    ("K", "order"), [(0, 1), (1, 3), (2, 3), (3, 5), (4, 5)], ids="K={}".format
)
def test_each_second_function_adds_two_orders(K: int, order: int) -> None:
    """The first jump that is left: of derivative K + 2, in (9) for odd K, in (10) for even."""
    kernel, T = kernels.compiled("hb-symmetric"), exact.times(1.0)[1]

    def worst(N: int) -> float:
        """Return the largest error of a few orders: it changes sign with the order."""
        starts = (cubic_slip(kernel, K, n, *rough_times(1.0)) for n in range(N, N + 5))
        found = [newton(kernel.iterate, (1.0, K), start) for start in starts]
        return max(abs(f.unknowns[-1] / T - 1) for f in found)

    rate = np.log2(worst(16) / worst(64)) / 2
    assert rate == pytest.approx(order, abs=0.6)


@pytest.mark.parametrize(
    "check",
    [
        symmetry.check_integrals,
        symmetry.check_symmetry,
        odd_functions.check_functions,
        hb_symmetric.check_recurrence,
    ],
)
def test_the_formulas_pass_the_derivation(check) -> None:
    check()


@pytest.mark.parametrize(
    ("module", "name", "check"),
    [
        (symmetry, "SLIP_COSINE", symmetry.check_integrals),
        (symmetry, "SINE_BY_SINE", symmetry.check_integrals),
        (symmetry, "SINE", symmetry.check_symmetry),
        (odd_functions, "Q_OF_DRIFT", odd_functions.check_functions),
        (odd_functions, "q_above", odd_functions.check_functions),
        (odd_functions, "BESSEL_SLOPE", odd_functions.check_functions),
        (hb_symmetric, "NEXT_BESSEL", hb_symmetric.check_recurrence),
    ],
)
def test_a_wrong_formula_does_not_pass_the_derivation(monkeypatch, module, name, check) -> None:
    right = getattr(module, name)
    if isinstance(right, sp.Basic):
        monkeypatch.setattr(module, name, right + symmetry.T)
    else:
        wrong = right() + symmetry.T
        monkeypatch.setattr(module, name, lambda: wrong)
    with pytest.raises(DerivationError):
        check()


@given(st.integers(1, 60), st.floats(0.01, 20), st.floats(0.5, 6))
def test_harmonics_of_g1_are_the_same_about_mid_stick(N: int, t1: float, s: float) -> None:
    direct = hb_c1.harmonics_of_g1(N, t1, t1 + s)[0]
    np.testing.assert_allclose(
        fourier._harmonics_of_g1(N, t1, t1 + s), direct, rtol=1e-12, atol=1e-14
    )


def test_what_is_in_the_cache_is_known_to_be() -> None:
    symmetric = kernels.compiled("hb-symmetric")
    newton(symmetric.iterate, (1.0, 0), cubic_slip(symmetric, 0, 3, *rough_times(1.0)))
    assert kernels.is_compiled("hb-symmetric")
    assert kernels.functions_for("hb-symmetric", 3)["residual"] is symmetric.residual
