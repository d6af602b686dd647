"""Natural modes and static answers, against the same matrices in 60 digits."""

from functools import cache

import flint
import numpy as np
import pytest
from scipy import sparse

from nonsmooth.codegen.scenes.beam_clearance import MASS, STIFFNESS
from nonsmooth.solver.bodies import modes, systems

BITS = 200

#: A beam; and one that nothing holds, of two modes without stiffness.
CLAMPED, LOOSE = "clamped", "loose"


@pytest.fixture(autouse=True)
def _bits():
    with flint.ctx.workprec(BITS):
        yield


def beam(which: str) -> tuple[np.ndarray, np.ndarray]:
    """Return mass and stiffness, of 60 degrees of freedom or, in small integers, of 22."""
    if which == CLAMPED:
        return MASS, STIFFNESS
    m = np.array([[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]])
    k = np.array([[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]])
    M, K = np.zeros((2, 22, 22))
    for e in range(10):
        here = slice(2 * e, 2 * e + 4)
        M[here, here] += m
        K[here, here] += k
    return M, K


@cache
def exact_squares(which: str) -> np.ndarray:
    """Return the squares of the natural frequencies."""
    M, K = (flint.arb_mat(q.tolist()) for q in beam(which))
    found = flint.acb_mat(M.solve(K)).eig(multiple=True)
    return np.sort([float(q.real.mid()) for q in found])


def shifted(M, K) -> tuple[float, object]:
    """Return a shift of the spectrum and the factors there."""
    shift = 1e-8 * K.diagonal().sum() / M.diagonal().sum()
    return shift, systems.factored(K + shift * M)


@pytest.mark.parametrize("which", [CLAMPED, LOOSE])
@pytest.mark.parametrize("twice", [False, True], ids=["once", "two alike"])
def test_all_modes_have_their_digits(which: str, twice: bool) -> None:
    """Those of two structures that do not touch are double."""
    M, K = map(sparse.csr_array, beam(which))
    if twice:
        M, K = (sparse.block_diag([q, q], format="csr") for q in (M, K))
    squares, shapes = modes.natural_modes(M, K, M.shape[0], 0.0)
    exact = np.repeat(exact_squares(which), 1 + twice)
    free = 0 if which == CLAMPED else 2 * (1 + twice)
    assert not squares[:free].any()
    assert squares[free:] == pytest.approx(exact[free:], rel=1e-14)
    pull, push = systems.exact_product(K, shapes)[0], shapes.T @ (M @ shapes)
    assert push == pytest.approx(np.eye(len(squares)), abs=2e-14)
    size = np.sqrt(np.maximum(squares, squares[free]))
    assert shapes.T @ pull / np.outer(size, size) == pytest.approx(
        np.diag(squares) / size**2, abs=2e-11
    )


@pytest.mark.parametrize("count", [4, 12, 30])
def test_few_modes_are_the_lowest_of_all(count: int) -> None:
    M, K = map(sparse.csr_array, beam(CLAMPED))
    squares, shapes = modes.natural_modes(M, K, count, *shifted(M, K))
    _, every = modes.natural_modes(M, K, M.shape[0], 0.0)
    assert squares == pytest.approx(exact_squares(CLAMPED)[:count], rel=1e-14)
    assert shapes == pytest.approx(every[:, :count], abs=1e-13 * np.abs(every).max())


@pytest.mark.parametrize("seed", range(24))
def test_modes_of_random_matrices_have_their_digits(seed: int) -> None:
    """Stiff and soft, twice alike, free, or with negative stiffness; masses of many sizes."""
    rng = np.random.default_rng(seed)
    n, kind = int(rng.integers(2, 12)), seed % 4
    A = rng.integers(-3, 4, (n, n)).astype(float)
    M, K = np.diag(np.exp(rng.uniform(-4, 4, n))), A + A.T
    if kind == 0:
        K = A @ A.T + np.diag(10.0 ** rng.integers(-6, 7, n))
    elif kind == 1:
        links = np.diff(np.eye(n), axis=0)
        K = links.T @ np.diag(10.0 ** rng.integers(-5, 6, n - 1)) @ links
    elif kind == 2:
        K = A @ A.T + np.eye(n)
    found = flint.acb_mat(flint.arb_mat(M.tolist()).solve(flint.arb_mat(K.tolist())))
    exact = np.sort([float(q.real.mid()) for q in found.eig(multiple=True)])
    if kind == 2:
        M, K, exact = np.kron(np.eye(2), M), np.kron(np.eye(2), K), np.repeat(exact, 2)
    squares, shapes = modes.natural_modes(*map(sparse.csr_array, (M, K)), len(M), 0.0)
    held = squares != 0
    assert squares[held] == pytest.approx(exact[held], rel=1e-13)
    assert shapes.T @ M @ shapes == pytest.approx(np.eye(len(M)), abs=1e-13)


def test_what_eigh_finds_has_not_these_digits(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(modes, "WIDE", np.inf)
    M, K = map(sparse.csr_array, beam(CLAMPED))
    squares, _ = modes.natural_modes(M, K, M.shape[0], 0.0)
    assert np.abs(squares / exact_squares(CLAMPED) - 1).max() > 1e-12


def test_static_answers_have_their_digits() -> None:
    K = sparse.csr_array(STIFFNESS)
    right = np.eye(len(STIFFNESS))[:, -2:]
    exact = flint.arb_mat(STIFFNESS.tolist()).solve(flint.arb_mat(right.tolist()))
    found = systems.solver(K)(right)
    assert found == pytest.approx(np.array(exact.tolist(), dtype=float), rel=1e-14)


@pytest.mark.parametrize("density", [0.05, 0.3])
def test_a_product_has_twice_the_digits(density: float) -> None:
    """Of a sparse matrix, and of one that is taken as full."""
    rng = np.random.default_rng(1)
    A = sparse.random_array((40, 30), density=density, rng=rng, format="csr")
    A.data *= np.exp2(rng.integers(-20, 20, A.nnz))
    B = rng.normal(size=(30, 3)) * np.exp2(rng.integers(-20, 20, (30, 1)))
    product, rest = systems.exact_product(A, B)
    exact = flint.arb_mat(A.toarray().tolist()) * flint.arb_mat(B.tolist())
    both = flint.arb_mat(product.tolist()) + flint.arb_mat(rest.tolist())
    left = np.array((exact - both).tolist(), dtype=float)
    assert np.abs(left).max() <= 2.0**-80 * np.abs(product).max()
    assert np.abs(rest).max() <= 2.0**-52 * np.abs(product).max()
