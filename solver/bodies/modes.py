"""The natural modes of a structure, with the digits that its matrices determine.

Eigenvalue solvers err by the rounding of the largest eigenvalue: by 2e-9 of the lowest one of
a beam of 60 modes.  Residuals ``K q - w^2 M q``, summed without rounding, correct eigenvalues
and vectors: T. Ogita and K. Aishima, Japan J. Indust. Appl. Math. 35 (2018), 1007-1035.
"""

from typing import Any

import numpy as np

from ..arrays import Indices, Matrix, Vector
from .systems import BodyError, exact_product

#: Degrees of freedom up to which all modes are computed, by full matrices.
DENSE = 1500

#: Modes that are looked for at once, as a part of all, from which on matrices are full.
MANY = 0.2

#: What rounding of K may change the square of a natural frequency by, as a part of it; and how
#: many times its rounding the stiffness of a mode may be that has none.
LOST, NOTHING = 1e-3, 4.0

#: Ratio of the squares of frequencies up to which they have their digits.
WIDE = 100.0

#: Turns of modes into each other: where they are settled, and where two modes are nearly one,
#: as they are where their squares differ by less than a part.
SETTLED, NEARLY_ONE, ALIKE = 1e-10, 1e-2, 1e-6

#: Corrections at most.
CORRECTIONS = 4

#: Products of a shape with fixed vectors, by which two are compared.
MARKS = 32


def natural_modes(
    M: Any, K: Any, count: int, shift: float, factors: Any = None
) -> tuple[Vector, Matrix]:
    """Return the squares of the lowest natural frequencies, and the modes, with unit mass.

    Parameters
    ----------
    M, K : sparse array, shape (n, n)
    count : int
        How many.
    shift : float
        Of the spectrum, where few modes of many are found.
    factors : SuperLU, optional
        Those of ``K + shift M``, by which few modes of many are found; without them all are.

    Returns
    -------
    squares : ndarray, shape (count,)
        Growing; 0 where the body moves freely.
    shapes : ndarray, shape (n, count)

    Raises
    ------
    BodyError
        If they are not found, or rounding of K leaves no digits.
    """
    squares, shapes = _found(M, K, count, shift, factors)
    if squares[-1] > WIDE * np.abs(squares).min():
        squares, shapes = corrected(M, K, squares, shapes, factors)
    return _with_digits(K, squares, shapes), shapes * signs(shapes)


def _found(M: Any, K: Any, count: int, shift: float, factors: Any) -> tuple[Vector, Matrix]:
    from scipy import linalg, sparse  # noqa: PLC0415  (a scene of one mass needs none)

    n = M.shape[0]
    try:
        if factors is None or (n <= DENSE and count > MANY * n):
            pairs = linalg.eigh(K.toarray(), M.toarray(), subset_by_index=(0, count - 1))
        else:
            inverse = sparse.linalg.LinearOperator(M.shape, factors.solve, dtype=float)
            pairs = sparse.linalg.eigsh(
                K, count, M, sigma=-shift, OPinv=inverse, v0=_begin(n), which="LM"
            )
    except (np.linalg.LinAlgError, RuntimeError, ValueError) as error:
        raise BodyError(f"the modes of the body are not found: {error}") from None
    return _sorted(*(np.asarray(part, dtype=float) for part in pairs))


def corrected(
    M: Any, K: Any, squares: Vector, shapes: Matrix, factors: Any = None
) -> tuple[Vector, Matrix]:
    """Return natural modes to full accuracy, from approximations with half the digits.

    With ``R = I - Phi^T M Phi`` and ``S = Phi^T K Phi``, mode j is turned by
    ``(S_ij + w_j^2 R_ij)/(w_j^2 - w_i^2)`` towards mode i.  Clusters are resolved by small
    eigenvalue problems of their own.  Components of modes that are not computed are removed by
    a solution with the factors.

    Parameters
    ----------
    M, K : sparse array, shape (n, n)
    squares : ndarray, shape (m,)
    shapes : ndarray, shape (n, m)
    factors : SuperLU, optional
        Those of K, shifted, where m is less than n.
    """
    from scipy import linalg  # noqa: PLC0415

    for _ in range(CORRECTIONS):
        pull, mass = exact_product(K, shapes)[0], M @ shapes
        defect = np.eye(len(squares)) - _symmetric(shapes.T @ mass)
        stiffness = _symmetric(shapes.T @ pull)
        squares = stiffness.diagonal() / (1 - defect.diagonal())
        coupling, distance = stiffness + defect * squares, squares - squares[:, None]
        near = np.abs(coupling) >= NEARLY_ONE * np.abs(distance)
        near |= np.abs(distance) <= ALIKE * np.abs(squares)
        halved = np.diag(defect.diagonal()) / 2
        turns = np.where(near, halved, coupling / np.where(near, 1.0, distance))
        outside = np.zeros_like(shapes)
        if factors is not None:
            residual = factors.solve(pull - mass * squares)
            outside = shapes @ (mass.T @ residual) - residual
        size = SETTLED * np.abs(shapes).max(axis=0)
        settled = np.abs(turns).max() <= SETTLED and (np.abs(outside).max(axis=0) <= size).all()
        for group in _groups(near):
            block = np.ix_(group, group)
            squares[group], turned = linalg.eigh(
                stiffness[block], np.eye(len(group)) - defect[block]
            )
            turns[block] = 0.0
            turns[:, group] = turns[:, group] @ turned
            turns[block] = turned - np.eye(len(group))
        shapes = shapes + (shapes @ turns + outside)
        if settled:
            break
    return _sorted(squares, shapes)


def _symmetric(matrix: Matrix) -> Matrix:
    return np.asarray((matrix + matrix.T) / 2)


def _groups(near: Indices) -> list[Indices]:
    """Return the clusters of modes with nearly equal frequencies."""
    if near.sum() <= len(near):  # each with itself
        return []
    from scipy.sparse import csgraph  # noqa: PLC0415

    count, labels = csgraph.connected_components(near, directed=False)
    groups = (np.flatnonzero(labels == j) for j in range(count))
    return [group for group in groups if len(group) > 1]


def _sorted(squares: Vector, shapes: Matrix) -> tuple[Vector, Matrix]:
    order = np.argsort(squares)
    return squares[order], shapes[:, order]


def _begin(n: int) -> Vector:
    """Return a start vector for Lanczos, the same in every run."""
    return np.random.default_rng(0).random(n) - 0.5


def signs(shapes: Matrix) -> Vector:
    """Return signs of shapes that rounding does not change."""
    return np.asarray(np.sign(_begin(len(shapes)) @ shapes))


def marks(M: Any, shapes: Matrix) -> Matrix:
    """Return products of shapes with some fixed vectors, by their masses; shape (m, MARKS).

    Products of two rows are, roughly, in proportion to those of the shapes.
    """
    fixed = np.random.default_rng(1).random((M.shape[0], MARKS)) - 0.5
    return np.asarray((shapes * np.sqrt(M.diagonal())[:, None]).T @ fixed)


def _with_digits(K: Any, squares: Vector, shapes: Matrix) -> Vector:
    """Return the squares of natural frequencies, exactly 0 for rigid-body modes.

    These have no stiffness beyond the rounding of the entries of K.
    """
    sizes = np.abs(shapes)
    rounding = np.finfo(float).eps * (sizes * (abs(K) @ sizes)).sum(axis=0)
    squares = np.where(
        np.abs((shapes * (K @ shapes)).sum(axis=0)) <= NOTHING * rounding, 0.0, squares
    )
    lost = float((rounding / np.where(squares == 0, np.inf, np.abs(squares))).max())
    if lost > LOST:
        raise BodyError(
            f"K: rounding of its entries may change a natural frequency by {lost / 2:.1g} of "
            "it: take fewer elements"
        )
    return squares
