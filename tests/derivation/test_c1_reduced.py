"""Section 3.3 reduced to one scalar equation: derived, generated, solved in batches."""

import math
import types

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.codegen.shortcuts.reduced import c1_reduced
from nonsmooth.codegen.shortcuts.reduced.elimination import condition
from nonsmooth.codegen.system import DerivationError
from nonsmooth.generated.shortcuts import c1_reduced as kernel
from nonsmooth.solver.shortcuts.orbit import exact
from nonsmooth.solver.shortcuts.polynomials import batch
from nonsmooth.solver.shortcuts.search import kernels, start

ALPHAS = np.logspace(-3, 3, 400)

#: How many of the six alphas below have no orbit, by order; all have one at the others.
NONE = {1: 2, 2: 3, 3: 3, 5: 2, 8: 2}


def belt(alpha: float) -> ns.StickSlip:
    return ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )


@pytest.mark.parametrize("degree", [0, 1, 3, 6])
def test_jacobi_polynomial_and_its_derivatives_at_the_ends(degree: int) -> None:
    u, n, m = c1_reduced.u, c1_reduced.n, c1_reduced.m
    J = c1_reduced.jacobi(degree)
    for i in range(degree):
        assert sp.integrate(sp.expand(J * u ** (i + 2)), (u, 0, 1)) == 0
    for order in range(degree + 1):
        at = {n: degree, m: order}
        assert J.diff(u, order).subs(u, 1) == c1_reduced.AT_1.subs(at)
        assert J.diff(u, order).subs(u, 0) == c1_reduced.AT_0.subs(at)


@pytest.mark.parametrize("order", range(1, 8))
def test_scalar_equation_is_the_elimination_of_the_coefficients(order: int) -> None:
    D, M = c1_reduced.determinants()
    parts = c1_reduced.series(order + 1) | c1_reduced.series(order + 2)
    assert sp.cancel((-M / D).subs(parts) - condition(order)) == 0


def test_a_wrong_series_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = -c1_reduced.ratio_at_0()
    monkeypatch.setattr(c1_reduced, "ratio_at_0", lambda: wrong)
    with pytest.raises(DerivationError, match="elimination at order 1"):
        c1_reduced.check_elimination()


@given(st.integers(1, 40), st.floats(3, 6.5), st.floats(0.01, 100))
def test_slope_is_the_derivative_of_the_equation(N: int, s: float, alpha: float) -> None:
    table = kernel.series_coefficients(N)
    h = 1e-5
    ahead, behind = (kernel.equation_and_slope(alpha, s + d, table)[0] for d in (h, -h))
    _, slope = kernel.equation_and_slope(alpha, s, table)
    size = (1 + alpha) * 10
    assert (ahead - behind) / (2 * h) == pytest.approx(slope, abs=1e-7 * size)


@pytest.mark.parametrize("alpha", [1e-6, 0.3, 1.0, 50.0])
def test_the_rough_slip_duration_is_that_of_the_driver(alpha: float) -> None:
    t1, T = start.rough_times(alpha)
    assert kernel.rough_slip(alpha) == pytest.approx(T - t1, rel=1e-14)


@pytest.mark.parametrize("N", [1, 2, 3, 5, 8, 13, 20, 40, 60, 200])
def test_times_are_those_of_the_full_system(N: int) -> None:
    table = kernel.series_coefficients(N)
    none = []
    for alpha in (1e-3, 0.05, 0.245, 1.0, 7.0, 1e3):
        t1, s, status = kernel.orbit_times(alpha, N, table)
        try:
            orbit = ns.solve(belt(alpha), "c1", N)
        except ns.NoOrbit:
            assert status != 0
            none.append(alpha)
            continue
        assert status == 0
        # Pure slip is a root 2 alpha away: rounding of the equation counts 1/alpha times.
        allowed = 4e-15 * (1 + 1 / alpha) * orbit.unknowns[-1]
        assert t1 == pytest.approx(orbit.unknowns[-2], abs=allowed)
        assert t1 + s == pytest.approx(orbit.unknowns[-1], rel=2e-14)
    assert len(none) == NONE.get(N, 0)


@pytest.mark.parametrize("N", [5, 13, 30])
def test_a_batch_is_bitwise_equal_to_single_solves(N: int) -> None:
    result = batch.c1_times(ALPHAS, N)
    table = kernel.series_coefficients(N)
    compiled = kernels.compiled_functions("c1-reduced")["series_coefficients"](N)
    assert table.tobytes() == compiled.tobytes()
    for i, alpha in enumerate(ALPHAS):
        t1, s, status = kernel.orbit_times(alpha, N, table)
        assert result.status[i] == status
        if status == batch.OK:
            assert (result.t1[i], result.T[i]) == (t1, t1 + s)
        else:
            assert np.isnan(result.t1[i])
            assert np.isnan(result.T[i])


def test_a_batch_does_not_return_what_is_no_orbit() -> None:
    result = batch.c1_times(ALPHAS, 4)
    none = result.alpha < 0.75
    assert (result.status[none] != batch.OK).all()
    assert np.isnan(result.T[none]).all()
    good = result.status == batch.OK
    assert (np.abs(result.t1[good] / (2 * result.alpha[good]) - 1) <= 1 / 8).all()


# Newton's method is led to a second turn here: t1 is right, and slip too long.
@pytest.mark.parametrize("alpha", [0.5970352865838379, 0.7204436204152853])
def test_a_batch_accepts_no_slip_longer_than_a_natural_period(alpha: float) -> None:
    t1, s, status = kernel.orbit_times(alpha, 4, kernel.series_coefficients(4))
    assert abs(t1 / (2 * alpha) - 1) <= 1 / 8
    assert s > 2 * math.pi * (1 + 1 / 8)
    assert status == batch.NOT_ADMISSIBLE
    assert np.isnan(batch.c1_times([alpha], 4).T).all()


@pytest.mark.parametrize("alpha", [0.3, 1.0, 3.0])
def test_a_second_turn_is_no_orbit(alpha: float) -> None:
    """The exact alpha = -tan(s/2) has a period of 2 pi, and t1 = 2 alpha at each root."""
    namespace = vars(kernel) | {
        "rough_slip": lambda alpha: kernel.rough_slip(alpha) + 2 * math.pi
    }
    later = types.FunctionType(kernel.orbit_times.__code__, namespace)
    table = kernel.series_coefficients(30)
    t1, s, status = later(alpha, 30, table)
    assert t1 == pytest.approx(2 * alpha, rel=1e-9)
    assert s == pytest.approx(kernel.orbit_times(alpha, 30, table)[1] + 2 * math.pi, rel=1e-9)
    assert status == batch.NOT_ADMISSIBLE


def test_a_batch_of_high_order_is_exact_to_rounding() -> None:
    result = batch.c1_times(np.logspace(-2, 6, 2000), 24)
    expected = np.array([exact.times(alpha)[1] for alpha in result.alpha])
    assert (result.status == batch.OK).all()
    np.testing.assert_allclose(result.T, expected, rtol=1e-14)
    error = np.abs(result.t1 - 2 * result.alpha) / expected
    assert (error < 4e-15 * (1 + 1 / result.alpha)).all()


@pytest.mark.parametrize("alpha", [0.0, -1.0, np.nan, np.inf])
def test_an_alpha_that_is_none_is_named(alpha: float) -> None:
    with pytest.raises(ValueError, match="alpha: got"):
        batch.c1_times([1.0, alpha], 5)


def test_a_wrong_order_is_named() -> None:
    with pytest.raises(ValueError, match="order: got 0"):
        batch.c1_times([1.0], 0)
