"""The factors of small systems: a solve is a solve, whatever stands on the diagonal."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from nonsmooth.solver.iteration import by_rows
from nonsmooth.solver.iteration.linear import factorise, solve_factorised


def solved(A: np.ndarray, b: np.ndarray) -> np.ndarray:
    factors, rows, x = A.copy(), np.empty(len(A), dtype=np.int64), b.copy()
    assert factorise(factors, rows)
    solve_factorised(factors, rows, x)
    return x


@settings(max_examples=60)
@given(st.integers(1, 12), st.integers(0, 10**6))
def test_a_random_system_is_solved(n: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    A, b = rng.normal(size=(n, n)), rng.normal(size=n)
    expected = np.linalg.solve(A, b)
    allowed = 1e-14 * n * np.linalg.cond(A) * np.abs(expected).max()
    np.testing.assert_allclose(solved(A, b), expected, atol=allowed)


@pytest.mark.parametrize("corner", [0.0, 1e-20])
def test_a_diagonal_that_is_nothing_is_exchanged(corner: float) -> None:
    A = np.array([[corner, 1.0, 2.0], [1.0, 1.0, 1.0], [3.0, 0.0, 1.0]])
    x = np.array([1.0, -2.0, 5.0])
    np.testing.assert_allclose(solved(A, A @ x), x, rtol=1e-14)


@pytest.mark.parametrize("rows", [[[0.0, 0.0], [0.0, 1.0]], [[1.0, 2.0], [2.0, 4.0]]])
def test_a_singular_matrix_is_said_to_be(rows: list[list[float]]) -> None:
    assert not factorise(np.array(rows), np.empty(2, dtype=np.int64))


@pytest.mark.parametrize("n", [5, 16, 40])
@pytest.mark.parametrize("filled", [0.2, 1.0])
def test_all_rows_at_once_give_the_same_bits(n: int, filled: float) -> None:
    rng = np.random.default_rng(n)
    A = rng.normal(size=(n, n)) * (rng.random((n, n)) < filled) + 0.1 * np.eye(n)
    (one, rows), (other, others) = ((A.copy(), np.zeros(n, dtype=np.int64)) for _ in range(2))
    assert factorise(one, rows)
    assert by_rows.factorise(other, others)
    np.testing.assert_array_equal(other, one)
    np.testing.assert_array_equal(others, rows)
    A[:, n // 2] = 0.0
    assert not by_rows.factorise(A, rows)
