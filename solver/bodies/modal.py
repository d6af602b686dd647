"""A body in its modes: what its contacts and its forcing see of it."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from ..arrays import Matrix, Vector

Complex: TypeAlias = npt.NDArray[np.complex128]

#: Degrees of freedom up to which matrices are full.
DENSE = 1500

#: Where the spectrum is shifted to for a sparse body, as a part of the mean of K over M.
SHIFT = 1e-8


class BodyError(ValueError):
    """A body whose numbers allow no orbit to be computed; it says why."""


@dataclass(frozen=True, eq=False)
class Modal:
    """A body in the modes that are kept, ``q = Phi eta`` with ``Phi^T M Phi = I``.

    Parameters
    ----------
    squares : ndarray, shape (m,)
        Squares of the natural angular frequencies.
    damping : ndarray, shape (m, m)
        ``Phi^T C Phi``.
    at : ndarray, shape (m, c)
        ``Phi^T w`` of each contact.
    forcing : ndarray, shape (m,)
        ``Phi^T f``.
    mobility : ndarray, shape (c, c)
        ``w^T M^-1 w`` of the whole body: the velocities that unit impulses give.
    residual : ndarray, shape (c, c)
        Static compliance of the modes that are left out.
    beyond : ndarray of complex, shape (c,)
        What the modes left out add to the response of the contacts to the forcing.
    """

    squares: Vector
    damping: Matrix
    at: Matrix
    forcing: Vector
    mobility: Matrix
    residual: Matrix
    beyond: Complex

    @property
    def is_proportional(self) -> bool:
        """Whether the damping does not couple the modes."""
        off = self.damping - np.diag(np.diag(self.damping))
        return bool(
            np.abs(off).max(initial=0.0) <= 1e-13 * np.abs(self.damping).max(initial=0.0)
        )

    @property
    def kept_mobility(self) -> Matrix:
        """``w^T M^-1 w`` of the modes that are kept."""
        return self.at.T @ self.at


def modal(
    matrices: Mapping[str, Any], ratio: float | None, modes: int | None, omega: float
) -> Modal:
    """Return a body in its modes.

    Parameters
    ----------
    matrices : mapping of str to sparse array
        ``M``, ``K``, ``at`` and, if given, ``C``, ``forcing``; in one system of units.
    ratio : float, optional
        Damping ratio of every mode.
    modes : int, optional
        How many are kept; without it all.
    omega : float
        Angular frequency of the forcing; 0 if there is none.

    Raises
    ------
    BodyError
        If it is too large for all of its modes, or its eigenvalues are not found.
    """
    M, K, at = matrices["M"], matrices["K"], matrices["at"].toarray()
    n = M.shape[0]
    force = matrices["forcing"].toarray() if "forcing" in matrices else np.zeros((n, 1))
    whole = modes is None or modes >= n
    if whole and n > DENSE:
        raise BodyError(f"the body has {n} degrees of freedom: say how many modes are kept")
    squares, shapes = _modes(M, K, n if modes is None or whole else modes)
    seen, driven = shapes.T @ at, shapes.T @ force
    damping = np.diag(2 * (ratio or 0.0) * np.sqrt(np.abs(squares)))
    if "C" in matrices:
        damping = shapes.T @ (matrices["C"] @ shapes)
    mobility = seen.T @ seen
    residual, beyond = np.zeros_like(mobility), np.zeros(at.shape[1], dtype=complex)
    if not whole:
        mobility = at.T @ _solve(M, at)
        answers = _solve(K, np.hstack([at, force]))
        kept = (seen / squares[:, None]).T @ np.hstack([seen, driven])
        left_out = at.T @ answers - kept
        residual = (left_out[:, :-1] + left_out[:, :-1].T) / 2
        beyond = left_out[:, -1].astype(complex)
        if "C" in matrices and omega:
            full = at.T @ _solve(K - omega**2 * M + 1j * omega * matrices["C"], force)
            rows = np.diag(squares - omega**2) + 1j * omega * damping
            beyond = (full - seen.T @ np.linalg.solve(rows, driven.astype(complex)))[:, 0]
    return Modal(squares, damping, seen, driven[:, 0], mobility, residual, beyond)


def _modes(M: Any, K: Any, count: int) -> tuple[Vector, Matrix]:
    """Return the squares of the lowest natural frequencies, and the modes, with unit mass."""
    from scipy import linalg, sparse  # noqa: PLC0415  (a scene of one mass needs none)

    n = M.shape[0]
    try:
        if n <= DENSE:
            found = linalg.eigh(K.toarray(), M.toarray(), subset_by_index=(0, count - 1))
        else:
            shift = -SHIFT * K.diagonal().sum() / M.diagonal().sum()
            found = sparse.linalg.eigsh(K.tocsc(), count, M.tocsc(), sigma=shift)
    except (np.linalg.LinAlgError, RuntimeError, ValueError) as error:
        raise BodyError(f"the modes of the body are not found: {error}") from None
    return np.asarray(found[0], dtype=float), np.asarray(found[1], dtype=float)


def _solve(matrix: Any, right: Any) -> Any:
    """Return the solutions of a system with a sparse matrix."""
    from scipy import sparse  # noqa: PLC0415

    try:
        return sparse.linalg.splu(matrix.tocsc()).solve(right.astype(matrix.dtype))
    except RuntimeError:
        raise BodyError("the body moves freely as a whole: keep all of its modes") from None
