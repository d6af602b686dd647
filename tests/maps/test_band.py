"""Bands solved from the highest index down, and least squares, against LAPACK."""

import numpy as np
import pytest

from nonsmooth.solver.iteration.linear import least_squares
from nonsmooth.solver.maps.band import BLOCK, PAD, SIDE, factorise_band
from nonsmooth.solver.maps.series import solve


def band(size, turn, rng):
    """Return a matrix like that of a phase of so many radians, and its diagonals."""
    D, A = np.zeros((PAD + size + SIDE, PAD + SIDE + 1)), np.zeros((size, size))
    for i in range(size):
        for j in range(max(0, i - SIDE), min(size, i + SIDE + 1)):
            near = 1.0 - (turn / (2 * i + 1)) ** 2 if i == j else turn / (i + j + 1)
            A[i, j] = D[PAD + i, PAD + j - i] = near + 1e-3 * rng.normal()
    return A, D


def solved(D, size, right):
    """Return the solution for columns of right sides, and which rows were exchanged."""
    B, exchanged = np.zeros((len(D), right.shape[1])), np.zeros(len(D), dtype=np.int64)
    B[PAD : PAD + size] = right
    wide = factorise_band(D, exchanged, size)
    solve(D, exchanged, wide, size, B, 0, right.shape[1])
    return B[PAD : PAD + size], wide, exchanged[PAD + BLOCK : PAD + size]


@pytest.mark.parametrize("turn", [0.3, 7.0, 50.0, 51.3])
@pytest.mark.parametrize("size", [2, 3, 11, 61])
def test_a_band_is_solved_with_rows_exchanged(turn, size):
    """Phases of up to fifty radians: on the diagonal it may all but vanish."""
    rng = np.random.default_rng(size)
    A, D = band(size, turn, rng)
    right = rng.normal(size=(size, 3))
    found, wide, exchanged = solved(D, size, right)
    expected = np.linalg.solve(A, right)
    error = np.abs(found - expected).max()
    assert error <= 1e-14 * np.linalg.cond(A) * np.abs(expected).max()
    assert wide == (exchanged != np.arange(PAD + BLOCK, PAD + size)).any()
    if turn > 7 and size > 11:
        assert wide


def test_a_pivot_of_the_second_row_may_vanish():
    """It does near ``s = pi sqrt(m/k)``, where phases often end; nothing is singular there."""
    A = np.array([[2.0, 1.0, 0.5], [3.0, 0.25, 1.0], [0.0, 0.5, 2.0]])
    D = np.zeros((PAD + 3 + SIDE, PAD + SIDE + 1))
    for i in range(3):
        for j in range(3):
            D[PAD + i, PAD + j - i] = A[i, j]
    right = np.array([[1.0], [2.0], [3.0]])
    found, wide, _ = solved(D, 3, right)
    assert not wide
    np.testing.assert_allclose(found, np.linalg.solve(A, right), rtol=1e-15)


@pytest.mark.parametrize(("rows", "count"), [(6, 4), (5, 5), (7, 1)])
def test_least_squares(rows, count):
    rng = np.random.default_rng(rows)
    A, b, x = rng.normal(size=(rows, count)), rng.normal(size=rows), np.empty(count)
    least_squares(np.column_stack([A, b]), count, x)
    np.testing.assert_allclose(x, np.linalg.lstsq(A, b)[0], atol=1e-13 * np.linalg.cond(A))


def test_a_column_of_least_squares_that_adds_nothing_gets_zero():
    A = np.array([[1.0, 2.0], [1.0, 2.0], [0.0, 0.0]])
    x = np.empty(2)
    least_squares(np.column_stack([A, [3.0, 3.0, 1.0]]), 2, x)
    np.testing.assert_allclose(x, [3.0, 0.0], atol=1e-14)
