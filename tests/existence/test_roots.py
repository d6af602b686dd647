"""All real solutions of the C1 series: counted, found, and one of them the orbit."""

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from computed import belt_of
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth import all_solutions as isolated
from nonsmooth.all_solutions import solutions
from nonsmooth.solver.existence import real_roots
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.orbit.solution import attempt


def orbits(order: int, alpha: float) -> list[tuple[float, float]]:
    """Return t1 and slip of the solutions that are orbits."""
    found = solutions(belt_of(alpha), order)
    return [(each.t1, each.slip) for each in found if not each.violations]


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
    assert isolated._eliminate(rows) == (-4, [3, 2])


def test_a_multiple_root_is_refused() -> None:
    with pytest.raises(ArithmeticError, match="multiple root"):
        real_roots.isolate([9, -6, 1])  # (s - 3)**2


@pytest.mark.parametrize("order", range(1, 9))
@pytest.mark.parametrize("alpha", [0.05, 1.0, 7.0])
def test_every_root_solves_the_kernels_equations(order: int, alpha: float) -> None:
    belt = belt_of(alpha)
    kernel = registry.kernel(belt.scene, "ck")
    for times in isolated.isolated(order, alpha):
        orbit = attempt(kernel, belt, order, np.array(times) / belt.units.time)
        assert orbit.converged
        assert orbit.durations == pytest.approx(times, rel=1e-9)


@pytest.mark.parametrize(("order", "count"), [(1, 1), (2, 2), (3, 3), (4, 4), (7, 5), (8, 6)])
def test_number_of_solutions_at_alpha_1(order: int, count: int) -> None:
    assert len(isolated.isolated(order, 1.0)) == len(solutions(belt_of(1.0), order)) == count
    assert len(by_sympy(isolated.polynomial(order, 1.0))) == count


@pytest.mark.parametrize("order", [5, 7, 8, 14, 20])
@pytest.mark.parametrize("alpha", [0.1, 0.3, 1.0, 10.0])
def test_exactly_one_solution_is_an_orbit_where_there_is_one(order: int, alpha: float) -> None:
    good = orbits(order, alpha)
    if (order, alpha) == (5, 0.1):
        assert not good
        with pytest.raises(ns.NoOrbit):
            ns.solve(belt_of(alpha), "c1", order)
        return
    (only,) = good
    assert ns.solve(belt_of(alpha), "c1", order).durations == pytest.approx(only, rel=1e-9)


@pytest.mark.parametrize(
    ("alpha", "order"), [(1e-8, 40), pytest.param(3e-8, 60, marks=pytest.mark.long), (1e-6, 20)]
)
def test_an_orbit_with_a_very_short_stick_is_among_the_solutions(
    alpha: float, order: int
) -> None:
    """Its t1 is 2 alpha: found from s to 64 bits, not as a difference of float64 numbers."""
    (only,) = orbits(order, alpha)
    assert only[0] == pytest.approx(ns.solve(belt_of(alpha), "c1", order).t1, rel=1e-6)


def test_rational_function_tends_to_the_exact_relation() -> None:
    for order, slip, rel in ((9, 0.3, 1e-3), (9, 5.5, 1e-3), (12, 4.5, 1e-7)):
        expected = -np.tan(slip / 2)  # of the exact orbit
        assert isolated.alpha_of(order, slip) == pytest.approx(expected, rel=rel)
