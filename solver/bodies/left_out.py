"""What the modes of a body that are left out answer to a forcing, and to contact forces."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from ..arrays import Complex, Matrix, Vector
from .modes import signs
from .systems import BodyError, Solve, exact_product, solver

#: Steps in which the static answer of the modes left out is found.
STEPS = 200

#: What of that answer rounding may go on changing, as a part.
BY_ROUNDING = 1e-9

#: What of the compliance at a contact is rounding, as a part; and what of a static answer is
#: new beside the others.
STIFF, NEW = 1e-12, 1e-10


class LeftOut(NamedTuple):
    """The shapes of a body, and how its matrices couple them with what is left out.

    Parameters
    ----------
    shapes : ndarray, shape (n, m)
        ``Phi`` of `Modal`.
    masses : ndarray, shape (n, m)
        ``M Phi``.
    by_stiffness, by_damping, damped_by : ndarray, shape (n, m)
        ``K Phi``, ``C Phi`` and ``C^T Phi``, less the part within the shapes; that of a mode is
        zero for K.  The last is how what is left out acts on the shapes.
    """

    shapes: Matrix
    masses: Matrix
    by_stiffness: Matrix
    by_damping: Matrix
    damped_by: Matrix


def left_out_of(matrices: Mapping[str, Any], shapes: Matrix, modes: int) -> LeftOut:
    """Return how the matrices of a body couple shapes, the first of them modes, with others."""
    masses = matrices["M"] @ shapes

    def outside(matrix: Any) -> Matrix:
        product, _ = exact_product(matrix, shapes)
        return np.asarray(product - masses @ (shapes.T @ product))

    by_stiffness = outside(matrices["K"])
    by_stiffness[:, :modes] = 0.0
    C = matrices["C"]
    by_damping, turned = outside(C), C.T.tocsr()
    damped_by = outside(turned) if (turned != C).nnz else by_damping
    return LeftOut(shapes, masses, by_stiffness, by_damping, damped_by)


def beyond_shapes(
    left_out: LeftOut, matrices: Mapping[str, Any], omega: float, rows: Complex, forcing: Vector
) -> tuple[Complex, Complex]:
    """Return what the whole body answers to a harmonic forcing beyond its shapes alone.

    Not as the difference of two answers: near the resonance of a mode they are large and alike.

    Parameters
    ----------
    left_out : LeftOut
    matrices : mapping of str to sparse array
    omega : float
        Angular frequency of the forcing.
    rows : ndarray of complex, shape (m, m)
        Dynamic stiffness of the shapes.
    forcing : ndarray, shape (m,)
        What forces them.

    Returns
    -------
    direct : ndarray of complex, shape (n,)
        The part outside the shapes.
    inside : ndarray of complex, shape (m,)
        What that brings about in the shapes.
    """
    from scipy import sparse  # noqa: PLC0415  (a scene of one mass needs none)

    force = matrices["forcing"].toarray()[:, 0]
    coupling = left_out.by_stiffness + 1j * omega * left_out.by_damping
    back = left_out.by_stiffness + 1j * omega * left_out.damped_by
    rest = force - left_out.masses @ forcing - coupling @ np.linalg.solve(rows, forcing)
    stiff, damping = (matrices["K"] - omega**2 * matrices["M"], -omega * matrices["C"])
    whole = sparse.block_array([[stiff, damping], [damping, -stiff]], format="csr")  # Re, Im
    parts = solver(whole)(np.concatenate([rest.real, -rest.imag])[:, None])[:, 0]
    real, imag = np.split(parts, 2)
    answer: Complex = real + 1j * imag
    direct: Complex = answer - left_out.shapes @ (left_out.masses.T @ answer)
    inside = np.linalg.solve(rows, -back.T @ direct)
    return direct, np.asarray(inside, dtype=complex)


def static_answers(M: Any, shapes: Matrix, right: Matrix, shift: float, stiff: Solve) -> Matrix:
    """Return the static response of the truncated modes.

    By ``1/w^2 = 1/(w^2 + shift) (1 + shift/w^2)``, repeated, since K may be singular.
    """

    def without(q: Matrix) -> Matrix:
        return np.asarray(q - shapes @ (shapes.T @ (M @ q)))

    first = without(stiff(right - M @ (shapes @ (shapes.T @ right))))
    response, last = first, np.inf
    for _ in range(STEPS):
        before, response = response, first + shift * without(stiff(M @ response))
        change, size = np.abs(response - before).max(), np.abs(response).max()
        if change <= 4 * np.finfo(float).eps * size or last <= change <= BY_ROUNDING * size:
            return response
        last = change
    raise BodyError("the modes left out are too slow for the forcing: keep more of them")


def static_shapes(
    left_out: Matrix, M: Any, K: Any, compliances: Vector
) -> tuple[Vector, Matrix]:
    """Return static answers as shapes with unit mass, and the squares of their frequencies.

    Parameters
    ----------
    left_out : ndarray, shape (n, c)
        What the modes that are left out answer to a unit force at each contact.
    M, K : sparse array, shape (n, n)
    compliances : ndarray, shape (c,)
        By how much each contact gives way without them.

    Returns
    -------
    squares : ndarray, shape (a,)
        Fewer than contacts where answers are rounding, or combinations of others.
    shapes : ndarray, shape (n, a)
    """
    stiff, mass = left_out.T @ (K @ left_out), left_out.T @ (M @ left_out)
    strong = np.diag(stiff) > STIFF * compliances
    sizes = np.sqrt(np.diag(stiff)[strong])
    values, vectors = np.linalg.eigh(stiff[np.ix_(strong, strong)] / np.outer(sizes, sizes))
    new = values > NEW
    basis = vectors[:, new] / sizes[:, None] / np.sqrt(values[new])  # of unit stiffness
    values, vectors = np.linalg.eigh(basis.T @ mass[np.ix_(strong, strong)] @ basis)
    shapes = left_out[:, strong] @ basis @ vectors / np.sqrt(values)
    return 1 / values, shapes * signs(shapes)
