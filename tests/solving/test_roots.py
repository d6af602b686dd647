"""All real solutions of the C1 series: counted, found, and one of them the orbit."""

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth.codegen.shortcuts.reduced.elimination import rational_function, square
from nonsmooth.solver.shortcuts.orbit import admissible
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.polynomials import c1_roots, real_roots
from nonsmooth.solver.shortcuts.search import kernels


def by_sympy(coefficients: list[int]) -> list[float]:
    """Return the positive real roots by SymPy."""
    s = sp.Symbol("s")
    polynomial = sp.Poly(coefficients[::-1], s)
    return [float(root.evalf(25)) for root in polynomial.real_roots() if root.evalf() > 0]


@settings(max_examples=40)
@given(st.lists(st.integers(-9, 9), min_size=2, max_size=7), st.integers(1, 9))
def test_isolation_finds_the_roots_that_sympy_finds(lower: list[int], lead: int) -> None:
    polynomial = [*lower, lead]
    s = sp.Symbol("s")
    exact = sp.Poly(polynomial[::-1], s)
    # Zero and multiple roots are not what the C1 series has; Hypothesis draws others instead.
    assume(polynomial[0] != 0 and sp.gcd(exact, exact.diff()).degree() == 0)
    expected = by_sympy(polynomial)
    intervals = real_roots.isolate(polynomial)
    assert len(intervals) == len(expected)
    found = [float(real_roots.refine(polynomial, *interval)) for interval in intervals]
    assert found == pytest.approx(expected, rel=1e-14)


def test_an_exchange_of_rows_changes_the_sign_of_the_determinant() -> None:
    rows = [[Fraction(c) for c in row] for row in ([0, 1, 2], [4, 8, 28])]
    assert c1_roots._eliminate(rows) == (-4, [3, 2])


def test_a_multiple_root_is_refused() -> None:
    with pytest.raises(ArithmeticError, match="multiple root"):
        real_roots.isolate([9, -6, 1])  # (s - 3)**2


@pytest.mark.parametrize("order", range(1, 9))
@pytest.mark.parametrize("alpha", [0.05, 1.0, 7.0])
def test_every_root_solves_the_kernels_equations(order: int, alpha: float) -> None:
    solutions = c1_roots.solutions(order, alpha)
    kernel = kernels.plain("c1")
    for z in solutions:
        R = np.empty(len(z))
        kernel.residual(alpha, z, R)
        size = np.abs(z).max() * (1 + (z[-1] - z[-2]) ** 2)
        assert np.abs(R).max() < 1e-10 * size


@pytest.mark.parametrize(("order", "count"), [(1, 1), (2, 2), (3, 3), (4, 4), (7, 5), (8, 6)])
def test_number_of_solutions_at_alpha_1(order: int, count: int) -> None:
    assert len(c1_roots.solutions(order, 1.0)) == count
    assert len(by_sympy(c1_roots.polynomial(order, 1.0))) == count


@pytest.mark.parametrize("order", [5, 7, 8, 14, 20])
@pytest.mark.parametrize("alpha", [0.1, 0.3, 1.0, 10.0])
def test_exactly_one_solution_is_an_orbit_where_there_is_one(order: int, alpha: float) -> None:
    belt = ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )
    method = METHODS["c1"]
    good = [
        z
        for z in c1_roots.solutions(order, alpha)
        if not admissible.violations(method, order, belt, z)
    ]
    if (order, alpha) == (5, 0.1):
        assert not good
        with pytest.raises(ns.NoOrbit):
            ns.solve(belt, "c1", order)
        return
    (only,) = good
    assert ns.solve(belt, "c1", order).unknowns[-2:] == pytest.approx(only[-2:], rel=1e-9)


@pytest.mark.parametrize("order", range(1, 9))
def test_sympy_eliminates_to_the_same_rational_function(order: int) -> None:
    below, above, _ = c1_roots._rational_function(order)
    solver = sum(sp.Rational(c) * square**i for i, c in enumerate(above)) / sum(
        sp.Rational(c) * square**i for i, c in enumerate(below)
    )
    assert sp.cancel(solver - rational_function(order)) == 0


def test_minus_the_rational_function_approximates_tan() -> None:
    order = 9
    for s in (0.3, 2.0, 4.0, 5.5):
        value = float(rational_function(order).subs(square, sp.Float(s, 30) ** 2))
        assert value == pytest.approx(-np.tan(s / 2) / s, rel=1e-3)


@pytest.mark.parametrize(
    ("alpha", "order"), [(1e-8, 40), pytest.param(3e-8, 60, marks=pytest.mark.long), (1e-6, 20)]
)
def test_an_orbit_with_a_very_short_stick_is_among_the_solutions(
    alpha: float, order: int
) -> None:
    """Its t1 is 2 alpha: found from s to 64 bits, not as a difference of float64 numbers."""
    belt = ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )
    method = METHODS["c1"]
    orbit = ns.solve(belt, "c1", order)
    good = [
        z
        for z in c1_roots.solutions(order, alpha)
        if not admissible.violations(method, order, belt, z)
    ]
    assert len(good) == 1
    assert good[0][-2] == pytest.approx(orbit.unknowns[-2], rel=1e-6)


def test_rational_function_tends_to_the_exact_relation() -> None:
    # alpha = -tan(s/2) for the exact orbit, and alpha = s E(s**2)/D(s**2) for the series.
    below, above, _ = c1_roots._rational_function(12)
    s = Fraction(9, 2)
    D, E = (sum(c * s ** (2 * i) for i, c in enumerate(part)) for part in (below, above))
    assert float(s * E / D) == pytest.approx(-np.tan(float(s) / 2), rel=1e-7)
