"""What the derivation rests on, shown by SymPy; and that its checks can fail."""

import pytest
import sympy as sp

from nonsmooth.codegen import derive
from nonsmooth.codegen.shortcuts.paper import (
    c1,
    c1_legendre,
    fourier,
    g1,
    oscillator,
    slip_moments,
)
from nonsmooth.codegen.shortcuts.paper.inner_product import omega_0, slip_cosine, slip_sine
from nonsmooth.codegen.shortcuts.paper.oscillator import T, t, t1
from nonsmooth.codegen.system import DerivationError, require_zero


def test_friction_carries_the_spring_in_stick() -> None:
    x = sp.Function("x")(t)
    assert oscillator.STICK.residual(x) == x.diff(t, 2)
    slip = oscillator.SLIP.residual(x)
    expected = x.diff(t, 2) + oscillator.omega_n**2 * (x - oscillator.x_s)
    assert sp.expand(slip - expected) == 0


def test_change_of_variables_leaves_alpha_alone() -> None:
    y = sp.Function("y")
    x = oscillator.to_dimensional(y(t))
    slip = oscillator.SLIP.residual(x)
    # omega_n V (y'' + y) at omega_n t: the dimensionless equation times its units.
    scale = oscillator.omega_n * oscillator.V
    dimensionless = oscillator.dimensionless(oscillator.SLIP.residual(y(t)))
    back = dimensionless.subs(y(t), y(oscillator.omega_n * t)).doit()
    at_time = y(oscillator.omega_n * t)
    expected = scale * (at_time.diff(t, 2) / oscillator.omega_n**2 + at_time)
    assert sp.simplify(slip - expected) == 0
    assert back.free_symbols <= {t, oscillator.omega_n}


def test_initial_state_in_dimensionless_variables_is_minus_alpha_and_one() -> None:
    assert oscillator.dimensionless(oscillator.x_0) == -oscillator.alpha
    assert oscillator.dimensionless(oscillator.V) == 1
    start = oscillator.to_dimensional(-oscillator.alpha)
    assert sp.simplify(start - oscillator.x_0) == 0


def test_g1_is_periodic_c1_and_a_smoothstep() -> None:
    g1.check_g1()


def test_a_function_with_a_kink_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(g1, "G1_SLIP", g1.G1_SLIP + (t - t1) * (T - t))
    with pytest.raises(DerivationError, match="velocity of g1"):
        g1.check_g1()


def test_an_unsymmetric_row_14_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(g1, "G_STICK", 2 * g1.G_STICK)
    with pytest.raises(DerivationError, match="in \\(14\\)"):
        g1.check_symmetry()


def test_wrong_harmonics_of_g1_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = -g1.sine_of_g1()
    monkeypatch.setattr(g1, "sine_of_g1", lambda: wrong)
    with pytest.raises(DerivationError, match="sine of g1"):
        g1.check_harmonics()


def test_16_is_c1_and_a_series_that_starts_with_a_kink_is_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    c1.check_c1()
    wrong = c1.term_velocity() + 1
    monkeypatch.setattr(c1, "term_velocity", lambda: wrong)
    with pytest.raises(DerivationError, match="velocity at t1"):
        c1.check_c1()


class Damped(oscillator.Phase):
    """Slip with viscous damping."""

    def residual(self, x: sp.Expr) -> sp.Expr:
        return sp.expand(super().residual(x) + 2 * zeta * oscillator.omega_n * x.diff(t))


zeta = sp.Symbol("zeta", positive=True)


@pytest.mark.parametrize(("n", "k"), [(0, 0), (1, 0), (3, 2)])
def test_17_and_18_follow_from_the_phase(
    n: int, k: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    slip = Damped("slip", t1, T, sticking=False)
    monkeypatch.setattr(c1, "SLIP", slip)
    condition, *_ = c1.conditions()
    closed = (condition.weight * condition.entry).subs({c1.n: n, c1.k: k})
    tau, omega_n = c1.tau, oscillator.omega_n
    phi, test = (tau ** (i + 2) / ((i + 1) * (i + 2)) for i in (n, k))
    damping = 2 * zeta * omega_n * phi.diff(tau)
    integrand = (phi.diff(tau, 2) + damping + omega_n**2 * phi) * test
    expected = sp.integrate(sp.expand(integrand), (tau, 0, c1.s))
    assert closed.has(zeta)
    assert sp.expand(closed - expected) == 0
    load = sp.integrate(
        sp.expand(slip.residual(c1.LINE).subs(t, t1 + tau) * test), (tau, 0, c1.s)
    )
    shown = (condition.weight * condition.load).subs(c1.k, k)
    assert sp.simplify(sp.expand(shown - load.subs(c1.START))) == 0


def test_a_phase_that_needs_other_moments_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = g1.through_motion() + g1.u**2
    monkeypatch.setattr(g1, "through_motion", lambda: wrong)
    with pytest.raises(DerivationError, match="moments of degree 2"):
        g1._by_harmonic(0)


@pytest.mark.parametrize("l", [0, 1, 2, 3])
def test_legendre_moments_are_spherical_bessel_functions(l: int) -> None:
    slip_moments.about_mid_slip(l)


@pytest.mark.parametrize("degree", range(10))
def test_legendre_polynomials_are_integrated_twice(degree: int) -> None:
    u = c1_legendre.u
    Q = c1_legendre.twice_integrated(degree)
    assert sp.expand(Q.diff(u, 2) - sp.legendre(degree, 2 * u - 1)) == 0
    assert Q.subs(u, 0) == 0
    assert Q.diff(u).subs(u, 0) == 0


@pytest.mark.parametrize("N", [1, 2, pytest.param(4, marks=pytest.mark.long)])
def test_the_legendre_form_of_18_spans_the_rows_of_the_paper(N: int) -> None:
    """The rows of the paper, combined to the test functions Q_k, are the kernel's rows."""
    u, s, k = c1_legendre.u, c1_legendre.s, c1.k
    p = sp.symbols(f"p0:{N + 1}")
    acceleration = sum(p[i] * sp.legendre(i, 2 * u - 1) for i in range(N + 1))
    d = sp.Poly(acceleration, u).all_coeffs()[::-1]
    condition = oscillator.dimensionless(c1.conditions()[0].closed.subs(c1.N, N).doit())
    condition = condition.subs({c1.d[i]: value / s**i for i, value in enumerate(d)})
    line = c1_legendre.line_coefficients(c1.LINE.subs(c1.START))
    for degree in range(N + 1):
        Q = sp.Poly(c1_legendre.twice_integrated(degree), u).all_coeffs()[::-1][2:]
        rows = sum(
            q * (i + 1) * (i + 2) / s ** (i + 3) * condition.subs(k, i) for i, q in enumerate(Q)
        )
        displacement = sum(p[i] * c1_legendre.twice_integrated(i) for i in range(N + 1))
        residual = acceleration + s**2 * displacement + line[0] + line[1] * (2 * u - 1)
        direct = sp.integrate(
            sp.expand(residual * c1_legendre.twice_integrated(degree)), (u, 0, 1)
        )
        assert sp.simplify((rows - direct).subs(T, t1 + s)) == 0


def test_stable_form_of_the_slip_integrals_is_the_integral() -> None:
    """C_k, S_k of hb, and the moments of hb-c1, from one primitive, l = 0."""
    k, s, z = slip_moments.k, slip_moments.s, slip_moments.z
    for integral, moment in zip(
        (slip_cosine(), slip_sine()), slip_moments.moments(0), strict=True
    ):
        closed = sp.expand_func(moment).subs(z, sp.pi * k * s / T).subs(s, T - t1)
        difference = sp.expand_trig(sp.expand(closed - integral.generic))
        assert sp.simplify(sp.expand_trig(sp.expand(difference, trig=True))) == 0


def test_entries_have_few_operations() -> None:
    """SymPy on the product itself gives a Piecewise of 190 operations."""
    for value in fourier.entries().values():
        assert not value.generic.has(sp.Piecewise)
        assert sp.count_ops(value.generic) <= 12


def test_require_zero_names_what_is_not() -> None:
    with pytest.raises(DerivationError, match=r"this claim: .* is not zero"):
        require_zero([("true", sp.Integer(0)), ("this claim", omega_0)])


def test_an_unknown_method_is_named() -> None:
    with pytest.raises(ValueError, match="got 'galerkin', expected one of hb, hb-c1, c1"):
        derive("galerkin")
